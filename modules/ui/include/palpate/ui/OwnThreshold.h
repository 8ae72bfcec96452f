// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/study/ThresholdSeries.h>

#include <QString>

#include <optional>

namespace palpate::ui {

/// Measured threshold of the user's hand, in the settings of the program.
struct OwnThreshold
{
    study::HandThreshold measured;
    QString device;      ///< name of the device
    int trials = 0;      ///< number of answers
    bool isUsed = false; ///< verdicts are also given for this hand

    /// Reads the stored threshold; empty without one.
    [[nodiscard]] PALPATE_EXPORT static std::optional<OwnThreshold> stored();
    PALPATE_EXPORT void store() const;
    /// Deletes the stored threshold.
    PALPATE_EXPORT static void reset();
};

/// Threshold as a Weber fraction with half the width of the 95 % interval: "0.18 ± 0.04".
[[nodiscard]] PALPATE_EXPORT QString weberText(const study::HandThreshold& threshold);
/// Verdict for the user's own hand: "for your hand: felt". Empty unless a threshold is stored and used.
/// @param ratio  stiffness relative to the organ without the lump, k/k0 [1]
[[nodiscard]] PALPATE_EXPORT QString ownVerdictText(double ratio);

} // namespace palpate::ui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/FeltLayers.h"

#include <QColor>
#include <QString>

#include <optional>
#include <vector>

namespace palpate::ui {

/// One moment of touch, for display.
struct TouchReading
{
    double time_s = 0.0;
    double force_N = 0.0; ///< force on the hand; model force for devices without motors
    double depth_mm = 0.0;
    QString structure;                  ///< structure of the outermost layer; empty in free space
    double stiffness_N_per_mm = 0.0;    ///< all layers in contact together; a healthy liver: about 0.1
    double stiffnessRatio = 1.0;        ///< relative to the tissue of the outermost layer alone [1]
    int constraints = 0;                ///< active constraints of the outermost layer, for the engineering panel
    bool isSlidOff = false;             ///< pressing, but the surface has slid aside
    bool isAtIterationLimit = false;    ///< the solver stopped at the iteration limit; the force lags
    std::vector<LayerShare> layers{};   ///< outermost first
    QString lump{};                     ///< lump felt through `structure` here; empty: no lump
    QColor lumpColour{};                ///< colour of the lump's structure
    double lumpRatio = 1.0;             ///< local stiffness relative to the organ without the lump [1]
    std::optional<double> recorded_s{}; ///< position in the recording [s]; empty: live
};

} // namespace palpate::ui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <QObject>
#include <QString>

#include <memory>

namespace palpate::ui {

/// Sonification of touch: pitch for stiffness, loudness for force (see TouchTone). Off by default.
///
/// @par Thread GUI thread; samples are generated on a separate thread.
class PALPATE_EXPORT TouchSound : public QObject
{
    Q_OBJECT
  public:
    explicit TouchSound(QObject* parent = nullptr);
    ~TouchSound() override;

    /// Short reason why sound is unavailable; empty when available.
    [[nodiscard]] static QString whyNot();
    /// Switches the sound. Returns the new state: false when `whyNot` gives a reason.
    bool setOn(bool isOn);
    /// Updates pitch and loudness.
    /// @param ratio  stiffness relative to the touched tissue alone [1]
    /// @param force_N  0 in free space
    /// @param limit_N  force limit of the device
    void setTouch(double ratio, double force_N, double limit_N);

  Q_SIGNALS:
    /// Emitted when the audio device disappeared; the sound is then off.
    void ended();

  private:
    struct Output;
    std::unique_ptr<Output> m_output; ///< null: off
};

} // namespace palpate::ui

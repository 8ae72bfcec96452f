// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/LiveTouch.h"

#include <palpate/core/Export.h>

#include <QObject>
#include <QTimer>

namespace palpate::ui {

/// How the tissue of the scene moves, as the user wants it. Not part of the scene file.
struct MotionSettings
{
    bool isPlaying = true;  ///< false: everything stands still, pulses included
    bool isHeld = false;    ///< breaths and frames stand still; poses and pulses go on
    double rate = 1.0;      ///< of all motions
    double amplitude = 1.0; ///< share of the displacement of breaths and frames, 0 to 1

    friend bool operator==(const MotionSettings&, const MotionSettings&) = default;
};

/// Gives the motions of the open scene another pace while they are felt. A change begins kLead_s after the newest tick
/// and takes kEase_s, so that neither place nor velocity of the tissue jumps, whichever tick takes the new scene. A
/// change during another one waits for its end. A running recording stores the motions with the new scene, so that it
/// replays bit for bit.
/// @par Thread GUI thread only.
class PALPATE_EXPORT MotionControl : public QObject
{
    Q_OBJECT
  public:
    static constexpr double kLead_s = 0.1; ///< time for the new scene to reach the servo loop
    static constexpr double kEase_s = 0.3;

    /// The references must outlive this object.
    MotionControl(StructureModel& model, LiveTouch& live, QObject* parent = nullptr);

    [[nodiscard]] const MotionSettings& settings() const noexcept { return m_settings; }
    void set(const MotionSettings& settings);
    /// True if a structure of the scene moves or pulses.
    [[nodiscard]] bool hasMotion() const;
    /// True if a structure breathes or moves by frames.
    [[nodiscard]] bool hasBreath() const;

  Q_SIGNALS:
    /// Emitted when the settings changed, or the scene.
    void changed();

  private:
    void apply();

    StructureModel& m_model;
    LiveTouch& m_live;
    MotionSettings m_settings;
    QTimer m_retry;
};

} // namespace palpate::ui

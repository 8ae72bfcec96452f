// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/HandSettings.h"
#include "palpate/ui/LiveTouch.h"
#include "palpate/ui/PointerHand.h"
#include "palpate/ui/TouchPanel.h"
#include "palpate/ui/VtkViewport.h"

#include <palpate/core/Export.h>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <cstdint>
#include <optional>

namespace palpate::ui {

/// Uses the pointer as a haptic device: view → PointerHand → device, newest servo tick → cursor and readings. Active
/// only while the pointer is over the view or another device is in use. The keyboard offers the same functions; a
/// crosshair then marks the hand until the pointer takes over.
class PALPATE_EXPORT PalpationController : public QObject
{
    Q_OBJECT
  public:
    /// All references must outlive this object.
    PalpationController(VtkViewport& viewport, LiveTouch& live, StructureModel& model, QObject* parent = nullptr);

    /// Switches between camera and palpation mode.
    void setPalpating(bool isPalpating);
    [[nodiscard]] bool isPalpating() const noexcept { return m_isPalpating; }
    /// Lifts the hand off the surface. Returns false when nothing was pressed.
    bool letGo();
    /// Adapts hover height, depths and strides to the size of a new scene.
    void setSceneSize(double diagonal_mm);
    /// Selects pressing to a fixed depth or by effort, where the depth follows from the stiffness of the pressed
    /// structures.
    void setPress(const HandSettings& settings);
    [[nodiscard]] bool isByEffort() const noexcept { return m_isByEffort; }
    [[nodiscard]] double depth_mm() const noexcept { return m_hand.settings().depth_mm; }
    /// Short status of the hand: "camera", "presses 4.0 mm", "pressing 12 of 27 mm", "aims at
    /// 2.3 of 5.0 N, reaches 2.1 N, 3.4 mm".
    [[nodiscard]] QString text() const;
    /// True while pressing when the surface has slid aside, so that the penetration depth is less than the commanded
    /// depth.
    [[nodiscard]] bool isSlidOff() const noexcept { return m_isSlidOff; }

    /// Moves the hand to a place of the view and presses, without a pointer.
    void pressAt(const QPointF& place);
    /// Moves a pressing or hovering hand.
    void moveTo(const QPointF& place);

    /// Moves the hand along the screen in strides of 2 mm, less in a small scene. The first call places the hand at the
    /// pointer's position or in the middle of the view.
    void stepAlongScreen(int right, int up);
    /// Presses at the current place, or releases.
    void togglePress();
    /// Handles a push of the 6-axis mouse: presses by effort at the current place with a fraction of the force limit.
    /// At rest, the press started by the 6-axis mouse is released.
    /// @param share  0 to 1; 0: at rest
    void push(double share);
    /// Changes the depth in steps of 0.5 mm, less in a small scene.
    void stepDepth(int steps);
    /// Updates a hovering hand after the camera was moved by keys.
    void followCamera();
    /// Contact at the end of a press.
    struct Press
    {
        view::TouchState touch;
        TouchReading reading;
        std::int64_t tick = 0;
    };
    /// Returns the contact of the last press of the pointer or the keys: with one mouse, a command can only be clicked
    /// after the release. Empty after a press that ended without contact, without palpation mode, with another device
    /// or scene, and after `forgetPress`.
    [[nodiscard]] const std::optional<Press>& lastPress() const noexcept { return m_lastPress; }
    void forgetPress() { m_lastPress.reset(); }
    /// True while keys control the hand and the crosshair is visible.
    [[nodiscard]] bool isByKeys() const noexcept { return m_isByKeys; }

  Q_SIGNALS:
    /// Emitted for a new tick, at most at display rate.
    void touched(const palpate::ui::TouchReading& reading);
    void handGone();
    void depthChanged(double depth_mm);
    /// Emitted when wheel or key changed the force limit.
    void effortTurned(double most_N);
    /// Emitted when `text` changed.
    void textChanged();
    /// Emitted for a hand key in camera mode.
    void palpationWanted();
    /// Message for the user, one sentence.
    void said(const QString& line);

  private:
    void connectPointer();
    [[nodiscard]] bool takeByKeys();
    [[nodiscard]] bool isPressing() const;
    [[nodiscard]] std::optional<double> pressFingertip_mm() const;
    void turnEffort(double notches);
    void updateEffortDepth(double now_s);
    void followTissue();
    void emitDepth(bool isWithin, bool isDeeper);
    void updatePressState(const servo::TickRecord& tick, TouchReading& reading);
    void refreshText();
    void point(const view::Ray& ray);
    void press();
    void run();
    void step();
    void showDevice(std::int64_t now_ns);
    void show(const servo::TickRecord& tick, std::int64_t now_ns);

    VtkViewport& m_viewport;
    LiveTouch& m_live;
    StructureModel& m_model;
    PointerHand m_hand;
    core::Vec3 m_toSurface_W = core::Vec3::Zero(); ///< from the hand's reference point to the pointed place
    QTimer m_timer;
    servo::TickRecord m_tick;
    view::TouchState m_shown;
    std::int64_t m_shown_ns = 0;
    bool m_isPalpating = false;
    Effort m_effort;
    bool m_isByEffort = false;
    bool m_isByKeys = false;
    double m_pressFingertip_mm = 0.0; ///< radius at the start of the press
    bool m_isPushed = false;          ///< press by the 6-axis mouse
    bool m_isSlidOff = false;
    double m_pressed_mm = 0.0; ///< depth of the hand along the line of sight
    std::optional<Press> m_lastPress;
    QString m_text; ///< last emitted text
};

} // namespace palpate::ui

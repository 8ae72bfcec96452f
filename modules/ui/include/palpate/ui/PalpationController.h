// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/LiveTouch.h"
#include "palpate/ui/PointerHand.h"
#include "palpate/ui/TouchPanel.h"
#include "palpate/ui/VtkViewport.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace palpate::ui {

/// The pointer as a hand: view -> PointerHand -> device, and the servo's newest tick -> cursor and numbers. Runs only
/// while a hand is over the view, or while another device than the pointer is the hand.
class PalpationController : public QObject
{
    Q_OBJECT
  public:
    /// All must outlive this.
    PalpationController(VtkViewport& viewport, LiveTouch& live, StructureModel& model, QObject* parent = nullptr);

    /// Switches between camera and palpation.
    void setPalpating(bool isPalpating);
    [[nodiscard]] bool isPalpating() const noexcept { return m_isPalpating; }
    /// Lifts the hand off. @return false when nothing was pressed
    bool letGo();
    /// Sizes depths for a new scene.
    void setSceneSize(double diagonal_mm);
    [[nodiscard]] double depth_mm() const noexcept { return m_hand.settings().depth_mm; }

    /// A hand that needs no pointer: goes where `place` of the view shows and presses.
    void pressAt(const QPointF& place);
    /// Moves the pressed or hovering hand.
    void moveTo(const QPointF& place);

  Q_SIGNALS:
    /// A newer moment of touch, at most at display rate.
    void touched(const palpate::ui::TouchReading& reading);
    void handGone();
    void depthChanged(double depth_mm);

  private:
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
    QTimer m_timer;
    servo::TickRecord m_tick;
    view::TouchState m_shown;
    std::int64_t m_shown_ns = 0;
    bool m_isPalpating = false;
};

} // namespace palpate::ui

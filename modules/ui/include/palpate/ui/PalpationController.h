// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/HandSettings.h"
#include "palpate/ui/LiveTouch.h"
#include "palpate/ui/PointerHand.h"
#include "palpate/ui/TouchPanel.h"
#include "palpate/ui/VtkViewport.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace palpate::ui {

/// The pointer as a hand: view -> PointerHand -> device, and the servo's newest tick -> cursor and numbers. Runs only
/// while a hand is over the view, or while another device than the pointer is the hand. Keys can do all that a pointer
/// does: then a crosshair shows where the hand is, until the pointer takes it again.
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
    /// How the pointer presses: as deep as is set, or by effort, where the depth follows from what is pressed.
    void setPress(const HandSettings& settings);
    [[nodiscard]] bool isByEffort() const noexcept { return m_isByEffort; }
    [[nodiscard]] double depth_mm() const noexcept { return m_hand.settings().depth_mm; }
    /// What the hand in the view does, in a few words: "camera", "presses 4.0 mm", "pressing 12 of 27 mm", "pressing
    /// 2.3 of 5.0 N".
    [[nodiscard]] QString text() const;
    /// It presses, and the surface has given way to the side: less is felt than is pressed.
    [[nodiscard]] bool isSlidOff() const noexcept { return m_isSlidOff; }

    /// A hand that needs no pointer: goes where `place` of the view shows and presses.
    void pressAt(const QPointF& place);
    /// Moves the pressed or hovering hand.
    void moveTo(const QPointF& place);

    /// Moves the hand along the screen, by strides of 2 mm, less in a small scene. The first time it is put in the
    /// middle of the view, or where the pointer has it.
    void stepAlongScreen(int right, int up);
    /// Presses where the hand is, or lets go.
    void togglePress();
    /// A 6-axis mouse is pushed: presses where the hand is, by effort with this share of the hardest press; it lets go
    /// of what it pressed when it rests. @param share  0 … 1; 0: it rests
    void push(double share);
    /// Deeper by steps of 0.5 mm, less in a small scene.
    void stepDepth(int steps);
    /// The camera was moved by keys: a hand that hovers follows.
    void followCamera();
    /// Keys move the hand, and a crosshair shows it.
    [[nodiscard]] bool isByKeys() const noexcept { return m_isByKeys; }

  Q_SIGNALS:
    /// A newer moment of touch, at most at display rate.
    void touched(const palpate::ui::TouchReading& reading);
    void handGone();
    void depthChanged(double depth_mm);
    /// The wheel or a key changed the force of a press at most.
    void effortTurned(double most_N);
    /// `text` is another one.
    void textChanged();
    /// A key for the hand was pressed while the pointer moves the camera.
    void palpationWanted();
    /// Something to tell the person, a sentence.
    void said(const QString& line);

  private:
    void connectPointer();
    [[nodiscard]] bool takeByKeys();
    [[nodiscard]] bool isPressing() const;
    void turnEffort(double notches);
    void sinkByEffort(double now_s);
    void tellDepth(bool isWithin, bool isDeeper);
    void judgePress(const servo::TickRecord& tick, TouchReading& reading);
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
    QTimer m_timer;
    servo::TickRecord m_tick;
    view::TouchState m_shown;
    std::int64_t m_shown_ns = 0;
    bool m_isPalpating = false;
    Effort m_effort;
    bool m_isByEffort = false;
    bool m_isByKeys = false;
    bool m_isPushed = false; ///< the press is a 6-axis mouse's
    bool m_isSlidOff = false;
    double m_pressed_mm = 0.0; ///< how far the hand is in, along the line of sight
    QString m_text;            ///< said last
};

} // namespace palpate::ui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

class QKeyEvent;

namespace palpate::ui {

class ActionList;
class PalpationController;
class VtkViewport;

/// Camera and pressing by keys, while the view has the focus: arrows turn the camera, with Shift they move it, + and −
/// zoom; Ctrl+arrows move the place that is pressed, Enter presses or lets go, Page down and up set the depth.
/// @par Thread The GUI's.
class ViewKeys : public QObject
{
    Q_OBJECT
  public:
    static constexpr double kTurn_deg = 15.0;
    static constexpr double kShift = 0.05; ///< of the view's height
    static constexpr double kZoom = 1.12;

    /// Both must outlive this.
    ViewKeys(VtkViewport& viewport, PalpationController& palpation, QObject* parent = nullptr);

    /// Puts what the keys do on the key card.
    static void describe(ActionList& actions);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    [[nodiscard]] bool handle(const QKeyEvent& key, bool isDone);
    [[nodiscard]] bool handleArrow(int right, int up, Qt::KeyboardModifiers modifiers, bool isDone);
    void moved();

    VtkViewport& m_viewport;
    PalpationController& m_palpation;
};

} // namespace palpate::ui

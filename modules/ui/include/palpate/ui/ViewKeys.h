// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <QObject>

class QKeyEvent;

namespace palpate::ui {

class ActionList;
class PalpationController;
class VtkViewport;

/// Keyboard control of camera and press while the view has the focus: arrows orbit, Shift+arrows pan, + and − zoom;
/// Ctrl+arrows move the hand, Enter presses or releases, Page Up and Page Down set the depth.
///
/// @par Thread GUI thread only.
class PALPATE_EXPORT ViewKeys : public QObject
{
    Q_OBJECT
  public:
    static constexpr double kTurn_deg = 15.0;
    static constexpr double kShift = 0.05; ///< fraction of the view's height
    static constexpr double kZoom = 1.12;

    /// Both references must outlive this object.
    ViewKeys(VtkViewport& viewport, PalpationController& palpation, QObject* parent = nullptr);

    /// Adds the keys to the key card.
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

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/ViewKeys.h"

#include "palpate/ui/ActionList.h"
#include "palpate/ui/PalpationController.h"
#include "palpate/ui/VtkViewport.h"

#include <QKeyEvent>

#include <vtkCamera.h>

namespace palpate::ui {

ViewKeys::ViewKeys(VtkViewport& viewport, PalpationController& palpation, QObject* parent)
    : QObject(parent)
    , m_viewport(viewport)
    , m_palpation(palpation)
{
    viewport.installEventFilter(this);
}

void ViewKeys::describe(ActionList& actions)
{
    const ActionGroup group = ActionGroup::InView;
    actions.addGesture(group, tr("← → ↑ ↓"), tr("rotate the camera by 15°; with Shift: pan"));
    actions.addGesture(group, tr("+  −"), tr("zoom"));
    actions.addGesture(group, tr("Ctrl+← → ↑ ↓"), tr("move the press point by 2 mm on screen"));
    actions.addGesture(group, tr("Enter"), tr("press, release"));
    actions.addGesture(group, tr("Page down  up"), tr("press 0.5 mm deeper, less deep"));
}

bool ViewKeys::eventFilter(QObject* /*watched*/, QEvent* event)
{
    // Accepting the override prevents window shortcuts with the same key while the view has the focus.
    if ((event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride) || !m_viewport.takesKeys()) {
        return false;
    }
    const bool isDone = event->type() == QEvent::KeyPress;
    if (!handle(static_cast<const QKeyEvent&>(*event), isDone)) {
        return false;
    }
    event->accept();
    return true;
}

/// Handles a key of the view. @param isDone  false: only checks whether the key belongs to the view
bool ViewKeys::handle(const QKeyEvent& key, bool isDone)
{
    const Qt::KeyboardModifiers modifiers = key.modifiers() & ~Qt::KeypadModifier;
    const auto zoom = [&](double factor) {
        if (isDone) {
            m_viewport.view().camera().Dolly(factor);
            moved();
        }
        return true;
    };
    switch (key.key()) {
    case Qt::Key_Left:
        return handleArrow(-1, 0, modifiers, isDone);
    case Qt::Key_Right:
        return handleArrow(1, 0, modifiers, isDone);
    case Qt::Key_Up:
        return handleArrow(0, 1, modifiers, isDone);
    case Qt::Key_Down:
        return handleArrow(0, -1, modifiers, isDone);
    case Qt::Key_Plus:
    case Qt::Key_Equal: // same key without Shift
        return !modifiers.testFlag(Qt::ControlModifier) && zoom(kZoom);
    case Qt::Key_Minus:
        return !modifiers.testFlag(Qt::ControlModifier) && zoom(1.0 / kZoom);
    case Qt::Key_PageDown:
    case Qt::Key_PageUp:
        if (modifiers != Qt::NoModifier) {
            return false;
        }
        if (isDone) {
            m_palpation.stepDepth(key.key() == Qt::Key_PageDown ? 1 : -1);
        }
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (modifiers != Qt::NoModifier) {
            return false;
        }
        if (isDone && !key.isAutoRepeat()) {
            m_palpation.togglePress();
        }
        return true;
    default:
        return false;
    }
}

bool ViewKeys::handleArrow(int right, int up, Qt::KeyboardModifiers modifiers, bool isDone)
{
    if (modifiers != Qt::NoModifier && modifiers != Qt::ShiftModifier && modifiers != Qt::ControlModifier) {
        return false;
    }
    if (!isDone) {
        return true;
    }
    vtkCamera& camera = m_viewport.view().camera();
    if (modifiers == Qt::ControlModifier) {
        m_palpation.stepAlongScreen(right, up);
    } else if (modifiers == Qt::ShiftModifier) {
        view::shift(camera, kShift * right, kShift * up);
        moved();
    } else {
        view::turn(camera, kTurn_deg * right, kTurn_deg * up);
        moved();
    }
    return true;
}

void ViewKeys::moved()
{
    m_viewport.update();
    m_palpation.followCamera();
}

} // namespace palpate::ui

#include "palpate/ui/moc_ViewKeys.cpp"

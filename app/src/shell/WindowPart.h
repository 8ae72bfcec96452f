// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

class QMainWindow;

namespace palpate::ui {
class ActionList;
class ChipRow;
class LiveTouch;
class StructureModel;
class VtkViewport;
} // namespace palpate::ui

namespace palpate::app {

class Docks;
class Notices;

/// Objects that all parts of the main window share. They outlive the parts.
struct WindowCore
{
    QMainWindow& window; ///< parent of parts and dialogs
    ui::ActionList& actions;
    ui::ChipRow& chips; ///< status chips of the tool bar
    ui::VtkViewport& viewport;
    ui::StructureModel& model; ///< the open scene
    ui::LiveTouch& live;
    Notices& notices;
};

/// State of the window that decides which commands are enabled.
struct WindowState
{
    bool hasScene = false; ///< also true if all structures were removed, because undo restores them
    bool hasRecording = false;
    bool isPlaying = false;
    bool isRecording = false;
};

/// Part of the main window: a panel or a group of commands, with everything that belongs to it. The constructor takes
/// the shared objects and the parts that this part uses, and connects to them. `MainWindow` then calls `addActions`
/// of all parts in the order of the menus, and `addPanel` of all parts in the order of the panels.
///
/// A part looks up commands by name in `ui::ActionList` and keeps no pointers to them. A part with a panel deletes the
/// panel in the destructor, because open editors in a panel write to the scene when they are closed.
///
/// @par Thread GUI thread only.
///
/// @par Example
/// @code
/// void ResultsPart::addActions()
/// {
///     connect(m_core.actions.add("measures", ui::ActionGroup::Session, tr("Results…"), tr("…"),
///                                {QKeySequence(Qt::Key_I)}),
///             &QAction::triggered, this, &ResultsPart::show);
/// }
///
/// void ResultsPart::showState(const WindowState& state)
/// {
///     m_core.actions.at("measures").setEnabled(state.hasRecording);
/// }
/// @endcode
class WindowPart : public QObject
{
    Q_OBJECT
  public:
    using QObject::QObject;

    /// Registers the commands and connects them. Called once.
    virtual void addActions() {}
    /// Adds the panel. Called once, after `addActions` of all parts.
    virtual void addPanel(Docks& /*docks*/) {}
    /// Enables commands and updates displays. Called after each `stateChanged` of any part.
    virtual void showState(const WindowState& /*state*/) {}

  Q_SIGNALS:
    /// Emitted when `WindowState` or the touching hand changed.
    void stateChanged();
};

} // namespace palpate::app

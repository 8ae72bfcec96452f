// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/Theme.h"

#include <palpate/core/Export.h>

#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QString>

#include <initializer_list>
#include <optional>
#include <vector>

class QAction;
class QMenu;
class QWidget;

namespace palpate::ui {

/// Menu of a command and its section on the key card, in the order of the key card.
enum class ActionGroup
{
    File,
    Edit,
    View,
    Directions, ///< submenu of View, as the groups up to Section
    TouchMap,
    Legend,
    Coordinates,
    Panels,
    Appearance,
    TextSize,
    Section,
    InView, ///< pointer and key gestures in the 3D view
    InList, ///< keys in the structure list
    Session,
    Device,
    Help
};

/// Registry of all commands of a window. Menus, tool bar, key card and tests read this list. Shortcuts also work while
/// the menus are hidden. Pointer and key gestures that are not commands are registered too, for the key card.
///
/// @par Thread GUI thread only.
///
/// @par Example
/// @code
/// auto* actions = new ActionList(window);
/// connect(actions->add("open", ActionGroup::File, tr("Open…"), tr("Open a mesh"),
///                      {QKeySequence(Qt::CTRL | Qt::Key_O)}),
///         &QAction::triggered, this, &Files::choose);
/// actions->fill(*window->menuBar()->addMenu(tr("File")), ActionGroup::File);
/// actions->at("open").setEnabled(false);
/// @endcode
class PALPATE_EXPORT ActionList : public QObject
{
    Q_OBJECT
  public:
    /// Line of the key card.
    struct KeyLine
    {
        ActionGroup group = ActionGroup::File;
        QString keys; ///< in the platform's notation
        QString does;
    };

    /// @param window  receives the actions and owns the list
    explicit ActionList(QWidget* window);

    /// Adds a command.
    /// @param id  unique, untranslated name for tests and settings
    /// @param keys  the first is shown in menus; an empty list means no shortcut
    /// @param tip  short description for the tool tip and the key card
    QAction* add(const char* id, ActionGroup group, const QString& text, const QString& tip,
                 const QList<QKeySequence>& keys = {});
    /// Adds a command with an icon for menu and tool bar.
    QAction* add(const char* id, ActionGroup group, const QString& text, const QString& tip,
                 const QList<QKeySequence>& keys, Symbol symbol);
    void addSeparator(ActionGroup group);
    /// Adds a submenu with the commands of another group, which `fill` makes.
    void addSubmenu(ActionGroup group, const QString& title, ActionGroup content);
    /// Adds a pointer or key gesture to the key card only.
    void addGesture(ActionGroup group, const QString& keys, const QString& does);

    /// Enables or disables shortcuts that consist of one letter, digit or sign without Ctrl or Alt. While disabled, the
    /// commands remain in the menus and the key card omits these shortcuts.
    void setLetterKeys(bool areOn);
    [[nodiscard]] bool hasLetterKeys() const noexcept { return m_hasLetterKeys; }

    /// Finds a command by its id, or returns nullptr.
    [[nodiscard]] QAction* find(const QString& id) const;
    /// Returns a command by its id; an unknown id ends the program.
    [[nodiscard]] QAction& at(const char* id) const;
    /// Enables or disables commands. @param ids  known ids
    void setEnabled(std::initializer_list<const char*> ids, bool areEnabled) const;
    /// Switches commands off, whatever else enables or checks them, until `release`. Checked ones are unchecked.
    /// @param ids  known ids; @param reason  for the tool tip
    void withhold(std::initializer_list<const char*> ids, const QString& reason);
    /// Returns the withheld commands, enabled; the caller has their state set again.
    void release();
    [[nodiscard]] bool isWithheld(const char* id) const;
    /// All commands in the order of registration.
    [[nodiscard]] std::vector<QAction*> all() const;
    /// Adds a group's commands, separators and submenus to a menu.
    void fill(QMenu& menu, ActionGroup group) const;
    /// Submenu with the commands of a group, in a filled menu. Returns nullptr if there is none.
    [[nodiscard]] QMenu* submenuOf(const QMenu& menu, ActionGroup content) const;
    /// Content of the key card: gestures and every command with a shortcut, by group, each in the order of
    /// registration.
    [[nodiscard]] std::vector<KeyLine> keyLines() const;

  private:
    struct Entry
    {
        ActionGroup group = ActionGroup::File;
        QAction* action = nullptr; // empty name: separator
        QString keys;              // gesture only; gestures have no action
        QString does;
        QList<QKeySequence> keysOfAll{};      // including single-letter shortcuts
        std::optional<ActionGroup> content{}; // submenu, whose title is `does`
    };
    void takeKeys(const Entry& entry);
    void keepWithheld(QAction& action);

    QWidget* m_window = nullptr;
    std::vector<Entry> m_entries;
    std::vector<QAction*> m_withheld;
    QString m_reason; ///< of the withheld commands
    bool m_hasLetterKeys = true;
};

} // namespace palpate::ui

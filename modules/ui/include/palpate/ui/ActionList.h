// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/Theme.h"

#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QString>

#include <vector>

class QAction;
class QMenu;
class QWidget;

namespace palpate::ui {

/// What a command is about: the menu that it stands in, and its part of the key card.
enum class ActionGroup
{
    File,
    Edit,
    View,
    Appearance, ///< in the menu View
    TextSize,   ///< in the menu View
    Session,
    Device,
    Help,
    InView, ///< what pointer and keys do in the view
    InList  ///< what keys do in the list of structures
};

/// Every command of a window, once: menus, tool bar, key card and tests read this list. Keys work with menus hidden
/// too. What pointer and keys do without being a command stands here as well, for the key card.
/// @par Thread The GUI's.
class ActionList : public QObject
{
    Q_OBJECT
  public:
    /// A line of the key card.
    struct KeyLine
    {
        ActionGroup group = ActionGroup::File;
        QString keys; ///< in the system's words
        QString does;
    };

    /// @param window  gets the commands, and owns the list
    explicit ActionList(QWidget* window);

    /// @param id    for tests and settings; unique, not translated
    /// @param keys  the first is shown in menus; none: the command has no key
    /// @param tip   what it does, in a few words: tool tip and key card
    QAction* add(const char* id, ActionGroup group, const QString& text, const QString& tip,
                 const QList<QKeySequence>& keys = {});
    /// The same with a symbol for menu and tool bar.
    QAction* add(const char* id, ActionGroup group, const QString& text, const QString& tip,
                 const QList<QKeySequence>& keys, Symbol symbol);
    void addSeparator(ActionGroup group);
    /// What is done by pointer or keys in a part of the window, in words: for the key card alone.
    void addGesture(ActionGroup group, const QString& keys, const QString& does);

    /// Whether commands may have keys of one letter, digit or sign, without Ctrl or Alt. Off, they are reached by menu
    /// and the key card doesn't show those keys.
    void setLetterKeys(bool areOn);

    /// @return nothing when there is no such command
    [[nodiscard]] QAction* find(const QString& id) const;
    /// All commands, in the order in which they were added.
    [[nodiscard]] std::vector<QAction*> all() const;
    /// Puts a group's commands and separators into a menu.
    void fill(QMenu& menu, ActionGroup group) const;
    /// What the key card shows: gestures, and every command with a key.
    [[nodiscard]] std::vector<KeyLine> keyLines() const;

  private:
    struct Entry
    {
        ActionGroup group = ActionGroup::File;
        QAction* action = nullptr; // a separator has no name
        QString keys;              // of a gesture, which has no action
        QString does;
        QList<QKeySequence> keysOfAll{}; // with those of one letter
    };
    void takeKeys(const Entry& entry);

    QWidget* m_window = nullptr;
    std::vector<Entry> m_entries;
    bool m_hasLetterKeys = true;
};

} // namespace palpate::ui

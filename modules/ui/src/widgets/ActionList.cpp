// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/ActionList.h"

#include <QAction>
#include <QKeyCombination>
#include <QMenu>
#include <QStringList>
#include <QWidget>

#include <algorithm>
#include <utility>

namespace palpate::ui {

namespace {

/// True for shortcuts that type a character: a letter, a digit or "?". Esc, Home and F1 type none of these.
bool isLetterKey(const QKeySequence& key)
{
    const QKeyCombination combination = key[0];
    constexpr int kFirstWithoutSign = 0x01000000; // Qt::Key_Escape; smaller codes are characters
    return key.count() == 1 && combination.key() < kFirstWithoutSign &&
           (combination.keyboardModifiers() & ~Qt::ShiftModifier) == Qt::NoModifier;
}

} // namespace

ActionList::ActionList(QWidget* window)
    : QObject(window)
    , m_window(window)
{
}

QAction* ActionList::add(const char* id, ActionGroup group, const QString& text, const QString& tip,
                         const QList<QKeySequence>& keys)
{
    auto* action = new QAction(text, m_window);
    action->setObjectName(QLatin1String(id));
    m_window->addAction(action); // makes the shortcut work while the menus are hidden
    m_entries.push_back({group, action, {}, tip, keys});
    takeKeys(m_entries.back());
    return action;
}

QAction* ActionList::add(const char* id, ActionGroup group, const QString& text, const QString& tip,
                         const QList<QKeySequence>& keys, Symbol symbol)
{
    QAction* action = add(id, group, text, tip, keys);
    action->setIcon(icon(symbol));
    return action;
}

void ActionList::addSeparator(ActionGroup group)
{
    auto* line = new QAction(m_window);
    line->setSeparator(true);
    m_entries.push_back({group, line, {}, {}});
}

void ActionList::addSubmenu(ActionGroup group, const QString& title, ActionGroup content)
{
    m_entries.push_back({group, nullptr, {}, title, {}, content});
}

void ActionList::addGesture(ActionGroup group, const QString& keys, const QString& does)
{
    m_entries.push_back({group, nullptr, keys, does});
}

void ActionList::takeKeys(const Entry& entry)
{
    QList<QKeySequence> keys = entry.keysOfAll;
    if (!m_hasLetterKeys) {
        keys.removeIf(isLetterKey);
    }
    entry.action->setShortcuts(keys);
    if (std::find(m_withheld.begin(), m_withheld.end(), entry.action) != m_withheld.end()) {
        entry.action->setToolTip(m_reason);
        return;
    }
    entry.action->setToolTip(keys.isEmpty()
                                 ? entry.does
                                 : tr("%1 (%2)").arg(entry.does, keys.constFirst().toString(QKeySequence::NativeText)));
}

void ActionList::setLetterKeys(bool areOn)
{
    m_hasLetterKeys = areOn;
    for (const Entry& entry : m_entries) {
        if (!entry.keysOfAll.isEmpty()) {
            takeKeys(entry);
        }
    }
}

QAction* ActionList::find(const QString& id) const
{
    for (QAction* action : all()) {
        if (action->objectName() == id) {
            return action;
        }
    }
    return nullptr;
}

QAction& ActionList::at(const char* id) const
{
    QAction* action = find(QLatin1String(id));
    if (action == nullptr) {
        qFatal("no command \"%s\"", id);
    }
    return *action;
}

void ActionList::setEnabled(std::initializer_list<const char*> ids, bool areEnabled) const
{
    for (const char* id : ids) {
        at(id).setEnabled(areEnabled);
    }
}

void ActionList::withhold(std::initializer_list<const char*> ids, const QString& reason)
{
    release();
    m_reason = reason;
    for (const char* id : ids) {
        QAction* action = &at(id);
        m_withheld.push_back(action);
        action->setToolTip(reason);
        connect(action, &QAction::enabledChanged, this, [this, action] { keepWithheld(*action); });
        connect(action, &QAction::toggled, this, [this, action] { keepWithheld(*action); });
        keepWithheld(*action);
    }
}

void ActionList::keepWithheld(QAction& action)
{
    action.setChecked(false);
    action.setEnabled(false);
}

void ActionList::release()
{
    for (QAction* action : std::exchange(m_withheld, {})) {
        action->disconnect(this);
        action->setEnabled(true);
    }
    for (const Entry& entry : m_entries) {
        if (entry.action != nullptr && !entry.action->isSeparator()) {
            takeKeys(entry);
        }
    }
}

bool ActionList::isWithheld(const char* id) const
{
    return std::find(m_withheld.begin(), m_withheld.end(), find(QLatin1String(id))) != m_withheld.end();
}

std::vector<QAction*> ActionList::all() const
{
    std::vector<QAction*> actions;
    for (const Entry& entry : m_entries) {
        if (entry.action != nullptr && !entry.action->isSeparator()) {
            actions.push_back(entry.action);
        }
    }
    return actions;
}

void ActionList::fill(QMenu& menu, ActionGroup group) const
{
    for (const Entry& entry : m_entries) {
        if (entry.group != group) {
            continue;
        }
        if (entry.content) {
            fill(*menu.addMenu(entry.does), *entry.content);
        } else if (entry.action != nullptr) {
            menu.addAction(entry.action);
        }
    }
}

QMenu* ActionList::submenuOf(const QMenu& menu, ActionGroup content) const
{
    const auto entry =
        std::find_if(m_entries.begin(), m_entries.end(), [&](const Entry& one) { return one.content == content; });
    for (QAction* action : menu.actions()) {
        if (entry != m_entries.end() && action->menu() != nullptr && action->text() == entry->does) {
            return action->menu();
        }
    }
    return nullptr;
}

std::vector<ActionList::KeyLine> ActionList::keyLines() const
{
    std::vector<KeyLine> lines;
    for (const Entry& entry : m_entries) {
        QStringList keys;
        if (entry.content) {
            continue;
        }
        if (entry.action != nullptr) {
            for (const QKeySequence& key : entry.action->shortcuts()) {
                keys << key.toString(QKeySequence::NativeText);
            }
        } else {
            keys << entry.keys;
        }
        if (!keys.isEmpty()) {
            lines.push_back({entry.group, keys.join(QStringLiteral("  ")), entry.does});
        }
    }
    std::stable_sort(lines.begin(), lines.end(),
                     [](const KeyLine& first, const KeyLine& second) { return first.group < second.group; });
    return lines;
}

} // namespace palpate::ui

#include "palpate/ui/moc_ActionList.cpp"

// SPDX-License-Identifier: BSD-3-Clause
#include "shell/ViewPart.h"

#include "shell/Notices.h"
#include "shell/SoundChoice.h"

#include <palpate/ui/ActionList.h>
#include <palpate/ui/TouchPanel.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QMainWindow>
#include <QSettings>

namespace palpate::app {

using ui::ActionGroup;

namespace {

constexpr auto kDentKey = "view/dent";

} // namespace

ViewPart::ViewPart(const WindowCore& core, const ui::TouchPanel& touch)
    : WindowPart(&core.window)
    , m_core(core)
    , m_touch(touch)
{
}

void ViewPart::addActions()
{
    ui::ActionList& actions = m_core.actions;
    QAction* dent = actions.add("dent", ActionGroup::View, tr("Dent under the finger"),
                                tr("Draw soft tissue deformed at the contact, with a fine grid"));
    dent->setCheckable(true);
    dent->setChecked(QSettings().value(QLatin1String(kDentKey), true).toBool());
    m_core.viewport.view().setBending(dent->isChecked());
    connect(dent, &QAction::toggled, this, [this](bool isOn) {
        m_core.viewport.view().setBending(isOn);
        m_core.viewport.update();
        QSettings().setValue(QLatin1String(kDentKey), isOn);
    });
    m_sound = new SoundChoice(actions, this);
    m_sound->follow(m_touch);
    connect(m_sound, &SoundChoice::said, this, [this](const QString& line) { m_core.notices.say(line); });
    actions.addSeparator(ActionGroup::View);
    addDirections();
}

void ViewPart::addDirections()
{
    const auto add = [this](const char* id, const QString& text, const QKeySequence& key, view::ViewFrom from) {
        connect(m_core.actions.add(id, ActionGroup::Directions, text, text, {key}), &QAction::triggered, this,
                [this, from] {
                    m_core.viewport.view().look(from);
                    m_core.viewport.update();
                });
    };
    add("view-front", tr("From the front (A)"), Qt::Key_1, view::ViewFrom::Front);
    add("view-back", tr("From the back (P)"), Qt::CTRL | Qt::Key_1, view::ViewFrom::Back);
    add("view-left", tr("From the left (L)"), Qt::Key_3, view::ViewFrom::Left);
    add("view-right", tr("From the right (R)"), Qt::CTRL | Qt::Key_3, view::ViewFrom::Right);
    add("view-head", tr("From the head (S)"), Qt::Key_7, view::ViewFrom::Head);
    add("view-feet", tr("From the feet (I)"), Qt::CTRL | Qt::Key_7, view::ViewFrom::Feet);
    add("view-oblique", tr("Oblique"), Qt::Key_0, view::ViewFrom::Oblique);
}

} // namespace palpate::app

#include "moc_ViewPart.cpp"

// SPDX-License-Identifier: BSD-3-Clause
#include "shell/HelpPart.h"

#include "shell/Help.h"
#include "shell/Notices.h"
#include "shell/ShowAround.h"

#include <palpate/ui/ActionList.h>
#include <palpate/ui/Pieces.h>
#include <palpate/ui/Tour.h>
#include <palpate/ui/TypeAhead.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QMainWindow>
#include <QSettings>

namespace palpate::app {

using ui::ActionGroup;

namespace {

constexpr auto kLetterKeysKey = "keys/letters";

} // namespace

HelpPart::HelpPart(const WindowCore& core)
    : WindowPart(&core.window)
    , m_core(core)
    , m_keys(new ui::KeysCard(core.actions, &core.window))
{
    new ui::TypeAhead(&core.window);
}

void HelpPart::addActions()
{
    ui::ActionList& actions = m_core.actions;
    addLetterKeys();
    // "?" on all keyboard layouts, with F1 as alternative.
    connect(actions.add("keys", ActionGroup::Help, tr("All keys"), tr("Show all keys"),
                        {QKeySequence(QStringLiteral("?")), QKeySequence(Qt::SHIFT | Qt::Key_Question),
                         QKeySequence(Qt::Key_F1)},
                        ui::Symbol::Keys),
            &QAction::triggered, m_keys, &ui::KeysCard::toggle);
    m_around = new ShowAround(&m_core.window, actions, &m_core.viewport);
    auto* help = new Help(&m_core.window, actions);
    connect(help, &Help::said, this, [this](const QString& line) { m_core.notices.say(line); });
}

void HelpPart::addLetterKeys()
{
    ui::ActionList& actions = m_core.actions;
    actions.addSeparator(ActionGroup::Edit);
    QAction* letters = actions.add(
        "letter-keys", ActionGroup::Edit, tr("Single-letter keys"),
        tr("Run commands by single letters. Turn this off for speech input, or if keys are pressed by accident"));
    letters->setCheckable(true);
    connect(letters, &QAction::toggled, this, [&actions](bool isOn) {
        actions.setLetterKeys(isOn);
        QSettings().setValue(QLatin1String(kLetterKeysKey), isOn);
    });
    letters->setChecked(QSettings().value(QLatin1String(kLetterKeysKey), true).toBool());
}

bool HelpPart::closeOverlay()
{
    if (m_keys->isVisible()) {
        m_keys->hide();
        return true;
    }
    return m_around->tour().end();
}

} // namespace palpate::app

#include "moc_HelpPart.cpp"

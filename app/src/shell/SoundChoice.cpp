// SPDX-License-Identifier: BSD-3-Clause
#include "shell/SoundChoice.h"

#include <palpate/ui/ActionList.h>
#include <palpate/ui/TouchPanel.h>

#include <QAction>
#include <QMenu>
#include <QSignalBlocker>

namespace palpate::app {

using namespace palpate::ui;

SoundChoice::SoundChoice(ActionList& actions, QObject* parent)
    : QObject(parent)
    , m_action(actions.add("sound", ActionGroup::View, tr("Touch sound"),
                           tr("Play a tone: higher pitch for stiffer tissue, louder for more force")))
{
    m_action->setCheckable(true);
    connect(m_action, &QAction::toggled, this, &SoundChoice::setOn);
    connect(&m_sound, &TouchSound::ended, this, [this] {
        m_action->setChecked(false);
        Q_EMIT said(tr("Touch sound stopped: the loudspeaker was disconnected."));
    });
}

void SoundChoice::follow(const TouchPanel& touch)
{
    connect(&touch, &TouchPanel::changed, this, [this, &touch] {
        const TouchReading& reading = touch.reading();
        m_sound.setTouch(reading.stiffnessRatio, reading.force_N, touch.forceLimit_N());
    });
}

void SoundChoice::watch(const QMenu& menu)
{
    connect(&menu, &QMenu::aboutToShow, this,
            [this] { offer(m_action->isChecked() ? QString() : TouchSound::whyNot()); });
}

void SoundChoice::setOn(bool isOn)
{
    if (m_sound.setOn(isOn) == isOn) {
        return;
    }
    const QSignalBlocker blocker(m_action);
    m_action->setChecked(false);
    offer(TouchSound::whyNot());
    Q_EMIT said(m_action->text());
}

void SoundChoice::offer(const QString& whyNot)
{
    m_action->setEnabled(whyNot.isEmpty());
    m_action->setText(whyNot.isEmpty() ? tr("Touch sound") : tr("Touch sound (%1)").arg(whyNot));
}

} // namespace palpate::app

#include "moc_SoundChoice.cpp"

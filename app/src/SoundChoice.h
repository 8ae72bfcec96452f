// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/ui/TouchSound.h>

#include <QObject>

class QAction;
class QMenu;

namespace palpate::ui {
class ActionList;
class TouchPanel;
} // namespace palpate::ui

namespace palpate::app {

/// The command *Sound of touch*: what the touch panel shows is heard too, live and in playback. Off at each start:
/// no one is startled.
class SoundChoice : public QObject
{
    Q_OBJECT
  public:
    SoundChoice(ui::ActionList& actions, QObject* parent);

    /// Lets the sound follow a panel.
    void follow(const ui::TouchPanel& touch);
    /// Greys the command when a menu with it opens and nothing can be heard here; its text then says why.
    void watch(const QMenu& menu);

  Q_SIGNALS:
    void said(const QString& line);

  private:
    void setOn(bool isOn);
    void offer(const QString& whyNot);

    QAction* m_action = nullptr;
    ui::TouchSound m_sound;
};

} // namespace palpate::app

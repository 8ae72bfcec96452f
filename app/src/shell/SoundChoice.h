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

/// Command *Sound of touch*: sonifies the values of the touch panel, live and in playback. Off at each start, so that
/// the sound never surprises the user.
class SoundChoice : public QObject
{
    Q_OBJECT
  public:
    SoundChoice(ui::ActionList& actions, QObject* parent);

    /// Connects the sound to a touch panel.
    void follow(const ui::TouchPanel& touch);
    /// Disables the command when its menu opens and no sound output is available; the text then shows the reason.
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

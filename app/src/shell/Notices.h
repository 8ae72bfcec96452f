// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

#include <palpate/ui/HintLine.h>
#include <palpate/ui/MessageBar.h>
#include <palpate/ui/Messages.h>

#include <QStringList>

#include <functional>

class QDockWidget;

namespace palpate::app {

class Docks;

/// Messages of the window: the newest in the status line, errors and offers over the view, all in a list.
class Notices : public WindowPart
{
    Q_OBJECT
  public:
    Notices(QMainWindow& window, ui::ActionList& actions, ui::VtkViewport& viewport);
    void addActions() override;
    void addPanel(Docks& docks) override;

    /// Shows a message in the status line. @param duration_ms  until the line is cleared
    void say(const QString& text, int duration_ms = 8000);
    /// Shows an error over the view until closed.
    void showError(const QString& line) { m_bar->showError(line); }
    /// Adds warnings to the list.
    void warn(const QStringList& lines);
    /// Removes all messages whose text matches, from the list, the view and the status line.
    void forgetIf(const std::function<bool(const QString& text)>& matches);
    /// Open offers and questions over the view.
    [[nodiscard]] ui::MessageBar& bar() noexcept { return *m_bar; }
    /// Status line.
    [[nodiscard]] ui::HintLine& hint() noexcept { return *m_hint; }

  private:
    void toggleList();

    ui::ActionList& m_actions;
    ui::VtkViewport& m_viewport;
    ui::Messages m_messages;
    ui::MessageBar* m_bar = nullptr;
    ui::HintLine* m_hint = nullptr;
    Docks* m_docks = nullptr;
    QDockWidget* m_dock = nullptr;
};

} // namespace palpate::app

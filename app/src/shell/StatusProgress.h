// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

class QProgressBar;
class QStatusBar;
class QToolButton;

namespace palpate::ui {
class HintLine;
}

namespace palpate::app {

/// Progress of a computation in the status bar, with a button that cancels it.
class StatusProgress : public QObject
{
    Q_OBJECT
  public:
    /// Adds bar and button to the status bar. @param hint  shows the current step
    StatusProgress(QStatusBar& bar, ui::HintLine& hint, QObject* parent);

    /// Shows the current step and the completed part. @param share  0 to 1
    void show(const QString& step, double share);
    /// Shows that a computation of unknown duration is running.
    void showBusy();
    void hide();
    /// Hides the progress and clears the line with the current step.
    void end();
    [[nodiscard]] bool isVisible() const;

  Q_SIGNALS:
    void cancelled();

  private:
    ui::HintLine& m_hint;
    QProgressBar* m_bar = nullptr;
    QToolButton* m_cancel = nullptr;
};

} // namespace palpate::app

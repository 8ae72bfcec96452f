// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

class QWidget;

namespace palpate::ui {
class ActionList;
}

namespace palpate::app {

/// Commands of the Help menu that do not depend on the window: documents and version information.
class Help : public QObject
{
    Q_OBJECT
  public:
    /// Makes the commands. @param window  parent of dialogs; owns this
    Help(QWidget* window, ui::ActionList& actions);

    /// Version information for bug reports: versions of the program and its libraries, one per line.
    [[nodiscard]] static QString versions();

  Q_SIGNALS:
    /// Message for the window's status line.
    void said(const QString& line);

  private:
    void openDocuments();
    void showAbout();
    QWidget* m_window = nullptr;
};

} // namespace palpate::app

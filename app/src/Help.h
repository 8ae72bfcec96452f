// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

class QWidget;

namespace palpate::ui {
class ActionList;
}

namespace palpate::app {

/// The commands of the Help menu that need nothing of the window: documents, and what this program is.
class Help : public QObject
{
    Q_OBJECT
  public:
    /// @param window  parent of what opens; owns this
    Help(QWidget* window, ui::ActionList& actions);

    /// What a report of a fault should begin with: versions of the program and of what it is made with, a line each.
    [[nodiscard]] static QString versions();

  Q_SIGNALS:
    /// Something to say in the window's line.
    void said(const QString& line);

  private:
    void openDocuments();
    void showAbout();
    QWidget* m_window = nullptr;
};

} // namespace palpate::app

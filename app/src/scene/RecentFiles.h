// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

#include <filesystem>

class QMenu;

namespace palpate::ui {
class WelcomePage;
}

namespace palpate::app {

/// Files that were opened last, in a menu and on the welcome page. Kept in the settings.
class RecentFiles : public QObject
{
    Q_OBJECT
  public:
    /// Both references must outlive this object.
    RecentFiles(QMenu& menu, ui::WelcomePage& page, QObject* parent);

    /// Puts a file at the top of the list.
    void add(const std::filesystem::path& file);
    /// Shows the files that exist.
    void refresh();

  Q_SIGNALS:
    /// The user chose a file of the menu.
    void chosen(const std::filesystem::path& file);

  private:
    QMenu& m_menu;
    ui::WelcomePage& m_page;
};

} // namespace palpate::app

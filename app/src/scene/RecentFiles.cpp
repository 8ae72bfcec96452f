// SPDX-License-Identifier: BSD-3-Clause
#include "scene/RecentFiles.h"

#include "shared/Paths.h"
#include "shared/ProgramFolders.h"

#include <palpate/ui/Pieces.h>

#include <QAction>
#include <QFileInfo>
#include <QMenu>
#include <QSettings>

namespace palpate::app {

namespace {

constexpr int kMaxRecentFiles = 12;

QString recentKey()
{
    return QStringLiteral("recent");
}

} // namespace

RecentFiles::RecentFiles(QMenu& menu, ui::WelcomePage& page, QObject* parent)
    : QObject(parent)
    , m_menu(menu)
    , m_page(page)
{
}

void RecentFiles::add(const std::filesystem::path& file)
{
    const QString path = QFileInfo(toText(file)).absoluteFilePath();
    QSettings settings;
    QStringList recent = settings.value(recentKey()).toStringList();
    recent.removeAll(path);
    recent.prepend(path);
    settings.setValue(recentKey(), recent.mid(0, kMaxRecentFiles));
    refresh();
}

void RecentFiles::refresh()
{
    QStringList recent;
    for (const QString& path : QSettings().value(recentKey()).toStringList()) {
        if (QFileInfo::exists(path)) {
            recent << path;
        }
    }
    m_page.setChoices(phantomFolder().has_value(), recent);
    m_menu.clear();
    m_menu.setEnabled(!recent.isEmpty());
    for (const QString& path : recent) {
        m_menu.addAction(QFileInfo(path).fileName(), this, [this, path] { Q_EMIT chosen(toPath(path)); })
            ->setToolTip(path);
    }
}

} // namespace palpate::app

#include "moc_RecentFiles.cpp"

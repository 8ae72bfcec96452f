// SPDX-License-Identifier: BSD-3-Clause
#include "shell/Help.h"

#include "shared/BuiltWith.h"
#include "shared/Paths.h"
#include "shared/ProgramFolders.h"
#include "shared/QtSetup.h"

#include <palpate/session/Recording.h>
#include <palpate/ui/ActionList.h>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDesktopServices>
#include <QMessageBox>
#include <QPushButton>
#include <QSize>
#include <QSysInfo>
#include <QUrl>

#include <sqlite3.h>
#include <vtkVersion.h>

namespace palpate::app {

Help::Help(QWidget* window, ui::ActionList& actions)
    : QObject(window)
    , m_window(window)
{
    connect(actions.add("documents", ui::ActionGroup::Help, tr("Documentation"),
                        tr("Open the documentation folder: keys, recordings, measures, glossary, devices")),
            &QAction::triggered, this, &Help::openDocuments);
    connect(actions.add("about", ui::ActionGroup::Help, tr("About Palpate"),
                        tr("Version, build and licences, for bug reports")),
            &QAction::triggered, this, &Help::showAbout);
}

QString Help::versions()
{
    return QStringList{
        QStringLiteral("Palpate %1").arg(QString::fromStdString(session::palpateVersion())),
        QStringLiteral("Build %1").arg(QString::fromStdString(session::buildId())),
        QStringLiteral("Qt %1, VTK %2, SQLite %3, Eigen %4")
            .arg(QLatin1String(qVersion()), QLatin1String(vtkVersion::GetVTKVersion()),
                 QLatin1String(sqlite3_libversion()), QLatin1String(kEigenVersion)),
        QStringLiteral("%1, %2, display %3")
            .arg(QSysInfo::prettyProductName(), QSysInfo::currentCpuArchitecture(), QGuiApplication::platformName()),
    }
        .join(QLatin1Char('\n'));
}

void Help::openDocuments()
{
    const auto folder = docsFolder();
    if (!folder) {
        Q_EMIT said(tr("The documentation was not found next to the program."));
    } else if (!QDesktopServices::openUrl(QUrl::fromLocalFile(toText(*folder)))) {
        Q_EMIT said(tr("No file manager was found. The documentation is in %1").arg(toText(*folder)));
    }
}

void Help::showAbout()
{
    QMessageBox box(m_window);
    box.setObjectName(QStringLiteral("about"));
    box.setWindowTitle(tr("About Palpate"));
    box.setIconPixmap(programIcon().pixmap(QSize(64, 64), m_window->devicePixelRatioF()));
    box.setTextFormat(Qt::PlainText);
    box.setText(versions());
    box.setInformativeText(
        tr("Research, training and planning rehearsal. Not a medical device.\n"
           "\n"
           "Palpate is free software under the BSD 3-Clause licence, built with Qt (LGPL 3), VTK (BSD 3-Clause), Eigen "
           "(MPL 2.0), SQLite (public domain), hidapi (BSD) and CLI11 (BSD 3-Clause)."));
    box.setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    QPushButton* copy = box.addButton(tr("Copy for a bug report"), QMessageBox::ActionRole);
    box.addButton(QMessageBox::Close);
    copy->disconnect(); // copying must not close the box
    connect(copy, &QPushButton::clicked, &box, [this] {
        QApplication::clipboard()->setText(versions());
        Q_EMIT said(tr("Copied: version, build and system."));
    });
    box.exec();
}

} // namespace palpate::app

#include "moc_Help.cpp"

// SPDX-License-Identifier: BSD-3-Clause
// Findings: commands, panel, import and export.
#include "window/MainWindow.h"
#include "shared/Paths.h"

#include <QDockWidget>
#include <QFileDialog>
#include <QSettings>

using namespace palpate;
using namespace palpate::ui;

void MainWindow::connectFindings()
{
    connect(m_findingAction, &QAction::triggered, m_findingsDesk, &FindingsDesk::mark);
    connect(m_findingNoteAction, &QAction::triggered, this, [this] {
        if (m_findingsDesk->mark()) {
            raiseFindings();
            m_findings->editNote(m_findings->current());
        }
    });
    connect(m_noteAction, &QAction::triggered, this, [this] {
        raiseFindings();
        m_findings->startNote();
    });
    connect(m_nextFindingAction, &QAction::triggered, this, [this] { m_findingsDesk->step(1); });
    connect(m_previousFindingAction, &QAction::triggered, this, [this] { m_findingsDesk->step(-1); });
    connect(m_exportFindingsAction, &QAction::triggered, this, &MainWindow::exportFindings);
    connect(m_importFindingsAction, &QAction::triggered, this, &MainWindow::importFindings);
    connect(m_showFindingsAction, &QAction::toggled, this, [this](bool isOn) {
        m_viewport->view().findings().setVisible(isOn);
        m_viewport->update();
    });
    connect(m_findingsDesk, &FindingsDesk::said, this, [this](const QString& line) { say(line); });
    connect(m_findingsDesk, &FindingsDesk::failed, this, &MainWindow::showError);
    connect(m_findingsDesk, &FindingsDesk::recordingWanted, this, &MainWindow::openRecording);
    connect(m_findingsDesk, &FindingsDesk::countChanged, this, [this](std::size_t count) {
        m_showFindingsAction->setEnabled(count > 0);
        m_exportFindingsAction->setEnabled(!m_document->findings().empty());
        std::vector<core::Vec3> places;
        for (const view::FindingMark& mark : m_viewport->view().findings().marks()) {
            places.push_back(mark.p_W);
        }
        m_handControl->setFindings(std::move(places));
    });
    m_exportFindingsAction->setEnabled(false);
}

/// Shows the panel if closed and raises its tab.
void MainWindow::raiseFindings()
{
    for (QDockWidget* dock : m_docks) {
        if (dock->isAncestorOf(m_findings)) {
            dock->show();
            dock->raise();
        }
    }
}

void MainWindow::exportFindings()
{
    const QString markups = tr("3D Slicer markups (*.mrk.json)");
    const QString table = tr("Table (*.csv)");
    const std::filesystem::path scene = m_document->file();
    const QString folder =
        scene.empty() ? QSettings().value(QStringLiteral("folder")).toString() : toText(scene.parent_path());
    QString kind = markups;
    QString chosen =
        QFileDialog::getSaveFileName(this, tr("Export findings"), folder + QStringLiteral("/findings.mrk.json"),
                                     markups + QStringLiteral(";;") + table, &kind);
    if (chosen.isEmpty()) {
        return;
    }
    if (!chosen.endsWith(QLatin1String(".csv")) && !chosen.endsWith(QLatin1String(".json"))) {
        chosen += kind == table ? QStringLiteral(".csv") : QStringLiteral(".mrk.json");
    }
    m_findingsDesk->exportTo(toPath(chosen));
}

void MainWindow::importFindings()
{
    const QString chosen = QFileDialog::getOpenFileName(this, tr("Import findings"),
                                                        QSettings().value(QStringLiteral("folder")).toString(),
                                                        tr("3D Slicer markups (*.mrk.json *.json);;All files (*)"));
    if (!chosen.isEmpty()) {
        m_findingsDesk->importFrom(toPath(chosen));
    }
}

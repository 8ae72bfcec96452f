// SPDX-License-Identifier: BSD-3-Clause
// Recording, playing, marking and measuring.
#include "MainWindow.h"
#include "MeasuresDialog.h"
#include "Paths.h"

#include <QInputDialog>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>

#include <algorithm>
#include <utility>

using namespace palpate;
using namespace palpate::ui;

void MainWindow::toggleRecording()
{
    if (m_recording->isOn()) {
        const core::Status stopped = m_recording->stop();
        m_recordAction->setChecked(false);
        if (!m_recording->hasFailed()) {
            const bool wasPalpating = m_palpation->isPalpating();
            openRecording(m_recording->path());
            setPalpating(wasPalpating);
            m_message->offer(stopped.isOk() ? tr("Recorded to %1").arg(toText(m_recording->path()))
                                            : QString::fromStdString(stopped.message()),
                             tr("Results…"), [this] { showMeasures(); });
        }
    } else {
        m_playback->setRecording(nullptr);
        const core::Status started = m_recording->start(m_files.size() == 1 ? m_files.front() : std::filesystem::path(),
                                                        m_embedAction->isChecked());
        m_recordAction->setChecked(started.isOk());
        if (!started.isOk()) {
            showError(QString::fromStdString(started.message()));
        } else {
            m_touch->clearHistory();
            m_session->showTitle(tr("Recording %1").arg(toText(m_recording->path().filename())));
            setPalpating(true);
        }
    }
    showStatus();
    showWhatPlays();
}

void MainWindow::togglePlaying()
{
    if (m_playback->isPlaying()) {
        m_playback->pause();
    } else {
        m_palpateAction->setChecked(false);
        m_playback->play();
    }
}

void MainWindow::showMeasures()
{
    if (m_playback->recording() == nullptr) {
        return;
    }
    session::MeshesByHash meshes;
    for (const StructureRow& row : m_model.rows()) {
        if (!row.sha256.empty()) {
            meshes[row.sha256] = row.loaded.surface;
        }
    }
    auto* dialog = new MeasuresDialog(m_playback->recording()->path(), std::move(meshes), this);
    dialog->show();
}

/// Marks the place that is touched, by the hand or in the recording that plays.
void MainWindow::markFinding()
{
    const view::TouchState& touch = m_viewport->view().cursor().state();
    if (!touch.isInContact) {
        say(tr("Nothing is touched: press on the place first, then mark it (M)."));
        return;
    }
    core::Finding finding;
    finding.name = tr("Finding %1").arg(m_document->findings().size() + 1).toStdString();
    const TouchReading& felt = m_touch->reading();
    finding.structure = felt.structure.toStdString();
    finding.p_W = touch.p_WG;
    finding.force_N = touch.f_W.norm();
    finding.depth_mm = (touch.p_WG - touch.p_WH).norm();
    for (const FeltLayer& layer : felt.layers) {
        if (felt.layers.size() > 1) {
            finding.layers.push_back({layer.name.toStdString(), layer.force_N, layer.depth_mm});
        }
    }
    m_document->addFinding(finding);
    say(felt.layers.size() > 1 ? tr("%1 marked: %2").arg(QString::fromStdString(finding.name), layersText(felt.layers))
                               : tr("%1 marked on %2 with %3 N")
                                     .arg(QString::fromStdString(finding.name), felt.structure,
                                          QLocale().toString(*finding.force_N, 'f', 2)));
}

/// Where findings are, in the view and for fitting a lump to the device.
void MainWindow::showFindings()
{
    std::vector<core::Vec3> places;
    for (const core::Finding& finding : m_document->findings()) {
        places.push_back(finding.p_W);
    }
    if (m_playback->recording() != nullptr) { // its own are drawn too, where the scene has them not
        for (const core::Finding& finding : m_playback->recording()->findings()) {
            if (std::find(places.begin(), places.end(), finding.p_W) == places.end()) {
                places.push_back(finding.p_W);
            }
        }
    }
    m_viewport->view().findings().set(places);
    m_viewport->update();
    m_showFindingsAction->setEnabled(!places.empty());
    m_handControl->setFindings(std::move(places));
}

void MainWindow::writeNote()
{
    const QString text = QInputDialog::getText(this, tr("Note"), tr("Note at this moment of the recording:"));
    if (!text.isEmpty()) {
        m_live.note("note", QJsonDocument(QJsonObject{{"text", text}}).toJson(QJsonDocument::Compact).toStdString());
    }
}

void MainWindow::saveSnapshot()
{
    const std::filesystem::path file = newFile(QStandardPaths::PicturesLocation, QStringLiteral(".png"));
    m_viewport->refineNext();
    if (m_viewport->grabFramebuffer().save(toText(file))) {
        say(tr("Picture saved to %1").arg(toText(file)), 15000);
    } else {
        showError(tr("%1: the picture could not be written. Is the folder writable and the disk not full?")
                      .arg(toText(file)));
    }
}

// SPDX-License-Identifier: BSD-3-Clause
// Recording, playback, marking and measuring.
#include "shared/Paths.h"
#include "touch/MeasuresDialog.h"
#include "window/MainWindow.h"

#include <palpate/core/AtomicFile.h>
#include <palpate/ui/EngineTexts.h>

#include <QBuffer>

#include <utility>

using namespace palpate;
using namespace palpate::ui;

void MainWindow::toggleRecording()
{
    if (m_recording->isOn()) {
        const core::Status stopped = m_recording->stop();
        m_recordAction->setChecked(false);
        m_findingsDesk->endRecording();
        if (!m_recording->hasFailed()) {
            const bool wasPalpating = m_palpation->isPalpating();
            openRecording(m_recording->path());
            setPalpating(wasPalpating);
            m_message->offer(stopped.isOk() ? tr("Recorded to %1").arg(toText(m_recording->path()))
                                            : ui::engineText(stopped),
                             tr("Results…"), [this] { showMeasures(); });
        }
    } else {
        m_playback->setRecording(nullptr);
        const core::Status started = m_recording->start(m_files.size() == 1 ? m_files.front() : std::filesystem::path(),
                                                        m_embedAction->isChecked());
        m_recordAction->setChecked(started.isOk());
        m_findingsDesk->beginRecording(m_recording->path());
        if (!started.isOk()) {
            showError(ui::engineText(started));
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

void MainWindow::saveSnapshot()
{
    const std::filesystem::path file = newFile(QStandardPaths::PicturesLocation, QStringLiteral(".png"));
    m_viewport->refineNext();
    QBuffer bytes;
    const bool isDrawn = m_viewport->grabFramebuffer().save(&bytes, "PNG");
    const auto written = core::writeNew(file, {bytes.data().constData(), static_cast<std::size_t>(bytes.size())});
    if (isDrawn && written.isOk()) {
        say(tr("Picture saved to %1").arg(toText(written.value())), 15000);
    } else {
        showError(tr("%1: the picture could not be written. Is the folder writable and the disk not full?")
                      .arg(toText(file)));
    }
}

// SPDX-License-Identifier: BSD-3-Clause
#include "touch/RecordingControl.h"

#include "shared/Paths.h"

#include <palpate/core/AtomicFile.h>
#include <palpate/ui/Translated.h>

#include <QDir>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>

#include <algorithm>
#include <iterator>
#include <system_error>
#include <utility>

using namespace palpate;
using namespace palpate::ui;

namespace {

constexpr int kMaxNumberedNames = 1000;
constexpr auto kFolderKey = "recording_folder";
constexpr const char* kSideFiles[] = {"", "-journal", "-wal", "-shm"};

/// Returns whether no file has the name of the recording or of one of SQLite's side files.
bool isNameFree(const std::filesystem::path& recording)
{
    return std::none_of(std::begin(kSideFiles), std::end(kSideFiles), [&](const char* suffix) {
        std::filesystem::path file = recording;
        file += suffix;
        std::error_code error;
        return std::filesystem::exists(std::filesystem::symlink_status(file, error));
    });
}

} // namespace

RecordingControl::RecordingControl(LiveTouch& live, Chip& chip, SessionPanel& panel, QObject* parent)
    : QObject(parent)
    , m_live(live)
    , m_chip(chip)
    , m_panel(panel)
{
    m_chip.setToolTip(tr("Length of the recording [min:s]. Late samples (1 ms each): the computer was too busy and "
                         "nothing was felt. Lost samples: felt, but not recorded because the disk was too slow."));
}

void RecordingControl::setFolder(const QString& folder)
{
    QSettings().setValue(QLatin1String(kFolderKey), folder);
}

core::Status RecordingControl::start(const std::filesystem::path& scene, bool embeds)
{
    refresh(); // report a recording that has just failed first
    m_failure.clear();
    m_reportedProblem.clear();
    m_hasFailed = false;
    // The name has a resolution of one second: an older recording, or one of another window, may have the same name.
    const QString folder = QSettings().value(QLatin1String(kFolderKey)).toString(), ending = QStringLiteral(".palpate");
    const std::filesystem::path wanted = !folder.isEmpty() && QDir(folder).exists()
                                             ? newFileIn(folder, ending)
                                             : newFile(QStandardPaths::DocumentsLocation, ending);
    core::Status started;
    bool isTaken = true;
    for (int number = 1; isTaken && number <= kMaxNumberedNames; ++number) {
        m_path = core::numbered(wanted, number);
        if (!isNameFree(m_path)) {
            continue;
        }
        started = m_live.startRecording(m_path, scene, embeds);
        isTaken = !started.isOk() && !isNameFree(m_path);
    }
    m_isWatching = !isTaken && started.isOk();
    return started;
}

core::Status RecordingControl::stop()
{
    const core::Status stopped = m_live.stopRecording();
    refresh();
    return stopped;
}

bool RecordingControl::mayEnd(QWidget* window)
{
    if (!isRecording()) {
        return true;
    }
    QMessageBox box(QMessageBox::Question, tr("Recording"), tr("Recording in progress. Stop recording and close?"),
                    QMessageBox::NoButton, window);
    box.setInformativeText(tr("The recording so far is kept in %1.").arg(toText(m_path)));
    QPushButton* const end = box.addButton(tr("Stop recording"), QMessageBox::AcceptRole);
    box.addButton(tr("Continue recording"), QMessageBox::RejectRole);
    box.setDefaultButton(end);
    box.exec();
    if (box.clickedButton() != static_cast<QAbstractButton*>(end)) {
        return false;
    }
    if (const core::Status stopped = stop(); !stopped.isOk()) {
        QMessageBox::warning(window, tr("Recording"), ui::translated(stopped));
    }
    return true;
}

void RecordingControl::refresh()
{
    const session::RecorderStatus now = m_live.recording();
    if (now.isRecording) {
        const QString losses = lossesText(now.late, now.dropped);
        const bool isTroubled = !now.problem.isEmpty();
        m_chip.say(isTroubled ? tr("● recording %1, disk not responding").arg(clockText(now.duration_s))
                              : tr("● recording %1, %2").arg(clockText(now.duration_s), losses),
                   Chip::Tone::Recording);
        m_panel.showRecording(now.duration_s, losses);
        const std::string problem = now.problem.english();
        if (std::exchange(m_reportedProblem, problem) != problem && isTroubled) {
            Q_EMIT writeProblem(ui::translated(now.problem));
        }
        return;
    }
    if (std::exchange(m_isWatching, false) && now.hasFailed) {
        m_failure = tr("recording failed at %1").arg(clockText(now.duration_s));
        (void)m_live.stopRecording(); // the recording has already ended; this closes the rest
        m_hasFailed = true;
        m_panel.showTitle(tr("%1 stopped: write error").arg(toText(m_path.filename())));
        m_panel.showRecording(now.duration_s, lossesText(now.late, now.dropped));
        Q_EMIT failed(ui::translated(now.problem));
    }
    m_chip.say(m_failure, Chip::Tone::Recording);
}

void RecordingControl::acknowledge()
{
    m_failure.clear();
    refresh();
}

#include "moc_RecordingControl.cpp"

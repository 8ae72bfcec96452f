// SPDX-License-Identifier: BSD-3-Clause
#include "touch/RecordingPart.h"

#include "scene/DocumentPart.h"
#include "scene/RecentFiles.h"
#include "shared/Paths.h"
#include "shared/SceneSize.h"
#include "shell/Docks.h"
#include "shell/Notices.h"
#include "touch/FingertipPart.h"
#include "touch/TouchPart.h"

#include <palpate/session/RecordingReader.h>
#include <palpate/ui/ActionList.h>
#include <palpate/ui/ChipRow.h>
#include <palpate/ui/PalpationController.h>
#include <palpate/ui/Playback.h>
#include <palpate/ui/RecordedTouch.h>
#include <palpate/ui/TouchPanel.h>
#include <palpate/ui/Translated.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QFileDialog>
#include <QLocale>
#include <QMainWindow>
#include <QTimer>

#include <utility>
#include <vector>

namespace palpate::app {

using ui::ActionGroup;

RecordingPart::RecordingPart(const WindowCore& core, DocumentPart& document, TouchPart& touch)
    : WindowPart(&core.window)
    , m_core(core)
    , m_document(document)
    , m_touch(touch)
    , m_panel(new ui::SessionPanel(&core.window))
    , m_playback(new ui::Playback(core.viewport, core.model, *m_panel, touch.panel(), this))
    , m_control(new RecordingControl(core.live, *core.chips.add("recording", tr("Recording"), 9, true), *m_panel, this))
{
    connect(m_control, &RecordingControl::writeProblem, &core.notices, &Notices::showError);
    connect(m_control, &RecordingControl::failed, this, &RecordingPart::takeFailure);
    connect(&core.live, &ui::LiveTouch::statusChanged, m_control, &RecordingControl::refresh);
    connect(m_playback, &ui::Playback::stateChanged, this, &RecordingPart::stateChanged);
    connect(&touch, &TouchPart::palpationBegins, m_playback, &ui::Playback::pause);
    connect(this, &RecordingPart::ended, this, [this] { m_trace.end(); });
    QTimer::singleShot(0, this, &RecordingPart::offerInterrupted);
    ui::PalpationController& palpation = touch.palpation();
    connect(&palpation, &ui::PalpationController::touched, this, [this](const ui::TouchReading& reading) {
        const session::RecorderStatus recording = m_core.live.recording();
        if (recording.isRecording) {
            m_panel->timeline().addLive(recording.duration_s, reading.force_N);
        }
    });
    connect(&palpation, &ui::PalpationController::handGone, m_playback,
            &ui::Playback::showAgain); // back to the recording, if one is open
}

RecordingPart::~RecordingPart()
{
    delete m_control;
    delete m_playback;
    delete m_panel;
}

void RecordingPart::addActions()
{
    ui::ActionList& actions = m_core.actions;
    QAction* record =
        actions.add("record", ActionGroup::Session, tr("Record"), tr("Record the motion and the force of the hand"),
                    {QKeySequence(Qt::Key_R)}, ui::Symbol::Record);
    record->setCheckable(true);
    connect(record, &QAction::triggered, this, &RecordingPart::toggle);
    QAction* play = actions.add("play", ActionGroup::Session, tr("Play"), tr("Play or pause the recording"),
                                {QKeySequence(Qt::Key_K)}, ui::Symbol::Play);
    connect(play, &QAction::triggered, this, &RecordingPart::togglePlaying);
    QAction* restart =
        actions.add("to-start", ActionGroup::Session, tr("To the start"), tr("Return to the start of the recording"),
                    {QKeySequence(Qt::Key_Home)}, ui::Symbol::Restart);
    connect(restart, &QAction::triggered, m_playback, &ui::Playback::toStart);
    actions.addSeparator(ActionGroup::Session);
    for (QAction* action : {record, restart, play}) {
        m_panel->addAction(action);
    }
}

void RecordingPart::addPanel(Docks& docks)
{
    docks.add({tr("Session"), "session", m_panel, Qt::BottomDockWidgetArea});
}

void RecordingPart::showState(const WindowState& state)
{
    QAction& play = m_core.actions.at("play");
    play.setIcon(ui::icon(state.isPlaying ? ui::Symbol::Pause : ui::Symbol::Play));
    play.setText(state.isPlaying ? tr("Pause") : tr("Play"));
    m_core.actions.setEnabled({"play", "to-start"}, state.hasRecording && !state.isRecording);
    QAction& record = m_core.actions.at("record");
    record.setEnabled(state.hasScene);
    record.setIcon(ui::icon(state.isRecording ? ui::Symbol::Stop : ui::Symbol::Record));
    record.setText(state.isRecording ? tr("Stop") : tr("Record"));
    showForceLimit(state);
}

WindowState RecordingPart::windowState() const
{
    const bool hasRecording = m_playback->recording() != nullptr;
    return {m_core.model.rowCount() > 0, hasRecording, hasRecording && m_playback->isPlaying(), isRecording()};
}

/// Shows the limit of the hand whose force is shown: the recording's only during playback.
void RecordingPart::showForceLimit(const WindowState& state)
{
    const bool isLiveHand = m_touch.palpation().isPalpating() || !m_core.live.usesPointer();
    const bool showsRecording = state.isPlaying || (state.hasRecording && !isLiveHand);
    const double limit_N =
        showsRecording ? m_playback->recording()->forceLimit_N() : m_core.live.deviceInfo().maxForce_N;
    m_touch.panel().setForceLimit(limit_N);
    m_core.viewport.view().cursor().setForceLimit(limit_N);
}

void RecordingPart::open(const std::filesystem::path& path)
{
    if (m_core.model.scene().hiddenTargets() > 0) {
        const QString line =
            tr("%1: a recording names what was touched. Open it after the exercise.").arg(toText(path.filename()));
        m_core.notices.showError(line);
        Q_EMIT openFailed(line);
        return;
    }
    auto recording = ui::RecordedTouch::open(path);
    if (!recording.isOk()) {
        m_core.notices.showError(ui::translated(recording.status()));
        Q_EMIT openFailed(ui::translated(recording.status()));
        return;
    }
    const QString losses = recording.value()->losses();
    connect(recording.value().get(), &ui::RecordedTouch::damageFound, &m_core.notices, &Notices::showError);
    m_core.actions.at("palpate").setChecked(false);
    m_playback->setRecording(std::move(recording).value());
    m_document.recent().add(path);
    if (!losses.isEmpty()) {
        m_core.notices.showError(losses);
    }
    if (m_core.model.rowCount() == 0) {
        m_core.notices.bar().offer(
            tr("%1 can be played, but its meshes were not found: only the path of the hand is shown. Open the meshes "
               "to see what was touched.")
                .arg(toText(path.filename())),
            tr("Find the meshes…"), [this, path] { findMeshes(path); });
        Q_EMIT shownAlone();
    }
}

/// Asks for the meshes of a recording and opens these with the recording.
void RecordingPart::findMeshes(const std::filesystem::path& recording)
{
    const QStringList chosen =
        QFileDialog::getOpenFileNames(&m_core.window, tr("Meshes of the recording"), toText(recording.parent_path()));
    std::vector<std::filesystem::path> files;
    for (const QString& file : chosen) {
        files.push_back(toPath(file));
    }
    if (!files.empty()) {
        files.push_back(recording);
        Q_EMIT meshesFound(files);
    }
}

void RecordingPart::toggle()
{
    if (m_control->isOn()) {
        stop();
    } else {
        start();
    }
    m_control->refresh();
    Q_EMIT stateChanged();
}

void RecordingPart::start()
{
    m_playback->setRecording(nullptr);
    const auto& files = m_document.files();
    const core::Status started = m_control->start(files.size() == 1 ? files.front() : std::filesystem::path(),
                                                  m_core.actions.at("embed").isChecked());
    m_core.actions.at("record").setChecked(started.isOk());
    Q_EMIT begun(m_control->path());
    if (!started.isOk()) {
        m_core.notices.bar().offer(ui::translated(started), tr("Record to another folder…"), [this] {
            const QString folder = QFileDialog::getExistingDirectory(&m_core.window, tr("Folder of recordings"));
            if (!folder.isEmpty()) {
                m_control->setFolder(folder);
                toggle();
            }
        });
        return;
    }
    m_trace.begin(m_control->path());
    m_touch.panel().clearHistory();
    m_panel->showTitle(tr("Recording %1").arg(toText(m_control->path().filename())));
    m_touch.setPalpating(true);
}

void RecordingPart::stop()
{
    const core::Status stopped = m_control->stop();
    m_core.actions.at("record").setChecked(false);
    Q_EMIT ended();
    if (m_control->hasFailed()) {
        return;
    }
    const bool wasPalpating = m_touch.palpation().isPalpating();
    open(m_control->path());
    if (const ui::RecordedTouch* recorded = m_playback->recording()) {
        m_playback->seek(recorded->duration_s()); // maps of touch show all that was recorded; Play starts over
    }
    m_touch.setPalpating(wasPalpating);
    m_core.notices.bar().withdraw(m_told); // about the recording before
    m_told = stopped.isOk() ? tr("Recorded to %1").arg(toText(m_control->path())) : ui::translated(stopped);
    m_core.notices.bar().offer(m_told, tr("Results…"), [this] { m_core.actions.at("measures").trigger(); });
}

void RecordingPart::takeFailure(const QString& line)
{
    m_trace.end(); // the line below offers the recording
    m_core.actions.at("record").setChecked(false);
    Q_EMIT stateChanged();
    m_core.notices.bar().offer(line, tr("Open the recording"), [this] { open(m_control->path()); });
}

/// Offers a recording that a crash cut off, if nothing is open.
void RecordingPart::offerInterrupted()
{
    const auto left = RecordingTrace::findLeft();
    if (!left || m_core.model.rowCount() > 0) {
        return;
    }
    const auto reader = session::RecordingReader::open(left->recording);
    if (!reader.isOk() || reader.value()->extent().ticks == 0) {
        RecordingTrace::discard(*left); // nothing was recorded yet
        return;
    }
    m_core.notices.bar().ask(
        tr("Palpate ended unexpectedly while recording %1. The first %2 s were saved.")
            .arg(toText(left->recording.filename()), QLocale().toString(reader.value()->extent().duration_s, 'f', 1)),
        tr("Open the recording"),
        [this, left = *left] {
            RecordingTrace::discard(left);
            Q_EMIT m_document.openWanted(left.recording);
        },
        tr("Do not offer again"), [left = *left] { RecordingTrace::discard(left); });
}

void RecordingPart::togglePlaying()
{
    if (m_playback->isPlaying()) {
        m_playback->pause();
    } else {
        m_core.actions.at("palpate").setChecked(false);
        m_playback->play();
    }
}

bool RecordingPart::mayEnd()
{
    return m_control->mayEnd(&m_core.window);
}

void RecordingPart::takeFingertip()
{
    const ui::RecordedTouch* recording =
        session::isRecordingByNameOrContent(m_document.files().front()) ? m_playback->recording() : nullptr;
    const auto first = recording != nullptr ? recording->at(0.0) : std::nullopt;
    const bool isTiny = m_core.viewport.view().bounds().diagonal().norm() < kSmallestScene_mm;
    const double radius_mm = first ? recording->fingertip_mm(*first) : isTiny ? 0.0 : chosenFingertip_mm();
    if (first && radius_mm != m_core.live.fingertip_mm()) {
        m_core.notices.say(
            radius_mm > 0.0 ? tr("The fingertip is a ball of %1 mm radius, as in the recording (Session › Fingertip).")
                                  .arg(ui::numberText(radius_mm))
                            : tr("The fingertip is a point, as in the recording (Session › Fingertip)."),
            20000);
    }
    m_core.live.setFingertip(radius_mm);
}

} // namespace palpate::app

#include "moc_RecordingPart.cpp"

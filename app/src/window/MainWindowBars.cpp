// SPDX-License-Identifier: BSD-3-Clause
// Tool bar, status chips and the state that they show.
#include "window/MainWindow.h"

#include "shared/ProgramFolders.h"

#include <palpate/ui/Theme.h>
#include <palpate/ui/ToolTexts.h>

#include <QDockWidget>
#include <QFileInfo>
#include <QLocale>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>
#include <QToolBar>
#include <QToolButton>

#include <algorithm>

using namespace palpate;
using namespace palpate::ui;

void MainWindow::makeToolBar()
{
    QToolBar* bar = addToolBar(tr("Tools"));
    bar->setObjectName(QStringLiteral("tools"));
    bar->setMovable(false);
    keepIconSize(*bar, 22);
    bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    bar->setContextMenuPolicy(Qt::PreventContextMenu);
    const auto add = [&](QAction* action, bool hasText) {
        bar->addAction(action);
        auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(action));
        button->setToolButtonStyle(hasText ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly);
        button->setAccessibleName(action->text());
    };
    add(m_openAction, true);
    bar->addSeparator();
    add(m_palpateAction, true);
    add(m_recordAction, true);
    add(m_playAction, true);
    bar->addSeparator();
    for (QAction* action : {m_fitAction, m_snapshotAction, m_undoAction, m_redoAction, m_keysAction}) {
        add(action, false);
    }
    m_undoAction->setEnabled(false);
    m_redoAction->setEnabled(false);

    auto* chips = new ChipRow(bar);
    m_depthChip = chips->add("mode", tr("What the pointer or the device does"), 3);
    m_recordingChip = chips->add("recording", tr("Recording"), 9, true);
    m_deviceChip = chips->add("device", tr("Device"), 2);
    m_runningChip = chips->add("running", tr("How touch runs"), 1);
    m_runningChip->setCursor(Qt::PointingHandCursor);
    bar->addWidget(chips);
    new ToolTexts(*bar);
}

void MainWindow::showMode()
{
    const bool isSlidOff = m_palpation != nullptr && m_palpation->isSlidOff();
    m_depthChip->say(handText(), isSlidOff ? Chip::Tone::Warning : Chip::Tone::Quiet);
    m_depthChip->setToolTip(tr("What the pointer does: it turns the view, or it presses this far along the line of "
                               "sight [mm] or with this force [N]; the wheel sets it (P switches)"));
}

void MainWindow::showStatus()
{
    showMode();
    if (m_devices != nullptr) {
        m_deviceChip->say(m_devices->summary(), m_devices->isTroubled() ? Chip::Tone::Warning : Chip::Tone::Quiet);
        m_deviceChip->setToolTip(m_devices->details());
    }
    m_recording->refresh();
    const EngineeringReading reading = engineeringReading(m_live, m_touch->reading());
    const RunningState state = runningState(reading);
    m_runningChip->say(state.text, state.isWell ? Chip::Tone::Good : Chip::Tone::Warning);
    m_runningChip->setToolTip(state.tip);
    if (reading.isRunning) {
        listRealtimeWarnings(reading.realtime);
    }
    if (m_engineering != nullptr && m_engineering->isVisible()) {
        m_engineering->show(reading);
    }
}

void MainWindow::showWhatPlays()
{
    const bool hasRecording = m_playback != nullptr && m_playback->recording() != nullptr;
    const bool isPlaying = hasRecording && m_playback->isPlaying();
    const bool isRecording = m_live.recording().isRecording;
    const bool hasScene = m_model.rowCount() > 0; // also true if all structures were removed: undo restores them
    m_playAction->setIcon(icon(isPlaying ? Symbol::Pause : Symbol::Play));
    m_playAction->setText(isPlaying ? tr("Pause") : tr("Play"));
    m_playAction->setEnabled(hasRecording && !isRecording);
    m_restartAction->setEnabled(hasRecording && !isRecording);
    m_recordAction->setEnabled(hasScene);
    m_recordAction->setIcon(icon(isRecording ? Symbol::Stop : Symbol::Record));
    m_recordAction->setText(isRecording ? tr("Stop") : tr("Record"));
    m_measuresAction->setEnabled(hasRecording && !isRecording);
    for (QAction* action : {m_palpateAction, m_addAction, m_closeAction, m_filterAction, m_renameAction, m_removeAction,
                            m_saveAction, m_saveAsAction, m_findingAction, m_findingNoteAction, m_noteAction,
                            m_fitAction, m_feltAction, m_snapshotAction, m_importFindingsAction}) {
        action->setEnabled(hasScene);
    }
    // The force limit belongs to the hand whose force is shown: the recording's only during playback.
    const bool isLiveHand = m_palpation != nullptr && (m_palpation->isPalpating() || !m_live.usesPointer());
    const bool showsRecording = isPlaying || (hasRecording && !isLiveHand);
    const double limit_N = showsRecording ? m_playback->recording()->forceLimit_N() : m_live.deviceInfo().maxForce_N;
    m_touch->setForceLimit(limit_N);
    m_viewport->view().cursor().setForceLimit(limit_N);
}

void MainWindow::togglePanels()
{
    const bool isAnyShown =
        std::any_of(m_docks.begin(), m_docks.end(), [](QDockWidget* dock) { return dock->isVisible(); });
    for (QDockWidget* dock : m_docks) {
        dock->setVisible(!isAnyShown);
    }
}

void MainWindow::remember(const std::filesystem::path& file)
{
    const QString path = QFileInfo(QString::fromStdU16String(file.u16string())).absoluteFilePath();
    QSettings settings;
    QStringList recent = settings.value(QStringLiteral("recent")).toStringList();
    recent.removeAll(path);
    recent.prepend(path);
    settings.setValue(QStringLiteral("recent"), recent.mid(0, 12));
    refreshRecent();
}

void MainWindow::refreshRecent()
{
    QStringList recent;
    for (const QString& path : QSettings().value(QStringLiteral("recent")).toStringList()) {
        if (QFileInfo::exists(path)) {
            recent << path;
        }
    }
    m_welcome->setChoices(app::phantomFolder().has_value(), recent);
    m_recentMenu->clear();
    m_recentMenu->setEnabled(!recent.isEmpty());
    for (const QString& path : recent) {
        m_recentMenu->addAction(QFileInfo(path).fileName(), this, [this, path] { open({path.toStdU16String()}); })
            ->setToolTip(path);
    }
}

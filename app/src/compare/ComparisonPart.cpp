// SPDX-License-Identifier: BSD-3-Clause
#include "compare/ComparisonPart.h"

#include "compare/ComparisonDialog.h"
#include "shared/Paths.h"
#include "shell/Notices.h"
#include "touch/TouchMapPart.h"

#include <palpate/session/RecordingReader.h>
#include <palpate/study/CompareRecordings.h>
#include <palpate/ui/ActionList.h>
#include <palpate/ui/Playback.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/ui/Translated.h>

#include <QAction>
#include <QFileDialog>
#include <QMainWindow>

#include <utility>

namespace palpate::app {

using ui::ActionGroup;

ComparisonPart::ComparisonPart(const WindowCore& core, ui::Playback& playback, TouchMapPart& map)
    : WindowPart(&core.window)
    , m_core(core)
    , m_playback(playback)
    , m_map(map)
{
}

void ComparisonPart::addActions()
{
    connect(m_core.actions.add("compare", ActionGroup::Session, tr("Compare with…"),
                               tr("Compare the recording with a second one of the same structures"),
                               {QKeySequence(Qt::SHIFT | Qt::Key_I)}),
            &QAction::triggered, this, &ComparisonPart::choose);
}

void ComparisonPart::showState(const WindowState& state)
{
    QAction& compare = m_core.actions.at("compare");
    compare.setEnabled(state.hasRecording && !state.isRecording);
    compare.setText(m_playback.second() == nullptr ? tr("Compare with…") : tr("End the comparison"));
}

/// Asks for the second recording, or ends the comparison.
void ComparisonPart::choose()
{
    if (m_playback.second() != nullptr) {
        m_playback.setSecond(nullptr);
        return;
    }
    if (m_playback.recording() == nullptr) {
        return;
    }
    const QString chosen = QFileDialog::getOpenFileName(&m_core.window, tr("Second recording"),
                                                        toText(m_playback.recording()->path().parent_path()),
                                                        tr("Recordings (*.palpate)"));
    if (!chosen.isEmpty()) {
        compareWith(toPath(chosen));
    }
}

void ComparisonPart::compareWith(const std::filesystem::path& second)
{
    const std::filesystem::path first = m_playback.recording()->path();
    study::CompareOptions options;
    for (const study::OpenStructure& row : m_core.model.rows()) {
        if (!row.sha256.empty()) {
            options.opened[row.sha256] = row.loaded.surface;
        }
    }
    const auto distance_mm = study::checkComparable(first, second, options.opened);
    if (!distance_mm.isOk()) {
        m_core.notices.showError(ui::translated(distance_mm.status()));
        return;
    }
    auto recording = ui::RecordedTouch::open(second);
    if (!recording.isOk()) {
        m_core.notices.showError(ui::translated(recording.status()));
        return;
    }
    m_playback.setSecond(std::move(recording).value());
    m_map.compare(distance_mm.value());
    options.distance_mm = distance_mm.value();
    auto* dialog = new ComparisonDialog(first, second, std::move(options), &m_core.window);
    dialog->show();
}

} // namespace palpate::app

#include "moc_ComparisonPart.cpp"

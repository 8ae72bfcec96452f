// SPDX-License-Identifier: BSD-3-Clause
#include "touch/ResultsPart.h"

#include "touch/MeasuresDialog.h"

#include <palpate/ui/ActionList.h>
#include <palpate/ui/Playback.h>
#include <palpate/ui/StructureModel.h>

#include <QAction>
#include <QMainWindow>
#include <QSettings>

#include <utility>

namespace palpate::app {

using ui::ActionGroup;

namespace {

constexpr auto kEmbedKey = "session/embed";

} // namespace

ResultsPart::ResultsPart(const WindowCore& core, const ui::Playback& playback)
    : WindowPart(&core.window)
    , m_core(core)
    , m_playback(playback)
{
}

void ResultsPart::addActions()
{
    ui::ActionList& actions = m_core.actions;
    connect(actions.add("measures", ActionGroup::Session, tr("Results…"),
                        tr("Show and export forces, coverage and findings of the recording"),
                        {QKeySequence(Qt::Key_I)}),
            &QAction::triggered, this, &ResultsPart::show);
    QAction* embed = actions.add("embed", ActionGroup::Session, tr("Store the surfaces in recordings"),
                                 tr("A recording then contains the whole session and grows by the size of the meshes"));
    embed->setCheckable(true);
    embed->setChecked(QSettings().value(QLatin1String(kEmbedKey)).toBool());
    connect(embed, &QAction::toggled, this, [](bool isOn) { QSettings().setValue(QLatin1String(kEmbedKey), isOn); });
    actions.addSeparator(ActionGroup::Session);
}

void ResultsPart::showState(const WindowState& state)
{
    m_core.actions.at("measures").setEnabled(state.hasRecording && !state.isRecording);
}

void ResultsPart::show()
{
    if (m_playback.recording() == nullptr) {
        return;
    }
    session::MeshesByHash meshes;
    for (const study::OpenStructure& row : m_core.model.rows()) {
        if (!row.sha256.empty()) {
            meshes[row.sha256] = row.loaded.surface;
        }
    }
    auto* dialog = new MeasuresDialog(m_playback.recording()->path(), std::move(meshes), &m_core.window);
    dialog->show();
}

} // namespace palpate::app

#include "moc_ResultsPart.cpp"

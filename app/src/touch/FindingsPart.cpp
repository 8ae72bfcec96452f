// SPDX-License-Identifier: BSD-3-Clause
#include "touch/FindingsPart.h"

#include "scene/DocumentPart.h"
#include "shared/Paths.h"
#include "shell/Docks.h"
#include "shell/Notices.h"
#include "touch/FindingsDesk.h"
#include "touch/RecordingPart.h"
#include "touch/TouchPart.h"

#include <palpate/ui/ActionList.h>
#include <palpate/ui/FindingsPanel.h>
#include <palpate/ui/Playback.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QDockWidget>
#include <QFileDialog>
#include <QMainWindow>
#include <QSettings>

namespace palpate::app {

using ui::ActionGroup;

FindingsPart::FindingsPart(const WindowCore& core, DocumentPart& document, TouchPart& touch, RecordingPart& recording)
    : WindowPart(&core.window)
    , m_core(core)
    , m_document(document)
    , m_panel(new ui::FindingsPanel(document.document().findingsModel(), &core.window))
    , m_desk(new FindingsDesk({document.document(), *m_panel, core.viewport, core.live, touch.palpation(),
                               recording.playback(), touch.panel(), core.model},
                              this))
{
    connect(m_desk, &FindingsDesk::said, this, [this](const QString& line) { m_core.notices.say(line); });
    connect(m_desk, &FindingsDesk::failed, &core.notices, &Notices::showError);
    connect(m_desk, &FindingsDesk::recordingWanted, &recording, &RecordingPart::open);
    connect(m_desk, &FindingsDesk::countChanged, this, &FindingsPart::takeCount);
    connect(&recording.playback(), &ui::Playback::stateChanged, m_desk, &FindingsDesk::show);
    connect(&recording, &RecordingPart::begun, m_desk, &FindingsDesk::beginRecording);
    connect(&recording, &RecordingPart::ended, m_desk, &FindingsDesk::endRecording);
}

FindingsPart::~FindingsPart()
{
    delete m_desk;
    delete m_panel;
}

void FindingsPart::addActions()
{
    ui::ActionList& actions = m_core.actions;
    connect(actions.add("import-findings", ActionGroup::File, tr("Import findings…"),
                        tr("Import the points of a 3D Slicer markups file (.mrk.json) as findings")),
            &QAction::triggered, this, &FindingsPart::importFindings);
    QAction* exports =
        actions.add("export-findings", ActionGroup::File, tr("Export findings…"),
                    tr("Export findings and notes as a table (CSV) or as 3D Slicer markups (.mrk.json)"));
    exports->setEnabled(false);
    connect(exports, &QAction::triggered, this, &FindingsPart::exportFindings);
    QAction* shown =
        actions.add("show-findings", ActionGroup::View, tr("Findings"), tr("Show the places marked as findings"));
    shown->setCheckable(true);
    shown->setChecked(true);
    shown->setEnabled(false);
    connect(shown, &QAction::toggled, this, [this](bool isOn) {
        m_core.viewport.view().findings().setVisible(isOn);
        m_core.viewport.update();
    });
    QAction* mark =
        actions.add("mark", ActionGroup::Session, tr("Mark a finding"),
                    tr("Mark the touched place, or the place pressed last, in the scene and in the recording"),
                    {QKeySequence(Qt::Key_M)}, ui::Symbol::Mark);
    mark->setIconText(tr("Mark")); // in the tool bar
    connect(mark, &QAction::triggered, m_desk, &FindingsDesk::mark);
    connect(actions.add("mark-and-write", ActionGroup::Session, tr("Mark a finding and write…"),
                        tr("Mark the touched place, or the place pressed last, and write a note on it"),
                        {QKeySequence(Qt::CTRL | Qt::Key_M)}),
            &QAction::triggered, this, [this] {
                if (m_desk->mark()) {
                    raise();
                    m_panel->editNote(m_panel->current());
                }
            });
    connect(actions.add("note", ActionGroup::Session, tr("Note…"), tr("Write a note without a place"),
                        {QKeySequence(Qt::Key_N)}),
            &QAction::triggered, this, [this] {
                raise();
                m_panel->startNote();
            });
    connect(actions.add("next-finding", ActionGroup::Session, tr("Next finding"),
                        tr("Go to the next finding and restore the view in which it was marked"),
                        {QKeySequence(Qt::Key_J)}),
            &QAction::triggered, this, [this] { m_desk->step(1); });
    connect(actions.add("previous-finding", ActionGroup::Session, tr("Previous finding"),
                        tr("Go to the previous finding"), {QKeySequence(Qt::SHIFT | Qt::Key_J)}),
            &QAction::triggered, this, [this] { m_desk->step(-1); });
    actions.addGesture(ActionGroup::InView, tr("Enter  F2  Del"), tr("in the findings: go there, edit, delete"));
    actions.addGesture(ActionGroup::InView, tr("Shift+Enter"),
                       tr("in the findings: play the recording from the marked moment"));
}

void FindingsPart::addPanel(Docks& docks)
{
    m_dock = &docks.add({tr("Findings"), "findings", m_panel, Qt::RightDockWidgetArea});
}

void FindingsPart::showState(const WindowState& state)
{
    m_core.actions.setEnabled({"mark", "mark-and-write", "note", "import-findings"}, state.hasScene);
}

/// Shows the panel if closed and raises its tab.
void FindingsPart::raise()
{
    m_dock->show();
    m_dock->raise();
}

void FindingsPart::takeCount(std::size_t count)
{
    m_core.actions.at("show-findings").setEnabled(count > 0);
    m_core.actions.at("export-findings").setEnabled(!m_document.document().findings().empty());
    std::vector<core::Vec3> places_W;
    for (const view::FindingMark& mark : m_core.viewport.view().findings().marks()) {
        places_W.push_back(mark.p_W);
    }
    Q_EMIT placesChanged(places_W);
}

void FindingsPart::exportFindings()
{
    const QString markups = tr("3D Slicer markups (*.mrk.json)");
    const QString table = tr("Table (*.csv)");
    const std::filesystem::path scene = m_document.document().file();
    const QString folder = scene.empty() ? QSettings().value(QStringLiteral("folder"), documentsFolder()).toString()
                                         : toText(scene.parent_path());
    QString kind = markups;
    QString chosen = QFileDialog::getSaveFileName(&m_core.window, tr("Export findings"),
                                                  folder + QStringLiteral("/findings.mrk.json"),
                                                  markups + QStringLiteral(";;") + table, &kind);
    if (chosen.isEmpty()) {
        return;
    }
    if (!chosen.endsWith(QLatin1String(".csv")) && !chosen.endsWith(QLatin1String(".json"))) {
        chosen += kind == table ? QStringLiteral(".csv") : QStringLiteral(".mrk.json");
    }
    m_desk->exportTo(toPath(chosen));
}

void FindingsPart::importFindings()
{
    const QString chosen = QFileDialog::getOpenFileName(&m_core.window, tr("Import findings"),
                                                        QSettings().value(QStringLiteral("folder")).toString(),
                                                        tr("3D Slicer markups (*.mrk.json *.json);;All files (*)"));
    if (!chosen.isEmpty()) {
        importFrom(toPath(chosen));
    }
}

void FindingsPart::importFrom(const std::filesystem::path& path)
{
    m_desk->importFrom(path);
}

} // namespace palpate::app

#include "moc_FindingsPart.cpp"

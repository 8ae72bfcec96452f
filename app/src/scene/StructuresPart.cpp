// SPDX-License-Identifier: BSD-3-Clause
#include "scene/StructuresPart.h"

#include "shell/Docks.h"
#include "shell/Notices.h"

#include <palpate/meshio/AnatomyPalette.h>
#include <palpate/meshio/LoadScene.h>
#include <palpate/ui/ActionList.h>
#include <palpate/ui/LiveTouch.h>
#include <palpate/ui/MapDisplay.h>
#include <palpate/ui/MapWarnings.h>
#include <palpate/ui/PointedStructure.h>
#include <palpate/ui/StructurePanel.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QMainWindow>
#include <QSettings>

#include <optional>
#include <utility>
#include <vector>

namespace palpate::app {

using ui::ActionGroup;

namespace {

constexpr auto kSafeKey = "look/safe_colours";

} // namespace

StructuresPart::StructuresPart(const WindowCore& core)
    : WindowPart(&core.window)
    , m_core(core)
    , m_panel(new ui::StructurePanel(core.model, &core.window))
    , m_maps(new ui::MapDisplay(core.viewport, core.model, this))
    , m_pointed(new ui::PointedStructure(core.viewport, core.model, *m_maps, this))
{
    takeLimit();
    connect(&core.live, &ui::LiveTouch::greatestChanged, this, &StructuresPart::takeLimit);
    connect(m_panel, &ui::StructurePanel::colourChosen, m_maps, &ui::MapDisplay::show);
    connect(m_panel, &ui::StructurePanel::highlighted, this, [this](const std::vector<int>& rows) {
        m_core.viewport.view().highlight(rows);
        m_core.viewport.update();
    });
    connect(m_pointed, &ui::PointedStructure::clicked, this, [this](int row, Qt::KeyboardModifiers modifiers) {
        m_panel->choose(row >= 0 ? std::optional(static_cast<std::size_t>(row)) : std::nullopt,
                        modifiers.testFlag(Qt::ControlModifier));
    });
    connectMapWarnings();
}

StructuresPart::~StructuresPart()
{
    delete m_panel; // an open name editor writes to the model
}

void StructuresPart::connectMapWarnings()
{
    auto* warnings = new ui::MapWarnings(m_core.live, this);
    connect(warnings, &ui::MapWarnings::changed, m_panel,
            [this, warnings] { m_panel->setMapWarnings(isSecret() ? QStringList() : warnings->lines()); });
    connect(warnings, &ui::MapWarnings::warned, this, [this](const QString& line) {
        if (isSecret()) {
            return; // the line has the place of a lump's border
        }
        m_core.notices.warn({line});
        m_core.notices.hint().say(line);
    });
    connect(&m_core.live, &ui::LiveTouch::stiffnessRefused, this,
            [this](const QString& line) { m_core.notices.say(line, 20000); });
}

/// True while targets of an exercise are hidden.
bool StructuresPart::isSecret() const
{
    return m_core.model.scene().hiddenTargets() > 0;
}

void StructuresPart::addActions()
{
    ui::ActionList& actions = m_core.actions;
    connect(actions.add("filter", ActionGroup::Edit, tr("Find a structure…"),
                        tr("List only structures with these words in their names"),
                        {QKeySequence(Qt::CTRL | Qt::Key_F)}),
            &QAction::triggered, m_panel, &ui::StructurePanel::focusFilter);
    // F2 and Del are handled by the focused list: see ActionGroup::InList.
    connect(actions.add("rename", ActionGroup::Edit, tr("Rename the structure…"), tr("Rename the selected structure")),
            &QAction::triggered, m_panel, &ui::StructurePanel::renameCurrent);
    connect(actions.add("remove", ActionGroup::Edit, tr("Remove from the scene"),
                        tr("Remove the selected structures from the scene; their files are kept")),
            &QAction::triggered, m_panel, &ui::StructurePanel::removeSelected);
    QAction* safe = actions.add("safe-colours", ActionGroup::Appearance, tr("Structures in colour-blind colours"),
                                tr("Give lumps, arteries, portal vein, other veins, ducts and organs colours that "
                                   "colour-blind people can distinguish; also when meshes are opened"));
    safe->setCheckable(true);
    safe->setChecked(QSettings().value(QLatin1String(kSafeKey), false).toBool());
    connect(safe, &QAction::toggled, this, [this](bool isSafe) {
        QSettings().setValue(QLatin1String(kSafeKey), isSafe);
        recolour(isSafe, 0);
    });
    actions.addGesture(ActionGroup::InList, tr("Ctrl+E  Ctrl+H"), tr("show or hide, turn touch on or off"));
    actions.addGesture(ActionGroup::InList, tr("letters"), tr("go to the structure whose name starts with them"));
    actions.addGesture(ActionGroup::InList, tr("F2  Del"), tr("rename, remove from the scene"));
    actions.addGesture(ActionGroup::InList, tr("Ctrl+↓  ↑"), tr("move one layer deeper or outwards"));
}

void StructuresPart::colourAsChosen(int first)
{
    if (m_core.actions.at("safe-colours").isChecked()) {
        recolour(true, first);
    }
}

/// Colours structures by their names as one undo step.
void StructuresPart::recolour(bool isSafe, int first)
{
    std::vector<ui::StructureModel::Edited> edits;
    for (int row = first; row < m_core.model.rowCount(); ++row) {
        meshio::SceneStructure changed = m_core.model.structure(row);
        const auto number = static_cast<std::size_t>(row);
        changed.colour =
            isSafe ? meshio::safeColour(changed.name, number) : meshio::defaultColour(changed.name, number);
        edits.push_back({row, std::move(changed)});
    }
    m_core.model.editAll(std::move(edits), tr("Colour structures"));
}

void StructuresPart::addPanel(Docks& docks)
{
    docks.add({tr("Structures"), "structures", m_panel, Qt::LeftDockWidgetArea});
}

void StructuresPart::showState(const WindowState& state)
{
    m_core.actions.setEnabled({"filter", "rename", "remove"}, state.hasScene);
}

void StructuresPart::takeLimit()
{
    m_panel->setGreatest(m_core.live.maxTissue(), m_core.live.limitText());
    m_maps->setGreatest(m_core.live.maxTissue());
}

} // namespace palpate::app

#include "moc_StructuresPart.cpp"

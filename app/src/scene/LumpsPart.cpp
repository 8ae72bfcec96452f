// SPDX-License-Identifier: BSD-3-Clause
#include "scene/LumpsPart.h"

#include "shell/Docks.h"
#include "shell/Notices.h"
#include "shell/StatusProgress.h"

#include <palpate/ui/ActionList.h>
#include <palpate/ui/FeltOverlay.h>
#include <palpate/ui/FeltPanel.h>
#include <palpate/ui/LumpMaps.h>
#include <palpate/ui/PointedStructure.h>
#include <palpate/ui/SceneLoader.h>

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>

#include <algorithm>

namespace palpate::app {

LumpsPart::LumpsPart(const WindowCore& core, const Parts& parts)
    : WindowPart(&core.window)
    , m_core(core)
    , m_parts(parts)
    , m_lumps(new ui::LumpMaps(core.model, this))
    , m_overlay(new ui::FeltOverlay(core.viewport, core.model, *m_lumps, parts.maps, this))
    , m_panel(new ui::FeltPanel(*m_overlay, core.model, &core.window))
{
    parts.pointed.setMore(
        [this](const ui::PointedStructure::Place& place) { return m_overlay->textAt(place.row, place.rest_W); });
    connectMaps();
}

LumpsPart::~LumpsPart()
{
    m_parts.pointed.setMore({});
    delete m_panel; // an open number editor writes to the model
    delete m_overlay;
    delete m_lumps;
}

void LumpsPart::connectMaps()
{
    connect(&m_parts.progress, &StatusProgress::cancelled, m_lumps, &ui::LumpMaps::cancel);
    connect(m_lumps, &ui::LumpMaps::progressed, this, [this](const QString& step, double share) {
        const bool isSecret = m_core.model.scene().hiddenTargets() > 0; // the step names the organ with the lumps
        m_parts.progress.show(isSecret ? tr("Preparing for touch") : step, share);
    });
    connect(m_lumps, &ui::LumpMaps::ended, this, [this] {
        if (!m_parts.loader.isBusy() && m_parts.progress.isVisible()) {
            m_parts.progress.end();
        }
    });
    connect(m_lumps, &ui::LumpMaps::cancelled, this, [this](const QString& line) {
        m_core.actions.at("felt").setChecked(false);
        m_core.notices.say(line);
    });
    connect(m_lumps, &ui::LumpMaps::noted, this, [this](const QStringList& lines) {
        m_core.notices.warn(lines);
        m_core.notices.hint().say(lines.front());
    });
}

void LumpsPart::addActions()
{
    QAction* shown = m_core.actions.add("felt", ui::ActionGroup::View, tr("What can be felt here"),
                                        tr("Colour organs by the palpability of the lumps below, with a table"),
                                        {QKeySequence(Qt::Key_B)});
    shown->setCheckable(true);
    shown->setEnabled(false);
}

void LumpsPart::addPanel(Docks& docks)
{
    m_dock = &docks.addHidden({tr("What can be felt"), "felt", m_panel, Qt::BottomDockWidgetArea});
    connect(m_dock->toggleViewAction(), &QAction::toggled, m_overlay, &ui::FeltOverlay::setTabled);
    connect(&m_core.actions.at("felt"), &QAction::toggled, this, [this, &docks](bool isShown) {
        m_overlay->setShown(isShown);
        docks.setShown(*m_dock, isShown);
        if (isShown) {
            constexpr int kHeight_px = 200; // two lumps and the details of one
            m_core.window.resizeDocks({m_dock}, {std::max(kHeight_px, m_dock->height())}, Qt::Vertical);
        }
    });
}

void LumpsPart::showState(const WindowState& state)
{
    m_core.actions.at("felt").setEnabled(state.hasScene);
}

} // namespace palpate::app

#include "moc_LumpsPart.cpp"

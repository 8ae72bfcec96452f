// SPDX-License-Identifier: BSD-3-Clause
#include "shell/LegendPart.h"

#include "shell/Notices.h"

#include <palpate/ui/ActionList.h>
#include <palpate/ui/LegendGrip.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QActionGroup>
#include <QMainWindow>
#include <QSettings>
#include <QString>

#include <algorithm>
#include <cstddef>

namespace palpate::app {

using ui::ActionGroup;

namespace {

constexpr auto kPlaceKey = "view/legend_place";

/// Corners in the order of the menu, with their names in the settings.
struct LegendPlace
{
    view::ColourLegend::Corner corner;
    const char* name;
};
constexpr std::array<LegendPlace, 4> kPlaces{{{view::ColourLegend::Corner::UpperLeft, "upper-left"},
                                              {view::ColourLegend::Corner::UpperRight, "upper-right"},
                                              {view::ColourLegend::Corner::LowerLeft, "lower-left"},
                                              {view::ColourLegend::Corner::LowerRight, "lower-right"}}};

} // namespace

LegendPart::LegendPart(const WindowCore& core)
    : WindowPart(&core.window)
    , m_core(core)
{
    auto* grip = new ui::LegendGrip(core.viewport, this);
    connect(grip, &ui::LegendGrip::dropped, this, [this](Corner corner) { place(corner); });
    connect(grip, &ui::LegendGrip::closed, this, [this] {
        m_core.actions.at("legend").setChecked(false);
        m_core.notices.say(tr("View › Colour legend shows the legend again."));
    });
}

void LegendPart::addActions()
{
    ui::ActionList& actions = m_core.actions;
    actions.addSubmenu(ActionGroup::View, tr("Colour legend"), ActionGroup::Legend);
    actions.addSeparator(ActionGroup::View);
    QAction* shown =
        actions.add("legend", ActionGroup::Legend, tr("Show the legend"), tr("Show what the colours in the view mean"));
    shown->setCheckable(true);
    shown->setChecked(true);
    connect(shown, &QAction::toggled, this, &LegendPart::setShown);
    actions.addSeparator(ActionGroup::Legend);
    auto* group = new QActionGroup(this);
    const QString tip = tr("Place of the legend; the mouse can drag it there as well");
    const std::array<QString, 5> texts{tr("Where it hides the least"), tr("Upper left"), tr("Upper right"),
                                       tr("Lower left"), tr("Lower right")};
    for (std::size_t i = 0; i < m_places.size(); ++i) {
        const QByteArray id = QByteArray("legend-") + (i == 0 ? "automatic" : kPlaces[i - 1].name);
        m_places[i] = actions.add(id.constData(), ActionGroup::Legend, texts[i], tip);
        m_places[i]->setCheckable(true);
        group->addAction(m_places[i]);
        connect(m_places[i], &QAction::triggered, this,
                [this, i] { place(i == 0 ? std::nullopt : std::optional(kPlaces[i - 1].corner)); });
    }
    const QString stored = QSettings().value(QLatin1String(kPlaceKey)).toString();
    const auto* found = std::find_if(kPlaces.begin(), kPlaces.end(),
                                     [&](const LegendPlace& one) { return stored == QLatin1String(one.name); });
    place(found == kPlaces.end() ? std::nullopt : std::optional(found->corner));
}

void LegendPart::place(std::optional<Corner> corner)
{
    const auto* found =
        std::find_if(kPlaces.begin(), kPlaces.end(), [&](const LegendPlace& one) { return one.corner == corner; });
    const std::size_t entry = found == kPlaces.end() ? 0 : static_cast<std::size_t>(found - kPlaces.begin()) + 1;
    m_places[entry]->setChecked(true);
    QSettings().setValue(QLatin1String(kPlaceKey), entry == 0 ? QString() : QLatin1String(found->name));
    m_core.viewport.view().setLegendCorner(corner);
    m_core.viewport.update();
}

void LegendPart::setShown(bool isShown)
{
    m_core.viewport.view().legend().setClosed(!isShown);
    m_core.viewport.update();
}

} // namespace palpate::app

#include "moc_LegendPart.cpp"

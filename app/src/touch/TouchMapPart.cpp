// SPDX-License-Identifier: BSD-3-Clause
#include "touch/TouchMapPart.h"

#include "shell/Notices.h"

#include <palpate/ui/ActionList.h>
#include <palpate/ui/HintLine.h>
#include <palpate/ui/LiveTouch.h>
#include <palpate/ui/MapDisplay.h>
#include <palpate/ui/Playback.h>
#include <palpate/ui/StructureModel.h>

#include <QAction>
#include <QActionGroup>
#include <QMainWindow>
#include <QMenu>

#include <algorithm>

namespace palpate::app {

using ui::ActionGroup;
using ui::TouchQuantity;

namespace {

constexpr const char* kOthers[] = {"felt", "distances"}; // colour structures and use the legend, too
constexpr int kSample_ms = 16;
constexpr double kLongest_s = 0.1; // between two displayed ticks; after a pause the time in between is not known
constexpr double kPoint_mm = 5.0, kLeast_mm = 1.0; // distance that counts as touched, see docs/measures.md

} // namespace

TouchMapPart::TouchMapPart(const WindowCore& core, ui::MapDisplay& maps, const ui::Playback& playback)
    : WindowPart(&core.window)
    , m_core(core)
    , m_playback(playback)
    , m_map(new ui::TouchMap(core.viewport, core.model, this))
{
    m_sampling.setInterval(kSample_ms);
    connect(&m_sampling, &QTimer::timeout, this, &TouchMapPart::sample);
    connect(&playback, &ui::Playback::momentShown, m_map, &ui::TouchMap::setPosition);
    connect(&playback, &ui::Playback::secondMomentShown, m_map, &ui::TouchMap::setSecondPosition);
    connect(m_map, &ui::TouchMap::shownChanged, &maps, &ui::MapDisplay::setCovered);
    connect(m_map, &ui::TouchMap::failed, this, [this](const QString& why) { m_core.notices.warn({why}); });
}

TouchMapPart::~TouchMapPart()
{
    delete m_map;
}

void TouchMapPart::addActions()
{
    auto* menu = new QMenu(tr("Map of touch"), &m_core.window);
    const QString tip = tr("Colour the examined surface, in the recording up to the moment shown, or live");
    auto* choices = new QActionGroup(this);
    for (int i = 0; i < ui::kTouchQuantities; ++i) {
        QAction* choice = menu->addAction(ui::touchQuantityText(static_cast<TouchQuantity>(i)));
        choice->setCheckable(true);
        choice->setChecked(i == 0);
        choices->addAction(choice);
        m_choices.push_back(choice);
        connect(choice, &QAction::triggered, this, [this, i] { select(i); });
    }
    m_core.actions.add("touch-map", ActionGroup::View, menu->title(), tip)->setMenu(menu);
    menu->addSeparator();
    const auto step = [this](int by) {
        select((static_cast<int>(m_map->quantity()) + by + ui::kTouchQuantities) % ui::kTouchQuantities);
    };
    connect(m_core.actions.add("touch-map-next", ActionGroup::TouchMap, tr("Next map of touch"), tip,
                               {QKeySequence(Qt::Key_D)}),
            &QAction::triggered, this, [step] { step(1); });
    connect(m_core.actions.add("touch-map-back", ActionGroup::TouchMap, tr("Previous map of touch"), tip,
                               {QKeySequence(Qt::SHIFT | Qt::Key_D)}),
            &QAction::triggered, this, [step] { step(-1); });
    m_core.actions.fill(*menu, ActionGroup::TouchMap);
    for (const char* id : kOthers) {
        connect(&m_core.actions.at(id), &QAction::toggled, this, [this](bool isShown) {
            if (isShown && m_map->quantity() != TouchQuantity::None) {
                select(0);
            }
        });
    }
}

void TouchMapPart::select(int quantity)
{
    const auto which = static_cast<TouchQuantity>(quantity);
    if (which != TouchQuantity::None) {
        for (const char* id : kOthers) {
            m_core.actions.at(id).setChecked(false);
        }
    }
    if (m_map->quantity() == TouchQuantity::None) {
        restart();
    }
    m_choices[static_cast<std::size_t>(quantity)]->setChecked(true);
    m_map->show(which);
    m_core.notices.hint().say(tr("Map of touch: %1").arg(ui::touchQuantityText(which)));
}

/// Starts the live map with the distance that the results of a recording would have.
void TouchMapPart::restart()
{
    const double fingertip_mm = m_core.live.fingertip_mm();
    m_map->restart(fingertip_mm > 0.0 ? std::max(fingertip_mm, kLeast_mm) : kPoint_mm);
}

void TouchMapPart::compare(double distance_mm)
{
    m_map->setSecond(m_playback.second()->path(), distance_mm);
    select(static_cast<int>(TouchQuantity::Covered));
}

void TouchMapPart::showState(const WindowState& state)
{
    m_core.actions.setEnabled({"touch-map", "touch-map-next", "touch-map-back"}, state.hasScene);
    if (m_core.model.scene().hiddenTargets() > 0 && m_map->quantity() != TouchQuantity::None) {
        select(0); // the map of an inner structure shows where it is
    }
    const bool isRecorded = state.hasRecording && !state.isRecording && m_playback.recording() != nullptr;
    if (state.isRecording && !m_isRecording) {
        restart();
    }
    m_isRecording = state.isRecording;
    m_map->setRecording(isRecorded ? m_playback.recording()->path() : std::filesystem::path());
    if (m_playback.second() == nullptr) {
        m_map->setSecond({}, 0.0);
    }
    if (state.hasScene && !isRecorded) {
        m_sampling.start();
    } else {
        m_sampling.stop();
    }
}

/// Adds the tick on display to the live map.
void TouchMapPart::sample()
{
    const servo::TickRecord& tick = m_core.live.newest();
    const double passed_s = static_cast<double>(tick.tick - m_lastTick) / m_core.live.rate_Hz();
    if (tick.tick != m_lastTick) {
        m_map->add(tick, std::clamp(passed_s, 0.0, kLongest_s));
        m_lastTick = tick.tick;
    }
}

} // namespace palpate::app

#include "moc_TouchMapPart.cpp"

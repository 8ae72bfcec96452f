// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/PalpationController.h"

#include <palpate/core/Clock.h>
#include <palpate/haptics/ForceTable.h>
#include <palpate/study/FeltMap.h>

namespace palpate::ui {

namespace {

constexpr int kHandPeriod_ms = 4;              // the device gets a new HIP this often while it moves
constexpr std::int64_t kFrame_ns = 15'000'000; // the view and the numbers follow at display rate

double seconds(std::int64_t time_ns)
{
    return static_cast<double>(time_ns) * 1e-9;
}

} // namespace

PalpationController::PalpationController(VtkViewport& viewport, LiveTouch& live, StructureModel& model, QObject* parent)
    : QObject(parent)
    , m_viewport(viewport)
    , m_live(live)
    , m_model(model)
{
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setInterval(kHandPeriod_ms);
    connect(&m_timer, &QTimer::timeout, this, &PalpationController::step);
    connect(&viewport, &VtkViewport::pointerMoved, this, [this] {
        if (const auto ray = m_viewport.pointerRay()) {
            point(*ray);
        }
    });
    connect(&viewport, &VtkViewport::pointerPressed, this, &PalpationController::press);
    connect(&viewport, &VtkViewport::pointerReleased, this, [this] { letGo(); });
    connect(&viewport, &VtkViewport::pointerLeft, this, [this] {
        m_hand.goAway();
        run();
    });
    connect(&live, &LiveTouch::deviceChanged, this, [this] {
        m_hand.goAway();
        run();
    });
    connect(&viewport, &VtkViewport::depthTurned, this, [this](double steps) {
        m_hand.turnDepth(steps);
        Q_EMIT depthChanged(depth_mm());
        run();
    });
}

void PalpationController::setPalpating(bool isPalpating)
{
    m_isPalpating = isPalpating;
    m_viewport.setMode(isPalpating ? VtkViewport::Mode::Palpate : VtkViewport::Mode::Camera);
    if (!isPalpating) {
        m_hand.goAway();
        run();
    } else if (const auto ray = m_viewport.pointerRay()) {
        point(*ray);
    }
}

bool PalpationController::letGo()
{
    const double now_s = seconds(core::monotonicNow_ns());
    const bool wasPressing = m_hand.phase(now_s) == PointerHand::Phase::Pressing;
    m_hand.release(now_s);
    m_live.pointer().setState(m_hand.state(now_s)); // at once: the next step may wait for a picture
    run();
    return wasPressing;
}

void PalpationController::setSceneSize(double diagonal_mm)
{
    m_hand.goAway();
    m_hand.setSettings(settingsForSize(diagonal_mm));
    Q_EMIT depthChanged(depth_mm());
    run();
}

void PalpationController::pressAt(const QPointF& place)
{
    moveTo(place);
    press();
}

void PalpationController::press()
{
    m_hand.press();
    m_live.pointer().setState(m_hand.state(seconds(core::monotonicNow_ns())));
    run();
}

void PalpationController::moveTo(const QPointF& place)
{
    point(m_viewport.rayAt(place));
}

void PalpationController::point(const view::Ray& ray)
{
    const auto pick = m_viewport.view().pick(ray);
    m_hand.pointAt(ray.p_W, ray.d_W, pick ? std::optional(pick->hit.p_W) : std::nullopt);
    run();
}

void PalpationController::run()
{
    if (!m_timer.isActive()) {
        m_timer.start();
        step();
    }
}

void PalpationController::step()
{
    const std::int64_t now_ns = core::monotonicNow_ns();
    if (!m_live.usesPointer()) {
        showDevice(now_ns);
        return;
    }
    const double now_s = seconds(now_ns);
    m_live.pointer().setState(m_hand.state(now_s));
    const PointerHand::Phase phase = m_hand.phase(now_s);
    const bool isNew = m_live.fetch(m_tick);
    const bool isFelt = isNew && (m_tick.flags & servo::kNoHand) == 0;
    if (phase == PointerHand::Phase::Away) {
        m_timer.stop();
        m_shown = {};
        m_viewport.view().cursor().setState(m_shown);
        m_viewport.update();
        Q_EMIT handGone();
        return;
    }
    if (phase == PointerHand::Phase::Hovering) {
        // The device is told nothing of a hovering hand, so its ticks say nothing of it: show where it hovers.
        servo::TickRecord hover;
        hover.p_WH = *m_hand.hoverPoint();
        hover.felt.p_WG = hover.p_WH;
        show(hover, now_ns);
        return;
    }
    if (isFelt) {
        show(m_tick, now_ns);
    }
}

void PalpationController::showDevice(std::int64_t now_ns)
{
    if (!m_live.fetch(m_tick)) {
        return;
    }
    if ((m_tick.flags & servo::kNoHand) == 0) {
        show(m_tick, now_ns);
    } else if (m_shown.isPresent) {
        m_shown = {};
        m_viewport.view().cursor().setState(m_shown);
        m_viewport.update();
        Q_EMIT handGone();
    }
}

void PalpationController::show(const servo::TickRecord& tick, std::int64_t now_ns)
{
    if (now_ns - m_shown_ns < kFrame_ns) {
        return;
    }
    m_shown_ns = now_ns;
    // What the hand feels: of a device that pushes, what it was given, nothing after a fault.
    const core::Vec3& f_W = m_live.deviceInfo().actuatedAxes > 0 ? tick.fSent_W : tick.felt.f_W;
    view::TouchState state;
    state.p_WH = tick.p_WH;
    state.p_WG = tick.felt.p_WG;
    state.f_W = f_W;
    state.fingertip_mm = m_live.fingertip_mm();
    state.isInContact = tick.felt.structure >= 0;
    state.isPresent = true;
    TouchReading reading;
    if (state.isInContact) {
        reading.layers = feltLayers(tick, f_W.norm(), [this](std::uint32_t number) {
            const int row = static_cast<int>(number);
            return row < m_model.rowCount()
                       ? LayerLook{readableName(m_model.structure(row).name), colourOf(m_model.structure(row))}
                       : LayerLook{};
        });
        showInner(tick, reading.layers, state);
        if (tick.felt.structure < m_model.rowCount()) {
            showFriction(tick, m_model.structure(tick.felt.structure).tissue, state);
        }
    }
    if (!m_shown.isPresent || state.innerCount != m_shown.innerCount || state.p_WH != m_shown.p_WH ||
        state.p_WG != m_shown.p_WG || state.f_W != m_shown.f_W) {
        m_shown = state;
        m_viewport.view().cursor().setState(state);
        m_viewport.update();
    }
    reading.time_s = seconds(now_ns);
    reading.solveP99_us = m_live.solveP99_us();
    reading.isAtBound = (tick.flags & servo::kIterationLimit) != 0;
    if (state.isInContact && tick.felt.structure < m_model.rowCount()) {
        reading.structure = readableName(m_model.structure(tick.felt.structure).name);
        for (std::size_t i = 0; i < tick.felt.contactCount; ++i) {
            const haptics::Contact& contact = tick.felt.contacts[i];
            const int row = static_cast<int>(contact.structure);
            if (row < m_model.rowCount()) {
                const meshio::LoadedStructure& touched = m_model.rows()[contact.structure].loaded;
                reading.stiffness_N_per_mm += study::stiffnessScaleAt(touched, contact.triangle, contact.p_WG) *
                                              haptics::stiffnessAt(touched.description.tissue, contact.depth_mm);
            }
        }
        reading.force_N = f_W.norm();
        reading.depth_mm = (tick.felt.p_WG - tick.p_WH).norm();
        reading.constraints = tick.felt.constraints;
    }
    Q_EMIT touched(reading);
}

} // namespace palpate::ui

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/PalpationController.h"

#include "palpate/ui/DrawnMotion.h"
#include "palpate/ui/LumpAtContact.h"

#include <palpate/core/Clock.h>
#include <palpate/haptics/ForceTable.h>

#include <palpate/study/EffortDepth.h>

#include <QLocale>

#include <algorithm>

namespace palpate::ui {

namespace {

constexpr int kHandPeriod_ms = 4;              // update interval of the device's target while the pointer moves
constexpr std::int64_t kFrame_ns = 15'000'000; // view and readings update at display rate

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
    connectPointer();
    connect(&live, &LiveTouch::deviceChanged, this, [this] {
        m_hand.goAway();
        m_isByKeys = false;
        forgetPress();
        run();
    });
    refreshText();
}

void PalpationController::connectPointer()
{
    connect(&m_viewport, &VtkViewport::pointerMoved, this, [this] {
        if (m_isByKeys && isPressing()) {
            return; // an accidental mouse motion must not drag a press made by keys
        }
        m_isByKeys = false;
        if (const auto ray = m_viewport.pointerRay()) {
            point(*ray);
        }
    });
    connect(&m_viewport, &VtkViewport::pointerPressed, this, [this] {
        if (m_isByKeys) {
            letGo(); // the first click only transfers the hand to the pointer
        } else {
            press();
        }
    });
    connect(&m_viewport, &VtkViewport::pointerReleased, this, [this] { letGo(); });
    connect(&m_viewport, &VtkViewport::pointerLeft, this, [this] {
        if (!m_isByKeys) {
            m_hand.goAway();
            run();
        }
    });
    connect(&m_viewport, &VtkViewport::penPressed, this, [this](double pressure) { m_effort.setShare(pressure); });
    connect(&m_viewport, &VtkViewport::depthTurned, this, [this](double notches) {
        if (m_isByEffort) {
            turnEffort(notches);
        } else {
            emitDepth(m_hand.turnDepth(notches), notches > 0.0);
            run();
        }
    });
}

bool PalpationController::isPressing() const
{
    return m_hand.phase(seconds(core::monotonicNow_ns())) == PointerHand::Phase::Pressing;
}

/// Radius from which the place of first touch is computed. A press keeps the radius with which it began: with another
/// one, its depth would count from another place, and the hand would jump there.
std::optional<double> PalpationController::pressFingertip_mm() const
{
    return isPressing() ? std::optional(m_pressFingertip_mm) : std::nullopt;
}

void PalpationController::emitDepth(bool isWithin, bool isDeeper)
{
    Q_EMIT depthChanged(depth_mm());
    if (!isWithin && isDeeper) {
        Q_EMIT said(tr("%1 mm is the maximum depth, limited by the size of the scene.")
                        .arg(QLocale().toString(depth_mm(), 'f', 0)));
    }
    refreshText();
}

void PalpationController::setPress(const HandSettings& settings)
{
    if (m_isByEffort != settings.isByEffort) {
        letGo(); // the current press uses the other mode
        m_hand.setAim(std::nullopt);
    }
    m_isByEffort = settings.isByEffort;
    m_effort.setMost(settings.effort_N);
    refreshText();
}

void PalpationController::turnEffort(double notches)
{
    const bool isWithin = m_effort.turn(notches);
    Q_EMIT effortTurned(m_effort.most_N());
    if (!isWithin && notches > 0.0) {
        Q_EMIT said(tr("%1 N is the maximum press force.").arg(QLocale().toString(m_effort.most_N(), 'f', 0)));
    }
    refreshText();
}

/// Sets the depth of a press by effort to the depth at which the surfaces in the way resist with the requested force.
void PalpationController::updateEffortDepth(double now_s)
{
    if (!m_isByEffort || !isPressing()) {
        return; // during lift-off the hand returns from its current depth
    }
    const double hover_mm = m_hand.settings().hover_mm;
    const view::Ray press{*m_hand.hoverPoint(), m_hand.direction()};
    std::vector<study::PressedSurface> inTheWay;
    if (m_live.scene() != nullptr) {
        inTheWay = surfacesAlongPress(*m_live.scene(), press, m_live.time_s(), pressFingertip_mm());
    }
    // Without a surface in the way, e.g. beyond a rim, nothing resists: the hand stays at surface height.
    m_hand.setAim(inTheWay.empty() ? 0.0
                                   : study::pressTravel_mm(inTheWay, m_effort.force_N(now_s),
                                                           hover_mm + m_hand.settings().deepest_mm) -
                                         hover_mm);
}

bool PalpationController::takeByKeys()
{
    if (!m_live.usesPointer()) {
        return false; // another device is the hand
    }
    if (!m_isPalpating) {
        Q_EMIT palpationWanted();
    }
    if (!m_isPalpating) {
        return false;
    }
    if (!m_hand.surfacePoint()) {
        const auto place = m_viewport.palpablePlace();
        if (!place) {
            Q_EMIT said(tr("No palpable structure is in view."));
            return false;
        }
        m_isByKeys = true;
        point(m_viewport.rayAt(*place));
    }
    m_isByKeys = true;
    return true;
}

void PalpationController::stepAlongScreen(int right, int up)
{
    if (!takeByKeys()) {
        return;
    }
    const view::ViewFrame frame = view::ViewFrame::of(m_viewport.view().renderer(), m_viewport.devicePixelRatioF());
    const double stride_mm = m_hand.settings().stride_mm;
    const core::Vec3 p_W =
        *m_hand.surfacePoint() + m_toSurface_W + stride_mm * (right * frame.right_W + up * frame.up_W);
    if (isPressing()) {
        // Keeps the press direction after a camera rotation; a new line of sight would make the hand jump.
        const core::Vec3 d_W = m_hand.direction();
        point({p_W - (frame.eye_W - p_W).norm() * d_W, d_W});
    } else {
        point(m_viewport.rayAt(m_viewport.placeOf(p_W)));
    }
}

void PalpationController::togglePress()
{
    if (m_isByKeys && isPressing()) {
        letGo();
    } else if (!isPressing() && takeByKeys()) {
        followCamera(); // the fingertip may have changed since the last step
        press();
    }
}

void PalpationController::stepDepth(int steps)
{
    if (m_live.usesPointer() && m_isByEffort) {
        turnEffort(steps);
    } else if (m_live.usesPointer()) {
        emitDepth(m_hand.stepDepth(steps), steps > 0);
        run();
    }
}

void PalpationController::followCamera()
{
    if (m_isByKeys && !isPressing() && m_hand.surfacePoint()) {
        point(m_viewport.rayAt(m_viewport.placeOf(*m_hand.surfacePoint() + m_toSurface_W)));
    }
}

/// Keeps a hovering hand over the place of the pointer while the tissue moves.
void PalpationController::followTissue()
{
    const auto& rows = m_model.rows();
    if (std::none_of(rows.begin(), rows.end(), [](const auto& row) { return row.loaded.motion != nullptr; })) {
        return;
    }
    if (m_isByKeys) {
        followCamera();
    } else if (const auto ray = m_viewport.pointerRay()) {
        point(*ray);
    }
}

QString PalpationController::text() const
{
    const auto number = [](double depth_mm) {
        return QLocale().toString(depth_mm, 'f', depth_mm < 0.95 ? 2 : depth_mm < 9.95 ? 1 : 0);
    };
    if (!m_isPalpating || !m_live.usesPointer()) {
        return tr("camera");
    }
    if (m_isByEffort) {
        const QString most = QLocale().toString(m_effort.most_N(), 'f', 1);
        if (!isPressing()) {
            return tr("presses up to %1 N").arg(most);
        }
        const double force_N = m_effort.force_N(seconds(core::monotonicNow_ns()));
        const QString pressed = number(std::max(0.0, m_pressed_mm));
        return m_isSlidOff ? tr("pressing %1 mm, slid aside").arg(pressed)
                           : tr("target %1 of %2 N, actual %3 N, %4 mm")
                                 .arg(QLocale().toString(force_N, 'f', 1), most,
                                      QLocale().toString(m_live.newest().felt.f_W.norm(), 'f', 1), pressed);
    }
    if (!isPressing()) {
        return tr("presses %1 mm").arg(number(depth_mm()));
    }
    const QString pressed = number(std::max(0.0, m_pressed_mm)), wanted = number(depth_mm());
    if (m_isSlidOff) {
        return tr("pressing %1 mm, slid aside").arg(pressed);
    }
    return pressed == wanted ? tr("pressing %1 mm").arg(wanted) : tr("pressing %1 of %2 mm").arg(pressed, wanted);
}

void PalpationController::refreshText()
{
    if (const QString now = text(); now != m_text) {
        m_text = now;
        Q_EMIT textChanged();
    }
}

/// Updates the commanded depth, and whether the surface has slid aside from under the hand.
void PalpationController::updatePressState(const servo::TickRecord& tick, TouchReading& reading)
{
    // Fraction of the commanded depth. The penetration depth falls below this only where the surface deflects the hand
    // sideways.
    constexpr double kFelt = 0.4;
    m_pressed_mm = m_live.usesPointer() && isPressing() ? m_hand.pressedDepth_mm(tick.p_WH) : 0.0;
    const double felt_mm = tick.felt.structure >= 0 ? (tick.felt.p_WG - tick.p_WH).norm() : 0.0;
    reading.isSlidOff = m_isSlidOff = m_pressed_mm > m_hand.settings().hover_mm && felt_mm < kFelt * m_pressed_mm;
    refreshText();
}

void PalpationController::setPalpating(bool isPalpating)
{
    m_isPalpating = isPalpating;
    m_viewport.setMode(isPalpating ? VtkViewport::Mode::Palpate : VtkViewport::Mode::Camera);
    if (!isPalpating) {
        forgetPress();
        m_hand.goAway();
        m_isByKeys = false;
        run();
    } else if (const auto ray = m_viewport.pointerRay()) {
        point(*ray);
    }
    refreshText();
}

bool PalpationController::letGo()
{
    const double now_s = seconds(core::monotonicNow_ns());
    const bool wasPressing = m_hand.phase(now_s) == PointerHand::Phase::Pressing;
    m_hand.release(now_s);
    m_isPushed = false;
    m_effort.end();
    m_live.pointer().setState(m_hand.state(now_s)); // immediately, since the next step may be delayed by rendering
    run();
    m_pressed_mm = 0.0;
    m_isSlidOff = false;
    refreshText();
    return wasPressing;
}

void PalpationController::push(double share)
{
    if (share > 0.0 && m_isPalpating && m_live.usesPointer() && m_hand.surfacePoint()) {
        if (!isPressing()) {
            m_isPushed = true;
            press();
        }
        m_effort.setShare(share);
    } else if (m_isPushed) {
        letGo();
    }
}

void PalpationController::setSceneSize(double diagonal_mm)
{
    m_hand.goAway();
    m_isByKeys = false;
    m_hand.setSettings(settingsForSize(diagonal_mm));
    forgetPress();
    Q_EMIT depthChanged(depth_mm());
    refreshText();
    run();
}

void PalpationController::pressAt(const QPointF& place)
{
    moveTo(place);
    press();
}

void PalpationController::press()
{
    const double now_s = seconds(core::monotonicNow_ns());
    m_pressFingertip_mm = m_live.scene() != nullptr ? m_live.scene()->fingertip_mm() : 0.0;
    Q_EMIT m_viewport.hoverEnded(); // the name at the pointer, for a press by keys
    m_hand.press();
    m_effort.begin(now_s + m_hand.settings().pressTime_s);
    updateEffortDepth(now_s);
    m_live.pointer().setState(m_hand.state(now_s));
    run();
}

void PalpationController::moveTo(const QPointF& place)
{
    point(m_viewport.rayAt(place));
}

void PalpationController::point(const view::Ray& ray)
{
    const auto pick = m_viewport.view().pick(ray);
    std::optional<core::Vec3> place_W;
    if (pick) {
        // The hand is the centre of the fingertip, which touches before the centre reaches the surface.
        const double hit_mm = pick->hit.distance_mm;
        const double touch_mm = m_live.scene() != nullptr ? touchAlongRay_mm(*m_live.scene(), ray, hit_mm,
                                                                             m_live.time_s(), pressFingertip_mm())
                                                          : hit_mm;
        place_W = ray.p_W + touch_mm * ray.d_W;
        m_toSurface_W = pick->hit.p_W - *place_W;
    }
    m_hand.pointAt(ray.p_W, ray.d_W, place_W);
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
    updateEffortDepth(now_s);
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
        // A hovering hand is reported to the device as absent, so its ticks contain no position. Show the hover point
        // instead.
        if (now_ns - m_shown_ns >= kFrame_ns) {
            followTissue();
        }
        servo::TickRecord hover;
        hover.tick = m_live.newest().tick;
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
    if (now_ns - m_shown_ns < kFrame_ns || m_live.isLent()) {
        return;
    }
    m_shown_ns = now_ns;
    // Force on the hand: the sent force for devices with motors (zero after a fault), else the model force.
    const core::Vec3& f_W = m_live.deviceInfo().actuatedAxes > 0 ? tick.fSent_W : tick.felt.f_W;
    TouchReading reading;
    const bool isTouching = tick.felt.structure >= 0;
    if (isTouching) {
        reading.layers = layerShares(tick, f_W.norm(), [this](std::uint32_t number) {
            const int row = static_cast<int>(number);
            return row < m_model.rowCount()
                       ? LayerStyle{m_model.shownName(row), colourOf(m_model.structure(row)), !m_model.isListed(row)}
                       : LayerStyle{};
        });
    }
    const core::Tissue* tissue = isTouching && tick.felt.structure < m_model.rowCount()
                                     ? &m_model.structure(tick.felt.structure).tissue
                                     : nullptr;
    drawMotion(m_viewport.view(), m_model, m_live.timeOf_s(tick));
    view::TouchState state = touchState(tick, f_W, m_live.fingertip_mm(), reading.layers, tissue);
    state.isPresent = true; // including hovering, which the device does not know
    state.hasCrosshair = m_isByKeys;
    updatePressState(tick, reading);
    if (!m_shown.isPresent || state.innerCount != m_shown.innerCount || state.p_WH != m_shown.p_WH ||
        state.p_WG != m_shown.p_WG || state.f_W != m_shown.f_W || state.hasCrosshair != m_shown.hasCrosshair) {
        m_shown = state;
        m_viewport.view().cursor().setState(state);
        m_viewport.update();
    }
    reading.time_s = seconds(now_ns);
    reading.isAtIterationLimit = (tick.flags & servo::kIterationLimit) != 0;
    if (state.isInContact && tick.felt.structure < m_model.rowCount()) {
        reading.structure =
            reading.layers.empty() ? m_model.shownName(tick.felt.structure) : reading.layers.front().name;
        const ContactStiffness stiffness = contactStiffness(tick, [this](std::uint32_t number) {
            const int row = static_cast<int>(number);
            return row < m_model.rowCount() ? &m_model.structure(row).tissue : nullptr;
        });
        reading.stiffness_N_per_mm = stiffness.whole_N_per_mm;
        reading.stiffnessRatio = stiffness.ratio;
        reading.force_N = f_W.norm();
        reading.depth_mm = (tick.felt.p_WG - tick.p_WH).norm();
        reading.constraints = tick.felt.constraints;
        const auto& touched = m_model.rows()[static_cast<std::size_t>(tick.felt.structure)].loaded;
        addLump(m_model, tick.felt.structure,
                restOf(touched.motion.get(), m_live.timeOf_s(tick), tick.felt.touched_W()), reading);
    }
    if (m_live.usesPointer() && isPressing()) {
        m_lastPress = state.isInContact ? std::optional<Press>({state, reading, tick.tick}) : std::nullopt;
    }
    Q_EMIT touched(reading);
}

} // namespace palpate::ui

#include "palpate/ui/moc_PalpationController.cpp"

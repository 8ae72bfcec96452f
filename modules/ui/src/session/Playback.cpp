// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/Playback.h"

#include "palpate/ui/DrawnMotion.h"
#include "palpate/ui/LumpAtContact.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace palpate::ui {

namespace {

constexpr int kFrame_ms = 16;
constexpr double kChartStep_s = 0.04; // sampling interval of the chart after a seek

} // namespace

Playback::Playback(VtkViewport& viewport, const StructureModel& model, SessionPanel& panel, TouchPanel& touch,
                   QObject* parent)
    : QObject(parent)
    , m_viewport(viewport)
    , m_model(model)
    , m_panel(panel)
    , m_touch(touch)
{
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setInterval(kFrame_ms);
    connect(&m_timer, &QTimer::timeout, this, &Playback::step);
    connect(&panel, &SessionPanel::sought, this, [this] { seek(m_panel.transport().position_s()); });
    connect(&panel, &SessionPanel::secondSought, this, &Playback::showSecondMoment);
}

void Playback::setRecording(std::unique_ptr<RecordedTouch> recording)
{
    m_timer.stop();
    setSecond(nullptr);
    m_recording = std::move(recording);
    m_viewport.view().handPath().set({});
    m_peak_s = 0.0;
    m_touch.clearHistory();
    m_panel.timeline().clear();
    m_panel.transport().setDuration(m_recording == nullptr ? 0.0 : m_recording->duration_s());
    if (m_recording == nullptr) {
        m_panel.showTitle({});
        m_panel.refresh();
        Q_EMIT stateChanged();
        return;
    }
    showNames();
    m_panel.timeline().setPeaks({}, m_recording->duration_s());
    m_panel.timeline().setMarks(m_recording->marks());
    connect(m_recording.get(), &RecordedTouch::overviewReady, this, [this](const std::vector<float>& peaks_N) {
        const auto peak = std::max_element(peaks_N.begin(), peaks_N.end());
        // Centre of the bin with the greatest force.
        m_peak_s = (static_cast<double>(peak - peaks_N.begin()) + 0.5) / static_cast<double>(peaks_N.size()) *
                   m_recording->duration_s();
        m_panel.timeline().setPeaks(peaks_N, m_recording->duration_s());
        m_panel.alignAxes();
        m_panel.refresh();
        showPath();
        Q_EMIT overviewReady();
    });
    m_recording->startOverview();
    m_panel.refresh();
    showMoment(0.0);
    Q_EMIT stateChanged();
}

/// Shows the path of the hand in the place of surfaces that were not found.
void Playback::showPath()
{
    view::SceneView& view = m_viewport.view();
    if (view.structureCount() > 0) {
        return;
    }
    view.handPath().set(m_recording->path_W());
    view.look(view::ViewFrom::Oblique);
    m_viewport.update();
}

void Playback::setSecond(std::unique_ptr<RecordedTouch> second)
{
    if (m_recording == nullptr || (second == nullptr && m_second == nullptr)) {
        return;
    }
    m_second = std::move(second);
    const double duration_s = m_second == nullptr ? 0.0 : m_second->duration_s();
    m_panel.secondTransport().setDuration(duration_s);
    m_panel.secondTimeline().clear();
    m_panel.showSecond(m_second != nullptr);
    m_panel.alignAxes();
    showNames();
    if (m_second != nullptr) {
        if (position_s() >= m_recording->duration_s()) {
            m_panel.secondTransport().seek(duration_s); // both at the end: the map shows all of both
        }
        m_panel.secondTimeline().setPeaks({}, duration_s);
        m_panel.secondTimeline().setMarks(m_second->marks());
        connect(m_second.get(), &RecordedTouch::overviewReady, this, [this](const std::vector<float>& peaks_N) {
            m_panel.secondTimeline().setPeaks(peaks_N, m_second->duration_s());
            m_panel.alignAxes();
            m_panel.refresh();
        });
        m_second->startOverview();
    }
    m_panel.refresh();
    showSecondMoment();
    Q_EMIT stateChanged();
}

void Playback::showNames()
{
    const auto nameOf = [](const RecordedTouch& one) { return QString::fromStdString(one.path().filename().string()); };
    m_panel.showTitle(m_second == nullptr ? nameOf(*m_recording)
                                          : tr("A: %1, B: %2").arg(nameOf(*m_recording), nameOf(*m_second)));
}

bool Playback::isPlaying() const
{
    return m_recording != nullptr && (m_panel.transport().isPlaying() || m_panel.secondTransport().isPlaying());
}

void Playback::play()
{
    if (m_recording == nullptr) {
        return;
    }
    // From the start once both have ended; else the one that has ended waits for the other.
    const auto isOver = [](const Transport& one) { return one.position_s() >= one.duration_s(); };
    Transport &first = m_panel.transport(), &second = m_panel.secondTransport();
    const bool isAllOver = isOver(first) && isOver(second);
    for (Transport* one : {&first, &second}) {
        if (isAllOver || !isOver(*one)) {
            one->play();
        }
    }
    m_clock.start();
    m_timer.start();
    Q_EMIT stateChanged();
}

void Playback::pause()
{
    m_panel.transport().pause();
    m_panel.secondTransport().pause();
    m_timer.stop();
    Q_EMIT stateChanged();
}

void Playback::toStart()
{
    seek(0.0);
    seekSecond(0.0);
}

void Playback::step()
{
    const double elapsed_s = static_cast<double>(m_clock.nsecsElapsed()) * 1e-9;
    m_clock.restart();
    if (m_panel.transport().isPlaying()) {
        m_panel.transport().advance(elapsed_s);
        showMoment(m_panel.transport().position_s());
    }
    if (m_panel.secondTransport().isPlaying()) {
        m_panel.secondTransport().advance(elapsed_s);
        showSecondMoment();
    }
    m_panel.refresh();
    if (!isPlaying()) { // at the end
        pause();
    }
}

void Playback::seekSecond(double position_s)
{
    m_panel.secondTransport().seek(position_s);
    showSecondMoment();
    m_panel.refresh();
}

/// Shows where the second hand is in contact.
void Playback::showSecondMoment()
{
    view::PlaceRing& ring = m_viewport.view().secondHand();
    const double time_s = m_panel.secondTransport().position_s();
    const auto tick = m_second == nullptr ? std::nullopt : m_second->at(time_s);
    if (!tick || tick->felt.structure < 0) {
        ring.hide();
    } else {
        constexpr double kLeast_mm = 5.0;                                             // of a point-like hand
        constexpr std::size_t kNoStructure = std::numeric_limits<std::size_t>::max(); // does not move with one
        const view::TouchState state =
            touchState(*tick, tick->felt.f_W, m_second->fingertip_mm(*tick), {}, m_second->tissue(*tick));
        ring.show(state.onSurface_W(), state.n_W.isZero() ? core::Vec3(core::Vec3::UnitZ()) : state.n_W,
                  std::max(m_second->fingertip_mm(*tick), kLeast_mm), kNoStructure);
    }
    m_viewport.update();
    if (m_second != nullptr) {
        Q_EMIT secondMomentShown(time_s);
    }
}

void Playback::seek(double position_s)
{
    if (m_recording == nullptr) {
        return;
    }
    Transport& transport = m_panel.transport();
    transport.seek(position_s);
    m_touch.clearHistory();
    for (double t = std::max(0.0, transport.position_s() - TouchHistory::kLength_s); t < transport.position_s();
         t += kChartStep_s) {
        if (const auto tick = m_recording->at(t)) {
            feed(*tick, t);
        }
    }
    showMoment(transport.position_s());
    m_panel.refresh();
}

LayerStyle Playback::lookOf(const servo::TickRecord& tick, std::uint32_t number) const
{
    const std::string name = m_recording->structureName(tick, number);
    if (name.empty()) {
        return {tr("structure %1").arg(number + 1), QColor(Qt::gray)};
    }
    for (int row = 0; row < m_model.rowCount(); ++row) {
        if (m_model.structure(row).name == name) {
            return {readableName(name), colourOf(m_model.structure(row))};
        }
    }
    return {readableName(name), QColor(Qt::gray)};
}

std::vector<LayerShare> Playback::layersOf(const servo::TickRecord& tick) const
{
    return layerShares(tick, tick.felt.f_W.norm(), [&](std::uint32_t number) { return lookOf(tick, number); });
}

/// Adds the transmitted lump at the contact, if the open scene contains the touched structure.
void Playback::addLump(TouchReading& reading, const servo::TickRecord& tick) const
{
    const std::string name = m_recording->structureName(tick, static_cast<std::uint32_t>(tick.felt.structure));
    for (int row = 0; row < m_model.rowCount(); ++row) {
        if (m_model.structure(row).name != name) {
            continue;
        }
        const auto motion = motionOf(tick, row);
        ui::addLump(m_model, row, restOf(motion.get(), m_recording->timeOf_s(tick), tick.felt.touched_W()), reading);
        return;
    }
}

std::shared_ptr<const geometry::SurfaceMotion> Playback::motionOf(const servo::TickRecord& tick, int row) const
{
    return m_recording->motion(tick, m_model.structure(row).name,
                               m_model.rows()[static_cast<std::size_t>(row)].loaded.motion);
}

void Playback::feed(const servo::TickRecord& tick, double time_s)
{
    TouchReading reading;
    reading.time_s = time_s;
    reading.recorded_s = time_s;
    reading.isAtIterationLimit = (tick.flags & servo::kIterationLimit) != 0;
    if (tick.felt.structure >= 0) {
        reading.layers = layersOf(tick);
        reading.structure = lookOf(tick, static_cast<std::uint32_t>(tick.felt.structure)).name;
        const ContactStiffness stiffness = m_recording->stiffness(tick);
        reading.stiffness_N_per_mm = stiffness.whole_N_per_mm;
        reading.stiffnessRatio = stiffness.ratio;
        reading.force_N = tick.felt.f_W.norm();
        reading.depth_mm = (tick.felt.p_WG - tick.p_WH).norm();
        reading.constraints = tick.felt.constraints;
        addLump(reading, tick);
    }
    m_touch.show(reading);
}

void Playback::showMoment(double time_s)
{
    const auto tick = m_recording->at(time_s);
    if (!tick) {
        return;
    }
    const view::TouchState state = touchState(*tick, tick->felt.f_W, m_recording->fingertip_mm(*tick), layersOf(*tick),
                                              m_recording->tissue(*tick));
    std::vector<std::shared_ptr<const geometry::SurfaceMotion>> motions;
    for (int row = 0; row < m_model.rowCount(); ++row) {
        motions.push_back(motionOf(*tick, row));
    }
    m_viewport.view().moveTo(motions, m_recording->timeOf_s(*tick));
    m_viewport.view().cursor().setState(state);
    m_viewport.update();
    feed(*tick, time_s);
    Q_EMIT momentShown(time_s);
}

} // namespace palpate::ui

#include "palpate/ui/moc_Playback.cpp"

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/LiveTouch.h"

#include "palpate/ui/Translated.h"

#include <algorithm>

#include <palpate/core/Clock.h>
#include <palpate/haptics/ForceTable.h>
#include <palpate/servo/PassivityController.h>
#include <palpate/study/DeviceLimit.h>
#include <palpate/study/RecordedLooks.h>
#include <palpate/study/RecordedScene.h>

#include <cmath>

namespace palpate::ui {

namespace {

constexpr double kRounding = 1e-5; // relative rounding error of the slope of a limited law

} // namespace

LiveTouch::LiveTouch(StructureModel& model, QObject* parent)
    : QObject(parent)
    , m_model(model)
    , m_info(m_pointer.info())
{
    m_handOver.setSingleShot(true);
    m_handOver.setInterval(0);
    connect(&m_handOver, &QTimer::timeout, this, &LiveTouch::handOverScene);
    connect(&model, &StructureModel::edited, this, [this](int, StructureModel::Change change) {
        if (change == StructureModel::Change::Touch) {
            m_handOver.start();
        }
    });
    connect(&model, &StructureModel::motionsChanged, &m_handOver, qOverload<>(&QTimer::start));
    connect(&model, &QAbstractItemModel::modelReset, this, [this] {
        // The motions of a new scene begin when it opens, while the loop goes on counting.
        m_model.changeMotions([this](const auto& motion) { return motion->startingAt(-time_s()); });
    });
    connect(&model, &QAbstractItemModel::modelReset, &m_handOver, qOverload<>(&QTimer::start));
    m_meter.setInterval(500);
    connect(&m_meter, &QTimer::timeout, this, &LiveTouch::measure);
}

LiveTouch::~LiveTouch()
{
    stop();
}

haptics::Tissue LiveTouch::maxTissue() const
{
    return study::maxTissue(m_info, heldStiffness_N_per_mm());
}

double LiveTouch::heldStiffness_N_per_mm() const
{
    // A scene millimetre is 1 / scale device millimetres, and the loop is closed in device units.
    return servo::heldStiffness_N_per_mm(m_info, rate_Hz(), true, m_delayTicks) / (m_map.isDirect ? 1.0 : m_map.scale);
}

QString LiveTouch::limitText() const
{
    const QString name = QString::fromStdString(m_info.name);
    const double held = heldStiffness_N_per_mm();
    if (!std::isfinite(held)) {
        return tr("%1 can render tissue up to %2 N/mm.").arg(name, numberText(maxTissue().stiffness_N_per_mm));
    }
    const double scale = m_map.isDirect ? 1.0 : m_map.scale;
    QString text = tr("%1 can render tissue up to %2 N/mm here.").arg(name, numberText(held, 3));
    if (held * scale >= m_info.maxStiffness_N_per_mm && m_info.maxStiffness_N_per_mm > 0.0) {
        text += tr(" This is the rating of the manufacturer.");
    } else {
        text += tr(" The force is delayed by %1 ms; stiffer tissue could make the device vibrate.")
                    .arg(numberText(1e3 * m_delayTicks / rate_Hz(), 3));
    }
    if (scale > 1.0) {
        text += tr(" 1 mm of the device is %1 mm of the scene; a smaller scale (Device panel) allows stiffer tissue.")
                    .arg(numberText(scale, 3));
    }
    return text;
}

double LiveTouch::rate_Hz() const
{
    return m_options.rate_Hz;
}

core::Status LiveTouch::setLoop(double rate_Hz, int cpu)
{
    if (rate_Hz == m_options.rate_Hz && cpu == m_options.cpu) {
        return {};
    }
    if (m_session.recording().isRecording) {
        return {core::StatusCode::Unsupported,
                PALPATE_TEXT("rate and CPU cannot be changed while a recording runs; stop it first")};
    }
    if (core::Status allowed = servo::checkCpu(cpu); !allowed.isOk()) {
        return allowed;
    }
    carryMotions();
    m_options.rate_Hz = rate_Hz;
    m_options.cpu = cpu;
    core::Status status;
    if (m_session.loop().isRunning()) {
        m_delayTicks = 1;
        m_ticks = 0;
        m_measured_ns = core::monotonicNow_ns();
        status = m_session.loop().restart(m_options);
        if (!m_session.loop().isRunning()) {
            status = start();
        }
    }
    m_handOver.start(); // the stable limit has changed
    Q_EMIT greatestChanged();
    return status;
}

void LiveTouch::setMap(const servo::MapSettings& map)
{
    const bool isScaled = map.isDirect != m_map.isDirect || map.scale != m_map.scale;
    m_map = map;
    m_session.loop().setMap(map);
    if (isScaled) {
        m_handOver.start();
        Q_EMIT greatestChanged();
    }
}

bool LiveTouch::fetch(servo::TickRecord& tick)
{
    if (!m_session.loop().fetchSnapshot(tick)) {
        return false;
    }
    m_newest = tick;
    return true;
}

void LiveTouch::setFingertip(double radius_mm)
{
    if (radius_mm != m_fingertip_mm) {
        m_fingertip_mm = std::clamp(radius_mm, 0.0, haptics::HapticScene::kMostFingertip_mm);
        m_handOver.start();
    }
}

core::Status LiveTouch::start()
{
    if (m_session.loop().isRunning()) {
        return {};
    }
    m_delayTicks = 1;
    carryMotions();
    handOverScene();
    core::Status status = m_session.start(usesPointer() ? m_pointer : *m_device, m_options);
    if (!status.isOk() && !usesPointer()) {
        m_device.reset();
        m_info = m_pointer.info();
        handOverScene();
        (void)m_session.start(m_pointer, m_options); // the first error is reported
        Q_EMIT deviceChanged();
    }
    m_ticks = 0;
    m_measured_ns = core::monotonicNow_ns();
    m_meter.start();
    return status;
}

core::Status LiveTouch::useDevice(std::unique_ptr<device::HapticDevice> device)
{
    if (m_session.recording().isRecording) {
        return {core::StatusCode::Unsupported,
                PALPATE_TEXT("the device cannot be changed while a recording runs; stop it first")};
    }
    if (device == nullptr && usesPointer()) {
        return {};
    }
    const bool wasRunning = m_session.loop().isRunning();
    m_session.loop().stop();
    m_device = std::move(device);
    m_info = usesPointer() ? m_pointer.info() : m_device->info();
    m_delayTicks = 1;
    core::Status status = wasRunning ? start() : core::Status();
    Q_EMIT deviceChanged();
    return status;
}

device::DeviceReport LiveTouch::deviceReport() const
{
    return usesPointer() ? m_pointer.report() : m_device->report();
}

core::Status LiveTouch::calibrate()
{
    return usesPointer() ? m_pointer.calibrate() : m_device->calibrate();
}

void LiveTouch::stop()
{
    m_meter.stop();
    m_session.stop();
    m_newest = {};
}

/// A loop that starts counts its ticks from 0: tissue goes on from where it is.
void LiveTouch::carryMotions()
{
    const double last_s = time_s();
    m_newest = {};
    if (last_s > 0.0) {
        m_model.changeMotions([last_s](const auto& motion) { return motion->startingAt(last_s); });
    }
}

core::Status LiveTouch::lend(std::shared_ptr<const haptics::HapticScene> scene)
{
    if (recording().isRecording) {
        return {core::StatusCode::Mismatch, PALPATE_TEXT("stop the recording first")};
    }
    m_isLent = scene != nullptr;
    if (m_isLent) {
        (void)m_session.setScene(std::move(scene), {});
    } else {
        handOverScene();
    }
    return {};
}

void LiveTouch::handOverScene()
{
    if (m_isLent) {
        return; // handed over at the end
    }
    m_scene = m_model.hapticScene(maxTissue(), m_fingertip_mm);
    (void)m_session.setScene(m_scene, m_model.scene().sources()); // sources contain each palpable surface
    reportSoftenedStructure();
    Q_EMIT handedOver();
}

void LiveTouch::reportSoftenedStructure()
{
    const haptics::Tissue greatest = maxTissue();
    const std::vector<haptics::HapticStructure> felt = m_model.hapticStructures(greatest);
    const auto number = [](double stiffness_N_per_mm) { return numberText(stiffness_N_per_mm, 3); };
    const auto wanted = [this] { return m_model.hapticStructures(core::unbounded()); };
    QString line;
    for (int row = 0; row < m_model.rowCount() && line.isEmpty(); ++row) {
        const meshio::SceneStructure& one = m_model.structure(row);
        const auto at = static_cast<std::size_t>(row);
        const double asked =
            felt[at].maps.stiffness.isEmpty() ? haptics::maxStiffness(one.tissue) : study::maxStiffness(wanted()[at]);
        const double is = study::maxStiffness(felt[at]);
        if (one.palpable && m_model.isListed(row) && asked > is * (1.0 + kRounding)) {
            // Short for the line below the view; the stiffness field explains the reason.
            line =
                tr("%1 is set to %2 N/mm but feels like %3 N/mm, the maximum that %4 can render here%5.")
                    .arg(QString::fromStdString(one.name), number(asked), number(is),
                         QString::fromStdString(m_info.name),
                         is < greatest.stiffness_N_per_mm ? tr(" in addition to the surrounding layers") : QString());
        }
    }
    if (line != m_refused) {
        m_refused = line;
        if (!line.isEmpty()) {
            Q_EMIT stiffnessRefused(line);
        }
    }
}

void LiveTouch::measure()
{
    const servo::TimingReport timing = m_session.loop().timing();
    const std::int64_t now_ns = core::monotonicNow_ns();
    if (timing.ticks >= m_ticks && now_ns > m_measured_ns) {
        m_rate_Hz = static_cast<double>(timing.ticks - m_ticks) / (static_cast<double>(now_ns - m_measured_ns) * 1e-9);
    }
    m_ticks = timing.ticks;
    m_measured_ns = now_ns;
    if (!usesPointer()) {
        setDelay(servo::delayTicksOf(m_device->report().latency, rate_Hz()));
    }
    if (const auto fault = m_session.poll()) {
        Q_EMIT faulted(translated(fault->message));
        if (m_info.actuatedAxes == 0) {
            m_session.loop().rearm(); // a device without motors cannot push: resume touch with a ramp
        }
    }
    Q_EMIT statusChanged();
}

void LiveTouch::setDelay(int ticks)
{
    if (ticks <= m_delayTicks) {
        return; // keeps the maximum, so that the limit does not fluctuate with each percentile
    }
    m_delayTicks = ticks;
    m_session.loop().setDelay(ticks);
    m_handOver.start();
    Q_EMIT greatestChanged();
}

core::Status LiveTouch::startRecording(const std::filesystem::path& path, const std::filesystem::path& scene,
                                       bool embeds)
{
    // Apply pending changes, so that the recording starts with the current scene.
    if (m_handOver.isActive()) {
        m_handOver.stop();
        handOverScene();
    }
    std::vector<study::RecordedLook> looks;
    for (std::size_t i = 0; i < m_model.rows().size(); ++i) {
        looks.push_back(study::lookOf(m_model.scene().described(i)));
    }
    session::RecordingInfo info;
    info.looks = study::looksText(looks);
    study::setSceneSource(info, scene);
    return m_session.startRecording(path, embeds ? session::Embed::Yes : session::Embed::No, std::move(info));
}

core::Status LiveTouch::stopRecording()
{
    return m_session.stopRecording();
}

} // namespace palpate::ui

#include "palpate/ui/moc_LiveTouch.cpp"

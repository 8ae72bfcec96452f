// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/MapWarnings.h"

#include "palpate/ui/DeviceChoice.h"

#include <QLocale>

#include <optional>

namespace palpate::ui {

namespace {

constexpr int kSettled_ms = 200; // delay after the latest change

bool pushesAnywhere(const haptics::HapticScene& scene)
{
    for (const haptics::HapticStructure& one : scene.structures()) {
        if (one.surface != nullptr && (!one.maps.stiffness.isEmpty() || one.maps.hasFelt())) {
            return true;
        }
    }
    return false;
}

QString placeText(const core::Vec3& p_W)
{
    const QLocale locale;
    return MapWarnings::tr("(%1; %2; %3) mm")
        .arg(locale.toString(p_W.x(), 'f', 1), locale.toString(p_W.y(), 'f', 1), locale.toString(p_W.z(), 'f', 1));
}

QString lineOf(const QString& name, const study::MapEdge& edge, const QString& device)
{
    const QLocale locale;
    const QString where =
        edge.isOfLumps ? MapWarnings::tr("%1: the effect of the lumps below changes too abruptly for the %2 at %3.")
                       : MapWarnings::tr("%1: the stiffness map changes too abruptly for the %2 at %3.");
    const QString what =
        MapWarnings::tr("The sideways force jumps by %1 N there and can make the hand oscillate by %2 mm.");
    const QString remedy =
        edge.isOfLumps
            ? MapWarnings::tr("Add friction to the tissue, or use a mesh with shorter edges there.")
            : MapWarnings::tr(
                  "Spread the step over a longer distance, smooth both ends, or add friction to the tissue.");
    return where.arg(name, device, placeText(edge.p_W)) + QLatin1Char(' ') +
           what.arg(locale.toString(edge.jump_N, 'f', 2), locale.toString(edge.swing_mm, 'f', 2)) + QLatin1Char(' ') +
           remedy;
}

} // namespace

MapWarnings::MapWarnings(LiveTouch& live, QObject* parent)
    : QObject(parent)
    , m_live(live)
{
    m_thread.setMaxThreadCount(1);
    m_wait.setSingleShot(true);
    m_wait.setInterval(kSettled_ms);
    connect(&m_wait, &QTimer::timeout, this, &MapWarnings::judge);
    connect(&live, &LiveTouch::handedOver, &m_wait, qOverload<>(&QTimer::start));
    connect(&live, &LiveTouch::deviceChanged, &m_wait, qOverload<>(&QTimer::start));
}

MapWarnings::~MapWarnings()
{
    m_thread.waitForDone();
}

void MapWarnings::judge()
{
    const int job = ++m_job;
    const servo::MapSettings& map = m_live.map();
    const std::optional<study::HeldDevice> device =
        study::heldDevice(m_live.deviceInfo(), m_live.rate_Hz(), m_live.delayTicks(), map.isDirect ? 1.0 : map.scale);
    const std::shared_ptr<const haptics::HapticScene> scene = m_live.scene();
    const QString name = deviceName(m_live.deviceInfo());
    if (!device || scene == nullptr || !pushesAnywhere(*scene)) {
        take(scene, {}, name);
        return;
    }
    m_thread.start([this, job, scene, device, name] {
        const std::vector<study::MapEdge> edges = study::mapEdges(*scene, *device);
        QMetaObject::invokeMethod(this, [this, job, scene, edges, name] {
            if (job == m_job) {
                take(scene, edges, name);
            }
        });
    });
}

void MapWarnings::take(const std::shared_ptr<const haptics::HapticScene>& scene,
                       const std::vector<study::MapEdge>& edges, const QString& device)
{
    QStringList lines, news;
    QSet<QString> told;
    for (std::size_t i = 0; scene != nullptr && i < scene->structures().size(); ++i) {
        lines << QString();
    }
    for (const study::MapEdge& edge : edges) {
        if (edge.swing_mm < study::kMinSwing_mm) {
            continue;
        }
        const QString name = readableName(scene->structures()[edge.structure].name);
        const QString line = lineOf(name, edge, device);
        const QString key = name + QLatin1Char('\n') + device + QLatin1Char('\n') + placeText(edge.p_W);
        lines[static_cast<qsizetype>(edge.structure)] = line;
        told.insert(key);
        if (!m_told.contains(key)) {
            news << line;
        }
    }
    m_told = told;
    if (lines != m_lines) {
        m_lines = lines;
        Q_EMIT changed();
    }
    for (const QString& line : news) {
        Q_EMIT warned(line);
    }
}

} // namespace palpate::ui

#include "palpate/ui/moc_MapWarnings.cpp"

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/RecordedTouch.h"

#include <palpate/session/Findings.h>
#include <palpate/study/RecordedScale.h>

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate::ui {

core::Result<std::unique_ptr<RecordedTouch>> RecordedTouch::open(const std::filesystem::path& path)
{
    auto reader = session::RecordingReader::open(path);
    if (!reader.isOk()) {
        return reader.status();
    }
    if (reader.value()->extent().ticks == 0) {
        return core::Status(core::StatusCode::Empty,
                            PALPATE_TEXT("%1: the recording holds no tick; there is nothing to play"),
                            path.filename().string());
    }
    return std::unique_ptr<RecordedTouch>(new RecordedTouch(path, std::move(reader).value()));
}

RecordedTouch::RecordedTouch(std::filesystem::path path, std::unique_ptr<session::RecordingReader> reader)
    : m_path(std::move(path))
    , m_reader(std::move(reader))
{
}

RecordedTouch::~RecordedTouch()
{
    m_isClosing = true;
    if (m_overview.joinable()) {
        m_overview.join();
    }
}

double RecordedTouch::duration_s() const
{
    return m_reader->extent().duration_s;
}

std::optional<servo::TickRecord> RecordedTouch::at(double time_s) const
{
    const session::RecordingExtent& extent = m_reader->extent();
    const auto offset = static_cast<std::int64_t>(std::llround(std::max(0.0, time_s) * m_reader->info().rate_Hz));
    const std::int64_t number = std::min(extent.firstTick + offset, extent.lastTick);
    std::optional<servo::TickRecord> tick = m_reader->at(number);
    const session::SceneRecord* scene = tick ? m_reader->scene(tick->scene) : nullptr;
    if (scene != nullptr) {
        const auto before = number > extent.firstTick ? m_reader->at(number - 1) : std::nullopt;
        const core::Vec3 v_WH =
            before ? core::Vec3((tick->p_WH - before->p_WH) * m_reader->info().rate_Hz) : core::Vec3::Zero();
        study::reconstructScales(*tick, *scene, v_WH);
    }
    return tick;
}

std::string RecordedTouch::structureName(const servo::TickRecord& tick, std::uint32_t number) const
{
    return std::string(m_reader->structureName(tick.scene, number));
}

double RecordedTouch::fingertip_mm(const servo::TickRecord& tick) const
{
    const session::SceneRecord* scene = m_reader->scene(tick.scene);
    return scene != nullptr ? scene->fingertip_mm : 0.0;
}

double RecordedTouch::timeOf_s(const servo::TickRecord& tick) const
{
    return static_cast<double>(tick.tick) * (1.0 / m_reader->info().rate_Hz);
}

std::shared_ptr<const geometry::SurfaceMotion>
RecordedTouch::motion(const servo::TickRecord& tick, const std::string& structure,
                      const std::shared_ptr<const geometry::SurfaceMotion>& own) const
{
    const session::SceneRecord* scene = m_reader->scene(tick.scene);
    if (scene == nullptr) {
        return own;
    }
    std::shared_ptr<const geometry::SurfaceMotion> found = own;
    for (const session::StructureRecord& one : scene->structures) {
        if (one.name == structure && one.palpable) {
            return one.motion;
        }
        if (own != nullptr && one.motion != nullptr && one.motion->shape() == own->shape()) {
            found = one.motion;
        }
    }
    return found;
}

const core::Tissue* RecordedTouch::tissue(const servo::TickRecord& tick) const
{
    const session::SceneRecord* scene = m_reader->scene(tick.scene);
    const auto number = static_cast<std::size_t>(tick.felt.structure);
    return scene != nullptr && tick.felt.structure >= 0 && number < scene->structures.size()
               ? &scene->structures[number].tissue
               : nullptr;
}

ContactStiffness RecordedTouch::stiffness(const servo::TickRecord& tick) const
{
    const session::SceneRecord* scene = m_reader->scene(tick.scene);
    return contactStiffness(tick, [scene](std::uint32_t number) {
        return scene != nullptr && number < scene->structures.size() ? &scene->structures[number].tissue : nullptr;
    });
}

std::vector<std::pair<double, QString>> RecordedTouch::marks() const
{
    std::vector<std::pair<double, QString>> marks;
    for (const session::RecordingEvent& event : m_reader->events()) {
        if (event.kind == "scene" || event.kind == "clutch" || event.kind == "timing" || event.kind == "shared") {
            // Scene changes have events of their own, clutch events repeat with each press, timing and shared concern
            // the whole recording.
            continue;
        }
        const double time_s = static_cast<double>(event.tick - m_reader->extent().firstTick) / m_reader->info().rate_Hz;
        if (event.kind == "finding" || event.kind == "note" || event.kind.starts_with("finding-")) {
            continue; // findings are added below in their final state
        }
        marks.emplace_back(std::max(0.0, time_s), QString::fromStdString(event.kind));
    }
    for (const auto& [tick, finding] : session::findingsOf(m_reader->events())) {
        const double time_s = static_cast<double>(tick - m_reader->extent().firstTick) / m_reader->info().rate_Hz;
        const QString name = QString::fromStdString(finding.name);
        const QString note = QString::fromStdString(finding.note);
        marks.emplace_back(std::max(0.0, time_s), note.isEmpty() ? name : name + QStringLiteral(": ") + note);
    }
    return marks;
}

std::vector<core::Finding> RecordedTouch::findings() const
{
    std::vector<core::Finding> findings;
    for (auto& [tick, finding] : session::findingsOf(m_reader->events())) {
        findings.push_back(std::move(finding));
    }
    return findings;
}

QString RecordedTouch::losses() const
{
    const session::RecordingExtent& extent = m_reader->extent();
    const QString name = QString::fromStdString(m_path.filename().string());
    const QString at = QLocale().toString(extent.duration_s, 'f', 1);
    if (const auto faults = m_reader->faults(); !faults.empty()) {
        return damageText(m_path, faults.size());
    }
    switch (extent.end) {
    case session::RecordingEnd::Closed:
        break;
    case session::RecordingEnd::DiskFull:
        return tr("%1 ends at %2 s because the disk was full. Later palpation was not recorded.").arg(name, at);
    case session::RecordingEnd::DiskFailed:
        return tr("%1 ends at %2 s because of a disk write error. Later palpation was not recorded.").arg(name, at);
    case session::RecordingEnd::CutOff:
        return tr("%1 was not closed (crash or full disk) and ends at %2 s. Later palpation was not recorded.")
            .arg(name, at);
    }
    if (extent.dropped > 0) {
        return tr("%1: %2 samples were lost during recording because the disk was too slow.")
            .arg(name, QLocale().toString(static_cast<qlonglong>(extent.dropped)));
    }
    return {};
}

QString damageText(const std::filesystem::path& recording, std::size_t places)
{
    return places == 0
               ? QString()
               : RecordedTouch::tr("%1 is damaged or was changed after recording: %n part(s) do not match their "
                                   "checksums and are left out. \"palpate session verify\" names the first part.",
                                   nullptr, static_cast<int>(std::min<std::size_t>(places, 1'000'000)))
                     .arg(QString::fromStdString(recording.filename().string()));
}

void RecordedTouch::startOverview()
{
    if (m_overview.joinable()) {
        return;
    }
    m_overview = std::thread([this] {
        // A reader must not be shared between threads.
        auto reader = session::RecordingReader::open(m_path);
        if (!reader.isOk()) {
            return;
        }
        const session::RecordingExtent extent = reader.value()->extent();
        const std::size_t known = reader.value()->faults().size();
        const double ticks = static_cast<double>(std::max<std::int64_t>(1, extent.lastTick - extent.firstTick + 1));
        std::vector<float> peaks(kBins, 0.0f);
        std::vector<view::PathPoint> path_W;
        const std::int64_t step = std::max<std::int64_t>(1, (extent.lastTick - extent.firstTick) / kPathPoints + 1);
        bool isContinued = false; // the hand was there since the last point
        const core::Status status =
            reader.value()->forEach(extent.firstTick, extent.lastTick, [&](const servo::TickRecord& tick) {
                const double place = static_cast<double>(tick.tick - extent.firstTick) / ticks;
                const auto bin = std::min(kBins - 1, static_cast<std::size_t>(place * static_cast<double>(kBins)));
                peaks[bin] = std::max(peaks[bin], static_cast<float>(tick.felt.f_W.norm()));
                const bool hasHand = (tick.flags & servo::kNoHand) == 0 && tick.p_WH.allFinite();
                isContinued = isContinued && hasHand && (tick.flags & servo::kReset) == 0;
                if (hasHand && (tick.tick - extent.firstTick) % step == 0) {
                    path_W.push_back({tick.p_WH, tick.felt.f_W.norm() > 0.0, isContinued});
                    isContinued = true;
                }
                return !m_isClosing;
            });
        if (status.isOk() && !m_isClosing) {
            QMetaObject::invokeMethod(
                this,
                [this, peaks = std::move(peaks), path_W = std::move(path_W)]() mutable {
                    m_path_W = std::move(path_W);
                    Q_EMIT overviewReady(peaks);
                },
                Qt::QueuedConnection);
            if (const std::size_t places = reader.value()->faults().size(); places > known) {
                QMetaObject::invokeMethod(
                    this, [this, places] { Q_EMIT damageFound(damageText(m_path, places)); }, Qt::QueuedConnection);
            }
        }
    });
}

} // namespace palpate::ui

#include "palpate/ui/moc_RecordedTouch.cpp"

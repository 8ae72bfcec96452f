// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/SessionExport.h"

#include <palpate/core/AtomicFile.h>
#include <palpate/meshio/VtpFile.h>
#include <palpate/session/TickCsv.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace palpate::study {

using core::Status;
using core::StatusCode;

namespace {

constexpr auto kFirst = std::numeric_limits<std::int64_t>::min(), kLast = std::numeric_limits<std::int64_t>::max();

/// Counts ticks and reports progress in steps of 1 %.
class Steps
{
  public:
    Steps(const session::RecordingReader& reader, const ExportProgress& progress)
        : m_progress(progress)
        , m_ticks(std::max<std::int64_t>(1, reader.extent().ticks))
        , m_step(std::max<std::int64_t>(1, m_ticks / 100))
    {
    }
    /// @return false if cancelled
    bool next()
    {
        if (++m_done % m_step == 0 && m_progress) {
            m_isCancelled = !m_progress(static_cast<double>(m_done) / static_cast<double>(m_ticks));
        }
        return !m_isCancelled;
    }
    [[nodiscard]] bool isCancelled() const noexcept { return m_isCancelled; }
    [[nodiscard]] Status status(const std::filesystem::path& path) const
    {
        return {StatusCode::Cancelled, PALPATE_TEXT("%1: not written: cancelled"), path};
    }

  private:
    const ExportProgress& m_progress;
    std::int64_t m_ticks, m_step, m_done = 0;
    bool m_isCancelled = false;
};

Status write(const std::filesystem::path& path, const meshio::VtpFile& file)
{
    const auto bytes = meshio::vtpBytes(file);
    return bytes.isOk() ? core::writeAtomically(path, bytes.value()) : bytes.status().at(path);
}

} // namespace

Status exportTicks(const session::RecordingReader& reader, const std::filesystem::path& path,
                   const ExportProgress& progress, std::span<const std::string> columns)
{
    auto csv = session::TickCsv::create(path, session::TickCsv::Rows::Session, columns);
    if (!csv.isOk()) {
        return csv.status();
    }
    std::span<const session::RecordingEvent> events(reader.events()); // in tick order
    Steps steps(reader, progress);
    std::optional<servo::TickRecord> last; // one row behind, so that the last row takes all remaining events
    const auto write = [&](std::int64_t upTo) {
        std::size_t count = 0;
        while (count < events.size() && events[count].tick <= upTo) {
            ++count;
        }
        csv.value().write(
            *last, [&](std::uint32_t number) { return reader.structureName(last->scene, number); },
            events.first(count));
        events = events.subspan(count);
    };
    Status status = reader.forEach(kFirst, kLast, [&](const servo::TickRecord& tick) {
        if (last) {
            write(last->tick);
        }
        last = tick;
        return steps.next();
    });
    if (last && !steps.isCancelled()) {
        write(kLast);
    }
    return !status.isOk() ? status : steps.isCancelled() ? steps.status(path) : csv.value().finish();
}

Status exportPath(const session::RecordingReader& reader, const std::filesystem::path& path,
                  const ExportProgress& progress)
{
    Steps steps(reader, progress);
    meshio::VtpFile file;
    std::vector<core::Vec3> forces, god;
    std::vector<double> times_s, forces_N, depths_mm;
    std::vector<std::int32_t> structures;
    std::optional<servo::TickRecord> previous;
    const std::int64_t first = reader.extent().firstTick;
    const Status status = reader.forEach(kFirst, kLast, [&](const servo::TickRecord& tick) {
        const bool goesOn = session::follows(previous, tick);
        previous = tick;
        if ((tick.flags & servo::kNoHand) != 0 || !tick.p_WH.allFinite()) {
            return steps.next();
        }
        if (!goesOn && !file.points.empty()) {
            file.lineEnds.push_back(file.points.size());
        }
        file.points.push_back(tick.p_WH);
        god.push_back(tick.felt.p_WG);
        forces.push_back(tick.felt.f_W);
        forces_N.push_back(tick.felt.f_W.norm());
        depths_mm.push_back((tick.felt.p_WG - tick.p_WH).norm());
        times_s.push_back(static_cast<double>(tick.tick - first) * reader.info().dt_s);
        structures.push_back(tick.felt.structure);
        return steps.next();
    });
    if (!status.isOk() || steps.isCancelled()) {
        return status.isOk() ? steps.status(path) : status;
    }
    if (file.points.empty()) {
        return {StatusCode::Empty, PALPATE_TEXT("%1: not written: found no tick with a hand, expected at least one"),
                path};
    }
    file.lineEnds.push_back(file.points.size());
    file.pointArrays = {{"force_N", std::move(forces_N)}, {"depth_mm", std::move(depths_mm)},
                        {"time_s", std::move(times_s)},   {"force", std::move(forces)},
                        {"god_object", std::move(god)},   {"structure", std::move(structures)}};
    return write(path, file);
}

Status exportSurface(const session::SessionMeasures& measures, const std::filesystem::path& path)
{
    meshio::VtpFile file;
    std::vector<double> dwell_s, peak_N, mean_N, stiffness, coverage;
    std::vector<std::int32_t> visits, ids;
    for (const session::SurfaceMeasures& one : measures.surfaces) {
        if (one.surface == nullptr) {
            continue;
        }
        const auto first = static_cast<std::uint32_t>(file.points.size());
        const geometry::TriangleMesh& mesh = one.surface->mesh();
        file.points.insert(file.points.end(), mesh.vertices.begin(), mesh.vertices.end());
        for (const geometry::Triangle& t : mesh.triangles) {
            file.triangles.push_back({first + t[0], first + t[1], first + t[2]});
            ids.push_back(static_cast<std::int32_t>(file.structureNames.size()));
        }
        const auto add = [](auto& to, const auto& values) { to.insert(to.end(), values.begin(), values.end()); };
        add(dwell_s, one.surface->dwell_s());
        add(peak_N, one.surface->peakForce_N());
        add(mean_N, one.surface->meanForce_N());
        add(stiffness, one.surface->stiffness_N_per_mm());
        add(visits, one.surface->visits());
        for (const double time_s : one.surface->dwell_s()) {
            coverage.push_back(time_s > 0.0 ? 1.0 : 0.0);
        }
        file.structureNames.push_back(one.structure);
    }
    if (file.structureNames.empty()) {
        return {StatusCode::Empty, PALPATE_TEXT("%1: not written: no surface that is there was touched"), path};
    }
    file.pointArrays = {{"dwell_s", std::move(dwell_s)},     {"peak_force_N", std::move(peak_N)},
                        {"mean_force_N", std::move(mean_N)}, {"stiffness_N_per_mm", std::move(stiffness)},
                        {"visits", std::move(visits)},       {"coverage", std::move(coverage)}};
    file.cellArrays = {{"StructureId", std::move(ids)}};
    return write(path, file);
}

std::filesystem::path surfaceFileOf(const std::filesystem::path& path)
{
    std::filesystem::path surface = path;
    return surface.replace_filename(path.stem().string() + "-surface" + path.extension().string());
}

Status checkSurfaceFile(const std::filesystem::path& surface)
{
    std::error_code error;
    if (!std::filesystem::exists(std::filesystem::symlink_status(surface, error))) {
        return {};
    }
    std::string head;
    if (std::filesystem::is_regular_file(surface, error)) {
        head.resize(16384); // array names are near the start
        std::ifstream(surface, std::ios::binary).read(head.data(), static_cast<std::streamsize>(head.size()));
    }
    return head.find("Name=\"dwell_s\"") != std::string::npos
               ? Status()
               : Status(
                     StatusCode::BadCommandLine,
                     PALPATE_TEXT("%1: the touched surface goes there; found another file, expected none or an older "
                                  "export. Choose another name"),
                     surface);
}

} // namespace palpate::study

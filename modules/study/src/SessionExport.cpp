// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/SessionExport.h"

#include <palpate/meshio/VtpFile.h>
#include <palpate/session/AtomicFile.h>
#include <palpate/session/TickCsv.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace palpate::study {

using core::Status;
using core::StatusCode;

namespace {

constexpr auto kFirst = std::numeric_limits<std::int64_t>::min(), kLast = std::numeric_limits<std::int64_t>::max();

Status write(const std::filesystem::path& path, const meshio::VtpFile& file)
{
    const auto bytes = meshio::vtpBytes(file);
    return bytes.isOk() ? session::writeAtomically(path, bytes.value())
                        : Status(bytes.status().code(), path.string() + ": " + bytes.status().message());
}

} // namespace

Status exportTicks(const session::RecordingReader& reader, const std::filesystem::path& path)
{
    auto csv = session::TickCsv::create(path);
    if (!csv.isOk()) {
        return csv.status();
    }
    const Status status = reader.forEach(kFirst, kLast, [&](const servo::TickRecord& tick) {
        if ((tick.flags & servo::kNoHand) == 0) {
            csv.value().write(tick, [&](std::uint32_t number) { return reader.structureName(tick.scene, number); });
        }
        return true;
    });
    return status.isOk() ? csv.value().finish() : status;
}

Status exportPath(const session::RecordingReader& reader, const std::filesystem::path& path)
{
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
            return true;
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
        return true;
    });
    if (!status.isOk()) {
        return status;
    }
    if (file.points.empty()) {
        return {StatusCode::Empty, path.string() + ": not written: found no tick with a hand, expected at least one"};
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
    std::vector<double> dwell_s, peak_N, coverage;
    std::vector<std::int32_t> ids;
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
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
            dwell_s.push_back(one.surface->dwell_s()[i]);
            peak_N.push_back(one.surface->peakForce_N()[i]);
            coverage.push_back(one.surface->dwell_s()[i] > 0.0 ? 1.0 : 0.0);
        }
        file.structureNames.push_back(one.structure);
    }
    if (file.structureNames.empty()) {
        return {StatusCode::Empty, path.string() + ": not written: no surface that is there was touched"};
    }
    file.pointArrays = {
        {"dwell_s", std::move(dwell_s)}, {"peak_force_N", std::move(peak_N)}, {"coverage", std::move(coverage)}};
    file.cellArrays = {{"StructureId", std::move(ids)}};
    return write(path, file);
}

std::filesystem::path surfaceFileOf(const std::filesystem::path& path)
{
    std::filesystem::path surface = path;
    return surface.replace_filename(path.stem().string() + "-surface" + path.extension().string());
}

} // namespace palpate::study

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/VtpExport.h"

#include "VtpWriter.h"

#include <limits>

namespace palpate::session {

using core::Status;
using core::StatusCode;
using core::Vec3;

Status writePathVtp(const std::filesystem::path& path, const RecordingReader& reader)
{
    std::vector<Vec3> points, forces, god;
    std::vector<double> times_s, forces_N, depths_mm;
    std::vector<std::int32_t> structures;
    std::vector<std::int64_t> ends;
    std::optional<servo::TickRecord> previous;
    const std::int64_t first = reader.extent().firstTick;
    const Status status =
        reader.forEach(std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max(),
                       [&](const servo::TickRecord& tick) {
                           const bool goesOn = follows(previous, tick);
                           previous = tick;
                           if ((tick.flags & servo::kNoHand) != 0 || !tick.p_WH.allFinite()) {
                               return true;
                           }
                           if (!goesOn && !points.empty()) {
                               ends.push_back(static_cast<std::int64_t>(points.size()));
                           }
                           points.push_back(tick.p_WH);
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
    if (points.empty()) {
        return {StatusCode::Empty, path.string() + ": not written: found no tick with a hand, expected at least one"};
    }
    ends.push_back(static_cast<std::int64_t>(points.size()));
    std::vector<std::int64_t> order(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        order[i] = static_cast<std::int64_t>(i);
    }
    internal::VtpWriter file;
    file.setPoints(points);
    file.setLines(order, ends);
    file.addPointArray("force_N", forces_N);
    file.addPointArray("depth_mm", depths_mm);
    file.addPointArray("time_s", times_s);
    file.addPointArray("force", forces);
    file.addPointArray("god_object", god);
    file.addPointArray("structure", structures);
    file.setActiveScalars("force_N");
    return file.write(path);
}

Status writeSurfaceVtp(const std::filesystem::path& path, const SessionMeasures& measures)
{
    std::vector<Vec3> points;
    std::vector<double> dwell_s, peak_N, coverage;
    std::vector<std::int64_t> corners, ends;
    std::vector<std::int32_t> ids;
    std::vector<std::string> names;
    for (const SurfaceMeasures& one : measures.surfaces) {
        if (one.surface == nullptr) {
            continue;
        }
        const auto first = static_cast<std::int64_t>(points.size());
        const geometry::TriangleMesh& mesh = one.surface->mesh();
        points.insert(points.end(), mesh.vertices.begin(), mesh.vertices.end());
        for (const geometry::Triangle& t : mesh.triangles) {
            for (const std::uint32_t corner : t) {
                corners.push_back(first + corner);
            }
            ends.push_back(static_cast<std::int64_t>(corners.size()));
            ids.push_back(static_cast<std::int32_t>(names.size()));
        }
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
            dwell_s.push_back(one.surface->dwell_s()[i]);
            peak_N.push_back(one.surface->peakForce_N()[i]);
            coverage.push_back(one.surface->dwell_s()[i] > 0.0 ? 1.0 : 0.0);
        }
        names.push_back(one.structure);
    }
    if (names.empty()) {
        return {StatusCode::Empty, path.string() + ": not written: no surface that is there was touched"};
    }
    internal::VtpWriter file;
    file.setPoints(points);
    file.setPolys(corners, ends);
    file.addPointArray("dwell_s", dwell_s);
    file.addPointArray("peak_force_N", peak_N);
    file.addPointArray("coverage", coverage);
    file.addCellArray("StructureId", ids);
    file.addFieldTexts("StructureNames", names);
    file.setActiveScalars("dwell_s");
    return file.write(path);
}

} // namespace palpate::session

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/SearchedLumps.h"

#include "palpate/study/BuriedLumps.h"

#include <palpate/haptics/TissueMap.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <span>

namespace palpate::study {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;
using session::LumpSearch;

/// Change of stiffness that the trained hand tells, as a logarithm: a softer place counts like a stiffer one.
const double kTold = std::log1p(buried::kTold_percent[1] / 100.0);

struct Searched
{
    std::string organ;
    buried::FeltSurface felt;
    std::unique_ptr<session::TouchedSurface> touched; ///< on the surface of `felt`
};

/// |ln k/k0| at a vertex for a depth, between the depths that are known; 0 where nothing is pressed.
double changeAt(const buried::FeltSurface& felt, std::size_t vertex, double depth_mm)
{
    const auto change = [&](std::size_t press) { return std::abs(std::log(double{felt.press[press].ratio[vertex]})); };
    if (!(depth_mm > 0.0)) {
        return 0.0;
    }
    for (std::size_t i = 1; i < felt.press.size(); ++i) {
        const double from = felt.press[i - 1].press_mm, to = felt.press[i].press_mm;
        if (depth_mm < to) {
            const double share = (depth_mm - from) / (to - from);
            return (1.0 - share) * change(i - 1) + share * change(i);
        }
    }
    return change(felt.press.size() - 1);
}

/// Area that each vertex stands for. [mm²]
std::vector<double> areas(const geometry::TriangleMesh& mesh)
{
    std::vector<double> out(mesh.vertices.size(), 0.0);
    for (const geometry::Triangle& t : mesh.triangles) {
        const core::Vec3& a = mesh.vertices[t[0]];
        const double area_mm2 = 0.5 * (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a).norm();
        for (const std::uint32_t corner : t) {
            out[corner] += area_mm2 / 3.0;
        }
    }
    return out;
}

void judge(const Searched& searched, std::vector<LumpSearch>& out)
{
    const buried::FeltSurface& felt = searched.felt;
    const std::vector<double> area_mm2 = areas(felt.surface);
    std::vector<LumpSearch> lumps;
    for (const buried::FeltSurface::Lump& lump : felt.lumps) {
        lumps.push_back({lump.name, searched.organ, 0.0, 0.0, 0.0});
    }
    for (std::size_t v = 0; v < felt.lump.size(); ++v) {
        if (felt.lump[v] == 0 || felt.notJudged[v] != 0) {
            continue;
        }
        LumpSearch& lump = lumps[felt.lump[v] - 1u];
        const double met = changeAt(felt, v, searched.touched->peakDepth_mm()[v]);
        lump.greatestChange_percent = std::max(lump.greatestChange_percent, 100.0 * std::expm1(met));
        if (changeAt(felt, v, felt.press.back().press_mm) >= kTold) {
            lump.told_mm2 += area_mm2[v];
            lump.pressed_mm2 += met >= kTold ? area_mm2[v] : 0.0;
        }
    }
    out.insert(out.end(), lumps.begin(), lumps.end());
}

} // namespace

Result<std::vector<LumpSearch>> searchedLumps(const session::RecordingReader& reader, const meshio::LoadedScene& scene,
                                              double distance_mm, const std::function<bool(double)>& progress)
{
    const auto organs = organsWithLumps(scene);
    if (!organs.isOk()) {
        return std::vector<LumpSearch>();
    }
    std::vector<Searched> all;
    for (const OrganWithLumps& organ : organs.value()) {
        buried::FeltOptions how;
        how.radius_mm = organ.radius_mm;
        how.press_mm.assign(haptics::kFeltPress_mm.begin(), haptics::kFeltPress_mm.end());
        how.progress = progress;
        auto felt = feltSurface(scene, organ, how);
        if (felt.isOk()) {
            auto touched = std::make_unique<session::TouchedSurface>(felt.value().surface, distance_mm);
            all.push_back(
                {scene.structures[organ.organ].description.name, std::move(felt).value(), std::move(touched)});
        } else if (felt.status().code() == StatusCode::Cancelled) {
            return felt.status();
        }
    }
    if (all.empty()) {
        return std::vector<LumpSearch>();
    }
    bool isCancelled = false;
    std::int64_t ticks = 0;
    constexpr std::int64_t kAsk = 100000;
    const Status read = reader.forEach(
        std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max(),
        [&](const servo::TickRecord& tick) {
            for (const haptics::Contact& contact : std::span(tick.felt.contacts).first(tick.felt.contactCount)) {
                const std::string_view name = reader.structureName(tick.scene, contact.structure);
                for (Searched& one : all) {
                    if (one.organ == name) {
                        one.touched->add(contact.p_WG, contact.f_W.norm(), contact.depth_mm, reader.info().dt_s);
                    }
                }
            }
            isCancelled = ++ticks % kAsk == 0 && progress && !progress(1.0);
            return !isCancelled;
        });
    if (!read.isOk()) {
        return read;
    }
    if (isCancelled) {
        return Status(StatusCode::Cancelled, "measuring was cancelled");
    }
    std::vector<LumpSearch> out;
    for (const Searched& one : all) {
        judge(one, out);
    }
    return out;
}

} // namespace palpate::study

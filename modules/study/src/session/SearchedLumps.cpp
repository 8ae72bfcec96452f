// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/SearchedLumps.h"

#include "palpate/study/RecordedScale.h"

#include <palpate/core/Finding.h>
#include <palpate/session/TouchPlace.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace palpate::study {

namespace {

using core::Result;
using session::LumpSearch;

/// Logarithm of the stiffness change that a trained hand detects. The logarithm treats softer and stiffer places
/// equally.
const double kDetectableLogRatio = std::log1p(buried::kDetectableChange_percent[1] / 100.0);

struct Searched
{
    std::string organ;
    buried::FeltSurface felt;
    std::unique_ptr<session::TouchedSurface> touched; ///< on the surface of `felt`
    std::vector<std::optional<double>> recorded;      ///< greatest recorded change for each lump, as a ratio
};

/// Returns |ln k/k0| at a vertex for a depth, interpolated between the known depths; 0 without a press.
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

/// Returns the area share of each vertex [mm²].
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
    for (std::size_t i = 0; i < felt.lumps.size(); ++i) {
        LumpSearch& lump = lumps.emplace_back();
        lump.lump = felt.lumps[i].name;
        lump.organ = searched.organ;
        if (felt.lumps[i].ratio) {
            lump.predicted_percent = 0.0;
        }
        if (searched.recorded[i]) {
            lump.recorded_percent = 100.0 * (*searched.recorded[i] - 1.0);
        }
    }
    for (std::size_t v = 0; v < felt.lump.size(); ++v) {
        if (felt.lump[v] == 0 || felt.notJudged[v] != 0) {
            continue;
        }
        LumpSearch& lump = lumps[felt.lump[v] - 1u];
        const double met = changeAt(felt, v, searched.touched->peakDepth_mm()[v]);
        const bool isSofter = felt.lumps[felt.lump[v] - 1u].ratio->typical < 1.0;
        const double percent = 100.0 * std::expm1(isSofter ? -met : met);
        if (std::abs(percent) > std::abs(*lump.predicted_percent)) {
            lump.predicted_percent = percent;
        }
        if (changeAt(felt, v, felt.press.back().press_mm) >= kDetectableLogRatio) {
            lump.detectable_mm2 += area_mm2[v];
            lump.pressed_mm2 += met >= kDetectableLogRatio ? area_mm2[v] : 0.0;
        }
    }
    out.insert(out.end(), lumps.begin(), lumps.end());
}

/// Processes the ticks of a recording.
class Ticks
{
  public:
    Ticks(const session::RecordingReader& reader, std::vector<Searched>& all)
        : m_reader(reader)
        , m_all(all)
    {
    }

    void add(const servo::TickRecord& tick)
    {
        const core::Vec3 v_WH = session::follows(m_before, tick)
                                    ? core::Vec3((tick.p_WH - m_before->p_WH) / m_reader.info().dt_s)
                                    : core::Vec3::Zero();
        const auto contacts = std::span(tick.felt.contacts).first(tick.felt.contactCount);
        for (const haptics::Contact& contact : contacts) {
            const std::string_view name = m_reader.structureName(tick.scene, contact.structure);
            for (Searched& one : m_all) {
                if (one.organ == name) {
                    const auto place =
                        one.touched->add({session::TouchPlace(tick.felt, contact), contact.f_W.norm(), contact.depth_mm,
                                          static_cast<double>(tick.tick) * m_reader.info().dt_s, m_reader.info().dt_s});
                    updateRecordedChange(one, place, tick, contact, v_WH);
                }
            }
        }
        m_before = tick;
    }

  private:
    /// Updates the ratio of the measured force to the force of the organ alone at the same depth.
    void updateRecordedChange(Searched& organ, const std::optional<std::uint32_t>& place, const servo::TickRecord& tick,
                              const haptics::Contact& on, const core::Vec3& v_WH) const
    {
        const session::SceneRecord* scene = m_reader.scene(tick.scene);
        const core::Vec3 push_W = on.p_WG - tick.p_WH;
        const double depth_mm = push_W.norm();
        if (scene == nullptr || on.structure >= scene->structures.size() || depth_mm < core::kMinStiffnessDepth_mm) {
            return;
        }
        core::Vec3 all_W = core::Vec3::Zero();
        std::vector<std::string_view> touched;
        const auto springOf = [&](const haptics::Contact& one) {
            const session::StructureRecord& structure = scene->structures[one.structure];
            return core::Vec3(one.f_W + structure.tissue.damping_Ns_per_mm * v_WH);
        };
        for (const haptics::Contact& one : std::span(tick.felt.contacts).first(tick.felt.contactCount)) {
            if (one.structure < scene->structures.size()) {
                all_W += springOf(one);
                touched.push_back(scene->structures[one.structure].name);
            }
        }
        // Organ alone: force of its layer with friction, without the scale due to maps and buried lumps.
        const core::Vec3 own_W = springOf(on);
        const double law_N = lawForce_N(scene->structures[on.structure], depth_mm);
        const double pushed_N = own_W.dot(push_W) / depth_mm;
        if (!(law_N > 0.0 && pushed_N > 0.0)) {
            return;
        }
        const double alone_N = law_N * own_W.norm() / pushed_N;
        const double change = all_W.norm() / alone_N;
        for (std::size_t i = 0; i < organ.felt.lumps.size(); ++i) {
            const bool isTouched = std::find(touched.begin(), touched.end(), organ.felt.lumps[i].name) != touched.end();
            const bool isOver = place && organ.felt.lump[*place] == i + 1;
            std::optional<double>& greatest = organ.recorded[i];
            if ((isTouched || isOver) && (!greatest || std::abs(std::log(change)) > std::abs(std::log(*greatest)))) {
                greatest = change;
            }
        }
    }

    const session::RecordingReader& m_reader;
    std::vector<Searched>& m_all;
    std::optional<servo::TickRecord> m_before;
};

} // namespace

Result<session::SessionMeasures> measureSearch(const session::RecordingReader& reader,
                                               const session::MeshesByHash& meshes, const meshio::LoadedScene& scene,
                                               std::vector<OrganPalpability> organs, session::MeasureOptions options)
{
    std::vector<Searched> all;
    for (OrganPalpability& organ : organs) {
        auto touched = std::make_unique<session::TouchedSurface>(organ.felt.surface, options.distance_mm);
        const std::size_t lumps = organ.felt.lumps.size();
        all.push_back({scene.structures[organ.organ.organ].description.name, std::move(organ.felt), std::move(touched),
                       std::vector<std::optional<double>>(lumps)});
    }
    Ticks sums(reader, all);
    if (!all.empty()) {
        options.sink = [&sums, given = std::move(options.sink)](const servo::TickRecord& tick) {
            sums.add(tick);
            if (given) {
                given(tick);
            }
        };
    }
    auto measures = session::measureSession(reader, meshes, options);
    if (measures.isOk()) {
        for (const Searched& one : all) {
            judge(one, measures.value().lumps);
        }
    }
    return measures;
}

} // namespace palpate::study

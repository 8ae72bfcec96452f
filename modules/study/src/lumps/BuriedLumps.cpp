// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/BuriedLumps.h"

#include "palpate/study/HapticCopy.h"
#include "palpate/study/Layers.h"
#include "palpate/study/LumpRule.h"

#include <palpate/geometry/Holes.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

namespace palpate::study {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;

bool hasTriangles(const meshio::LoadedStructure& one)
{
    return one.surface != nullptr && !one.surface->mesh.triangles.empty();
}

/// Computes the nesting of the structures that can be felt from their geometry.
Layering layeringOf(const meshio::LoadedScene& scene)
{
    std::vector<std::shared_ptr<const geometry::SurfaceIndex>> indices;
    std::vector<LayeredSurface> surfaces;
    for (const meshio::LoadedStructure& one : scene.structures) {
        const bool isThere = canBeFelt(one.description) && hasTriangles(one);
        indices.push_back(isThere ? indexed(*one.surface) : nullptr);
        surfaces.push_back({isThere ? one.surface.get() : nullptr, indices.back().get()});
    }
    return layering(surfaces);
}

LumpRule ruleOf(const meshio::LoadedScene& scene, const Layering& layers, const std::map<std::string, double>& ratios)
{
    std::vector<PlacedStructure> structures;
    for (std::size_t i = 0; i < scene.structures.size(); ++i) {
        const meshio::LoadedStructure& one = scene.structures[i];
        structures.push_back(
            {&one.description, hasTriangles(one) ? one.surface.get() : nullptr, layers.structures[i].in});
    }
    std::set<std::string> lumps;
    for (const auto& [name, ratio] : ratios) {
        lumps.insert(name);
    }
    return LumpRule(std::move(structures), std::move(lumps));
}

/// Returns why a structure that was meant as a lump has no organ: its name is that of a lump, its entry names an organ,
/// or a ratio is given. Empty for any other structure, and with an organ.
std::optional<core::Message> whyNoOrgan(const LumpRule& rule, const meshio::LoadedScene& scene, std::size_t structure,
                                        const std::map<std::string, double>& ratios)
{
    const meshio::SceneStructure& one = scene.structures[structure].description;
    const bool isMeant =
        !one.inside.empty() || ratios.count(one.name) > 0 || meshio::isLump(meshio::anatomyKind(one.name));
    const LumpRule::Organ found = isMeant ? rule.organOf(structure) : LumpRule::Organ();
    if (!isMeant || found) {
        return std::nullopt;
    }
    return core::Message(PALPATE_TEXT("%1: not felt through an organ: %2"), one.name, found.whyNot);
}

/// Returns a clause for each structure that would be a lump if the surrounding organ were closed, and for each other
/// one that was meant as a lump.
std::vector<core::Message> lumpsWithoutOrgan(const LumpRule& rule, const meshio::LoadedScene& scene,
                                             const Layering& layers, const std::map<std::string, double>& ratios)
{
    std::vector<core::Message> clauses;
    for (std::size_t i = 0; i < scene.structures.size(); ++i) {
        if (const auto in = layers.structures[i].unreliableParent) {
            clauses.push_back(core::Message(PALPATE_TEXT("%1 seems to lie in %2, whose surface is open or inside out"),
                                            scene.structures[i].description.name,
                                            scene.structures[*in].description.name));
        } else if (auto why = whyNoOrgan(rule, scene, i, ratios)) {
            clauses.push_back(std::move(*why));
        }
    }
    return clauses;
}

std::vector<LumpInOpenSurface> lumpsInOpenSurfaces(const meshio::LoadedScene& scene, const Layering& layers)
{
    std::vector<LumpInOpenSurface> found;
    for (std::size_t i = 0; i < scene.structures.size(); ++i) {
        const meshio::SceneStructure& one = scene.structures[i].description;
        const auto in = layers.structures[i].unreliableParent;
        if (in && !layers.structures[i].in && meshio::isLump(meshio::anatomyKind(one.name))) {
            found.push_back({i, *in});
        }
    }
    return found;
}

buried::FeltOptions usualOptions(const OrganWithLumps& organ, const std::function<bool(double)>& progress)
{
    buried::FeltOptions how;
    how.radius_mm = organ.radius_mm;
    how.press_mm.assign(haptics::kFeltPress_mm.begin(), haptics::kFeltPress_mm.end());
    how.progress = progress;
    return how;
}

SceneLump lumpOf(const meshio::LoadedScene& scene, std::size_t lump, std::size_t organ,
                 const std::map<std::string, double>& ratios)
{
    const meshio::SceneStructure &of = scene.structures[lump].description, &in = scene.structures[organ].description;
    const auto given = ratios.find(of.name);
    return {lump, stiffnessRatio(of, in, given != ratios.end() ? std::optional(given->second) : std::nullopt)};
}

/// Finds the organs of a scene.
/// @param rule  of the scene
std::vector<OrganWithLumps> organsBy(const LumpRule& rule, const meshio::LoadedScene& scene,
                                     const std::map<std::string, double>& ratios)
{
    std::map<std::size_t, OrganWithLumps> organs;
    for (std::size_t i = 0; i < scene.structures.size(); ++i) {
        const LumpRule::Organ found = rule.organOf(i);
        if (!found) {
            continue;
        }
        const std::size_t organ = *found.organ;
        const double radius_mm =
            scene.structures[organ].description.felt_contact_radius_mm.value_or(kDefaultContactRadius_mm);
        OrganWithLumps& to = organs.try_emplace(organ, OrganWithLumps{organ, radius_mm, {}}).first->second;
        to.lumps.push_back(lumpOf(scene, i, organ, ratios));
    }
    std::vector<OrganWithLumps> found;
    for (auto& [number, organ] : organs) {
        found.push_back(std::move(organ));
    }
    return found;
}

/// Checks the result of organsBy. @return as organsWithLumps
Status statusOf(const std::vector<OrganWithLumps>& organs, const LumpRule& rule, const meshio::LoadedScene& scene,
                const Layering& layers, const std::map<std::string, double>& ratios)
{
    std::set<std::string> lumps;
    for (const OrganWithLumps& organ : organs) {
        for (const SceneLump& lump : organ.lumps) {
            lumps.insert(scene.structures[lump.structure].description.name);
        }
    }
    for (const auto& [name, ratio] : ratios) {
        if (lumps.count(name) == 0) {
            std::vector<core::Message> why = lumpsWithoutOrgan(rule, scene, layers, ratios);
            why.insert(why.begin(),
                       core::Message(PALPATE_TEXT("ratio of \"%1\": found no such lump, expected a structure "
                                                  "that lies in another one"),
                                     name));
            return Status(StatusCode::NotFound, core::joined(why));
        }
    }
    if (organs.empty()) {
        std::vector<core::Message> why = lumpsWithoutOrgan(rule, scene, layers, ratios);
        why.insert(why.begin(),
                   core::Message(PALPATE_TEXT("found no lump, expected a palpable structure inside another "
                                              "one's closed surface, or one whose `inside` names its organ")));
        return Status(StatusCode::Empty, core::joined(why));
    }
    return {};
}

} // namespace

std::vector<buried::BuriedLump> OrganWithLumps::shapes(const meshio::LoadedScene& scene) const
{
    std::vector<buried::BuriedLump> shapes;
    for (const SceneLump& lump : lumps) {
        const meshio::LoadedStructure& one = scene.structures[lump.structure];
        shapes.push_back(
            {one.description.name, one.surface,
             lump.ratio ? std::optional<buried::RatioRange>({lump.ratio->low, lump.ratio->typical, lump.ratio->high})
                        : std::nullopt});
    }
    return shapes;
}

Result<std::vector<OrganWithLumps>> organsWithLumps(const meshio::LoadedScene& scene,
                                                    const std::map<std::string, double>& ratios,
                                                    std::vector<LumpInOpenSurface>* leftOut)
{
    const Layering layers = layeringOf(scene);
    if (leftOut != nullptr) {
        *leftOut = lumpsInOpenSurfaces(scene, layers);
    }
    const LumpRule rule = ruleOf(scene, layers, ratios);
    std::vector<OrganWithLumps> organs = organsBy(rule, scene, ratios);
    if (Status status = statusOf(organs, rule, scene, layers, ratios); !status.isOk()) {
        return status;
    }
    return organs;
}

core::Message openSurface(const std::string& name, const geometry::RepairedMesh& surface)
{
    if (surface.report.isClosed()) {
        return {PALPATE_TEXT("the surface of %1 is inside out"), name};
    }
    const std::vector<geometry::Hole> holes = geometry::holesOf(surface.mesh);
    if (holes.empty()) {
        return {PALPATE_TEXT("more than two triangles of %1 meet at an edge"), name};
    }
    const core::Rounded across_mm{holes.front().across_mm, 3};
    return holes.size() == 1 ? core::Message(PALPATE_TEXT("the surface of %1 has a hole of %2 mm"), name, across_mm)
                             : core::Message(PALPATE_TEXT("the surface of %1 has %2 holes, the largest of %3 mm"), name,
                                             holes.size(), across_mm);
}

bool isLumpCandidate(const meshio::SceneStructure& structure)
{
    const meshio::AnatomyKind kind = meshio::anatomyKind(structure.name);
    return meshio::isLump(kind) || kind == meshio::AnatomyKind::Other || structure.young_ratio.has_value();
}

Result<buried::FeltSurface> feltSurface(const meshio::LoadedScene& scene, const OrganWithLumps& organ,
                                        const buried::FeltOptions& options)
{
    const meshio::LoadedStructure& of = scene.structures[organ.organ];
    return buried::feltSurface(of.description.name, *of.surface, organ.shapes(scene), options);
}

Result<std::vector<OrganPalpability>> computePalpability(const meshio::LoadedScene& scene,
                                                         std::vector<OrganPalpability> known,
                                                         std::vector<core::Message>* notes,
                                                         const std::function<bool(double)>& progress)
{
    std::vector<OrganPalpability> out;
    const auto organs = organsWithLumps(scene);
    if (!organs.isOk()) {
        return out;
    }
    std::vector<core::Message> ignored;
    std::vector<core::Message>& told = notes != nullptr ? *notes : ignored;
    for (const OrganWithLumps& organ : organs.value()) {
        const auto same =
            std::find_if(known.begin(), known.end(), [&](const OrganPalpability& one) { return one.organ == organ; });
        if (same != known.end()) {
            out.push_back(std::move(*same));
        } else {
            auto felt = feltSurface(scene, organ, usualOptions(organ, progress));
            if (felt.status().code() == StatusCode::Cancelled) {
                return felt.status();
            }
            if (!felt.isOk()) {
                told.push_back(felt.status().text());
                continue;
            }
            out.push_back({organ, std::move(felt).value()});
        }
        told.insert(told.end(), out.back().felt.notes.begin(), out.back().felt.notes.end());
    }
    return out;
}

std::vector<OrganWithLumps> filterLumps(std::vector<OrganWithLumps> organs,
                                        const std::function<bool(std::size_t structure)>& isTaken)
{
    for (OrganWithLumps& organ : organs) {
        std::erase_if(organ.lumps, [&](const SceneLump& lump) { return !isTaken(lump.structure); });
    }
    std::erase_if(organs, [](const OrganWithLumps& organ) { return organ.lumps.empty(); });
    return organs;
}

Status applyBuriedLumps(meshio::LoadedScene& scene, const std::function<bool(double)>& progress,
                        std::vector<OrganPalpability>* kept)
{
    if (scene.scene.buried != meshio::BuriedTouch::Felt) {
        return {};
    }
    const Layering layers = layeringOf(scene);
    const LumpRule rule = ruleOf(scene, layers, {});
    std::vector<OrganWithLumps> organs = organsBy(rule, scene, {});
    if (const Status status = statusOf(organs, rule, scene, layers, {}); !status.isOk()) {
        scene.warnings.push_back({PALPATE_TEXT("lumps felt through their organ: %1"), status.text()});
        return {};
    }
    for (std::size_t i = 0; i < scene.structures.size(); ++i) {
        const meshio::SceneStructure& one = scene.structures[i].description;
        auto why = canBeFelt(one) && !one.inside.empty() ? whyNoOrgan(rule, scene, i, {}) : std::nullopt;
        if (why) {
            scene.warnings.push_back(std::move(*why));
        }
    }
    const auto isThrough = [&](std::size_t structure) { return static_cast<bool>(rule.feltThrough(structure)); };
    for (const OrganWithLumps& organ : filterLumps(std::move(organs), isThrough)) {
        auto felt = feltSurface(scene, organ, usualOptions(organ, progress));
        if (!felt.isOk()) {
            if (felt.status().code() == StatusCode::Cancelled) {
                return felt.status();
            }
            scene.warnings.push_back(felt.status().text());
            continue;
        }
        scene.warnings.insert(scene.warnings.end(), felt.value().notes.begin(), felt.value().notes.end());
        meshio::LoadedStructure& through = scene.structures[organ.organ];
        through.feltBelow.clear();
        for (const buried::FeltSurface::Press& press : felt.value().press) {
            const auto own = press.ratio.begin() + static_cast<std::ptrdiff_t>(felt.value().organVertices);
            through.feltBelow.emplace_back(press.ratio.begin(), own); // the organ's original vertices come first
        }
        bool isAnyKnown = false;
        for (const buried::FeltSurface::Lump& lump : felt.value().lumps) {
            scene.structures[organ.lumps[lump.given].structure].isTransmitted = lump.ratio.has_value();
            isAnyKnown = isAnyKnown || lump.ratio;
            if (!lump.ratio) {
                scene.warnings.push_back(ratioQuestion(lump.name, through.description.name));
            }
        }
        if (!isAnyKnown) {
            through.feltBelow.clear();
        }
        if (kept != nullptr) {
            kept->push_back({organ, std::move(felt).value()});
        }
    }
    for (std::size_t i = 0; i < scene.structures.size(); ++i) {
        if (isThrough(i) && !scene.structures[i].isTransmitted) {
            scene.structures[i].description.layer = rule.layerWithin(i); // otherwise its organ would hide it
        }
    }
    return {};
}

} // namespace palpate::study

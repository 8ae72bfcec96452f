// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/BuriedLumps.h"

#include "palpate/study/HapticCopy.h"
#include "palpate/study/Layers.h"

#include <algorithm>
#include <optional>
#include <set>

namespace palpate::study {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;

/// What lies in what by shape, of what is palpable.
Layering layeringOf(const meshio::LoadedScene& scene)
{
    std::vector<std::shared_ptr<const geometry::SurfaceIndex>> indices;
    std::vector<LayeredSurface> surfaces;
    for (const meshio::LoadedStructure& one : scene.structures) {
        const bool isThere = one.description.palpable && one.surface != nullptr && !one.surface->mesh.triangles.empty();
        indices.push_back(isThere ? indexed(*one.surface) : nullptr);
        surfaces.push_back({isThere ? one.surface.get() : nullptr, indices.back().get()});
    }
    return layering(surfaces);
}

std::optional<std::size_t> named(const meshio::LoadedScene& scene, const std::string& name)
{
    for (std::size_t i = 0; i < scene.structures.size(); ++i) {
        if (scene.structures[i].description.name == name) {
            return i;
        }
    }
    return std::nullopt;
}

/// Of structures that would be lumps but for an organ that is open, a clause each.
std::string unsureLumps(const meshio::LoadedScene& scene, const Layering& layers)
{
    std::string clauses;
    for (std::size_t i = 0; i < scene.structures.size(); ++i) {
        if (const auto in = layers.structures[i].unsureIn) {
            clauses += "; " + scene.structures[i].description.name + " seems to lie in " +
                       scene.structures[*in].description.name + ", whose surface is open or inside out";
        }
    }
    return clauses;
}

LumpOf lumpOf(const meshio::LoadedScene& scene, std::size_t lump, std::size_t organ,
              const std::map<std::string, double>& ratios)
{
    const meshio::SceneStructure &of = scene.structures[lump].description, &in = scene.structures[organ].description;
    if (const auto given = ratios.find(of.name); given != ratios.end()) {
        return {lump, given->second, RatioSource::Typed};
    }
    if (of.young_ratio) {
        return {lump, *of.young_ratio, RatioSource::Typed};
    }
    if (of.young_kPa && in.young_kPa) {
        return {lump, *of.young_kPa / *in.young_kPa, RatioSource::Moduli};
    }
    const double organs = in.tissue.stiffness_N_per_mm, lumps = of.tissue.stiffness_N_per_mm;
    return {lump, organs > 0.0 && lumps > 0.0 ? lumps / organs : 1.0, RatioSource::Tissue};
}

} // namespace

std::vector<buried::BuriedLump> OrganWithLumps::shapes(const meshio::LoadedScene& scene) const
{
    std::vector<buried::BuriedLump> shapes;
    for (const LumpOf& lump : lumps) {
        const meshio::LoadedStructure& one = scene.structures[lump.structure];
        shapes.push_back({one.description.name, one.surface, lump.ratio});
    }
    return shapes;
}

Result<std::vector<OrganWithLumps>> organsWithLumps(const meshio::LoadedScene& scene,
                                                    const std::map<std::string, double>& ratios)
{
    const Layering layers = layeringOf(scene);
    std::map<std::size_t, OrganWithLumps> organs;
    std::set<std::string> lumps;
    for (std::size_t i = 0; i < scene.structures.size(); ++i) {
        const meshio::LoadedStructure& one = scene.structures[i];
        std::optional<std::size_t> organ;
        if (!one.description.inside.empty()) {
            organ = named(scene, one.description.inside);
        } else {
            organ = layers.structures[i].in;
            while (organ && layers.structures[*organ].in) {
                organ = layers.structures[*organ].in;
            }
        }
        if (!organ || *organ == i || one.surface == nullptr || scene.structures[*organ].surface == nullptr) {
            continue;
        }
        const double radius_mm = scene.structures[*organ].description.felt_contact_radius_mm.value_or(kUsualRadius_mm);
        OrganWithLumps& to = organs.try_emplace(*organ, OrganWithLumps{*organ, radius_mm, {}}).first->second;
        to.lumps.push_back(lumpOf(scene, i, *organ, ratios));
        lumps.insert(one.description.name);
    }
    for (const auto& [name, ratio] : ratios) {
        if (lumps.count(name) == 0) {
            return Status(StatusCode::NotFound, "ratio of \"" + name +
                                                    "\": found no such lump, expected a structure that lies in another "
                                                    "one" +
                                                    unsureLumps(scene, layers));
        }
    }
    if (organs.empty()) {
        return Status(StatusCode::Empty, "found no lump, expected a palpable structure inside another one's closed "
                                         "surface, or one whose `inside` names its organ" +
                                             unsureLumps(scene, layers));
    }
    std::vector<OrganWithLumps> found;
    for (auto& [number, organ] : organs) {
        found.push_back(std::move(organ));
    }
    return found;
}

std::string_view sourceText(RatioSource source) noexcept
{
    switch (source) {
    case RatioSource::Typed:
        return "as typed";
    case RatioSource::Moduli:
        return "from the moduli";
    case RatioSource::Tissue:
        break;
    }
    return "from the tissues' stiffness";
}

Result<buried::FeltSurface> feltSurface(const meshio::LoadedScene& scene, const OrganWithLumps& organ,
                                        const buried::FeltOptions& options)
{
    const meshio::LoadedStructure& of = scene.structures[organ.organ];
    return buried::feltSurface(of.description.name, *of.surface, organ.shapes(scene), options);
}

std::vector<OrganWithLumps> lumpsThat(std::vector<OrganWithLumps> organs,
                                      const std::function<bool(std::size_t structure)>& isTaken)
{
    for (OrganWithLumps& organ : organs) {
        std::erase_if(organ.lumps, [&](const LumpOf& lump) { return !isTaken(lump.structure); });
    }
    std::erase_if(organs, [](const OrganWithLumps& organ) { return organ.lumps.empty(); });
    return organs;
}

Status feelBuried(meshio::LoadedScene& scene, const std::function<bool(double)>& progress)
{
    if (scene.scene.buried != meshio::BuriedTouch::Felt) {
        return {};
    }
    const auto organs = organsWithLumps(scene);
    if (!organs.isOk()) {
        scene.warnings.push_back("lumps felt through their organ: " + organs.status().message());
        return {};
    }
    const bool areNamed = std::any_of(scene.structures.begin(), scene.structures.end(),
                                      [](const auto& one) { return !one.description.inside.empty(); });
    const auto isThrough = [&](std::size_t structure) {
        const meshio::SceneStructure& lump = scene.structures[structure].description;
        return lump.palpable && (!areNamed || !lump.inside.empty());
    };
    for (const OrganWithLumps& organ : lumpsThat(organs.value(), isThrough)) {
        buried::FeltOptions how;
        how.radius_mm = organ.radius_mm;
        how.press_mm.assign(haptics::kFeltPress_mm.begin(), haptics::kFeltPress_mm.end());
        how.progress = progress;
        auto felt = feltSurface(scene, organ, how);
        if (!felt.isOk()) {
            if (felt.status().code() == StatusCode::Cancelled) {
                return felt.status();
            }
            scene.warnings.push_back(felt.status().message());
            continue;
        }
        for (const std::string& note : felt.value().notes) {
            scene.warnings.push_back(note);
        }
        meshio::LoadedStructure& through = scene.structures[organ.organ];
        through.feltBelow.clear();
        for (buried::FeltSurface::Press& press : felt.value().press) {
            press.ratio.resize(felt.value().organVertices); // the organ's own come first
            through.feltBelow.push_back(std::move(press.ratio));
        }
        for (const buried::FeltSurface::Lump& lump : felt.value().lumps) {
            scene.structures[organ.lumps[lump.given].structure].isFeltThrough = true;
        }
    }
    return {};
}

} // namespace palpate::study

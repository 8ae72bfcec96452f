// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/SceneNotes.h"

#include <palpate/core/Parallel.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <utility>

namespace palpate::study {

namespace {

Layering layeringOf(std::span<const NeighbourSurface> surfaces)
{
    std::vector<LayeredSurface> layered;
    for (const NeighbourSurface& one : surfaces) {
        layered.push_back({one.index != nullptr ? one.surface : nullptr, one.index});
    }
    return layering(layered);
}

bool liesIn(const Layering& found, std::size_t inner, std::size_t outer)
{
    std::optional<std::size_t> in = found.structures[inner].in;
    while (in && *in != outer) {
        in = found.structures[*in].in;
    }
    return in.has_value();
}

bool isSameSurface(const Layering& found, std::size_t a, std::size_t b)
{
    return found.structures[a].twin.value_or(a) == found.structures[b].twin.value_or(b);
}

std::string gapSentence(const std::string& a, const std::string& b, const geometry::SurfaceGap& gap)
{
    std::array<char, 240> text{};
    std::snprintf(text.data(), text.size(),
                  "within %.2g mm of each other at (%.6g, %.6g, %.6g) without touching: a point falls into the gap, a "
                  "fingertip of 0.5 mm or more rides over it",
                  gap.distance_mm, gap.at.x(), gap.at.y(), gap.at.z());
    return a + " and " + b + " come " + text.data();
}

} // namespace

std::vector<NeighbourSurface> neighbours(const meshio::LoadedScene& scene, const haptics::HapticScene& felt)
{
    std::vector<NeighbourSurface> out;
    for (std::size_t i = 0; i < scene.structures.size(); ++i) {
        const meshio::LoadedStructure& one = scene.structures[i];
        out.push_back(
            {one.description.name, one.description.layer, one.surface.get(), felt.structures()[i].surface.get()});
    }
    return out;
}

std::vector<std::string> gapNotes(std::span<const NeighbourSurface> surfaces, const Layering& found)
{
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t a = 0; a < surfaces.size(); ++a) {
        for (std::size_t b = a + 1; b < surfaces.size(); ++b) {
            if (surfaces[a].index == nullptr || surfaces[b].index == nullptr ||
                surfaces[a].layer != surfaces[b].layer || isSameSurface(found, a, b) || liesIn(found, a, b) ||
                liesIn(found, b, a)) {
                continue;
            }
            const geometry::Box &one = surfaces[a].index->bounds(), &other = surfaces[b].index->bounds();
            if (one.squaredExteriorDistance(other) <= kNarrowGap_mm * kNarrowGap_mm) {
                pairs.emplace_back(a, b);
            }
        }
    }
    std::vector<std::optional<geometry::SurfaceGap>> gaps(pairs.size());
    core::parallelFor(pairs.size(), [&](std::size_t i, unsigned /*thread*/) {
        gaps[i] = geometry::nearestWithin(*surfaces[pairs[i].first].index, *surfaces[pairs[i].second].index,
                                          kNarrowGap_mm, kTouching_mm);
    });
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (gaps[i] && gaps[i]->distance_mm > kTouching_mm) {
            lines.push_back(gapSentence(surfaces[pairs[i].first].name, surfaces[pairs[i].second].name, *gaps[i]));
        }
    }
    return lines;
}

std::vector<std::string> gapNotes(std::span<const NeighbourSurface> surfaces)
{
    return gapNotes(surfaces, layeringOf(surfaces));
}

std::vector<std::string> unfeltLumpNotes(std::span<const NeighbourSurface> surfaces, const Layering& found)
{
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const std::optional<std::size_t> in = found.structures[i].in;
        if (surfaces[i].index == nullptr || !in || surfaces[*in].index == nullptr ||
            surfaces[*in].layer != surfaces[i].layer) {
            continue;
        }
        const char* const when = isWhollyInside(*surfaces[i].surface, *surfaces[*in].index)
                                     ? "it is never felt"
                                     : "it is felt only where it reaches out";
        lines.push_back(
            surfaces[i].name + " lies in " + surfaces[*in].name + " and in the same layer: " + when +
            "; a deeper layer lets it be felt (--layers auto for mesh files, the field layer in a scene file)");
    }
    return lines;
}

std::vector<std::string> neighbourNotes(const meshio::LoadedScene& scene, const haptics::HapticScene& felt)
{
    const std::vector<NeighbourSurface> surfaces = neighbours(scene, felt);
    const Layering found = layeringOf(surfaces);
    std::vector<std::string> lines = unfeltLumpNotes(surfaces, found);
    for (std::string& line : gapNotes(surfaces, found)) {
        lines.push_back(std::move(line));
    }
    return lines;
}

} // namespace palpate::study

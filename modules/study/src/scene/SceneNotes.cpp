// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/SceneNotes.h"

#include <palpate/core/Parallel.h>
#include <palpate/haptics/ForceTable.h>

#include <algorithm>
#include <cstdint>
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

core::Message gapSentence(const std::string& a, const std::string& b, const geometry::SurfaceGap& gap)
{
    return {
        PALPATE_TEXT("%1 and %2 come within %3 mm of each other at (%4, %5, %6) without touching: a point falls into "
                     "the gap, a fingertip of 0.5 mm or more rides over it"),
        a,
        b,
        core::Rounded{gap.distance_mm, 2},
        gap.at.x(),
        gap.at.y(),
        gap.at.z()};
}

/// Two structures of one layer with a possibly palpable border.
struct Border
{
    std::size_t a, b;
    bool isNested; ///< nested: a gap between them is unreachable
    double ratio;  ///< stiffness ratio of the stiffer to the softer structure, at least 1
    bool isSeam() const { return ratio > kPalpableSeamRatio; }
};

double ratioOf(double a, double b)
{
    return std::min(a, b) > 0.0 ? std::max(a, b) / std::min(a, b) : 1.0;
}

std::vector<Border> bordersOf(std::span<const NeighbourSurface> surfaces, const Layering& found)
{
    std::vector<Border> borders;
    for (std::size_t a = 0; a < surfaces.size(); ++a) {
        for (std::size_t b = a + 1; b < surfaces.size(); ++b) {
            const NeighbourSurface &one = surfaces[a], &other = surfaces[b];
            if (one.index == nullptr || other.index == nullptr || one.layer != other.layer ||
                isSameSurface(found, a, b)) {
                continue;
            }
            const Border border{a, b, liesIn(found, a, b) || liesIn(found, b, a),
                                ratioOf(one.stiffness_N_per_mm, other.stiffness_N_per_mm)};
            if ((!border.isNested || border.isSeam()) &&
                one.index->bounds().squaredExteriorDistance(other.index->bounds()) <= kNarrowGap_mm * kNarrowGap_mm) {
                borders.push_back(border);
            }
        }
    }
    return borders;
}

core::Message seamSentence(const std::string& a, const std::string& b, const Border& border)
{
    return {PALPATE_TEXT("%1 and %2 touch in one layer and differ %3-fold in stiffness: the force steps at the seam"),
            a, b, core::Rounded{border.ratio, 2}};
}

} // namespace

std::vector<NeighbourSurface> neighbours(const meshio::LoadedScene& scene, const haptics::HapticScene& felt)
{
    std::vector<NeighbourSurface> out;
    for (std::size_t i = 0; i < scene.structures.size(); ++i) {
        const meshio::LoadedStructure& one = scene.structures[i];
        out.push_back({one.description.name, one.description.layer, one.surface.get(),
                       felt.structures()[i].surface.get(), pressStiffness(one.description.tissue)});
    }
    return out;
}

double pressStiffness(const core::Tissue& tissue)
{
    constexpr double kPress_mm = 2.0;
    const auto table = haptics::ForceTable::build(tissue);
    return table == nullptr ? tissue.stiffness_N_per_mm : table->force(kPress_mm) / kPress_mm;
}

std::vector<core::Message> borderNotes(std::span<const NeighbourSurface> surfaces, const Layering& found)
{
    const std::vector<Border> borders = bordersOf(surfaces, found);
    std::vector<std::optional<geometry::SurfaceGap>> gaps(borders.size());
    core::parallelFor(borders.size(), [&](std::size_t i, unsigned /*thread*/) {
        gaps[i] = geometry::nearestWithin(*surfaces[borders[i].a].index, *surfaces[borders[i].b].index, kNarrowGap_mm,
                                          kTouching_mm);
    });
    std::vector<core::Message> lines;
    for (std::size_t i = 0; i < borders.size(); ++i) {
        const Border& border = borders[i];
        const std::string &a = surfaces[border.a].name, &b = surfaces[border.b].name;
        if (gaps[i] && gaps[i]->distance_mm <= kTouching_mm) {
            if (border.isSeam()) {
                lines.push_back(seamSentence(a, b, border));
            }
        } else if (gaps[i] && !border.isNested) {
            lines.push_back(gapSentence(a, b, *gaps[i]));
        }
    }
    return lines;
}

std::vector<core::Message> borderNotes(std::span<const NeighbourSurface> surfaces)
{
    return borderNotes(surfaces, layeringOf(surfaces));
}

std::vector<core::Message> maskedLumpNotes(std::span<const NeighbourSurface> surfaces, const Layering& found)
{
    std::vector<core::Message> lines;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const std::optional<std::size_t> in = found.structures[i].in;
        if (surfaces[i].index == nullptr || !in || surfaces[*in].index == nullptr ||
            surfaces[*in].layer != surfaces[i].layer) {
            continue;
        }
        const std::string &name = surfaces[i].name, &around = surfaces[*in].name;
        lines.push_back(
            isWhollyInside(*surfaces[i].surface, *surfaces[*in].index)
                ? core::Message(
                      PALPATE_TEXT("%1 lies in %2 and in the same layer: it is never felt; a deeper layer lets "
                                   "it be felt (--layers auto for mesh files, the field layer in a scene file)"),
                      name, around)
                : core::Message(
                      PALPATE_TEXT("%1 lies in %2 and in the same layer: it is felt only where it reaches out; "
                                   "a deeper layer lets it be felt (--layers auto for mesh files, the field "
                                   "layer in a scene file)"),
                      name, around));
    }
    return lines;
}

std::vector<core::Message> neighbourNotes(const meshio::LoadedScene& scene, const haptics::HapticScene& felt)
{
    const std::vector<NeighbourSurface> surfaces = neighbours(scene, felt);
    const Layering found = layeringOf(surfaces);
    std::vector<core::Message> lines = maskedLumpNotes(surfaces, found);
    for (core::Message& line : borderNotes(surfaces, found)) {
        lines.push_back(std::move(line));
    }
    return lines;
}

} // namespace palpate::study

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/LumpAtContact.h"

#include <palpate/buried/FeltSurface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace palpate::ui {

namespace {

/// k/k0 at a vertex, interpolated linearly between the tabulated depths as in the haptic rendering.
double ratioAt(const std::vector<std::vector<float>>& below, std::size_t vertex, double depth_mm)
{
    for (std::size_t i = 1; i < below.size(); ++i) {
        const double from_mm = haptics::kFeltPress_mm[i - 1], to_mm = haptics::kFeltPress_mm[i];
        if (depth_mm < to_mm) {
            const double part = std::max(0.0, (depth_mm - from_mm) / (to_mm - from_mm));
            return (1.0 - part) * double{below[i - 1][vertex]} + part * double{below[i][vertex]};
        }
    }
    return double{below.back()[vertex]};
}

/// Far-field share of a lump up to a common factor: volume divided by the fourth power of the distance
/// (resources/docs/felt.md). The offset of 1 µm avoids a division by zero.
double shareOf(const meshio::LoadedStructure& lump, const core::Vec3& p_W)
{
    const geometry::MeshReport& report = lump.surface->report;
    return std::abs(report.volume_mm3) / std::pow((report.bounds.center() - p_W).norm() + 1e-3, 4.0);
}

} // namespace

std::optional<LumpAtContact> lumpAtContact(const StructureModel& model, int organRow, const core::Vec3& p_WG,
                                           double depth_mm)
{
    const meshio::LoadedStructure& organ = model.rows()[static_cast<std::size_t>(organRow)].loaded;
    if (organ.feltBelow.size() != haptics::kFeltPress_mm.size() || organ.surface == nullptr) {
        return std::nullopt;
    }
    std::optional<LumpAtContact> under;
    double most = 0.0;
    for (int row = 0; row < model.rowCount(); ++row) {
        const study::OpenStructure& lump = model.rows()[static_cast<std::size_t>(row)];
        if (lump.isRemoved || !lump.loaded.isTransmitted || lump.loaded.surface == nullptr ||
            model.organAround(row) != organRow) {
            continue;
        }
        if (const double share = shareOf(lump.loaded, p_WG); share > most) {
            most = share;
            under = LumpAtContact{row, 1.0};
        }
    }
    const std::vector<core::Vec3>& vertices = organ.surface->mesh.vertices;
    if (!under || !model.isListed(under->row) || organ.feltBelow.front().size() != vertices.size()) {
        return std::nullopt;
    }
    const auto nearest = std::min_element(vertices.begin(), vertices.end(), [&](const auto& a, const auto& b) {
        return (a - p_WG).squaredNorm() < (b - p_WG).squaredNorm();
    });
    under->ratio = ratioAt(organ.feltBelow, static_cast<std::size_t>(nearest - vertices.begin()), depth_mm);
    const double least = std::log1p(buried::kDetectableChange_percent[0] / 100.0);
    return std::abs(std::log(under->ratio)) >= least ? under : std::nullopt;
}

void addLump(const StructureModel& model, int organRow, const core::Vec3& p_WG, TouchReading& reading)
{
    if (const auto under = lumpAtContact(model, organRow, p_WG, reading.depth_mm)) {
        const meshio::SceneStructure& lump = model.structure(under->row);
        reading.lump = readableName(lump.name);
        reading.lumpColour = colourOf(lump);
        reading.lumpRatio = under->ratio;
    }
}

} // namespace palpate::ui

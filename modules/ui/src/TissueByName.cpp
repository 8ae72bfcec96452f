// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/TissueByName.h"

#include "palpate/ui/TissuePresets.h"

#include <palpate/meshio/AnatomyKind.h>

#include <algorithm>
#include <string_view>

namespace palpate::ui {

namespace {

constexpr double kAroundOthers = 0.4; // opacity at which a lump shows through its organ

/// @return the preset's English name; empty for what keeps its tissue.
std::string_view presetNameOf(meshio::AnatomyKind kind)
{
    switch (kind) {
    case meshio::AnatomyKind::Lump:
        return "Hard lump";
    case meshio::AnatomyKind::Bone:
        return "Bone";
    case meshio::AnatomyKind::Liver:
        return "Liver, healthy (2.3 kPa)";
    case meshio::AnatomyKind::Organ:
    case meshio::AnatomyKind::Skin:
        return "Soft organ";
    case meshio::AnatomyKind::SoftOrgan:
        return "Very soft organ";
    default:
        return {};
    }
}

bool isPassedThrough(meshio::AnatomyKind kind)
{
    return kind == meshio::AnatomyKind::Vessel || kind == meshio::AnatomyKind::Nerve ||
           kind == meshio::AnatomyKind::Duct;
}

bool isAround(meshio::AnatomyKind kind)
{
    return kind == meshio::AnatomyKind::Liver || kind == meshio::AnatomyKind::Organ ||
           kind == meshio::AnatomyKind::SoftOrgan || kind == meshio::AnatomyKind::Skin;
}

bool isSame(const meshio::SceneStructure& a, const meshio::SceneStructure& b)
{
    return a.tissue == b.tissue && a.opacity == b.opacity && a.palpable == b.palpable;
}

} // namespace

std::vector<StructureModel::Edited> tissueByName(const StructureModel& model, const study::Layering& layering,
                                                 int first)
{
    bool isAnyFelt = false;
    std::vector<bool> holds(model.rows().size());
    for (const StructureRow& row : model.rows()) {
        const meshio::SceneStructure& one = row.loaded.description;
        isAnyFelt = isAnyFelt ||
                    (!row.isRemoved && StructureModel::isFelt(one) && !isPassedThrough(meshio::anatomyKind(one.name)));
    }
    for (const study::Layering::Structure& one : layering.structures) {
        for (const std::optional<std::size_t>& around : {one.in, one.unsureIn}) {
            if (around) {
                holds[*around] = true;
            }
        }
    }
    std::vector<StructureModel::Edited> edits;
    for (int number = first; number < model.rowCount(); ++number) {
        const StructureRow& row = model.rows()[static_cast<std::size_t>(number)];
        const meshio::AnatomyKind kind = meshio::anatomyKind(row.loaded.description.name);
        meshio::SceneStructure changed = row.loaded.description;
        const auto preset = std::find_if(tissuePresets().begin(), tissuePresets().end(),
                                         [&](const TissuePreset& one) { return one.name == presetNameOf(kind); });
        if (preset != tissuePresets().end() && row.loaded.maps.empty()) {
            changed.tissue = withPreset(changed.tissue, *preset);
        }
        changed.palpable = changed.palpable && !(isAnyFelt && isPassedThrough(kind));
        if (isAround(kind) && holds[static_cast<std::size_t>(number)]) {
            changed.opacity = std::min(changed.opacity, kAroundOthers);
        }
        if (!row.isRemoved && !isSame(changed, row.loaded.description)) {
            edits.push_back({number, changed});
        }
    }
    return edits;
}

} // namespace palpate::ui

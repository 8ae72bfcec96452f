// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/TissueByName.h"

#include "palpate/ui/TissuePresets.h"

#include <palpate/study/HapticCopy.h>
#include <palpate/study/StiffnessRatio.h>

#include <algorithm>
#include <optional>
#include <string>

namespace palpate::ui {

namespace {

constexpr double kAroundOthers = 0.4;             // opacity at which a lump is visible through its organ
constexpr double kBoneDamping_Ns_per_mm = 0.0005; // as in the preset "Bone"

bool isPassedThrough(meshio::AnatomyKind kind)
{
    return kind == meshio::AnatomyKind::Vessel || kind == meshio::AnatomyKind::Nerve ||
           kind == meshio::AnatomyKind::Duct;
}

/// True for structures that become translucent when they contain others.
bool isAround(meshio::AnatomyKind kind)
{
    return kind >= meshio::AnatomyKind::Kidney || kind == meshio::AnatomyKind::Fat ||
           kind == meshio::AnatomyKind::Muscle;
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
    for (const study::OpenStructure& row : model.rows()) {
        const meshio::SceneStructure& one = row.loaded.description;
        isAnyFelt =
            isAnyFelt || (!row.isRemoved && study::canBeFelt(one) && !isPassedThrough(meshio::anatomyKind(one.name)));
    }
    for (const study::Layering::Structure& one : layering.structures) {
        for (const std::optional<std::size_t>& around : {one.in, one.unreliableParent}) {
            if (around) {
                holds[*around] = true;
            }
        }
    }
    std::vector<StructureModel::Edited> edits;
    for (int number = first; number < model.rowCount(); ++number) {
        const study::OpenStructure& row = model.rows()[static_cast<std::size_t>(number)];
        const meshio::AnatomyKind kind = meshio::anatomyKind(row.loaded.description.name);
        meshio::SceneStructure changed = row.loaded.description;
        const std::optional<std::size_t> around =
            layering.structures[static_cast<std::size_t>(number)].in
                ? layering.structures[static_cast<std::size_t>(number)].in
                : layering.structures[static_cast<std::size_t>(number)].unreliableParent;
        const std::string* organ = around ? &model.structure(static_cast<int>(*around)).name : nullptr;
        const std::optional<double> stiffness = study::namedStiffness_N_per_mm(changed.name, organ);
        if (stiffness && row.loaded.maps.empty()) {
            core::Tissue named;
            named.stiffness_N_per_mm = *stiffness;
            named.damping_Ns_per_mm = kind == meshio::AnatomyKind::Bone ? kBoneDamping_Ns_per_mm : 0.0;
            changed.tissue = withPreset(changed.tissue, {nullptr, nullptr, named});
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

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/TouchMode.h"

#include <palpate/study/Layers.h>

#include <algorithm>

namespace palpate::ui {

namespace {

bool hasReliableInterior(const StructureModel& model, int row)
{
    const auto& surface = model.rows()[static_cast<std::size_t>(row)].loaded.surface;
    return surface != nullptr && study::hasReliableInterior(surface->report);
}

} // namespace

std::optional<int> transmittingOrgan(const StructureModel& model, int row)
{
    const std::optional<int> organ = model.organAround(row);
    if (!organ || !hasReliableInterior(model, row) || !hasReliableInterior(model, *organ)) {
        return std::nullopt;
    }
    // A scene file identifies the organ by name, which must be unique.
    for (int other = 0; other < model.rowCount(); ++other) {
        if (other != *organ && model.structure(other).name == model.structure(*organ).name &&
            !model.rows()[static_cast<std::size_t>(other)].isRemoved) {
            return std::nullopt;
        }
    }
    return organ;
}

void feel(StructureModel& model, const std::vector<TouchMode>& ways, const QString& text)
{
    std::vector<StructureModel::Edited> edits;
    bool hasTransmittedLump = false;
    for (int row = 0; row < model.rowCount(); ++row) {
        const auto way = std::find_if(ways.begin(), ways.end(), [row](const TouchMode& one) { return one.row == row; });
        const meshio::SceneStructure& now = model.structure(row);
        meshio::SceneStructure changed = now;
        const bool isThrough = way == ways.end() ? model.isTransmitted(row) : !way->layer;
        const std::optional<int> organ = isThrough ? model.organAround(row) : std::nullopt;
        if (organ) { // names the organ explicitly, so that no other structure is chosen as an organ by its shape
            changed.inside = model.structure(*organ).name;
            changed.layer = 0;
            hasTransmittedLump = true;
        } else if (way != ways.end() && way->layer) {
            changed.layer = *way->layer;
            if (changed.layer > 0 || model.buried() == meshio::BuriedTouch::Felt) {
                changed.inside.clear();
            }
        }
        if (changed.layer != now.layer || changed.inside != now.inside) {
            edits.push_back({row, std::move(changed)});
        }
    }
    model.editAll(std::move(edits), text, hasTransmittedLump ? meshio::BuriedTouch::Felt : meshio::BuriedTouch::Layers);
}

} // namespace palpate::ui

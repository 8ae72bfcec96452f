// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/DrawnMotion.h"

#include <memory>
#include <vector>

namespace palpate::ui {

void drawMotion(view::SceneView& view, const StructureModel& model, double time_s)
{
    std::vector<std::shared_ptr<const geometry::SurfaceMotion>> motions;
    for (const study::OpenStructure& row : model.rows()) {
        motions.push_back(row.loaded.motion);
    }
    view.moveTo(motions, time_s);
}

core::Vec3 restOf(const geometry::SurfaceMotion* motion, double time_s, const core::Vec3& p_W)
{
    return motion == nullptr ? p_W : motion->toRest(motion->at(time_s), p_W, p_W).X;
}

} // namespace palpate::ui

// SPDX-License-Identifier: BSD-3-Clause
#include "Models.h"

#include <algorithm>

namespace palpate::haply {

Model modelOf(std::string_view type)
{
    if (type.empty() || type.starts_with("inverse3")) {
        return {"Haply Inverse3", 10.0, 1.0, 0.006, 150.0, core::Vec3(0.0, -0.15, 0.20), true};
    }
    return {type == "minverse" ? "Haply Minverse" : "Haply " + std::string(type),
            3.0,
            0.3,
            0.004,
            75.0,
            core::Vec3::Zero(),
            false};
}

Model limited(Model model, const Settings& settings)
{
    const auto apply = [&model](double stated, double& limit) {
        if (stated > 0.0) {
            limit = model.isKnown ? std::min(stated, limit) : stated;
        }
    };
    apply(settings.maxForce_N, model.maxForce_N);
    apply(settings.maxStiffness_N_per_mm, model.maxStiffness_N_per_mm);
    apply(settings.maxDamping_Ns_per_mm, model.maxDamping_Ns_per_mm);
    apply(settings.workspaceRadius_mm, model.workspaceRadius_mm);
    return model;
}

} // namespace palpate::haply

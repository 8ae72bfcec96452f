// SPDX-License-Identifier: BSD-3-Clause
#include "Fuzz.h"

#include <palpate/meshio/SceneFile.h>

#include <cmath>

namespace palpate::fuzz {

namespace scene {

std::vector<std::string> seeds()
{
    return {
        R"({"version": 1, "structures": [{"mesh": "a.obj"}]})",
        R"({"version": 1, "structures": [{"mesh": "b/ä.stl", "part": "p", "unit_mm": 10, "name": "liver",
            "colour": [0.1, 0.2, 0.3], "opacity": 0.5, "visible": false, "palpable": true, "flipped": true, "layer": 2,
            "stiffness_N_per_mm": 0.4, "damping_Ns_per_mm": 0.001, "mine": {"a": [1, null]},
            "pose": [[1,0,0,5],[0,1,0,6],[0,0,1,7],[0,0,0,1]]}],
            "camera": {"position": [1,2,3], "focus": [0,0,0], "up": [0,0,1], "view_angle_deg": 30},
            "findings": [{"name": "lump", "position": [1,2,3], "note": "hard"}], "later": true})",
        R"({"version": 2})",
        R"([])",
        "{",
    };
}

void tryInput(std::string_view bytes)
{
    static const InputFile file("a.palpate.json");
    static const InputFile again("b.palpate.json");
    file.set(bytes);
    const auto scene = meshio::readScene(file.path());
    if (!scene.isOk()) {
        requireOneLine(scene.status(), "a.palpate.json");
        return;
    }
    for (const meshio::SceneStructure& structure : scene.value().structures) {
        require(structure.opacity >= 0.0 && structure.opacity <= 1.0, "opacity is 0 to 1");
        require(std::isfinite(structure.tissue.stiffness_N_per_mm), "stiffness is a number");
    }
    // What was read can be written, and reads as the same number of everything.
    again.set("");
    require(meshio::writeScene(again.path(), scene.value()).isOk(), "a scene that was read can be written");
    const auto back = meshio::readScene(again.path());
    require(back.isOk(), "a scene that was written can be read");
    require(back.value().structures.size() == scene.value().structures.size(), "no structure is lost");
    require(back.value().findings.size() == scene.value().findings.size(), "no finding is lost");
}

} // namespace scene

extern const Target kScene{"scene", 300, scene::seeds, scene::tryInput};

} // namespace palpate::fuzz

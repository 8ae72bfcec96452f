// SPDX-License-Identifier: BSD-3-Clause
#include "Fuzz.h"

#include <palpate/core/Tissue.h>
#include <palpate/meshio/SceneFile.h>

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
        // Every group of fields of a structure, a finding and the scene.
        R"({"version": 1, "buried": "felt", "structures": [{"mesh": "a.vtp", "name": "organ", "surface": "smoothed",
            "smoothing": 0.5, "crease_deg": 40, "frame": "RAS", "friction": {"static": 0.5, "dynamic": 0.3,
            "drag_Ns_per_mm": 0.01}, "law": {"kind": "points", "points": [[0, 0], [1, 0.5], [3, 4]]},
            "maps": [{"quantity": "stiffness", "array": "E", "unit": "young_kPa", "contact_radius_mm": 4,
            "clamp": [0.1, 10]}, {"quantity": "friction", "file": "f.vti"}]},
            {"mesh": "b.vtp", "name": "lump", "inside": "organ", "young_ratio": 5, "felt_contact_radius_mm": 4},
            {"mesh": "c.vtp", "law": {"kind": "exponential", "k0_N_per_mm": 0.1, "beta_per_mm": 0.5,
            "k_max_N_per_mm": 2}}, {"mesh": "d.vtp", "law": {"kind": "hertz", "young_kPa": 10, "radius_mm": 8}},
            {"mesh": "e.vtp", "law": {"kind": "layer", "young_kPa": 10, "radius_mm": 8, "thickness_mm": 5}},
            {"mesh": "f.vtp", "law": {"kind": "click", "F1_N": 2, "F2_N": 1, "fall_mm": 1}}],
            "shown_map": {"structure": "organ", "numbers": "array:E"},
            "findings": [{"id": "a", "name": "lump", "type": "lump", "position": [1,2,3], "size_mm": 4, "force_N": 1,
            "depth_mm": 2, "layers": [{"structure": "organ", "force_N": 1, "depth_mm": 2}],
            "camera": {"position": [1,2,3], "focus": [0,0,0], "up": [0,0,1]},
            "recording": {"file": "r.palpate", "tick": 5, "time_s": 0.005}, "marked_utc": "2026-11-23T08:30:00Z"}]})",
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
        for (const core::TissueTerm& term : core::kTissueTerms) {
            const double value = structure.tissue.*term.member;
            require(value >= 0.0 && value <= term.most, "a tissue's numbers are in range");
        }
        require(core::check(structure.tissue.law).isOk(), "a law is a possible one");
        require(structure.X_WM.matrix().allFinite(), "a pose is of numbers");
    }
    // A scene that was read can be written, and reading the result gives the same counts.
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

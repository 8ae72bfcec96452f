// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/Stability.h"

#include <algorithm>
#include <iomanip>
#include <locale>
#include <sstream>

namespace palpate::evaluation::stability {

namespace {

std::vector<MapEdge> edgesFor(const haptics::HapticScene& scene, const Setup& setup)
{
    study::HeldDevice held = study::heldDevice(setup.preset, setup.rate_Hz, setup.delayTicks);
    held.added_Ns_per_mm = setup.isControlled ? held.added_Ns_per_mm : 0.0;
    return study::mapEdges(scene, held);
}

} // namespace

std::optional<MapEdge> worstMapEdge(const haptics::HapticScene& scene, const Setup& setup)
{
    const std::vector<MapEdge> edges = edgesFor(scene, setup);
    const auto worst = std::max_element(edges.begin(), edges.end(),
                                        [](const MapEdge& a, const MapEdge& b) { return a.swing_mm < b.swing_mm; });
    return worst == edges.end() ? std::nullopt : std::optional(*worst);
}

std::vector<std::string> mapWarnings(const haptics::HapticScene& scene, const Options& options)
{
    std::vector<std::string> lines;
    for (const device::DevicePreset& preset : options.presets) {
        Setup setup;
        setup.preset = preset;
        setup.rate_Hz = options.rate_Hz;
        setup.delayTicks = options.delayTicks;
        for (const MapEdge& edge : edgesFor(scene, setup)) {
            if (edge.swing_mm < kLimitCycle_mm) {
                continue;
            }
            std::ostringstream line;
            line.imbue(std::locale::classic());
            line << scene.structures()[edge.structure].name << ": "
                 << (edge.isOfLumps ? "what lumps below make of it bends too sharply for "
                                    : "its map of stiffness bends too sharply for ")
                 << preset.name << " at (" << std::fixed << std::setprecision(1) << edge.p_W.x() << ", " << edge.p_W.y()
                 << ", " << edge.p_W.z() << ") mm: the push aside jumps by " << std::setprecision(2) << edge.jump_N
                 << " N there and can keep the tip swinging by " << edge.swing_mm << " mm, expected less than "
                 << kLimitCycle_mm
                 << (edge.isOfLumps ? "; give the tissue friction, or the mesh shorter edges there"
                                    : "; spread the step over more millimetres, round its ends, or give the tissue "
                                      "friction");
            lines.push_back(line.str());
        }
    }
    return lines;
}

} // namespace palpate::evaluation::stability

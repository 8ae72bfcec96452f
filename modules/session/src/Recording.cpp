// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/Recording.h"

#include "recording/BuildId.h"
#include "store/MapRows.h"

#include <palpate/haptics/ForceTable.h>

namespace palpate::session {

std::string palpateVersion()
{
    return internal::kVersion;
}

std::string buildId()
{
    return internal::kBuildId;
}

bool isExactBuild(std::string_view id)
{
    const std::string_view commit = id.substr(0, id.find(' '));
    return commit != "unknown" && !commit.ends_with("-dirty");
}

SceneRecord describeScene(std::uint32_t generation, const haptics::HapticScene& scene,
                          std::span<const StructureSource> sources)
{
    SceneRecord record;
    record.generation = generation;
    record.fingertip_mm = scene.fingertip_mm();
    for (std::size_t i = 0; i < scene.structures().size(); ++i) {
        const auto& structure = scene.structures()[i];
        StructureRecord& out = record.structures.emplace_back();
        out.name = structure.name;
        out.source = i < sources.size() ? sources[i] : StructureSource{};
        out.tissue = structure.tissue;
        out.layer = structure.layer;
        out.palpable = structure.surface != nullptr;
        out.tissueMaps = structure.maps;
        out.motion = structure.motion;
        out.maps = internal::mapsText({structure.maps, structure.motion});
        if (structure.law != nullptr) {
            const std::vector<std::byte> table = structure.law->bytes();
            out.lawTable.assign(reinterpret_cast<const char*>(table.data()), table.size());
        }
    }
    return record;
}

} // namespace palpate::session

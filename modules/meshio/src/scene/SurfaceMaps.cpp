// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/meshio/SurfaceMaps.h"

#include "scene/SampleVolume.h"
#include "text/Fault.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate::meshio {

using namespace internal;

namespace {

using core::TissueMapping;
using geometry::MeshArray;

constexpr float kNotFelt = std::numeric_limits<float>::quiet_NaN();
constexpr double kManyMissing = 0.2; ///< share of missing values that the warning points out

/// @return the expected array, for messages
core::Message namesOf(const geometry::TriangleMesh& mesh)
{
    std::string names;
    for (const MeshArray& array : mesh.arrays) {
        names += (names.empty() ? "" : ", ") + inQuotes(array.name);
    }
    return names.empty() ? core::Message(PALPATE_TEXT("a mesh with arrays: this one has none"))
                         : core::Message(PALPATE_TEXT("one of %1"), names);
}

/// Converts a number of a file for the servo tick; unknown if not palpable: a stiffness must be above 0.
float feltValue(const TissueMapping& mapping, float value)
{
    if (!std::isfinite(value)) {
        return kNotFelt;
    }
    const double taken = mapping.clamp ? std::clamp(double{value}, (*mapping.clamp)[0], (*mapping.clamp)[1]) : value;
    const auto felt = static_cast<float>(mapping.felt(taken));
    const bool isUsable =
        std::isfinite(felt) && (core::traitsOf(mapping.quantity).isAboveZero ? felt > 0.0F : felt >= 0.0F);
    return isUsable ? felt : kNotFelt;
}

void noteMissing(const SurfaceMap& map, const std::string& name, std::vector<core::Message>& warnings)
{
    const std::size_t missing = missingValues(map);
    if (missing == 0) {
        return;
    }
    const core::Message what = map.mapping.array.empty()
                                   ? core::Message(PALPATE_TEXT("the volume"))
                                   : core::Message(PALPATE_TEXT("the array %1"), inQuotes(map.mapping.array));
    const bool isMany = static_cast<double>(missing) > kManyMissing * static_cast<double>(map.values.size());
    const Count places(map.values.size());
    warnings.push_back(
        isMany ? core::Message(PALPATE_TEXT("%1: %2 has no value at %3 of %4 places, more than a fifth: the "
                                            "structure's own value is felt there"),
                               name, what, Count(missing), places)
               : core::Message(
                     PALPATE_TEXT("%1: %2 has no value at %3 of %4 places: the structure's own value is felt there"),
                     name, what, Count(missing), places));
}

} // namespace

std::vector<TissueMapping> knownMappings(const geometry::TriangleMesh& mesh)
{
    std::vector<TissueMapping> found;
    for (const core::KnownMap& known : core::kKnownMaps) {
        if (std::any_of(mesh.arrays.begin(), mesh.arrays.end(),
                        [&](const MeshArray& a) { return a.name == known.array; })) {
            TissueMapping& mapping = found.emplace_back();
            mapping.quantity = known.quantity;
            mapping.unit = known.unit;
            mapping.array = known.array;
        }
    }
    return found;
}

std::size_t missingValues(const SurfaceMap& map) noexcept
{
    return static_cast<std::size_t>(
        std::count_if(map.values.begin(), map.values.end(), [](float v) { return std::isnan(v); }));
}

void resolveMaps(LoadedStructure& structure, std::vector<core::Message>& warnings, std::vector<core::Message>& losses,
                 const std::function<bool()>& keepGoing)
{
    const geometry::TriangleMesh& mesh = structure.surface->mesh;
    const std::string& name = structure.description.name;
    structure.maps.clear();
    for (const TissueMapping& mapping : structure.description.maps.value_or(knownMappings(mesh))) {
        SurfaceMap map{mapping, false, {}};
        if (mapping.array.empty()) {
            core::Result<std::vector<float>> sampled =
                sampleVolume(mapping, *structure.surface, structure.description.frame, keepGoing);
            if (!sampled.isOk()) {
                losses.push_back(sampled.status().at(name).text());
                continue;
            }
            map.values = std::move(sampled).value();
        } else {
            const auto array = std::find_if(mesh.arrays.begin(), mesh.arrays.end(),
                                            [&](const MeshArray& a) { return a.name == mapping.array; });
            if (array == mesh.arrays.end()) {
                losses.push_back(fault(core::StatusCode::NotFound, structure.description.mesh.filename().string(),
                                       {PALPATE_TEXT("%1"), name},
                                       {PALPATE_TEXT("no array %1"), inQuotes(mapping.array)}, namesOf(mesh))
                                     .text());
                continue;
            }
            map.isPerTriangle = array->isPerTriangle;
            map.values = array->values;
        }
        std::transform(map.values.begin(), map.values.end(), map.values.begin(),
                       [&](float value) { return feltValue(mapping, value); });
        noteMissing(map, name, warnings);
        std::erase_if(structure.maps, [&](const SurfaceMap& m) { return m.mapping.quantity == mapping.quantity; });
        structure.maps.push_back(std::move(map));
    }
}

} // namespace palpate::meshio

// SPDX-License-Identifier: BSD-3-Clause
#include "reports/MapReport.h"

#include "shared/Console.h"
#include "shared/QtText.h"

#include <palpate/core/Numbers.h>
#include <palpate/core/Text.h>
#include <palpate/meshio/SurfaceMaps.h>
#include <palpate/study/FeltMap.h>

#include <QJsonArray>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>

namespace palpate::app {

namespace {

/// Range of the known values and number of unknown ones.
struct Range
{
    double least = 0.0, greatest = 0.0;
    std::size_t known = 0, missing = 0;
};

Range rangeOf(std::span<const float> values)
{
    Range range;
    for (const float value : values) {
        if (!std::isfinite(value)) {
            ++range.missing;
            continue;
        }
        range.least = range.known == 0 ? double{value} : std::min(range.least, double{value});
        range.greatest = range.known == 0 ? double{value} : std::max(range.greatest, double{value});
        ++range.known;
    }
    return range;
}

std::string between(double least, double greatest)
{
    return core::shortNumber(least) + " to " + core::shortNumber(greatest);
}

std::string missing(std::size_t count, std::size_t all, const char* what)
{
    return count == 0 ? std::string() : "; " + grouped(count) + " of " + grouped(all) + what;
}

const char* placeName(bool isPerTriangle)
{
    return isPerTriangle ? "cell" : "point";
}

std::string_view nameOf(core::MappedQuantity quantity)
{
    return core::traitsOf(quantity).name;
}

std::string_view nameOf(core::MapUnit unit)
{
    return core::kMapUnitNames[static_cast<std::size_t>(unit)];
}

bool isModulus(core::MapUnit unit)
{
    return unit == core::MapUnit::YoungKPa || unit == core::MapUnit::ShearKPa;
}

std::string mapLine(const meshio::SurfaceMap& map, const core::Tissue& tissue)
{
    const core::TissueMapping& mapping = map.mapping;
    const study::FeltMap felt = study::feltMap(map, tissue);
    std::string line = std::string(nameOf(mapping.quantity)) + " by ";
    line += mapping.array.empty()
                ? "the volume " + core::inQuotes(std::filesystem::path(mapping.file).filename().string())
                : "the array " + core::inQuotes(mapping.array);
    line += " (" + std::string(nameOf(mapping.unit));
    if (isModulus(mapping.unit)) {
        line += ", contact radius " + core::shortNumber(mapping.contactRadius_mm) + " mm";
    }
    if (mapping.clamp) {
        line += ", limited to " + between((*mapping.clamp)[0], (*mapping.clamp)[1]);
    }
    line += "): felt as " + between(felt.least, felt.greatest) + " " + felt.unit;
    const std::string used = " values missing: " + core::shortNumber(felt.own) + " is used there";
    return line + missing(meshio::missingValues(map), map.values.size(), used.c_str());
}

} // namespace

std::vector<std::string> mapLines(const meshio::LoadedStructure& structure)
{
    std::vector<std::string> lines;
    for (const geometry::MeshArray& array : structure.surface->mesh.arrays) {
        const Range range = rangeOf(array.values);
        lines.push_back("array " + core::inQuotes(array.name) + " (" + placeName(array.isPerTriangle) +
                        "): " + (range.known == 0 ? "no values" : between(range.least, range.greatest)) +
                        missing(range.missing, array.values.size(), " missing"));
    }
    for (const meshio::SurfaceMap& map : structure.maps) {
        lines.push_back("map: " + mapLine(map, structure.description.tissue));
    }
    return lines;
}

void addMaps(const meshio::LoadedStructure& structure, QJsonObject& object)
{
    QJsonArray arrays, maps;
    for (const geometry::MeshArray& array : structure.surface->mesh.arrays) {
        const Range range = rangeOf(array.values);
        QJsonObject one{{"name", text(array.name)},
                        {"of", placeName(array.isPerTriangle)},
                        {"missing", static_cast<qint64>(range.missing)}};
        one["least"] = range.known > 0 ? QJsonValue(range.least) : QJsonValue();
        one["greatest"] = range.known > 0 ? QJsonValue(range.greatest) : QJsonValue();
        arrays.append(one);
    }
    for (const meshio::SurfaceMap& map : structure.maps) {
        const core::TissueMapping& mapping = map.mapping;
        const study::FeltMap felt = study::feltMap(map, structure.description.tissue);
        QJsonObject one{{"quantity", text(std::string(nameOf(mapping.quantity)))},
                        {"unit", text(std::string(nameOf(mapping.unit)))},
                        {"of", placeName(map.isPerTriangle)},
                        {"missing", static_cast<qint64>(meshio::missingValues(map))},
                        {"felt_unit", text(felt.unit)},
                        {"felt_least", felt.least},
                        {"felt_greatest", felt.greatest},
                        {"felt_where_missing", felt.own}};
        one[mapping.array.empty() ? "file" : "array"] = text(mapping.array.empty() ? mapping.file : mapping.array);
        if (isModulus(mapping.unit) || mapping.array.empty()) {
            one["contact_radius_mm"] = mapping.contactRadius_mm;
        }
        if (mapping.clamp) {
            one["clamp"] = QJsonArray{(*mapping.clamp)[0], (*mapping.clamp)[1]};
        }
        maps.append(one);
    }
    if (!arrays.isEmpty()) {
        object["arrays"] = arrays;
    }
    if (!maps.isEmpty()) {
        object["maps"] = maps;
    }
}

} // namespace palpate::app

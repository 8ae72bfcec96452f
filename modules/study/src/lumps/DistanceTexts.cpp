// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/Distances.h"

#include <palpate/core/Quantity.h>

#include <QJsonArray>

namespace palpate::study {

namespace {

using core::Message;
using core::Rounded;
using geometry::Relation;

QJsonArray tripleOf(const core::Vec3& v)
{
    return {v.x(), v.y(), v.z()};
}

Message placeOf(const core::Vec3& p)
{
    return {PALPATE_TEXT("(%1, %2, %3)"), p.x(), p.y(), p.z()};
}

QJsonArray sizesOf(const DistanceTable& table)
{
    QJsonArray sizes;
    for (const StructureSize& size : table.sizes) {
        const auto diameter_mm = size.ballDiameter_mm();
        sizes.append(QJsonObject{
            {"name", QString::fromStdString(size.name)},
            {"volume_mm3", size.volume_mm3 ? QJsonValue(*size.volume_mm3) : QJsonValue()},
            {"volume_note", size.note.isEmpty() ? QJsonValue() : QString::fromStdString(size.note.english())},
            {"ball_diameter_mm", diameter_mm ? QJsonValue(*diameter_mm) : QJsonValue()},
            {"area_mm2", size.area_mm2},
            {"extent_mm", tripleOf(size.extent_mm)}});
    }
    return sizes;
}

} // namespace

Message sizeText(const StructureSize& size)
{
    const Message extent{PALPATE_TEXT("area %1, extent %2 × %3 × %4 mm"), core::areaText(size.area_mm2),
                         Rounded{size.extent_mm.x(), 4}, Rounded{size.extent_mm.y(), 4},
                         Rounded{size.extent_mm.z(), 4}};
    if (!size.volume_mm3) {
        return {PALPATE_TEXT("%1; %2"), extent, size.note};
    }
    const Message whole{PALPATE_TEXT("volume %1 (a ball of %2 mm), %3"), core::volumeText(*size.volume_mm3),
                        Rounded{*size.ballDiameter_mm(), 4}, extent};
    return size.note.isEmpty() ? whole : core::joined({whole, size.note});
}

Message sentence(const StructureSize& size)
{
    return {PALPATE_TEXT("%1: %2"), size.name, sizeText(size)};
}

Message sentence(const DistanceTable& table, const PairDistance& pair)
{
    const std::string &first = table.sizes[pair.first].name, &second = table.sizes[pair.second].name;
    const geometry::SurfaceDistance& found = pair.found;
    const Message from = placeOf(found.onFirst), to = placeOf(found.onSecond);
    const Rounded surface_mm{found.surface_mm, 4};
    switch (found.relation) {
    case Relation::Crossing:
        return {PALPATE_TEXT("%1 to %2: 0 mm, they cross or touch at %3"), first, second, from};
    case Relation::Inside:
        return {PALPATE_TEXT("%1 to %2: 0 mm, %1 lies inside, %3 mm from the surface, from %4 to %5"),
                first,
                second,
                surface_mm,
                from,
                to};
    case Relation::Around:
        return {PALPATE_TEXT("%1 to %2: 0 mm, %2 lies inside, %3 mm from the surface, from %4 to %5"),
                first,
                second,
                surface_mm,
                from,
                to};
    case Relation::Apart:
        break;
    }
    return {PALPATE_TEXT("%1 to %2: %3 mm, from %4 to %5"), first, second, surface_mm, from, to};
}

Message sentence(const core::Tape& tape)
{
    const auto end = [](const std::string& on, const core::Vec3& p) {
        return on.empty() ? placeOf(p) : Message(PALPATE_TEXT("%1 at %2"), on, placeOf(p));
    };
    return {PALPATE_TEXT("%1: %2 mm, from %3 to %4"), tape.name, Rounded{tape.length_mm(), 4},
            end(tape.fromOn, tape.from_W), end(tape.toOn, tape.to_W)};
}

std::vector<Message> bandNames(std::span<const double> limits_mm)
{
    std::vector<Message> names;
    for (std::size_t i = 0; i < limits_mm.size(); ++i) {
        names.push_back(i == 0 ? Message(PALPATE_TEXT("< %1 mm"), limits_mm[0])
                               : Message(PALPATE_TEXT("%1 to %2 mm"), limits_mm[i - 1], limits_mm[i]));
    }
    if (!limits_mm.empty()) {
        names.push_back({PALPATE_TEXT("> %1 mm"), limits_mm.back()});
    }
    return names;
}

std::vector<Message> clauses(const DistanceTable& table, const LumpMargin& margin)
{
    const std::vector<Message> names = bandNames(table.limits_mm);
    std::vector<Message> bands;
    for (std::size_t i = 0; i < names.size(); ++i) {
        bands.push_back({PALPATE_TEXT("%1: %2 %"), names[i], Rounded{100.0 * margin.found.shares[i], 3}});
    }
    if (margin.found.insideShare > 0.0) {
        bands.push_back({PALPATE_TEXT("inside: %1 %"), Rounded{100.0 * margin.found.insideShare, 3}});
    }
    return bands;
}

const char* relationName(Relation relation) noexcept
{
    switch (relation) {
    case Relation::Crossing:
        return "crossing";
    case Relation::Inside:
        return "inside";
    case Relation::Around:
        return "around";
    case Relation::Apart:
        break;
    }
    return "apart";
}

QJsonObject toJson(const DistanceTable& table)
{
    const auto nameOf = [&table](std::size_t i) { return QString::fromStdString(table.sizes[i].name); };
    const auto numbers = [](const std::vector<double>& values) {
        QJsonArray array;
        for (const double value : values) {
            array.append(value);
        }
        return array;
    };
    QJsonArray nearest, margins, tapes;
    for (const core::Tape& tape : table.tapes) {
        tapes.append(QJsonObject{{"name", QString::fromStdString(tape.name)},
                                 {"length_mm", tape.length_mm()},
                                 {"from_mm", tripleOf(tape.from_W)},
                                 {"to_mm", tripleOf(tape.to_W)}});
    }
    for (const PairDistance& pair : table.pairs) {
        nearest.append(QJsonObject{{"first", nameOf(pair.first)},
                                   {"second", nameOf(pair.second)},
                                   {"relation", relationName(pair.found.relation)},
                                   {"distance_mm", pair.found.distance_mm},
                                   {"surface_mm", pair.found.surface_mm},
                                   {"first_mm", tripleOf(pair.found.onFirst)},
                                   {"second_mm", tripleOf(pair.found.onSecond)}});
    }
    for (const LumpMargin& margin : table.margins) {
        margins.append(QJsonObject{{"lump", nameOf(margin.lump)},
                                   {"structure", nameOf(margin.structure)},
                                   {"area_shares", numbers(margin.found.shares)},
                                   {"inside_share", margin.found.insideShare}});
    }
    return {{"limits_mm", numbers(table.limits_mm)},
            {"sizes", sizesOf(table)},
            {"nearest", nearest},
            {"margins", margins},
            {"tapes", tapes}};
}

} // namespace palpate::study

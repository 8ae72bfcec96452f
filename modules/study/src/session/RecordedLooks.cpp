// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/RecordedLooks.h"

#include <palpate/geometry/MeshCheck.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace palpate::study {

namespace {

bool isShare(const QJsonValue& value)
{
    return value.isDouble() && value.toDouble() >= 0.0 && value.toDouble() <= 1.0;
}

QString nameOf(meshio::SurfaceKind surface)
{
    const std::string_view name = meshio::kSurfaceNames[static_cast<std::size_t>(surface)];
    return QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
}

RecordedLook lookIn(const QJsonObject& json)
{
    const QJsonArray colour = json["colour"].toArray();
    if (colour.size() != 3 || !std::all_of(colour.begin(), colour.end(), isShare) || !isShare(json["opacity"])) {
        return {};
    }
    RecordedLook look{json["name"].toString().toStdString(),
                      {colour[0].toDouble(), colour[1].toDouble(), colour[2].toDouble()},
                      json["opacity"].toDouble()};
    look.outwards = json["outwards"].toBool();
    look.closeHoles_mm = std::clamp(json["close_holes_mm"].toDouble(), 0.0, geometry::kMostCoordinate_mm);
    for (const auto kind :
         {meshio::SurfaceKind::Smooth, meshio::SurfaceKind::Smoothed, meshio::SurfaceKind::SmoothedSmooth}) {
        look.surface = json["surface"].toString() == nameOf(kind) ? kind : look.surface;
    }
    if (meshio::isSmoothed(look.surface) && isShare(json["smoothing"])) {
        look.smoothing = json["smoothing"].toDouble();
    }
    if (meshio::isCurved(look.surface) && json["crease_deg"].isDouble()) {
        look.crease_deg = std::clamp(json["crease_deg"].toDouble(), 0.0, 180.0);
    }
    return look;
}

} // namespace

std::string looksText(const std::vector<RecordedLook>& looks)
{
    QJsonArray all;
    for (const RecordedLook& one : looks) {
        QJsonObject look{{"name", QString::fromStdString(one.name)},
                         {"colour", QJsonArray{one.colour[0], one.colour[1], one.colour[2]}},
                         {"opacity", one.opacity}};
        if (one.outwards) {
            look["outwards"] = true;
        }
        if (one.closeHoles_mm > 0.0) {
            look["close_holes_mm"] = one.closeHoles_mm;
        }
        if (one.surface != meshio::SurfaceKind::Facets) {
            look["surface"] = nameOf(one.surface);
        }
        if (meshio::isSmoothed(one.surface)) {
            look["smoothing"] = one.smoothing;
        }
        if (meshio::isCurved(one.surface)) {
            look["crease_deg"] = one.crease_deg;
        }
        all.append(look);
    }
    return QJsonDocument(all).toJson(QJsonDocument::Compact).toStdString();
}

std::vector<RecordedLook> looksFrom(std::string_view text)
{
    std::vector<RecordedLook> looks;
    const QByteArray bytes(text.data(), static_cast<qsizetype>(text.size()));
    for (const QJsonValue& one : QJsonDocument::fromJson(bytes).array()) {
        looks.push_back(lookIn(one.toObject()));
    }
    return looks;
}

RecordedLook lookOf(const meshio::SceneStructure& structure)
{
    return {structure.name,    structure.colour,    structure.opacity,    structure.outwards,
            structure.surface, structure.smoothing, structure.crease_deg, structure.closeHoles_mm};
}

} // namespace palpate::study

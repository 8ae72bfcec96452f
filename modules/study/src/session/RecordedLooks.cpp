// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/RecordedLooks.h"

#include <palpate/geometry/MeshCheck.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <optional>

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

std::optional<double> positiveIn(const QJsonObject& json, const char* key)
{
    const double value = json[QLatin1String(key)].toDouble();
    return value > 0.0 ? std::optional(value) : std::nullopt;
}

RecordedLook lookIn(const QJsonObject& json)
{
    const QJsonArray colour = json["colour"].toArray();
    if (colour.size() != 3 || !std::all_of(colour.begin(), colour.end(), isShare) || !isShare(json["opacity"])) {
        return {};
    }
    RecordedLook look;
    look.name = json["name"].toString().toStdString();
    look.colour = {colour[0].toDouble(), colour[1].toDouble(), colour[2].toDouble()};
    look.opacity = json["opacity"].toDouble();
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
    look.inside = json["inside"].toString().toStdString();
    look.youngRatio = positiveIn(json, "young_ratio");
    look.young_kPa = positiveIn(json, "young_kPa");
    look.feltContactRadius_mm = positiveIn(json, "felt_contact_radius_mm");
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
        if (!one.inside.empty()) {
            look["inside"] = QString::fromStdString(one.inside);
        }
        const auto put = [&look](const char* key, const std::optional<double>& value) {
            if (value) {
                look[QLatin1String(key)] = *value;
            }
        };
        put("young_ratio", one.youngRatio);
        put("young_kPa", one.young_kPa);
        put("felt_contact_radius_mm", one.feltContactRadius_mm);
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
    return {structure.name,    structure.colour,      structure.opacity,    structure.outwards,
            structure.surface, structure.smoothing,   structure.crease_deg, structure.closeHoles_mm,
            structure.inside,  structure.young_ratio, structure.young_kPa,  structure.felt_contact_radius_mm};
}

} // namespace palpate::study

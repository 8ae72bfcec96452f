// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/meshio/SceneFile.h"

#include "AtomicFile.h"
#include "SceneLaw.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace palpate::meshio {

namespace {

using core::Vec3;

QString text(const std::string& value)
{
    return QString::fromStdString(value);
}

/// The fields that a newer version or another program put there.
QJsonObject unknownFields(const std::string& extra)
{
    return QJsonDocument::fromJson(QByteArray::fromStdString(extra)).object();
}

QJsonArray triple(const Vec3& v)
{
    return {v.x(), v.y(), v.z()};
}

QJsonArray pose(const core::Transform& X_WM)
{
    QJsonArray out;
    for (Eigen::Index row = 0; row < 4; ++row) {
        for (Eigen::Index column = 0; column < 4; ++column) {
            out.append(X_WM.matrix()(row, column));
        }
    }
    return out;
}

QJsonObject mapping(const core::TissueMapping& map, const std::filesystem::path& folder)
{
    const core::TissueMapping usual;
    QJsonObject out;
    out["quantity"] = text(std::string(core::kQuantityNames[static_cast<std::size_t>(map.quantity)]));
    out["unit"] = text(std::string(core::kMapUnitNames[static_cast<std::size_t>(map.unit)]));
    if (map.array.empty()) {
        out["file"] = text(std::filesystem::path(map.file).lexically_relative(folder).generic_string());
    } else {
        out["array"] = text(map.array);
    }
    if (map.contactRadius_mm != usual.contactRadius_mm) {
        out["contact_radius_mm"] = map.contactRadius_mm;
    }
    if (map.clamp) {
        out["clamp"] = QJsonArray{(*map.clamp)[0], (*map.clamp)[1]};
    }
    return out;
}

QJsonObject structure(const SceneStructure& s, const std::filesystem::path& folder)
{
    QJsonObject out = unknownFields(s.extra);
    const std::filesystem::path relative = std::filesystem::absolute(s.mesh).lexically_relative(folder);
    out["mesh"] = text((relative.empty() ? s.mesh : relative).generic_string());
    if (!s.sha256.empty()) {
        out["sha256"] = text(s.sha256);
    }
    if (!s.part.empty()) {
        out["part"] = text(s.part);
    }
    out["unit_mm"] = s.unit_mm;
    if (s.frame != core::FileFrame::Untagged) {
        out["frame"] = text(std::string(core::axesOf(s.frame)));
    }
    out["name"] = text(s.name);
    out["colour"] = QJsonArray{s.colour[0], s.colour[1], s.colour[2]};
    out["opacity"] = s.opacity;
    out["visible"] = s.visible;
    out["palpable"] = s.palpable;
    out["flipped"] = s.flipped;
    for (const core::TissueTerm& term : core::kTissueTerms) {
        const double value = s.tissue.*term.member;
        if (term.group.empty()) {
            out[term.key.data()] = value;
        } else if (value != 0.0) { // what a tissue lacks is not said
            QJsonObject group = out[term.group.data()].toObject();
            group[term.field.data()] = value;
            out[term.group.data()] = group;
        }
    }
    internal::writeLaw(s.tissue.law, out);
    out["layer"] = static_cast<double>(s.layer);
    if (s.maps) {
        QJsonArray maps;
        for (const core::TissueMapping& map : *s.maps) {
            maps.append(mapping(map, folder));
        }
        out["maps"] = maps;
    }
    out["pose"] = pose(s.X_WM);
    return out;
}

} // namespace

core::Status writeScene(const std::filesystem::path& path, const SceneFile& scene)
{
    const std::filesystem::path folder = std::filesystem::absolute(path).parent_path().lexically_normal();
    QJsonObject out = unknownFields(scene.extra);
    out["version"] = SceneFile::kVersion;
    QJsonArray structures;
    for (const SceneStructure& s : scene.structures) {
        structures.append(structure(s, folder));
    }
    out["structures"] = structures;
    if (scene.camera) {
        QJsonObject camera = unknownFields(scene.camera->extra);
        camera["position"] = triple(scene.camera->position_W);
        camera["focus"] = triple(scene.camera->focus_W);
        camera["up"] = triple(scene.camera->up_W);
        camera["viewAngle_deg"] = scene.camera->viewAngle_deg;
        out["camera"] = camera;
    }
    QJsonArray findings;
    for (const core::Finding& finding : scene.findings) {
        QJsonObject one = unknownFields(finding.extra);
        one["name"] = text(finding.name);
        one["position"] = triple(finding.p_W);
        one["note"] = text(finding.note);
        if (!finding.structure.empty()) {
            one["structure"] = text(finding.structure);
        }
        if (finding.force_N) {
            one["force_N"] = *finding.force_N;
        }
        if (finding.depth_mm) {
            one["depth_mm"] = *finding.depth_mm;
        }
        if (!finding.layers.empty()) {
            QJsonArray layers;
            for (const core::FeltLayer& layer : finding.layers) {
                layers.append(QJsonObject{
                    {"structure", text(layer.structure)}, {"force_N", layer.force_N}, {"depth_mm", layer.depth_mm}});
            }
            one["layers"] = layers;
        }
        findings.append(one);
    }
    out["findings"] = findings;
    return internal::writeAtomically(path, QJsonDocument(out).toJson(QJsonDocument::Indented).toStdString());
}

} // namespace palpate::meshio

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/meshio/SceneFile.h"

#include "motion/MotionFields.h"
#include "scene/SceneLaw.h"

#include <palpate/core/AtomicFile.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <optional>
#include <string>

namespace palpate::meshio {

namespace {

using core::Vec3;

QString text(const std::string& value)
{
    return QString::fromStdString(value);
}

/// Fields from a newer version or another program, kept on saving.
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
    out["quantity"] = text(std::string(core::traitsOf(map.quantity).name));
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

void putIfThere(QJsonObject& out, const char* name, const std::optional<double>& value)
{
    if (value) {
        out[name] = *value;
    }
}

void putIfThere(QJsonObject& out, const char* name, const std::string& value)
{
    if (!value.empty()) {
        out[name] = text(value);
    }
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
    if (s.outwards) {
        out["outwards"] = true;
    }
    if (s.closeHoles_mm > 0.0) {
        out["close_holes_mm"] = s.closeHoles_mm;
    }
    if (s.surface != defaultSurface(s.mesh)) {
        out["surface"] = text(std::string(kSurfaceNames[static_cast<std::size_t>(s.surface)]));
    }
    if (s.smoothing != defaultSmoothing(s.mesh)) {
        out["smoothing"] = s.smoothing;
    }
    if (s.crease_deg != kDefaultCrease_deg) {
        out["crease_deg"] = s.crease_deg;
    }
    for (const core::TissueTerm& term : core::kTissueTerms) {
        const double value = s.tissue.*term.member;
        if (term.group.empty()) {
            out[term.key.data()] = value;
        } else if (value != 0.0) { // terms that are zero are omitted
            QJsonObject group = out[term.group.data()].toObject();
            group[term.field.data()] = value;
            out[term.group.data()] = group;
        }
    }
    internal::writeLaw(s.tissue.law, out);
    internal::writeMotion(s.motion, s.pulse, folder, out);
    out["layer"] = static_cast<double>(s.layer);
    putIfThere(out, "inside", s.inside);
    putIfThere(out, "young_ratio", s.young_ratio);
    putIfThere(out, "young_kPa", s.young_kPa);
    putIfThere(out, "felt_contact_radius_mm", s.felt_contact_radius_mm);
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

void putView(QJsonObject& out, const core::ViewPose& view)
{
    out["position"] = triple(view.position_W);
    out["focus"] = triple(view.focus_W);
    out["up"] = triple(view.up_W);
    out["viewAngle_deg"] = view.viewAngle_deg;
}

/// Empty fields of a finding are omitted.
QJsonObject finding(const core::Finding& finding, const std::filesystem::path& folder)
{
    QJsonObject out = unknownFields(finding.extra);
    putIfThere(out, "id", finding.id);
    out["name"] = text(finding.name);
    if (finding.type != core::FindingType::Other) {
        out["type"] = text(std::string(core::nameOf(finding.type)));
    }
    if (finding.hasPlace) {
        out["position"] = triple(finding.p_W);
    }
    out["note"] = text(finding.note);
    putIfThere(out, "structure", finding.structure);
    putIfThere(out, "size_mm", finding.size_mm);
    putIfThere(out, "force_N", finding.force_N);
    putIfThere(out, "depth_mm", finding.depth_mm);
    if (!finding.layers.empty()) {
        QJsonArray layers;
        for (const core::FindingLayer& layer : finding.layers) {
            layers.append(QJsonObject{
                {"structure", text(layer.structure)}, {"force_N", layer.force_N}, {"depth_mm", layer.depth_mm}});
        }
        out["layers"] = layers;
    }
    if (finding.camera) {
        QJsonObject camera = out["camera"].toObject();
        putView(camera, *finding.camera);
        out["camera"] = camera;
    }
    if (finding.recording) {
        QJsonObject moment = out["recording"].toObject();
        const std::filesystem::path file = finding.recording->file;
        const std::filesystem::path relative = std::filesystem::absolute(file).lexically_relative(folder);
        moment["file"] = text((relative.empty() ? file : relative).generic_string());
        putIfThere(moment, "sha256", finding.recording->sha256);
        moment["tick"] = static_cast<qint64>(finding.recording->tick);
        moment["time_s"] = finding.recording->time_s;
        out["recording"] = moment;
    }
    putIfThere(out, "marked_utc", finding.marked_utc);
    return out;
}

QJsonObject tape(const core::Tape& tape)
{
    QJsonObject out = unknownFields(tape.extra);
    out["name"] = text(tape.name);
    out["from"] = triple(tape.from_W);
    out["to"] = triple(tape.to_W);
    putIfThere(out, "from_on", tape.fromOn);
    putIfThere(out, "to_on", tape.toOn);
    return out;
}

QJsonObject exerciseFields(const Exercise& exercise)
{
    QJsonObject out = unknownFields(exercise.extra);
    QJsonArray targets;
    for (const std::string& name : exercise.targets) {
        targets.append(text(name));
    }
    out["targets"] = targets;
    putIfThere(out, "time_s", exercise.time_s);
    putIfThere(out, "force_ceiling_N", exercise.force_ceiling_N);
    putIfThere(out, "coverage_goal", exercise.coverage_goal);
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
        putView(camera, *scene.camera);
        out["camera"] = camera;
    }
    if (scene.shownMap) {
        out["shown_map"] =
            QJsonObject{{"structure", text(scene.shownMap->structure)}, {"numbers", text(scene.shownMap->numbers)}};
    }
    if (!scene.image.empty()) {
        out["image"] = text(scene.image.lexically_relative(folder).generic_string());
    }
    if (scene.imageWindow) {
        out["image_window"] = QJsonObject{{"level", scene.imageWindow->level}, {"width", scene.imageWindow->width}};
    }
    if (scene.section) {
        QJsonObject section = unknownFields(scene.section->extra);
        section["direction"] = text(std::string(kSectionNames[static_cast<std::size_t>(scene.section->direction)]));
        section["point"] = triple(scene.section->p_W);
        section["normal"] = triple(scene.section->n_W);
        out["section"] = section;
    }
    if (scene.buried != BuriedTouch::Layers) {
        out["buried"] = text(std::string(kBuriedNames[static_cast<std::size_t>(scene.buried)]));
    }
    if (scene.exercise) {
        out["exercise"] = exerciseFields(*scene.exercise);
    }
    QJsonArray findings;
    for (const core::Finding& one : scene.findings) {
        findings.append(finding(one, folder));
    }
    out["findings"] = findings;
    QJsonArray tapes;
    for (const core::Tape& one : scene.tapes) {
        tapes.append(tape(one));
    }
    if (!tapes.isEmpty()) {
        out["tapes"] = tapes;
    }
    return core::writeAtomically(path, QJsonDocument(out).toJson(QJsonDocument::Indented).toStdString(),
                                 core::AtomicFile::Onto::File);
}

} // namespace palpate::meshio

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/meshio/SceneFile.h"

#include "palpate/meshio/MeshFormats.h"

#include "guard/FileImage.h"
#include "motion/MotionFields.h"
#include "scene/SceneLaw.h"
#include "text/Fault.h"
#include "text/FileStem.h"
#include "text/JsonFields.h"
#include "text/RepeatedField.h"
#include "text/TextScan.h"

#include <palpate/core/Text.h>
#include <palpate/core/VisibleText.h>
#include <palpate/geometry/MeshCheck.h>

#include <QCryptographicHash>
#include <QDateTime>
#include <QFile>
#include <QJsonDocument>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace palpate::meshio {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;
using core::Vec3;
using internal::exactNumber;
using internal::JsonFields;

constexpr double kMostMm = 1e7;

core::Message quotedText(std::string_view text)
{
    return {PALPATE_TEXT("%1"), core::inQuotes(text)};
}

core::Message textOrNothing(bool isThere, std::string_view text)
{
    return isThere ? quotedText(text) : core::Message(PALPATE_TEXT("nothing"));
}

std::optional<Vec3> point(JsonFields& fields, const char* name)
{
    const auto values = fields.numbers(name, 3, -kMostMm, kMostMm);
    return values ? std::optional(Vec3((*values)[0], (*values)[1], (*values)[2])) : std::nullopt;
}

/// Limits of moduli [kPa] and of the ratio of moduli.
constexpr double kLeastModulus = 1e-4, kMostModulusRatio = 1e4, kMostYoung_kPa = 1e9;
constexpr double kLeastRadius_mm = 0.1, kMostRadius_mm = 30.0; ///< limits of the fingertip radius

/// Reads an optional number; `value` stays empty if the field is absent.
void readIfThere(JsonFields& fields, const char* name, std::optional<double>& value, double low = 0.0,
                 double high = kMostMm)
{
    if (fields.has(name)) {
        fields.read(name, value.emplace(), low, high);
    }
}

/// Reads a 4 x 4 matrix, row by row, last row 0 0 0 1; must be a rotation and a translation.
void readPose(JsonFields& fields, const char* name, core::Transform& pose)
{
    const auto values = fields.numbers(name, 16, -kMostMm, kMostMm);
    if (!values) {
        return;
    }
    const Eigen::Matrix4d m = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(values->data());
    const Eigen::Matrix3d r = m.topLeftCorner<3, 3>();
    const bool isRigid = (r * r.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 1e-9 &&
                         r.determinant() > 0.0 && m.row(3) == Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0);
    if (!isRigid) {
        fields.fail(name, {PALPATE_TEXT("a matrix that is not rigid")},
                    {PALPATE_TEXT("a rotation and a translation, row by row")});
        return;
    }
    pose.matrix() = m;
}

void readTissue(JsonFields& fields, core::Tissue& tissue)
{
    for (const core::TissueTerm& term : core::kTissueTerms) {
        if (term.group.empty()) {
            fields.read(term.key.data(), tissue.*term.member, 0.0, term.most);
        }
    }
    if (auto friction = fields.fieldsOf("friction")) {
        for (const core::TissueTerm& term : core::kTissueTerms) {
            if (term.group == "friction") {
                friction->read(term.field.data(), tissue.*term.member, 0.0, term.most);
            }
        }
        if (tissue.friction_dynamic > tissue.friction_static) {
            friction->fail("dynamic", {PALPATE_TEXT("%1"), exactNumber(tissue.friction_dynamic)},
                           {PALPATE_TEXT("at most `static`, which is %1"), exactNumber(tissue.friction_static)});
        }
        fields.keepUnknown("friction", friction->unknown());
    }
}

/// Reads a name from a fixed list and returns the index.
template<class Enum, std::size_t N>
void readName(JsonFields& fields, const char* name, const std::array<std::string_view, N>& names, Enum& value)
{
    std::string text(names[static_cast<std::size_t>(value)]);
    fields.read(name, text);
    const auto found = std::find(names.begin(), names.end(), text);
    if (found != names.end()) {
        value = static_cast<Enum>(found - names.begin());
        return;
    }
    std::string expected;
    for (const std::string_view known : names) {
        expected.append(expected.empty() ? "" : ", ").append(known);
    }
    fields.fail(name, quotedText(text), {PALPATE_TEXT("one of %1"), expected});
}

core::TissueMapping readMapping(JsonFields& fields, const std::filesystem::path& folder)
{
    core::TissueMapping map;
    std::array<std::string_view, core::kMappedQuantities.size()> names;
    std::transform(core::kMappedQuantities.begin(), core::kMappedQuantities.end(), names.begin(),
                   [](const core::QuantityTraits& quantity) { return quantity.name; });
    readName(fields, "quantity", names, map.quantity);
    map.unit = core::traitsOf(map.quantity).unit;
    fields.read("array", map.array);
    std::string file;
    fields.read("file", file);
    if (map.array.empty() == file.empty()) {
        fields.fail("array",
                    map.array.empty() ? core::Message(PALPATE_TEXT("neither `array` nor `file`"))
                                      : core::Message(PALPATE_TEXT("both `array` and `file`")),
                    {PALPATE_TEXT("one of the two")});
    }
    if (!file.empty()) {
        map.file = (folder / std::filesystem::path(file)).lexically_normal().string();
    }
    const auto known = std::find_if(core::kKnownMaps.begin(), core::kKnownMaps.end(),
                                    [&](const core::KnownMap& k) { return k.array == map.array; });
    if (known != core::kKnownMaps.end() && known->quantity == map.quantity) {
        map.unit = known->unit;
    } else if (!fields.has("unit") && map.quantity == core::MappedQuantity::Stiffness) {
        // Young's modulus, shear modulus or a scale: a wrong guess is an error by a factor of three or more.
        fields.fail("unit", {PALPATE_TEXT("nothing")},
                    {PALPATE_TEXT("the unit of the numbers: scale, N_per_mm, young_kPa or shear_kPa")});
    }
    readName(fields, "unit", core::kMapUnitNames, map.unit);
    if (!core::fits(map.quantity, map.unit)) {
        fields.fail("unit", quotedText(core::kMapUnitNames[static_cast<std::size_t>(map.unit)]),
                    {PALPATE_TEXT("a unit of `%1`"), core::traitsOf(map.quantity).name});
    }
    fields.read("contact_radius_mm", map.contactRadius_mm, 1e-3, 1e3);
    if (const auto clamp = fields.numbers("clamp", 2, 0.0, 1e12)) {
        map.clamp = {(*clamp)[0], (*clamp)[1]};
        if ((*clamp)[0] > (*clamp)[1]) {
            fields.fail("clamp", {PALPATE_TEXT("a larger number before a smaller one")},
                        {PALPATE_TEXT("the minimum, then the maximum")});
        }
    }
    return map;
}

/// Reads the fields of lumps and of organs with lumps.
void readBuried(JsonFields& fields, SceneStructure& s)
{
    fields.read("inside", s.inside);
    if (!s.inside.empty() && s.layer > 0) {
        fields.fail("layer", {PALPATE_TEXT("%1 together with `inside`"), s.layer},
                    {PALPATE_TEXT("one of the two: a structure felt through its organ has no layer of its own")});
    }
    if (s.inside == s.name && !s.inside.empty()) {
        fields.fail("inside", {PALPATE_TEXT("its own name")}, {PALPATE_TEXT("the name of the organ around it")});
    }
    readIfThere(fields, "young_ratio", s.young_ratio, kLeastModulus, kMostModulusRatio);
    readIfThere(fields, "young_kPa", s.young_kPa, kLeastModulus, kMostYoung_kPa);
    readIfThere(fields, "felt_contact_radius_mm", s.felt_contact_radius_mm, kLeastRadius_mm, kMostRadius_mm);
}

SceneStructure readStructure(JsonFields& fields, const std::filesystem::path& folder)
{
    SceneStructure s;
    std::string mesh;
    fields.read("mesh", mesh);
    if (mesh.empty()) {
        fields.fail("mesh", textOrNothing(fields.has("mesh"), mesh), {PALPATE_TEXT("the path of a mesh file")});
    }
    s.mesh = (folder / std::filesystem::path(mesh)).lexically_normal();
    s.surface = defaultSurface(s.mesh);
    s.smoothing = defaultSmoothing(s.mesh);
    fields.read("sha256", s.sha256);
    fields.read("part", s.part);
    fields.read("unit_mm", s.unit_mm, 1e-6, 1e6);
    if (fields.has("frame")) {
        std::string frame;
        fields.read("frame", frame);
        if (const auto named = core::frameNamed(frame)) {
            s.frame = *named;
        } else {
            fields.fail("frame", quotedText(frame), {PALPATE_TEXT("LPS, RAS or Y-up")});
        }
    }
    s.name = s.part.empty() ? internal::fileStem(s.mesh) : s.part;
    fields.read("name", s.name);
    if (const auto colour = fields.numbers("colour", 3, 0.0, 1.0)) {
        s.colour = {(*colour)[0], (*colour)[1], (*colour)[2]};
    }
    fields.read("opacity", s.opacity, 0.0, 1.0);
    fields.read("visible", s.visible);
    fields.read("palpable", s.palpable);
    fields.read("flipped", s.flipped);
    fields.read("outwards", s.outwards);
    fields.read("close_holes_mm", s.closeHoles_mm, 0.0, geometry::kMostCoordinate_mm);
    readName(fields, "surface", kSurfaceNames, s.surface);
    fields.read("smoothing", s.smoothing, 0.0, 1.0);
    fields.read("crease_deg", s.crease_deg, 0.0, 180.0);
    readTissue(fields, s.tissue);
    if (fields.has("maps")) {
        s.maps.emplace();
        for (JsonFields& map : fields.listOf("maps")) {
            s.maps->push_back(readMapping(map, folder));
        }
    }
    internal::readLaw(fields, folder, s.tissue.law);
    internal::readMotion(fields, folder, s.motion, s.pulse);
    double layer = 0.0;
    fields.read("layer", layer, 0.0, 63.0);
    if (layer != std::floor(layer)) {
        fields.fail("layer", {PALPATE_TEXT("a fraction")}, {PALPATE_TEXT("a whole number")});
    }
    s.layer = static_cast<std::uint32_t>(layer);
    readBuried(fields, s);
    readPose(fields, "pose", s.X_WM);
    s.extra = fields.unknown();
    return s;
}

void readView(JsonFields& fields, core::ViewPose& camera)
{
    camera.position_W = point(fields, "position").value_or(camera.position_W);
    camera.focus_W = point(fields, "focus").value_or(camera.focus_W);
    camera.up_W = point(fields, "up").value_or(camera.up_W);
    fields.read("viewAngle_deg", camera.viewAngle_deg, 0.1, 179.0);
}

/// Reads a SHA-256: empty or 64 hex digits.
void readHash(JsonFields& fields, const char* name, std::string& hash)
{
    fields.read(name, hash);
    const bool isHex = hash.find_first_not_of("0123456789abcdef") == std::string::npos;
    if (!hash.empty() && (hash.size() != 64 || !isHex)) {
        fields.fail(name, quotedText(hash), {PALPATE_TEXT("64 hex digits")});
    }
}

core::RecordedMoment readMoment(JsonFields& fields, const std::filesystem::path& folder)
{
    core::RecordedMoment moment;
    std::string file;
    fields.read("file", file);
    if (file.empty()) {
        fields.fail("file", textOrNothing(fields.has("file"), file), {PALPATE_TEXT("the path of a recording")});
    }
    moment.file = (folder / std::filesystem::path(file)).lexically_normal().string();
    readHash(fields, "sha256", moment.sha256);
    constexpr double kLast = 9007199254740992.0; // 2^53: integers up to here are exact in a double
    double tick = 0.0;
    fields.read("tick", tick, -kLast, kLast);
    if (tick != std::floor(tick)) {
        fields.fail("tick", {PALPATE_TEXT("a fraction")}, {PALPATE_TEXT("a whole number")});
    }
    moment.tick = static_cast<std::int64_t>(tick);
    fields.read("time_s", moment.time_s, 0.0, 1e9);
    return moment;
}

void readTouch(JsonFields& entry, core::Finding& finding)
{
    readIfThere(entry, "force_N", finding.force_N);
    readIfThere(entry, "depth_mm", finding.depth_mm);
    for (JsonFields& layer : entry.listOf("layers")) {
        core::FindingLayer& out = finding.layers.emplace_back();
        layer.read("structure", out.structure);
        layer.read("force_N", out.force_N, 0.0, 1e9);
        layer.read("depth_mm", out.depth_mm, 0.0, 1e9);
    }
}

core::Finding readFinding(JsonFields& entry, const std::filesystem::path& folder)
{
    core::Finding finding;
    entry.read("id", finding.id);
    entry.read("name", finding.name);
    readName(entry, "type", core::kFindingTypeNames, finding.type);
    entry.read("note", finding.note);
    entry.read("structure", finding.structure);
    finding.hasPlace = entry.has("position");
    finding.p_W = point(entry, "position").value_or(finding.p_W);
    readIfThere(entry, "size_mm", finding.size_mm);
    readTouch(entry, finding);
    if (auto camera = entry.fieldsOf("camera")) {
        readView(*camera, finding.camera.emplace());
        entry.keepUnknown("camera", camera->unknown());
    }
    if (auto moment = entry.fieldsOf("recording")) {
        finding.recording = readMoment(*moment, folder);
        entry.keepUnknown("recording", moment->unknown());
    }
    entry.read("marked_utc", finding.marked_utc);
    if (!finding.marked_utc.empty() &&
        !QDateTime::fromString(QString::fromStdString(finding.marked_utc), Qt::ISODate).isValid()) {
        entry.fail("marked_utc", quotedText(finding.marked_utc),
                   {PALPATE_TEXT("a time in UTC, e.g. %1"), "2026-11-23T08:30:00Z"});
    }
    finding.extra = entry.unknown();
    return finding;
}

core::Tape readTape(JsonFields& entry)
{
    core::Tape tape;
    entry.read("name", tape.name);
    for (const auto& [name, end] : {std::pair("from", &tape.from_W), std::pair("to", &tape.to_W)}) {
        if (!entry.has(name)) {
            entry.fail(name, {PALPATE_TEXT("nothing")}, {PALPATE_TEXT("a place as three numbers")});
        }
        *end = point(entry, name).value_or(*end);
    }
    entry.read("from_on", tape.fromOn);
    entry.read("to_on", tape.toOn);
    tape.extra = entry.unknown();
    return tape;
}

/// Names the format of a JSON file that is not a scene; ok if the file may be a scene.
Status anotherPrograms(const QJsonObject& document, const std::string& file)
{
    if (document.contains(QLatin1String("markups"))) {
        return {
            StatusCode::Unsupported,
            PALPATE_TEXT("%1: is a list of 3D Slicer marks, not a Palpate scene: import it into a scene as findings, "
                         "with File > Import findings in the window, or with `palpate findings SCENE.palpate.json "
                         "--import %1 --out NEW.palpate.json`"),
            file};
    }
    if (!document.contains(QLatin1String("version")) && !document.contains(QLatin1String("structures"))) {
        return {StatusCode::Unsupported,
                PALPATE_TEXT("%1: is not a Palpate scene: found neither `version` nor `structures`; expected a file "
                             "that Palpate saved (.palpate.json)"),
                file};
    }
    return {};
}

/// In older files the note contains the name of the touched structure.
void takeOldNotes(SceneFile& scene)
{
    for (core::Finding& finding : scene.findings) {
        const bool isName = std::any_of(scene.structures.begin(), scene.structures.end(),
                                        [&](const SceneStructure& one) { return one.name == finding.note; });
        if (finding.structure.empty() && !finding.note.empty() && isName) {
            finding.structure = std::exchange(finding.note, {});
        }
    }
}

bool hasStructure(const SceneFile& scene, const std::string& name)
{
    return std::any_of(scene.structures.begin(), scene.structures.end(),
                       [&name](const SceneStructure& one) { return one.name == name; });
}

void readShownMap(JsonFields& fields, SceneFile& scene)
{
    if (auto entry = fields.fieldsOf("shown_map")) {
        ShownMap& shown = scene.shownMap.emplace();
        entry->read("structure", shown.structure);
        entry->read("numbers", shown.numbers);
        if (!hasStructure(scene, shown.structure)) {
            entry->fail("structure", quotedText(shown.structure),
                        {PALPATE_TEXT("the name of a structure of this scene")});
        }
        if (!shown.numbers.starts_with("felt:") && !shown.numbers.starts_with("array:")) {
            entry->fail("numbers", quotedText(shown.numbers),
                        {PALPATE_TEXT("`felt:` and a quantity, or `array:` and its name")});
        }
    }
}

void readImagePath(JsonFields& fields, const std::filesystem::path& folder, SceneFile& scene)
{
    if (!fields.has("image")) {
        return;
    }
    std::string image;
    fields.read("image", image);
    if (image.empty()) {
        fields.fail("image", textOrNothing(true, image), {PALPATE_TEXT("the path of a volume")});
    }
    scene.image = (folder / std::filesystem::path(image)).lexically_normal();
}

void readImageWindow(JsonFields& fields, SceneFile& scene)
{
    constexpr double kLeastWidth = 1e-12, kLargest = 1e12;
    if (auto entry = fields.fieldsOf("image_window")) {
        geometry::GreyWindow& window = scene.imageWindow.emplace();
        for (const char* name : {"level", "width"}) {
            if (!entry->has(name)) {
                entry->fail(name, {PALPATE_TEXT("nothing")}, {PALPATE_TEXT("a number")});
            }
        }
        entry->read("level", window.level, -kLargest, kLargest);
        entry->read("width", window.width, kLeastWidth, kLargest);
    }
}

void readSection(JsonFields& fields, SceneFile& scene)
{
    if (auto entry = fields.fieldsOf("section")) {
        SceneSection& section = scene.section.emplace();
        readName(*entry, "direction", kSectionNames, section.direction);
        if (!entry->has("point")) {
            entry->fail("point", {PALPATE_TEXT("nothing")}, {PALPATE_TEXT("a place as three numbers")});
        }
        section.p_W = point(*entry, "point").value_or(section.p_W);
        const Vec3 normal_W = point(*entry, "normal").value_or(Vec3::Zero());
        // Of a plane of the patient, only the side is taken from the file.
        const Vec3 axis_W = section.direction == SectionDirection::Free
                                ? normal_W
                                : Vec3(Vec3::Unit(2 - static_cast<Eigen::Index>(section.direction)));
        if (normal_W.dot(axis_W) == 0.0 || !normal_W.allFinite()) {
            entry->fail("normal", {PALPATE_TEXT("no direction")},
                        {PALPATE_TEXT("three numbers that point to the hidden side")});
        }
        section.n_W = std::copysign(1.0, normal_W.dot(axis_W)) * axis_W.stableNormalized();
        section.extra = entry->unknown();
    }
}

/// The organ of a lump must be a structure of the scene that is not inside another: the response of a lump is
/// transmitted to the outermost surface.
void checkOrgans(const SceneFile& scene, JsonFields& fields)
{
    std::map<std::string_view, std::vector<const SceneStructure*>> named;
    for (const SceneStructure& one : scene.structures) {
        named[one.name].push_back(&one);
    }
    for (std::size_t i = 0; i < scene.structures.size(); ++i) {
        const std::string& organ = scene.structures[i].inside;
        if (organ.empty()) {
            continue;
        }
        const std::string field = "structures[" + std::to_string(i) + "].inside";
        const std::vector<const SceneStructure*>& found = named[organ];
        if (found.empty()) {
            fields.fail(field.c_str(), quotedText(organ), {PALPATE_TEXT("the name of a structure of this scene")});
        } else if (found.size() > 1) {
            fields.fail(field.c_str(),
                        {PALPATE_TEXT("%1, the name of %2 structures"), core::inQuotes(organ), found.size()},
                        {PALPATE_TEXT("the name of one structure: rename the others")});
        } else if (!found.front()->inside.empty()) {
            fields.fail(field.c_str(),
                        {PALPATE_TEXT("%1, which lies inside %2"), core::inQuotes(organ),
                         core::inQuotes(found.front()->inside)},
                        {PALPATE_TEXT("the outermost structure around it")});
        }
    }
}

constexpr std::size_t kMostTargets = 1000;
constexpr double kLeastExercise = 1e-3, kMostExercise = 1e6; ///< limits of time [s] and force [N]

/// Reads the exercise and hides the targets.
void readExercise(JsonFields& fields, SceneFile& scene)
{
    auto entry = fields.fieldsOf("exercise");
    if (!entry) {
        return;
    }
    Exercise& exercise = scene.exercise.emplace();
    exercise.targets = entry->texts("targets", kMostTargets);
    if (exercise.targets.empty()) {
        entry->fail("targets", {PALPATE_TEXT("nothing")},
                    {PALPATE_TEXT("the name of at least one structure of this scene")});
    }
    for (std::size_t i = 0; i < exercise.targets.size(); ++i) {
        const std::string& name = exercise.targets[i];
        const std::string field = "targets[" + std::to_string(i) + "]";
        const auto isNamed = [&name](const SceneStructure& one) { return one.name == name; };
        const auto target = std::find_if(scene.structures.begin(), scene.structures.end(), isNamed);
        if (target == scene.structures.end()) {
            entry->fail(field.c_str(), quotedText(name), {PALPATE_TEXT("the name of a structure of this scene")});
        } else if (std::count_if(target, scene.structures.end(), isNamed) > 1) {
            entry->fail(field.c_str(), {PALPATE_TEXT("%1, the name of several structures"), core::inQuotes(name)},
                        {PALPATE_TEXT("the name of one structure: rename the others")});
        } else if (!target->palpable) {
            entry->fail(field.c_str(), {PALPATE_TEXT("%1, which is not palpable"), core::inQuotes(name)},
                        {PALPATE_TEXT("a structure that can be felt")});
        } else if (std::exchange(target->isHiddenTarget, true)) {
            entry->fail(field.c_str(), {PALPATE_TEXT("%1 a second time"), core::inQuotes(name)},
                        {PALPATE_TEXT("each target once")});
        }
    }
    readIfThere(*entry, "time_s", exercise.time_s, kLeastExercise, kMostExercise);
    readIfThere(*entry, "force_ceiling_N", exercise.force_ceiling_N, kLeastExercise, kMostExercise);
    readIfThere(*entry, "coverage_goal", exercise.coverage_goal, kLeastExercise, 1.0);
    exercise.extra = entry->unknown();
}

} // namespace

SurfaceKind defaultSurface(const std::filesystem::path& mesh)
{
    return hasLabelMapExtension(mesh) ? SurfaceKind::Smoothed : SurfaceKind::Facets;
}

double defaultSmoothing(const std::filesystem::path& mesh)
{
    return hasLabelMapExtension(mesh) ? kLabelSmoothing : kDefaultSmoothing;
}

bool isSceneFile(const std::filesystem::path& path)
{
    return internal::sameWord(path.extension().string(), ".json");
}

std::string fileHash(const std::filesystem::path& path)
{
    QFile file(QString::fromStdU16String(path.u16string()));
    QCryptographicHash hash(QCryptographicHash::Sha256);
    return file.open(QIODevice::ReadOnly) && hash.addData(&file) ? hash.result().toHex().toStdString() : std::string();
}

core::Result<SceneFile> readScene(const std::filesystem::path& path)
{
    const std::string file = path.filename().string();
    const Result<internal::FileImage> image = internal::FileImage::load(path);
    if (!image.isOk()) {
        return image.status();
    }
    const std::string_view bytes = image.value().bytes();
    QJsonParseError error;
    const QJsonDocument document =
        QJsonDocument::fromJson(QByteArray::fromRawData(bytes.data(), static_cast<qsizetype>(bytes.size())), &error);
    if (!document.isObject()) {
        return internal::fault(StatusCode::BadFormat, file, internal::onByte(static_cast<std::uint64_t>(error.offset)),
                               bytes.empty() ? core::Message(PALPATE_TEXT("the file is empty"))
                               : error.error == QJsonParseError::NoError
                                   ? core::Message(PALPATE_TEXT("no JSON object"))
                                   : core::Message::untranslated(error.errorString().toStdString()),
                               {PALPATE_TEXT("a scene as a JSON object")});
    }
    if (Status other = anotherPrograms(document.object(), file); !other.isOk()) {
        return other;
    }
    if (const auto field = internal::repeatedField(bytes)) {
        return Status(StatusCode::BadFormat, PALPATE_TEXT("%1: %2: found twice, expected it once"), file,
                      core::visible(*field));
    }
    Status status;
    SceneFile scene;
    JsonFields fields(document.object(), file, "", status);
    if (!fields.has("version")) {
        fields.fail("version", {PALPATE_TEXT("nothing")}, {PALPATE_TEXT("%1"), 1});
    }
    double version = SceneFile::kVersion;
    fields.read("version", version, 1.0, 1e9);
    if (status.isOk() && version > SceneFile::kVersion) {
        return Status(StatusCode::Mismatch,
                      PALPATE_TEXT("%1: version: found %2, expected at most %3: it was made by a newer Palpate"), file,
                      static_cast<int>(version), SceneFile::kVersion);
    }
    const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
    std::size_t i = 0;
    for (const QJsonObject& object : fields.objects("structures")) {
        JsonFields entry(object, file, "structures[" + std::to_string(i++) + "]", status);
        scene.structures.push_back(readStructure(entry, folder));
    }
    if (const auto object = fields.object("camera")) {
        JsonFields camera(*object, file, "camera", status);
        readView(camera, scene.camera.emplace());
        scene.camera->extra = camera.unknown();
    }
    readShownMap(fields, scene);
    readImagePath(fields, folder, scene);
    readImageWindow(fields, scene);
    readSection(fields, scene);
    for (JsonFields& entry : fields.listOf("findings")) {
        scene.findings.push_back(readFinding(entry, folder));
    }
    for (JsonFields& entry : fields.listOf("tapes")) {
        scene.tapes.push_back(readTape(entry));
    }
    takeOldNotes(scene);
    readName(fields, "buried", kBuriedNames, scene.buried);
    checkOrgans(scene, fields);
    readExercise(fields, scene);
    scene.extra = fields.unknown();
    scene.sha256 = QCryptographicHash::hash(QByteArrayView(bytes.data(), static_cast<qsizetype>(bytes.size())),
                                            QCryptographicHash::Sha256)
                       .toHex()
                       .toStdString();
    return status.isOk() ? Result<SceneFile>(std::move(scene)) : Result<SceneFile>(status);
}

} // namespace palpate::meshio

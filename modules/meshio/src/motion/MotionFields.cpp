// SPDX-License-Identifier: BSD-3-Clause
#include "motion/MotionFields.h"

#include "text/Fault.h"

#include <QJsonArray>

#include <algorithm>
#include <cmath>

namespace palpate::meshio::internal {

namespace {

constexpr double kLeastPeriod_s = 1e-3, kMostPeriod_s = 1e6, kMostPlace_mm = 1e7;
constexpr std::size_t kMostFiles = 1000;

std::optional<std::array<double, 3>> threeOf(JsonFields& fields, const char* name)
{
    const auto values = fields.numbers(name, 3, -kMostPlace_mm, kMostPlace_mm);
    return values ? std::optional(std::array{(*values)[0], (*values)[1], (*values)[2]}) : std::nullopt;
}

void readKind(JsonFields& fields, MotionKind& kind)
{
    std::string name;
    fields.read("kind", name);
    const auto found = std::find(kMotionNames.begin(), kMotionNames.end(), name);
    if (found == kMotionNames.end()) {
        fields.fail("kind",
                    fields.has("kind") ? core::Message(PALPATE_TEXT("%1"), inQuotes(name))
                                       : core::Message(PALPATE_TEXT("nothing")),
                    {PALPATE_TEXT("one of %1"), "breath, frames, poses, field"});
        return;
    }
    kind = static_cast<MotionKind>(found - kMotionNames.begin());
}

void readExponent(JsonFields& fields, SceneMotion& motion)
{
    double exponent = motion.exponent;
    fields.read("exponent", exponent, 2.0, 64.0);
    if (std::fmod(exponent, 2.0) != 0.0) {
        fields.fail("exponent", {PALPATE_TEXT("%1"), exponent}, {PALPATE_TEXT("an even number from 2 to 64")});
    }
    motion.exponent = static_cast<int>(exponent);
}

void readDirection(JsonFields& fields, SceneMotion& motion)
{
    std::string name(kFieldDirections[0]);
    fields.read("direction", name);
    const auto found = std::find(kFieldDirections.begin(), kFieldDirections.end(), name);
    if (found == kFieldDirections.end()) {
        fields.fail("direction", {PALPATE_TEXT("%1"), inQuotes(name)},
                    {PALPATE_TEXT("one of %1"), "rest_to_moved, moved_to_rest"});
        return;
    }
    motion.direction = static_cast<FieldDirection>(found - kFieldDirections.begin());
}

void readBreath(JsonFields& fields, SceneMotion& motion)
{
    if (!fields.has("amplitude_mm")) {
        fields.fail("amplitude_mm", {PALPATE_TEXT("nothing")}, {PALPATE_TEXT("three numbers")});
    }
    motion.amplitude_mm = threeOf(fields, "amplitude_mm").value_or(motion.amplitude_mm);
    readExponent(fields, motion);
    motion.still_mm = threeOf(fields, "still_mm");
    motion.full_mm = threeOf(fields, "full_mm");
    if (fields.has("still_mm") != fields.has("full_mm")) {
        fields.fail(fields.has("still_mm") ? "full_mm" : "still_mm", {PALPATE_TEXT("nothing")},
                    {PALPATE_TEXT("both `still_mm` and `full_mm`, or neither")});
    } else if (motion.still_mm && motion.still_mm == motion.full_mm) {
        fields.fail("full_mm", {PALPATE_TEXT("the same place as `still_mm`")}, {PALPATE_TEXT("another place")});
    }
}

void readFiles(JsonFields& fields, const std::filesystem::path& folder, SceneMotion& motion)
{
    const auto add = [&](const std::string& file) {
        motion.files.push_back((folder / std::filesystem::path(file)).lexically_normal());
    };
    if (motion.kind == MotionKind::Poses) {
        std::string file;
        fields.read("file", file);
        if (file.empty()) {
            fields.fail("file", {PALPATE_TEXT("nothing")}, {PALPATE_TEXT("the path of a CSV file of poses")});
        }
        add(file);
        fields.read("repeats", motion.repeats);
        return;
    }
    for (const std::string& file : fields.texts("files", kMostFiles)) {
        add(file);
    }
    if (motion.kind == MotionKind::Field) {
        readExponent(fields, motion);
        readDirection(fields, motion);
        if (motion.files.empty()) {
            fields.fail("files", {PALPATE_TEXT("nothing")},
                        {PALPATE_TEXT("the path of at least one displacement field")});
        }
    } else if (motion.files.size() < 2) {
        fields.fail("files", {PALPATE_TEXT("%1 files"), motion.files.size()},
                    {PALPATE_TEXT("at least two, at equal steps of the period")});
    }
    fields.read("lattice_mm", motion.lattice_mm, 0.1, 1000.0);
}

} // namespace

void readMotion(JsonFields& structure, const std::filesystem::path& folder, std::optional<SceneMotion>& motion,
                std::optional<ScenePulse>& pulse)
{
    if (auto fields = structure.fieldsOf("motion")) {
        SceneMotion& read = motion.emplace();
        readKind(*fields, read.kind);
        if (read.kind != MotionKind::Poses) {
            fields->read("period_s", read.period_s, kLeastPeriod_s, kMostPeriod_s);
        }
        if (read.kind == MotionKind::Breath) {
            readBreath(*fields, read);
        } else {
            readFiles(*fields, folder, read);
        }
        structure.keepUnknown("motion", fields->unknown());
    }
    if (auto fields = structure.fieldsOf("pulse")) {
        ScenePulse& read = pulse.emplace();
        fields->read("period_s", read.period_s, kLeastPeriod_s, kMostPeriod_s);
        fields->read("share", read.share, 0.0, 10.0);
        structure.keepUnknown("pulse", fields->unknown());
    }
}

void writeMotion(const std::optional<SceneMotion>& motion, const std::optional<ScenePulse>& pulse,
                 const std::filesystem::path& folder, QJsonObject& structure)
{
    const auto three = [](const std::array<double, 3>& v) { return QJsonArray{v[0], v[1], v[2]}; };
    const auto relative = [&folder](const std::filesystem::path& file) {
        const std::filesystem::path to = file.lexically_relative(folder);
        return QString::fromStdString((to.empty() ? file : to).generic_string());
    };
    if (motion) {
        QJsonObject out = structure.value("motion").toObject();
        out["kind"] = QLatin1String(kMotionNames[static_cast<std::size_t>(motion->kind)].data());
        if (motion->kind != MotionKind::Poses) {
            out["period_s"] = motion->period_s;
        }
        if (motion->kind == MotionKind::Breath) {
            out["amplitude_mm"] = three(motion->amplitude_mm);
            out["exponent"] = motion->exponent;
            if (motion->still_mm && motion->full_mm) {
                out["still_mm"] = three(*motion->still_mm);
                out["full_mm"] = three(*motion->full_mm);
            }
        } else if (motion->kind == MotionKind::Poses) {
            out["file"] = relative(motion->files.front());
            out["repeats"] = motion->repeats;
        } else {
            QJsonArray files;
            for (const std::filesystem::path& file : motion->files) {
                files.append(relative(file));
            }
            out["files"] = files;
            out["lattice_mm"] = motion->lattice_mm;
        }
        if (motion->kind == MotionKind::Field) {
            out["exponent"] = motion->exponent;
            out["direction"] = QLatin1String(kFieldDirections[static_cast<std::size_t>(motion->direction)].data());
        }
        structure["motion"] = out;
    }
    if (pulse) {
        QJsonObject out = structure.value("pulse").toObject();
        out["period_s"] = pulse->period_s;
        out["share"] = pulse->share;
        structure["pulse"] = out;
    }
}

} // namespace palpate::meshio::internal

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/meshio/SceneMotion.h"

#include "motion/FieldMotion.h"
#include "palpate/meshio/MeshFile.h"
#include "text/Fault.h"

#include <palpate/geometry/FitMotion.h>

#include <algorithm>
#include <utility>

namespace palpate::meshio {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;
using core::Vec3;
using geometry::SurfaceMotion;

Vec3 vectorOf(const std::array<double, 3>& v)
{
    return {v[0], v[1], v[2]};
}

/// Reads the vertices of a structure as they are in the file, in the world.
Result<std::vector<Vec3>> verticesOf(const std::filesystem::path& path, const MotionSubject& subject)
{
    ReadOptions options;
    options.unit_mm = subject.unit_mm;
    options.frame = subject.frame;
    options.readsScale = false;
    const auto file = readMesh(path, options);
    if (!file.isOk()) {
        return file.status();
    }
    for (const MeshStructure& one : file.value().structures) {
        if (subject.part.empty() || one.name == subject.part) {
            std::vector<Vec3> vertices = one.mesh.vertices;
            for (Vec3& p : vertices) {
                p = subject.X_WM * p;
            }
            return vertices;
        }
    }
    return internal::fault(StatusCode::NotFound, path.filename().string(), {},
                           {PALPATE_TEXT("no structure %1"), internal::inQuotes(subject.part)},
                           {PALPATE_TEXT("one of that name")});
}

SurfaceMotion::Made fromFrames(const SceneMotion& motion, const MotionSubject& subject)
{
    const auto rest = verticesOf(subject.mesh, subject);
    if (!rest.isOk()) {
        return rest.status();
    }
    std::vector<std::vector<Vec3>> frames;
    for (const std::filesystem::path& file : motion.files) {
        auto frame = verticesOf(file, subject);
        if (!frame.isOk()) {
            return frame.status();
        }
        if (frame.value().size() != rest.value().size()) {
            return internal::fault(StatusCode::Mismatch, file.filename().string(), {},
                                   {PALPATE_TEXT("%1 vertices"), frame.value().size()},
                                   {PALPATE_TEXT("%1 as in %2: every frame has the same mesh"), rest.value().size(),
                                    subject.mesh.filename()});
        }
        frames.push_back(std::move(frame).value());
    }
    auto fitted = geometry::fitMotion(motion.period_s, rest.value(), frames, motion.lattice_mm);
    return fitted.isOk() ? SurfaceMotion::Made(fitted.value().motion) : SurfaceMotion::Made(fitted.status());
}

SurfaceMotion::Made fromPoses(const SceneMotion& motion)
{
    const std::filesystem::path& file = motion.files.front();
    const auto keys = readPoses(file);
    if (!keys.isOk()) {
        return keys.status();
    }
    auto made = SurfaceMotion::poses(keys.value(), motion.repeats);
    return made.isOk() ? made : SurfaceMotion::Made(made.status().at(file.filename()));
}

SurfaceMotion::Made moved(const SceneMotion& motion, const MotionSubject& subject)
{
    switch (motion.kind) {
    case MotionKind::Frames:
        return fromFrames(motion, subject);
    case MotionKind::Poses:
        return fromPoses(motion);
    case MotionKind::Field:
        return internal::fieldMotion(motion, subject);
    case MotionKind::Breath:
        break;
    }
    geometry::Breath breath;
    breath.period_s = motion.period_s;
    breath.amplitude_mm = vectorOf(motion.amplitude_mm);
    breath.exponent = motion.exponent;
    if (motion.still_mm && motion.full_mm) {
        breath.still_W = vectorOf(*motion.still_mm);
        breath.full_W = vectorOf(*motion.full_mm);
    }
    return SurfaceMotion::breath(breath, subject.bounds);
}

} // namespace

SurfaceMotion::Made makeMotion(const SceneMotion* motion, const ScenePulse* pulse, const MotionSubject& subject)
{
    std::shared_ptr<const SurfaceMotion> made;
    if (motion != nullptr) {
        auto result = moved(*motion, subject);
        if (!result.isOk()) {
            return result.status().at("motion");
        }
        made = std::move(result).value();
    }
    if (pulse != nullptr) {
        auto result = SurfaceMotion::pulse(pulse->period_s, pulse->share, made);
        return result.isOk() ? result : SurfaceMotion::Made(result.status().at("pulse"));
    }
    return made;
}

} // namespace palpate::meshio

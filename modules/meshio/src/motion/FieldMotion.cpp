// SPDX-License-Identifier: BSD-3-Clause
#include "motion/FieldMotion.h"

#include "read/FieldFile.h"
#include "text/Fault.h"

#include <palpate/geometry/FitMotion.h>

#include <limits>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;
using core::Vec3;
using geometry::SurfaceMotion;

core::Message placeOf(const Vec3& p)
{
    return {PALPATE_TEXT("(%1, %2, %3) mm"), core::Rounded{p.x(), 4}, core::Rounded{p.y(), 4}, core::Rounded{p.z(), 4}};
}

/// Returns the position y that a field v maps to `X`, y + v(y) = X, by fixed-point iteration. It contracts where the
/// gradient of v is below 1; the inverse of a motion with the largest accepted strain s has at most s / (1 - s) = 0.43.
/// @return NaN without such a position
Vec3 inverseAt(const FieldGrid& field, const Vec3& X)
{
    constexpr int kMostSteps = 200;
    constexpr double kEnough_mm = 1e-6;
    Vec3 y = X;
    for (int step = 0; step < kMostSteps; ++step) {
        const Vec3 off = X - y - field.at(y);
        if (off.norm() <= kEnough_mm) {
            return y;
        }
        y += off;
    }
    return Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
}

/// Returns where a field takes the vertices.
Result<std::vector<Vec3>> movedBy(const std::filesystem::path& path, FieldDirection direction,
                                  const std::vector<Vec3>& rest, core::FileFrame frame)
{
    const std::string file = path.filename().string();
    const Result<FieldGrid> read = readField(path, frame);
    if (!read.isOk()) {
        return read.status();
    }
    const FieldGrid& field = read.value();
    std::vector<Vec3> moved;
    moved.reserve(rest.size());
    for (const Vec3& X : rest) {
        const bool isForward = direction == FieldDirection::RestToMoved;
        const Vec3 now = isForward ? Vec3(X + field.at(X)) : inverseAt(field, X);
        if (!now.allFinite()) {
            return fault(StatusCode::OutOfRange, file, placeOf(X),
                         {PALPATE_TEXT("no position that the field maps to this one: it may fold")},
                         {PALPATE_TEXT("a field that can be inverted; is its direction right?")});
        }
        if (const Vec3& at = isForward ? X : now; !field.covers(at)) {
            return fault(StatusCode::OutOfRange, file, placeOf(at), {PALPATE_TEXT("outside of the field")},
                         {PALPATE_TEXT("a field that covers the structure, at rest and moved, in the same "
                                       "coordinates")});
        }
        moved.push_back(now);
    }
    return moved;
}

} // namespace

SurfaceMotion::Made fieldMotion(const SceneMotion& motion, const MotionSubject& subject)
{
    std::vector<Vec3> rest;
    for (const std::span<const Vec3> vertices : subject.surfaces) {
        rest.insert(rest.end(), vertices.begin(), vertices.end());
    }
    std::vector<std::vector<Vec3>> frames{rest};
    for (const std::filesystem::path& file : motion.files) {
        Result<std::vector<Vec3>> moved = movedBy(file, motion.direction, rest, subject.frame);
        if (!moved.isOk()) {
            return moved.status();
        }
        frames.push_back(std::move(moved).value());
    }
    const bool isSingle = motion.files.size() == 1;
    const auto fitted =
        isSingle ? geometry::fitBreath(motion.period_s, motion.exponent, rest, frames.back(), motion.lattice_mm)
                 : geometry::fitMotion(motion.period_s, rest, frames, motion.lattice_mm);
    if (!fitted.isOk()) {
        return isSingle ? fitted.status().at(motion.files.front().filename()) : fitted.status();
    }
    return fitted.value().motion;
}

} // namespace palpate::meshio::internal

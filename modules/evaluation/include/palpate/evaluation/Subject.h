// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/Surface.h"

#include <palpate/haptics/HapticScene.h>
#include <palpate/meshio/LoadScene.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace palpate::evaluation {

/// What is touched in an evaluation: the palpable structures of a scene, all in one layer.
struct Subject
{
    std::string name;
    std::string hash; ///< session::geometryHash of all triangles
    Surface surface;
    std::shared_ptr<const haptics::HapticScene> scene; ///< the product's own copy
    double build_ms = 0.0;                             ///< time to index it
};

/// @return null when nothing of it can be touched
[[nodiscard]] std::shared_ptr<const Subject> subjectOf(std::string name, const meshio::LoadedScene& scene);
[[nodiscard]] std::shared_ptr<const Subject> subjectOf(std::string name, const geometry::TriangleMesh& mesh);

/// A path of the HIP, four samples a millisecond so that it can be fed at any of the rates.
struct HandMotion
{
    static constexpr double kBase_Hz = 4000.0;
    std::string name;
    std::vector<Vec3> p_WH; ///< [mm]
};

/// Brings a path of another rate to the base rate, straight between its samples. @param dt_s  time between samples
[[nodiscard]] HandMotion resampled(std::string name, const std::vector<Vec3>& p_WH, double dt_s);

/// Lays motions on a surface: press and slide at 100 mm/s, quick pokes, and sliding with 0.1 mm of device noise; less
/// on what is smaller than 200 mm or 100 mm.
/// @param milliseconds  how long each lasts
[[nodiscard]] std::vector<HandMotion> standardMotions(const Surface& surface, std::uint64_t seed, int milliseconds);

} // namespace palpate::evaluation

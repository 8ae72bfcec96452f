// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/ContactSprings.h"
#include "palpate/evaluation/Surface.h"

#include <palpate/haptics/HapticScene.h>
#include <palpate/meshio/LoadScene.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace palpate::evaluation {

/// One structure of a subject.
struct SubjectStructure
{
    std::string name;
    double stiffness_N_per_mm = 0.5;
    std::uint32_t layer = 0;         ///< position in `Subject::layers`
    std::uint32_t firstTriangle = 0; ///< in the layer's surface, which holds its structures one after the other
};

/// The structures that share one god-object, as one surface.
struct SubjectLayer
{
    Surface surface;
    std::vector<SubjectStructure> structures;

    /// @return what the tissues that a god-object at `p_WG` touches answer with; in free space the stiffest of all
    /// @param spring_mm  from the HIP to the god-object
    /// @param fingertip_mm  radius of the ball around it; 0 is a point
    [[nodiscard]] ContactSprings springsAt(const Vec3& p_WG, const Vec3& spring_mm, double fingertip_mm = 0.0) const;
};

/// What is touched in an evaluation: the palpable structures of a scene in their layers, outermost first.
struct Subject
{
    std::string name;
    std::string hash;                                  ///< session::geometryHash of all triangles
    std::vector<SubjectLayer> layers;                  ///< at least one
    std::shared_ptr<const haptics::HapticScene> scene; ///< the product's own copy
    double build_ms = 0.0;                             ///< time to index it

    [[nodiscard]] std::size_t triangleCount() const;
    [[nodiscard]] Box bounds() const; ///< [mm]
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

/// Lays motions on a surface, a scene's outermost: press and slide at 100 mm/s, quick pokes, and sliding with 0.1 mm of
/// device noise; less on what is smaller than 200 mm or 100 mm.
/// @param milliseconds  how long each lasts
[[nodiscard]] std::vector<HandMotion> standardMotions(const Surface& surface, std::uint64_t seed, int milliseconds);

} // namespace palpate::evaluation

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

/// Structure of a subject.
struct SubjectStructure
{
    std::string name;
    double stiffness_N_per_mm = 0.5;
    std::uint32_t layer = 0;         ///< index in `Subject::layers`
    std::uint32_t firstTriangle = 0; ///< index in the surface of the layer, which concatenates its structures
};

/// Structures that share one god-object, merged into one surface.
struct SubjectLayer
{
    Surface surface;
    std::vector<SubjectStructure> structures;

    /// @return springs of the tissue in contact with a god-object at `p_WG`; in free space those of the stiffest
    /// structure
    /// @param spring_mm  from the HIP to the god-object
    /// @param fingertip_mm  fingertip radius; 0: point contact
    [[nodiscard]] ContactSprings springsAt(const Vec3& p_WG, const Vec3& spring_mm, double fingertip_mm = 0.0) const;
};

/// Object under evaluation: the palpable structures of a scene by layer, outermost first.
struct Subject
{
    std::string name;
    std::string hash;                                  ///< session::geometryHash of all triangles
    std::vector<SubjectLayer> layers;                  ///< at least one
    std::shared_ptr<const haptics::HapticScene> scene; ///< haptic copy used by the product
    double build_ms = 0.0;                             ///< time to build its spatial index

    [[nodiscard]] std::size_t triangleCount() const;
    [[nodiscard]] Box bounds() const; ///< [mm]
};

/// @return null if no structure is palpable
[[nodiscard]] std::shared_ptr<const Subject> subjectOf(std::string name, const meshio::LoadedScene& scene);
[[nodiscard]] std::shared_ptr<const Subject> subjectOf(std::string name, const geometry::TriangleMesh& mesh);

/// HIP path with four samples per millisecond, a multiple of all evaluated servo rates.
struct HandMotion
{
    static constexpr double kBase_Hz = 4000.0;
    std::string name;
    std::vector<Vec3> p_WH; ///< [mm]
};

/// Resamples a path to the base rate by linear interpolation. @param dt_s  time between samples
[[nodiscard]] HandMotion resampled(std::string name, const std::vector<Vec3>& p_WH, double dt_s);

/// Generates motions on a surface (for a scene, the outermost one): press and slide at 100 mm/s, fast pokes, and
/// sliding with 0.1 mm of device noise. Amplitudes and speeds are reduced on subjects smaller than 200 mm or 100 mm.
/// @param milliseconds  duration of each motion
[[nodiscard]] std::vector<HandMotion> standardMotions(const Surface& surface, std::uint64_t seed, int milliseconds);

} // namespace palpate::evaluation

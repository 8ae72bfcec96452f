// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/buried/Stiffening.h"

#include <palpate/core/Export.h>
#include <palpate/core/Parallel.h>
#include <palpate/core/Status.h>
#include <palpate/geometry/Repair.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::buried {

using core::Vec3;

/// Lump embedded in an organ.
struct BuriedLump
{
    std::string name;
    std::shared_ptr<const geometry::RepairedMesh> surface; ///< world frame [mm]
    /// Modulus ratio rho of lump and organ; malignant liver tumour: 4.4. Without a value the lump has no effect on the
    /// map and gets no verdict.
    std::optional<RatioRange> ratio = RatioRange(4.4);
};

struct FeltOptions
{
    double radius_mm = 5.0;                           ///< contact radius of the finger
    std::vector<double> press_mm{0.0, 2.0, 4.0, 8.0}; ///< indentation depths of the finger, ascending
    /// Progress callback (0 to 1), called on the calling thread. Return false to cancel. May be empty.
    std::function<bool(double)> progress;
    unsigned threads = core::coreCount(); ///< maximum number of threads, including the calling thread
};
inline constexpr double kMostRadius_mm = 30.0, kMaxPress_mm = 30.0, kMaxModulusRatio = 1e4;
inline constexpr std::size_t kMaxPresses = 8;
/// Maximum triangle count of a surface refined for the contact radius: larger surfaces take minutes and gigabytes.
inline constexpr double kMaxRefinedTriangles = 2e6;

/// Detectable stiffness changes in percent: half the trained threshold, trained 14 %, untrained 28 %.
/// @par Source docs/felt.md
inline constexpr std::array<double, 3> kDetectableChange_percent{7.0, 14.0, 28.0};

/// Palpability of a lump at its best place.
enum class Verdict : std::uint8_t
{
    NotByHand,     ///< below the threshold of a trained hand
    ByTrainedHand, ///< 14 % or more
    Plainly,       ///< 28 % or more
    NotJudged,     ///< the model is invalid wherever the lump has an effect
    NotKnown,      ///< the stiffness ratio of the lump is unknown
};
inline constexpr std::array<std::string_view, 5> kVerdictNames{"not by hand", "by a trained hand", "plainly",
                                                               "not judged", "stiffness ratio not known"};
/// @param ratio  k/k0; for soft places the inverse is used
[[nodiscard]] PALPATE_EXPORT Verdict verdictOf(double ratio) noexcept;

/// Reasons why the model is invalid at a place, as bit flags.
enum NotJudged : std::uint8_t
{
    kCurved = 1,      ///< the radius of curvature is below Ground::kMinValidRadii contact radii
    kThin = 2,        ///< the organ is thinner than Ground::kMinValidRadii contact radii
    kOverlapping = 4, ///< overlapping lumps contribute at this place
};

/// Palpability map over an organ's surface.
struct FeltSurface
{
    /// k/k0 at each vertex for one indentation depth, all lumps combined.
    struct Press
    {
        double press_mm = 0.0;
        std::vector<float> low, ratio, high;
    };
    /// Result of a single lump at one indentation depth.
    struct LumpPress
    {
        std::optional<std::size_t> best;  ///< vertex with the largest effect among the valid places
        double share = 0.0;               ///< energy share S at this vertex, independent of the ratio
        Stiffening felt;                  ///< stiffness ratio at this vertex for the typical modulus ratio
        std::array<double, 3> area_mm2{}; ///< valid area with a stiffness change of at least kDetectableChange_percent
        Verdict verdict = Verdict::NotByHand;
        /// Verdicts at both ends of the ratio's range; equal to `verdict` for a single ratio.
        Verdict verdictAtLow = Verdict::NotByHand, verdictAtHigh = Verdict::NotByHand;
    };
    struct Lump
    {
        std::string name;
        std::size_t given = 0; ///< index in the list of input lumps
        std::optional<RatioRange> ratio;
        double minCover_mm = 0.0; ///< minimum depth of the lump below the organ's vertices; 0 if it protrudes
        std::vector<LumpPress> press;
    };

    geometry::TriangleMesh surface; ///< organ surface, refined to edges of at most half a contact radius
    std::size_t organVertices = 0;  ///< the first organVertices vertices are those of the original organ
    /// Maximum difference between `surface` and the maps at the organ's original vertices, interpolated over its
    /// triangles [1]: worst-case error of a display on the original mesh. 0 if the organ is fine enough.
    double interpolationError = 0.0;
    double radius_mm = 0.0;
    std::vector<Press> press;
    std::vector<Lump> lumps;
    std::vector<float> cover_mm;    ///< depth of the lump with the largest effect; NaN without one
    std::vector<std::uint8_t> lump; ///< index + 1 of the lump with the largest effect at the deepest press; 0: no lump
    std::vector<std::uint8_t> notJudged; ///< bit flags of NotJudged
    std::vector<core::Message> notes;    ///< omitted items with the reason, one sentence each
};

/// Formats the verdict with its basis: "by a trained hand", or, if the ends of the ratio's range lead to different
/// verdicts, "by a trained hand (at 1: not by hand; at 5.2: plainly)".
/// @param ratio  modulus ratio of the lump
[[nodiscard]] PALPATE_EXPORT std::string verdictText(const FeltSurface::LumpPress& press,
                                                     const std::optional<RatioRange>& ratio);

/// Computes the palpability of lumps through an organ's surface. Lumps are processed in order. A lump with an unknown
/// ratio gets a cover depth but no verdict; open or inside-out lumps and lumps entirely outside the organ are skipped
/// with a note.
/// @param name  name of the organ, for messages
/// @return OutOfRange for an invalid radius, press or ratio, or if the radius is so small that the surface would need
/// more than kMaxRefinedTriangles triangles; Unsupported if the organ is not a closed surface; Empty without a lump;
/// Cancelled.
/// @par Cost About 20 ns for each combination of vertex, lump triangle (at most LumpShape::kDefaultTriangles) and
/// press. Uses all cores, with bit-identical results for any number of threads. Not for the servo thread.
[[nodiscard]] PALPATE_EXPORT core::Result<FeltSurface> feltSurface(const std::string& name,
                                                                   const geometry::RepairedMesh& organ,
                                                                   const std::vector<BuriedLump>& lumps,
                                                                   const FeltOptions& options = {});

} // namespace palpate::buried

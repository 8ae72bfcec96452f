// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/buried/Stiffening.h"

#include <palpate/core/Parallel.h>
#include <palpate/core/Status.h>
#include <palpate/geometry/MeshReport.h>

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

/// A lump in an organ.
struct BuriedLump
{
    std::string name;
    std::shared_ptr<const geometry::RepairedMesh> surface; ///< world frame [mm]
    /// rho: its modulus by the organ's, a malignant tumour of the liver: 4.4. Nothing: not known; then the lump changes
    /// nothing and has no verdict.
    std::optional<RatioRange> ratio = RatioRange(4.4);
};

struct FeltOptions
{
    double radius_mm = 5.0;                           ///< of the finger's contact
    std::vector<double> press_mm{0.0, 2.0, 4.0, 8.0}; ///< how deep the finger is pressed in, ascending
    /// Told the share done, 0 … 1, on the calling thread; false cancels. May be empty.
    std::function<bool(double)> progress;
    unsigned threads = core::coreCount(); ///< at most, the calling one included
};
inline constexpr double kMostRadius_mm = 30.0, kMostPress_mm = 30.0, kMostRatio = 1e4;
inline constexpr std::size_t kMostPresses = 8;
/// Triangles of a surface that is refined for the finger's contact: more would take minutes and gigabytes.
inline constexpr double kMostRefined = 2e6;

/// Changes of stiffness that hands tell: untrained 28 %, trained 14 %, and half of it, in 100.
/// @par Source resources/docs/felt.md
inline constexpr std::array<double, 3> kTold_percent{7.0, 14.0, 28.0};

/// Whether a hand finds a lump at its best place.
enum class Verdict : std::uint8_t
{
    NotByHand,     ///< below what a trained hand tells
    ByTrainedHand, ///< 14 % or more
    Plainly,       ///< 28 % or more
    NotJudged,     ///< wherever it could be felt the model does not hold
    NotKnown,      ///< how stiff the lump is, is not known
};
inline constexpr std::array<std::string_view, 5> kVerdictNames{"not by hand", "by a trained hand", "plainly",
                                                               "not judged", "stiffness ratio not known"};
/// @param ratio  k/k0; of a soft place its inverse counts
[[nodiscard]] Verdict verdictOf(double ratio) noexcept;

/// Why a place is not judged, as bits.
enum NotJudged : std::uint8_t
{
    kCurved = 1,      ///< the surface bends with less than Ground::kLeastRadii contact radii
    kThin = 2,        ///< the organ is thinner than that
    kOverlapping = 4, ///< lumps that reach into each other are felt here
};

/// What can be felt from each vertex of an organ's surface.
struct FeltSurface
{
    /// k/k0 at each vertex for one press, all lumps together.
    struct Press
    {
        double press_mm = 0.0;
        std::vector<float> low, ratio, high;
    };
    /// A lump alone, at one press.
    struct LumpPress
    {
        std::optional<std::size_t> best;  ///< vertex where it is felt most; of those that are judged
        double share = 0.0;               ///< S there, whatever the ratio
        Stiffening felt;                  ///< there, for the typical ratio
        std::array<double, 3> area_mm2{}; ///< that is judged, where it is felt by kTold_percent or more
        Verdict verdict = Verdict::NotByHand;
        /// For the ends of the ratio's range; the same as `verdict` where one ratio is known.
        Verdict verdictAtLow = Verdict::NotByHand, verdictAtHigh = Verdict::NotByHand;
    };
    struct Lump
    {
        std::string name;
        std::size_t given = 0; ///< its number among the lumps that were given
        std::optional<RatioRange> ratio;
        double leastCover_mm = 0.0; ///< from the organ's vertices to the lump; 0 where it sticks out
        std::vector<LumpPress> press;
    };

    geometry::TriangleMesh surface; ///< the organ's, refined where its edges are longer than half a contact radius
    std::size_t organVertices = 0;  ///< the first so many are the organ's own
    /// By how much the maps at the organ's own vertices, linear over its triangles, differ from those of `surface` [1]:
    /// so much more or less than is shown a hand feels at worst. 0 where the organ is fine enough.
    double coarseness = 0.0;
    double radius_mm = 0.0;
    std::vector<Press> press;
    std::vector<Lump> lumps;
    std::vector<float> cover_mm;         ///< to the lump that is felt most; NaN where none is
    std::vector<std::uint8_t> lump;      ///< number + 1 of the one that is felt most at the deepest press; 0: none
    std::vector<std::uint8_t> notJudged; ///< bits of NotJudged
    std::vector<std::string> notes;      ///< what was left out and why, one sentence each
};

/// @return the verdict and what it rests on: "by a trained hand", and where the ratio is a range and its ends decide
/// otherwise "by a trained hand (at 1: not by hand; at 5.2: plainly)"
/// @param ratio  of the lump
[[nodiscard]] std::string verdictText(const FeltSurface::LumpPress& press, const std::optional<RatioRange>& ratio);

/// Computes what can be felt of lumps through an organ's surface.
/// Lumps are taken in their order; one whose ratio is not known has its cover and no verdict; one that is open, inside
/// out, or wholly outside the organ is left out, with a note.
/// @param name  the organ's, for messages
/// @return OutOfRange for a radius, press or ratio out of range, and for a radius so small that the surface would need
/// more than kMostRefined triangles; Unsupported where the organ has no sure inside; Empty
/// without a lump; Cancelled.
/// @par Cost about 20 ns for each vertex, triangle of a lump (at most LumpShape::kUsualTriangles) and press. All cores;
/// the same bits on any number of them. Never from the servo thread.
[[nodiscard]] core::Result<FeltSurface> feltSurface(const std::string& name, const geometry::RepairedMesh& organ,
                                                    const std::vector<BuriedLump>& lumps,
                                                    const FeltOptions& options = {});

} // namespace palpate::buried

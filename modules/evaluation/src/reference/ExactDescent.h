// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/Surface.h"
#include "reference/Orientation.h"

#include <array>
#include <utility>
#include <vector>

namespace palpate::evaluation {

/// Moves a point to a local minimum of its distance to the HIP by moves that no triangle blocks, or as close as
/// friction permits; see ExactSolver.
class ExactDescent
{
  public:
    /// @param friction  static and dynamic coefficient of all triangles [1]
    explicit ExactDescent(const Surface& surface, double friction = 0.0);

    /// @param g    start position; receives the end position [mm]
    /// @return number of moves; `kMostMoves` if the limit was reached
    std::uint32_t converge(Long3& g, const Long3& hip);
    /// Number of planes that constrain the point after `converge`, at most 3.
    [[nodiscard]] int constraints() const noexcept { return m_constraints; }

    static constexpr std::uint32_t kMostMoves = 5000;

  private:
    struct Candidate
    {
        Long3 a, b, c, n;        ///< corners and unit normal [mm]
        long double normalError; ///< bound on the error of `n` times a length, relative to the length
        std::uint32_t triangle;
        bool isTwoSided;
    };
    struct Touched
    {
        const Candidate* triangle;
        Long3 n; ///< towards the side of the point
    };
    struct Way
    {
        Long3 target;
        long double promise; ///< expected decrease of the squared distance to the HIP [mm^2]
        int planes;
        std::array<const Candidate*, 2> on; ///< triangles of these planes
        long double multiplierSum_mm;       ///< sum of the multipliers that keep the target on the planes
    };

    void gather(const Long3& g, const Long3& hip);
    /// @return end of the move from → to: `to`, or one skin before the first blocking triangle
    [[nodiscard]] Long3 sweep(const Long3& from, const Long3& to, bool& isBlocked) const;
    [[nodiscard]] static int side(const Candidate& t, const Long3& p);
    [[nodiscard]] static bool blocks(const Candidate& t, const Long3& from, const Long3& to);
    void findTouched(const Long3& g);
    void findPairs();
    void collectWays(const Long3& from, const Long3& hip);
    [[nodiscard]] bool isBlockedQuickly(const Long3& from, const Long3& to, long double leastMove_mm);
    [[nodiscard]] bool advance(Long3& g, const Long3& from, const Long3& hip, long double leastMove_mm);
    [[nodiscard]] static long double supportedLength_mm(const Way& way, const Long3& from);
    [[nodiscard]] bool moveWithFriction(Long3& g, const Long3& from, const Way& way, long double leastMove_mm);

    const Surface& m_surface;
    long double m_friction;
    long double m_skin_mm;
    Box m_gathered;
    std::vector<std::uint32_t> m_near;
    std::vector<Candidate> m_candidates;
    std::vector<Box> m_boxes; ///< boxes of the candidates
    std::vector<Touched> m_touched;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> m_pairs; ///< indices of touched triangles
    std::size_t m_lastShut = 0;                                   ///< touched triangle that blocked the previous move
    std::vector<Way> m_ways;
    int m_constraints = 0;
};

} // namespace palpate::evaluation

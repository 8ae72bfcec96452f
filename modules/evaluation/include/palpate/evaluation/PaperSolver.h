// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/ReferenceSolver.h"
#include "palpate/evaluation/Surface.h"

#include <cstdint>
#include <string>
#include <vector>

namespace palpate::evaluation {

/// Zilles & Salisbury as published: every triangle is tested against the line from the old god-object to the HIP; the
/// plane that is met becomes a constraint; with the new god-object in the HIP's place the search goes on for acute
/// concavities, until nothing new is met or three planes are held. Nothing is kept between ticks but the god-object, so
/// a convex edge takes two ticks.
///
/// Where the paper leaves a choice: of several planes met the first along the line is taken; a god-object within a
/// roundoff of a plane counts as on it. A fourth plane is not seen, and a pivot of 0 leaves the god-object in its
/// place.
/// @par Source Zilles & Salisbury, IROS 1995, doi:10.1109/IROS.1995.525876, sections 3 and 4.
class PaperSolver : public ReferenceSolver
{
  public:
    /// How the facets on a line are found. Both give the same bits.
    enum class Search
    {
        BruteForce, ///< every facet is tested, as published: what its time is measured with
        Boxes,      ///< only those whose boxes are near the line: fast enough to take the errors of whole paths
    };

    /// @param surface  must outlive this
    explicit PaperSolver(const Surface& surface, Search search = Search::BruteForce);

    [[nodiscard]] std::string name() const override { return "paper (brute force)"; }
    void start(const Vec3& p_WH) override { m_god = p_WH; }
    [[nodiscard]] SolverStep step(const Vec3& p_WH) override;

  private:
    struct Facet
    {
        Vec3 a, b, c, n;
        bool isTwoSided;
    };
    [[nodiscard]] bool meets(const Facet& facet, const Vec3& target, double& share, double& side) const;
    void findNear(const Vec3& target);

    const Surface& m_surface;
    Search m_search;
    std::vector<Facet> m_facets;
    std::vector<std::uint32_t> m_near; ///< facets to test, ascending
    double m_roundoff_mm;
    Vec3 m_god = Vec3::Zero();
};

} // namespace palpate::evaluation

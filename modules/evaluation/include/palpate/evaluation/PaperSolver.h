// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/ReferenceSolver.h"
#include "palpate/evaluation/Surface.h"

#include <cstdint>
#include <string>
#include <vector>

namespace palpate::evaluation {

/// The algorithm of Zilles & Salisbury as published. Every triangle is tested against the line from the old god-object
/// to the HIP, and an intersected plane becomes a constraint. The search is repeated with the new god-object in place
/// of the HIP (for acute concavities) until no new plane is found or three are active. Only the god-object is kept
/// between ticks, so crossing a convex edge takes two ticks.
///
/// Choices left open by the paper: of several intersected planes, the first along the line is used; a god-object
/// within the roundoff tolerance of a plane counts as on the plane. A fourth plane is ignored, and a zero pivot leaves
/// the god-object unchanged.
/// @par Source Zilles & Salisbury, IROS 1995, doi:10.1109/IROS.1995.525876, sections 3 and 4.
class PaperSolver : public ReferenceSolver
{
  public:
    /// Search method for intersected facets. Both give bit-identical results.
    enum class Search
    {
        BruteForce, ///< tests every facet, as published; used for timings
        Boxes,      ///< tests only facets whose boxes are near the line; fast enough to measure errors over whole paths
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
    std::vector<std::uint32_t> m_near; ///< candidate facets, ascending
    double m_roundoff_mm;
    Vec3 m_god = Vec3::Zero();
};

} // namespace palpate::evaluation

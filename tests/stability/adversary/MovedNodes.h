// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "LayerJudge.h"
#include "RandomMotion.h"

#include <vector>

namespace palpate::adversary {

/// Checks in the world that no closed surface passes a god-object: moves the nodes of the refined surface and counts
/// how often it winds around the god-object. A fall is allowed, since points inside leave freely; a rise never is.
class MovedNodes
{
  public:
    /// @param motion  must stay alive; null: the surfaces rest
    MovedNodes(const JudgedLayer& layer, const RandomMotion* motion);
    void forget();
    /// @param t  time of the tick [s]
    void look(double t, const Vec3& god, double rounding_mm, Faults& faults);
    [[nodiscard]] std::int64_t ticks() const { return m_ticks; }

  private:
    struct Watched
    {
        std::vector<std::array<Vec3, 3>> rest; ///< refined so that facets and what they become are close
        double edge_mm = 0.0;                  ///< longest
        bool isKnown = false;
        int most = 0; ///< winding number
    };

    std::vector<Watched> m_bodies;
    const RandomMotion* m_motion;
    double m_skin_mm;
    std::int64_t m_ticks = 0;
};

} // namespace palpate::adversary

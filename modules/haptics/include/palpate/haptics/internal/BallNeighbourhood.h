// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/haptics/internal/Ball.h"
#include "palpate/haptics/internal/CloseTriangles.h"
#include "palpate/haptics/internal/FacetCache.h"

namespace palpate::haptics::internal {

/// What a ball's moves meet, asked of the facets around it.
class BallNeighbourhood
{
  public:
    /// Forgets everything: the scene changed.
    void clear() noexcept PALPATE_NONBLOCKING
    {
        m_cache.clear();
        m_close.clear();
    }

    /// Tells where the ball's centre stands after a tick.
    /// @par Real-time Wait-free.
    void endTick(const HapticScene& scene, const HapticLayer& layer, const Vec3& g) noexcept PALPATE_NONBLOCKING;

    /// Finds the first facet of the layer that blocks a ball with the scene's radius, its centre going x → y.
    /// @return false when nothing blocks it.
    /// @par Real-time Wait-free.
    [[nodiscard]] bool sweep(const HapticScene& scene, const HapticLayer& layer, const Vec3& x, const Vec3& y,
                             BallCrossing& first) noexcept PALPATE_NONBLOCKING;

  private:
    using Cache = FacetCache<TriangleGroup, kMostTriangles>;

    struct First;
    template<class Facets>
    static void offerFrom(const HapticScene& scene, const Facets& facets, First& first) noexcept;

    Cache m_cache;
    CloseTriangles m_close;
};

} // namespace palpate::haptics::internal

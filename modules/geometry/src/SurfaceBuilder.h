// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/SurfaceIndex.h"

namespace palpate::geometry {

/// Builds a SurfaceIndex, one thing after the other: each step takes what the steps before have finished.
class SurfaceBuilder
{
  public:
    /// @param repaired  must outlive the builder; not empty, its box finite and within SurfaceIndex::kLargest_mm
    SurfaceBuilder(const RepairedMesh& repaired, unsigned threads)
        : m_repaired(repaired)
        , m_threads(threads)
    {
    }
    /// @pre called once
    [[nodiscard]] SurfaceIndex build();

  private:
    /// The index's numbers that follow from all triangles.
    struct Scale
    {
        double skin_mm = 0.0;
        double facetSize_mm = 0.0;
        bool isSkinAboveRounding = false;
    };

    /// @param items  becomes a box a triangle
    [[nodiscard]] Scale measure(const Box& bounds, core::LargeArray<BoxedItem>& items) const;
    /// Puts triangles and vertices into the order of the leaves. @param items  as BoxHierarchy::build left them
    void reorder(const core::LargeArray<BoxedItem>& items, SurfaceIndex& index) const;
    /// Sets the index's flags.
    void flag(const std::vector<std::uint8_t>& isClear, SurfaceIndex& index) const;

    const RepairedMesh& m_repaired;
    unsigned m_threads;
};

} // namespace palpate::geometry

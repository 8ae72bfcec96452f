// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/geometry/SurfaceIndex.h"

namespace palpate::geometry {

/// Builds a SurfaceIndex step by step.
class SurfaceBuilder
{
  public:
    /// @param repaired  must outlive the builder; not empty, with finite bounds within SurfaceIndex::kLargest_mm
    SurfaceBuilder(const RepairedMesh& repaired, unsigned threads)
        : m_repaired(repaired)
        , m_threads(threads)
    {
    }
    /// @pre not called before
    [[nodiscard]] SurfaceIndex build();

  private:
    /// Scalar properties of the index that depend on all triangles.
    struct Scale
    {
        double skin_mm = 0.0;
        double facetSize_mm = 0.0;
        bool isSkinAboveRounding = false;
    };

    /// @param items  output: the box of each triangle
    [[nodiscard]] Scale measure(const Box& bounds, core::LargeArray<BoxedItem>& items) const;
    /// Sorts triangles and vertices into leaf order. @param items  as sorted by BoxHierarchy::build
    void reorder(const core::LargeArray<BoxedItem>& items, SurfaceIndex& index) const;
    /// Numbers the connected parts.
    static void findParts(SurfaceIndex& index);
    /// Sets the flag bits of the index.
    void flag(const std::vector<std::uint8_t>& isClear, SurfaceIndex& index) const;

    const RepairedMesh& m_repaired;
    unsigned m_threads;
};

} // namespace palpate::geometry

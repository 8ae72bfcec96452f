// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/ReferenceSolver.h"
#include "palpate/evaluation/Surface.h"

#include <memory>

namespace palpate::evaluation {

/// Segment intersection test with a surface; the ray solvers differ only in this backend.
class SegmentCaster
{
  public:
    struct Hit
    {
        double share = 1.0; ///< position along the segment, 0 to 1
        std::uint32_t triangle = 0;
    };
    virtual ~SegmentCaster() = default;
    [[nodiscard]] virtual std::string name() const = 0;
    /// @return false if there is no hit after `from`, on either side of the surface.
    [[nodiscard]] virtual bool cast(const Vec3& from, const Vec3& to, Hit& hit) = 0;
};

/// God-object built on a generic segment-casting library: moves to the first hit, then along the hit plane to the
/// next, with up to three planes, until no move is left. Keeps a gap of 1e-6 of the scene size because such libraries
/// use their own tolerances.
class RaySolver : public ReferenceSolver
{
  public:
    /// @param surface  must outlive this
    RaySolver(const Surface& surface, std::unique_ptr<SegmentCaster> caster);
    ~RaySolver() override;

    [[nodiscard]] std::string name() const override { return m_caster->name(); }
    void start(const Vec3& p_WH) override { m_god = p_WH; }
    [[nodiscard]] SolverStep step(const Vec3& p_WH) override;

  private:
    [[nodiscard]] bool firstBlocking(const Vec3& target, SegmentCaster::Hit& hit, Vec3& n);
    [[nodiscard]] int pass(const Vec3& p_WH);

    const Surface& m_surface;
    std::unique_ptr<SegmentCaster> m_caster;
    double m_gap_mm;
    Vec3 m_god = Vec3::Zero();
};

/// Creates a caster on vtkStaticCellLocator, the fastest VTK locator for lines.
[[nodiscard]] std::unique_ptr<SegmentCaster> makeVtkCaster(const Surface& surface);
/// Creates a caster on Embree 4 or 3 in single precision; null if built without Embree.
[[nodiscard]] std::unique_ptr<SegmentCaster> makeEmbreeCaster(const Surface& surface);

} // namespace palpate::evaluation

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/ReferenceSolver.h"
#include "palpate/evaluation/Surface.h"

#include <memory>

namespace palpate::evaluation {

/// Casts a segment against a surface; how is what the ray solvers differ in.
class SegmentCaster
{
  public:
    struct Hit
    {
        double share = 1.0; ///< of the segment, 0 … 1
        std::uint32_t triangle = 0;
    };
    virtual ~SegmentCaster() = default;
    [[nodiscard]] virtual std::string name() const = 0;
    /// @return false when nothing is met after `from`, whichever side it faces.
    [[nodiscard]] virtual bool cast(const Vec3& from, const Vec3& to, Hit& hit) = 0;
};

/// The god-object as one would write it on a library that casts segments: up to the first hit, along its plane to the
/// next, up to three planes, again until it rests. It keeps a gap of a millionth of the scene, since such libraries
/// have tolerances of their own.
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

/// On vtkStaticCellLocator, VTK's fastest for lines.
[[nodiscard]] std::unique_ptr<SegmentCaster> makeVtkCaster(const Surface& surface);
/// On Embree 4 or 3, in single precision; null when this build was made without it.
[[nodiscard]] std::unique_ptr<SegmentCaster> makeEmbreeCaster(const Surface& surface);

} // namespace palpate::evaluation

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/ReferenceSolver.h"
#include "palpate/evaluation/Surface.h"

namespace palpate::evaluation {

/// Vector-field penalty method, the predecessor of the god-object: the force depends on the HIP alone. Inside a
/// volume, the hand is pushed to the nearest point of the surface; where volumes overlap, either the nearest surface
/// or the sum of all forces is used.
/// @par Source Zilles & Salisbury, IROS 1995, doi:10.1109/IROS.1995.525876, section 2, figures 1 to 4.
class VectorFieldSolver : public ReferenceSolver
{
  public:
    enum class Overlap
    {
        Nearest, ///< the nearest surface of all volumes that contain the HIP
        Sum,     ///< one force per volume (connected component) that contains the HIP
    };

    /// @param surface  must outlive this object; open surfaces have no inside and give no force
    explicit VectorFieldSolver(const Surface& surface, Overlap overlap = Overlap::Nearest);

    [[nodiscard]] std::string name() const override;
    void start(const Vec3&) override {}
    [[nodiscard]] SolverStep step(const Vec3& p_WH) override;

  private:
    [[nodiscard]] Vec3 nearest(const Vec3& p, int component) const;

    const Surface& m_surface;
    Overlap m_overlap;
};

/// Measurements for figures 2 to 4 of the paper, on boxes with a spring of 1 N/mm.
struct VectorFieldFigures
{
    double plate_mm = 0.0;            ///< thickness of the pressed plate
    double popThroughDepth_mm = 0.0;  ///< depth at which the plate pushes the hand out on the far side
    double jumpAtTheMiddle_N = 0.0;   ///< change of the force when the HIP crosses the middle of a volume by 2e-6 mm
    double stiffnessAlone = 0.0;      ///< stiffness of a single box [N/mm]
    double stiffnessOverlapped = 0.0; ///< stiffness in the overlap of two boxes with summed forces [N/mm]
};

[[nodiscard]] VectorFieldFigures measureVectorField();

} // namespace palpate::evaluation

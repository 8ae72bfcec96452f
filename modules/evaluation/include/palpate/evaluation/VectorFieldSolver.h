// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/evaluation/ReferenceSolver.h"
#include "palpate/evaluation/Surface.h"

namespace palpate::evaluation {

/// What the god-object replaces: a force that is a function of the HIP alone. Inside a volume the hand is pushed to the
/// nearest point of the surface; where volumes overlap, either the nearest surface counts or the sum of all.
/// @par Source Zilles & Salisbury, IROS 1995, doi:10.1109/IROS.1995.525876, section 2, figures 1 to 4.
class VectorFieldSolver : public ReferenceSolver
{
  public:
    enum class Overlap
    {
        Nearest, ///< the nearest surface of any volume that holds the HIP
        Sum,     ///< one force for each volume (connected component) that holds the HIP
    };

    /// @param surface  must outlive this; open surfaces have no inside and give no force
    explicit VectorFieldSolver(const Surface& surface, Overlap overlap = Overlap::Nearest);

    [[nodiscard]] std::string name() const override;
    void start(const Vec3&) override {}
    [[nodiscard]] SolverStep step(const Vec3& p_WH) override;

  private:
    [[nodiscard]] Vec3 nearest(const Vec3& p, int component) const;

    const Surface& m_surface;
    Overlap m_overlap;
};

/// Figures 2 to 4 of the paper as numbers, measured on boxes with a spring of 1 N/mm.
struct VectorFieldFigures
{
    double plate_mm = 0.0;            ///< thickness of the plate that is pressed
    double popThroughDepth_mm = 0.0;  ///< how deep a press gets before the plate pushes the hand out on its far side
    double jumpAtTheMiddle_N = 0.0;   ///< change of the force when the HIP crosses a volume's middle by 2e-6 mm
    double stiffnessAlone = 0.0;      ///< felt pressing one box [N/mm]
    double stiffnessOverlapped = 0.0; ///< felt where two boxes overlap, forces summed [N/mm]
};

[[nodiscard]] VectorFieldFigures measureVectorField();

} // namespace palpate::evaluation

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>

namespace palpate::evaluation {

/// What presses, straight down and without friction.
enum class Press
{
    Punch, ///< flat, rigid, of radius 1: the same depth all over
    Bell,  ///< the model's finger: pressure P c / (2 pi (r^2 + c^2)^(3/2)), c = 1/pi, as stiff as the punch
};

/// How fine the elements are; as they stand, ten times finer ones change no excess k/k0 - 1 by more than 0.3 %.
struct LumpFineness
{
    double rimEdge = 2e-3; ///< of an element at the punch's rim, where the pressure is infinite [contact radii]
    double farEdge =
        2e4;             ///< where the half-space ends, held still: makes it stiffer by about 1/farEdge [contact radii]
    double growth = 1.5; ///< of an element by its neighbour, at most
    int acrossCover = 8; ///< elements from surface to sphere, at least
    double angle = 0.157; ///< of an element around the sphere, at most, in bispherical coordinates [rad]
};

/// Finite elements of a half-space with a sphere bonded into it below a press, symmetric about the axis: a truth for
/// buried lumps that shares nothing with buried::stiffening. Incompressible: quadrilaterals of nine nodes with a
/// linear, discontinuous pressure (Q2-P1, which doesn't lock), bulk modulus 1e5 times the shear modulus, sparse
/// Cholesky. Lengths are in radii of the contact; the half-space's shear modulus is 1. Const calls from several threads
/// at once.
class LumpElements
{
  public:
    /// @param sphereRadius, cover  of the sphere and of the tissue above it, > 0 [contact radii]; a sphere of radius
    /// 1e4 is
    ///                            a half-space below a layer
    LumpElements(double sphereRadius, double cover, const LumpFineness& fineness = {});
    ~LumpElements();
    LumpElements(LumpElements&&) noexcept;
    LumpElements& operator=(LumpElements&&) noexcept;

    struct Response
    {
        double stiffness = 0.0; ///< k by the half-space's own, 8 mu a, without a sphere in it [1]
        double share = 0.0;     ///< of the elastic energy that is inside the sphere [1]
    };
    /// @param ratio  of the moduli, sphere by half-space, > 0; infinite: rigid
    /// @return NaN when the equations could not be solved
    [[nodiscard]] Response press(Press how, double ratio) const;

    [[nodiscard]] std::size_t elementCount() const noexcept;

  private:
    struct Parts;
    std::unique_ptr<const Parts> m_parts;
};

} // namespace palpate::evaluation

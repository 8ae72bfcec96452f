// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>

namespace palpate::evaluation {

/// Pressure distribution of the contact, vertical and frictionless.
enum class Press
{
    Punch, ///< flat, rigid punch of radius 1: uniform depth
    Bell,  ///< finger of the model: pressure P c / (2 pi (r^2 + c^2)^(3/2)) with c = 1/pi, as stiff as the punch
};

/// Mesh resolution. Ten times finer elements than the defaults change no excess k/k0 - 1 by more than 0.3 %.
struct LumpResolution
{
    double rimEdge = 2e-3; ///< element edge at the rim of the punch, where the pressure is singular [contact radii]
    double farEdge =
        2e4; ///< distance of the fixed far boundary; increases the stiffness by about 1/farEdge [contact radii]
    double growth = 1.5;  ///< largest ratio between neighbouring element sizes
    int acrossCover = 8;  ///< minimum number of elements from the surface to the sphere
    double angle = 0.157; ///< largest element angle around the sphere, in bispherical coordinates [rad]
};

/// Axisymmetric finite elements of a half-space with a bonded sphere below a press: a reference for buried lumps that
/// is independent of buried::stiffening. Incompressible material: nine-node quadrilaterals with a linear,
/// discontinuous pressure (Q2-P1, free of locking), bulk modulus 1e5 times the shear modulus, sparse Cholesky. Lengths
/// are in contact radii; the shear modulus of the half-space is 1. Const calls are safe from several threads at once.
class LumpElements
{
  public:
    /// @param sphereRadius  radius of the sphere, > 0 [contact radii]; 1e4 approximates a half-space below a layer
    /// @param cover  thickness of the tissue above the sphere, > 0 [contact radii]
    LumpElements(double sphereRadius, double cover, const LumpResolution& fineness = {});
    ~LumpElements();
    LumpElements(LumpElements&&) noexcept;
    LumpElements& operator=(LumpElements&&) noexcept;

    struct Response
    {
        double stiffness = 0.0; ///< relative to the homogeneous half-space, 8 mu a [1]
        double share = 0.0;     ///< fraction of the elastic energy inside the sphere [1]
    };
    /// @param ratio  modulus of the sphere divided by that of the half-space, > 0; infinite: rigid
    /// @return NaN if the linear system cannot be solved
    [[nodiscard]] Response press(Press how, double ratio) const;

    [[nodiscard]] std::size_t elementCount() const noexcept;

  private:
    struct Parts;
    std::unique_ptr<const Parts> m_parts;
};

} // namespace palpate::evaluation

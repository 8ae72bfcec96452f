// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace palpate::evaluation {

/// Relative stiffness k/k0 [1] of a flat, rigid, frictionless, circular punch on an incompressible layer bonded to a
/// half-space of another modulus; k0 is the stiffness on a half-space of the layer's modulus. Exact up to the
/// quadrature error (1e-6).
///
/// The Hankel transform gives the surface compliance for a sinusoidal pressure, layerCompliance; the pressure below
/// the punch follows from a Fredholm equation,
/// chi(x) - int_0^1 chi(t) (2/pi) int_0^inf (1 - L) cos kx cos kt dk dt = 1, k/k0 = int chi.
///
/// @param thickness  of the layer in punch radii, > 0.05
/// @param ratio      modulus below divided by modulus of the layer, > 0; infinite: rigid base
/// @par Source  Lebedev & Ufliand 1958 for the rigid base; the layer on another half-space: resources/docs/felt.md
[[nodiscard]] double layeredPunch(double thickness, double ratio);

/// Surface compliance L of the layer under a sinusoidal pressure, relative to a half-space of the layer's modulus [1].
/// @param u  wave number times thickness, >= 0; @param ratio  as for layeredPunch
[[nodiscard]] double layerCompliance(double u, double ratio);

} // namespace palpate::evaluation

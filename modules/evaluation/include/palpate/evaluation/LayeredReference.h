// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace palpate::evaluation {

/// By how much a flat, rigid, frictionless, round punch is stiffer on an incompressible layer that is bonded to a
/// half-space of another modulus than on a half-space of the layer's: k/k0 [1]. Exact but for quadrature (1e-6).
///
/// The Hankel transform gives the surface's compliance under a ripple, layerCompliance; the punch's pressure comes from
/// a Fredholm equation, chi(x) - int_0^1 chi(t) (2/pi) int_0^inf (1 - L) cos kx cos kt dk dt = 1, k/k0 = int chi.
///
/// @param thickness  of the layer in radii of the punch, > 0.05
/// @param ratio      of the moduli, below by layer, > 0; infinite: rigid
/// @par Source  Lebedev & Ufliand 1958 for the rigid base; the layer on another half-space: resources/docs/felt.md
[[nodiscard]] double layeredPunch(double thickness, double ratio);

/// L: compliance of the layer's surface under a ripple of pressure by that of the half-space of the layer's modulus
/// [1].
/// @param u  wave number times thickness, >= 0; @param ratio  as above
[[nodiscard]] double layerCompliance(double u, double ratio);

} // namespace palpate::evaluation

// SPDX-License-Identifier: BSD-3-Clause
// Contact tolerances of the exact point and the exact sphere.
#pragma once

namespace palpate::evaluation {

/// Exponent of the skin thickness, relative to the largest coordinate: about ten thousand rounding errors of a long
/// double, and a millionth of the product's skin.
inline constexpr int kSkinBits = -50;
/// Distance in skins within which a triangle counts as touched.
inline constexpr long double kTouched = 64;
/// Minimum gain of a move in skins. Without this limit the point could oscillate for ever between two nearly coplanar
/// planes. Along a surface 10 mm away the limit corresponds to a few 1e-8 mm.
inline constexpr long double kLeastGain = 0.01L;

} // namespace palpate::evaluation

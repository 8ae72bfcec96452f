// SPDX-License-Identifier: BSD-3-Clause
// How near is touched, for the exact point and the exact ball.
#pragma once

namespace palpate::evaluation {

/// A skin is 2 to this of the largest coordinate: some ten thousand roundings of a long double, and a millionth of the
/// product's own.
inline constexpr int kSkinBits = -50;
/// Within this many skins a triangle is touched.
inline constexpr long double kTouched = 64;
/// A way must bring the god-object this many skins closer: between two planes that are nearly one it could otherwise go
/// to and fro for ever. Along a surface 10 mm away that is a few 1e-8 mm.
inline constexpr long double kLeastGain = 0.01L;

} // namespace palpate::evaluation

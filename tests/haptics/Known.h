// SPDX-License-Identifier: BSD-3-Clause
// For tests in which the god-object's place is known.
#pragma once

#include <QtTest>

namespace palpate::test {

inline constexpr double kTick_s = 1e-3;
/// Position error that the design allows where the mesh is exact.
inline constexpr double kBound_mm = 1e-6;

} // namespace palpate::test

/// The god-object of a tick is at `expected`, within the bound.
#define QVERIFY_AT(result, expected)                                                                                   \
    QVERIFY2((result.p_WG - (expected)).norm() <= palpate::test::kBound_mm,                                            \
             qPrintable(QString("off by %1 mm").arg((result.p_WG - (expected)).norm())))

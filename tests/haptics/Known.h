// SPDX-License-Identifier: BSD-3-Clause
// For tests with a known god-object position.
#pragma once

#include <QtTest>

namespace palpate::test {

inline constexpr double kTick_s = 1e-3;
/// Position error that the design allows for an exact mesh.
inline constexpr double kBound_mm = 1e-6;

} // namespace palpate::test

/// Checks that the god-object of a tick is at `expected`, within the bound.
#define QVERIFY_AT(result, expected)                                                                                   \
    QVERIFY2((result.p_WG - (expected)).norm() <= palpate::test::kBound_mm,                                            \
             qPrintable(QString("off by %1 mm").arg((result.p_WG - (expected)).norm())))

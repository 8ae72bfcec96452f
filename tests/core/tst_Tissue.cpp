// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/core/Tissue.h>

#include <cmath>
#include <limits>
#include <string>

using palpate::core::check;
using palpate::core::kTissueTerms;
using palpate::core::StatusCode;
using palpate::core::Tissue;
using palpate::core::TissueTerm;

class TissueTest : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void boundsEveryTerm()
    {
        QVERIFY(check(Tissue{}).isOk());
        constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(),
                         kInfinite = std::numeric_limits<double>::infinity();
        for (const TissueTerm& term : kTissueTerms) {
            Tissue tissue;
            tissue.friction_static = 5.0; // the largest, so that dynamic friction may have any permitted value
            for (const double value : {0.0, term.most}) {
                tissue.*term.member = value;
                QVERIFY2(term.member == &Tissue::friction_static || check(tissue).isOk(), term.key.data());
            }
            for (const double value : {-5.0, std::nextafter(term.most, kInfinite), 1e300}) {
                tissue.*term.member = value;
                const palpate::core::Status status = check(tissue);
                QCOMPARE(status.code(), StatusCode::OutOfRange);
                QVERIFY2(status.message().starts_with(std::string(term.key) + ": found "), status.message().c_str());
            }
            for (const double value : {kNaN, kInfinite}) {
                tissue.*term.member = value;
                QCOMPARE(check(tissue).code(), StatusCode::NonFinite);
            }
        }
    }

    void slidingFrictionIsAtMostStatic()
    {
        Tissue tissue;
        tissue.friction_static = 0.3;
        tissue.friction_dynamic = 0.3;
        QVERIFY(check(tissue).isOk());
        tissue.friction_dynamic = 0.4;
        QCOMPARE(check(tissue).message(),
                 std::string("friction_dynamic: found 0.4, expected at most 0.3 (friction_static)"));
    }

    void checksTheLaw()
    {
        Tissue tissue;
        tissue.law.kind = palpate::core::LawKind::Points;
        tissue.law.points = {{0.0, 0.0}, {1.0, -1.0}};
        QCOMPARE(check(tissue).code(), StatusCode::OutOfRange);
    }
};

PALPATE_TEST_NAMED("Tissue", TissueTest)
#include "tst_Tissue.moc"

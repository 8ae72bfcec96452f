// SPDX-License-Identifier: BSD-3-Clause
// Compares the model of buried lumps with reference results: resources/docs/felt.md.
#include "TestRunner.h"

#include <palpate/evaluation/FeltComparison.h>
#include <palpate/evaluation/LayeredReference.h>
#include <palpate/evaluation/LumpElements.h>

#include <cmath>
#include <limits>
#include <numbers>

using namespace palpate::evaluation;
using palpate::buried::Stiffening;
using palpate::buried::stiffening;

namespace {

constexpr double kRigidBelow = std::numeric_limits<double>::infinity();
constexpr double kPlate = 1e4; // radius of a sphere that approximates a half-space

/// Returns k/k0 from the finite elements, with and without the lump on the same grid.
double feltBy(const LumpElements& elements, Press how, double ratio)
{
    return elements.press(how, ratio).stiffness / elements.press(how, 1.0).stiffness;
}

} // namespace

class Felt : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    /// Reference values from another program, with the digits as printed.
    void theLayeredReferenceGivesTheTable_data()
    {
        QTest::addColumn<double>("thickness");
        QTest::addColumn<QList<double>>("expected"); // ratio 2, 4.4, 10, rigid
        QTest::newRow("0.5") << 0.5 << QList<double>{1.748, 3.072, 4.856, 9.149};
        QTest::newRow("1") << 1.0 << QList<double>{1.523, 2.198, 2.806, 3.619};
        QTest::newRow("2") << 2.0 << QList<double>{1.288, 1.561, 1.745, 1.933};
        QTest::newRow("4") << 4.0 << QList<double>{1.141, 1.249, 1.312, 1.369};
        QTest::newRow("6") << 6.0 << QList<double>{1.092, 1.157, 1.194, 1.226};
    }
    void theLayeredReferenceGivesTheTable()
    {
        QFETCH(double, thickness);
        QFETCH(QList<double>, expected);
        const double ratios[]{2.0, 4.4, 10.0, kRigidBelow};
        const double share = palpate::buried::shareBelow(thickness, 1.0);
        for (int i = 0; i < 4; ++i) {
            const double exact = layeredPunch(thickness, ratios[i]);
            QVERIFY2(std::abs(exact - expected[i]) < 1e-3, qPrintable(QString::number(exact)));
            QVERIFY(felt::isWithin(stiffening(share, ratios[i]), exact));
        }
        QVERIFY(std::abs(layeredPunch(thickness, 1.0) - 1.0) < 1e-9);
    }

    void theLayeredReferenceAgreesWithWhatIsPublished()
    {
        // Garcia & Garcia 2018, a punch on a thin incompressible layer, x = radius / thickness.
        const double x = 0.1;
        const double polynomial = 1.0 + 1.133 * x + 1.283 * x * x + 0.598 * x * x * x - 0.291 * x * x * x * x;
        QVERIFY(std::abs(layeredPunch(1.0 / x, kRigidBelow) / polynomial - 1.0) < 1e-3);
        // Gao, Chiu & Lee 1992: first-order share of the layer under a punch.
        for (const double h : {0.5, 1.0, 2.0, 4.0}) {
            const double slope = (layeredPunch(h, 1.001) - layeredPunch(h, 0.999)) / 0.002;
            const double share = 1.0 - 2.0 / std::numbers::pi * std::atan(h) + h / (std::numbers::pi * (1.0 + h * h));
            QVERIFY2(std::abs(slope - share) < 2e-4, qPrintable(QString::number(slope - share)));
        }
    }

    void rippleComplianceHasItsLimits()
    {
        for (const double ratio : {1.0 / 3.0, 2.0, 10.0}) {
            // long wavelengths: the lower layer dominates
            QVERIFY(std::abs(layerCompliance(1e-3, ratio) * ratio - 1.0) < 0.02);
            QVERIFY(std::abs(layerCompliance(25.0, ratio) - 1.0) < 1e-9);
        }
        for (const double u : {0.009, 0.0101}) {
            QVERIFY(std::abs(layerCompliance(u, kRigidBelow) / (2.0 / 3.0 * u * u * u) - 1.0) < 1e-3);
        }
        QVERIFY(std::abs(layerCompliance(1.0, 1e9) - layerCompliance(1.0, kRigidBelow)) < 1e-6);
    }

    /// Without a lump the elements give the stiffness of the half-space: the far boundary has no influence and there is
    /// no locking.
    void elementsGiveTheHalfSpace()
    {
        const LumpElements elements(1.0, 1.0);
        for (const Press how : {Press::Punch, Press::Bell}) {
            const double k = elements.press(how, 1.0).stiffness;
            QVERIFY2(std::abs(k - 1.0) < 3e-3, qPrintable(QString::number(k)));
        }
    }

    void elementsMeetTheLayeredReference_data()
    {
        QTest::addColumn<double>("thickness");
        for (const double thickness : {0.5, 1.0, 2.0, 4.0, 6.0}) {
            QTest::addRow("%g", thickness) << thickness;
        }
    }
    void elementsMeetTheLayeredReference()
    {
        QFETCH(double, thickness);
        const LumpElements elements(kPlate, thickness);
        const double without = elements.press(Press::Punch, 1.0).stiffness;
        for (const double ratio : {2.0, 4.4, 10.0, kRigidBelow}) {
            const double k = elements.press(Press::Punch, ratio).stiffness / without,
                         exact = layeredPunch(thickness, ratio);
            QVERIFY2(std::abs(k / exact - 1.0) < 1e-2, qPrintable(QString("%1: %2, %3").arg(ratio).arg(k).arg(exact)));
        }
    }

    /// A rigid sphere is the limit of increasingly stiff spheres: two different sets of equations.
    void aRigidSphereIsTheLimitOfStiffOnes()
    {
        const LumpElements elements(1.0, 0.5);
        for (const Press how : {Press::Punch, Press::Bell}) {
            const double rigid = feltBy(elements, how, kRigidBelow), stiff = feltBy(elements, how, 1e4);
            QVERIFY(stiff < rigid && (rigid - stiff) / (rigid - 1.0) < 2e-3);
        }
    }

    void finerElementsChangeNothing()
    {
        const LumpResolution fine{5e-4, 2e5, 1.3, 14, 0.09};
        for (const double radius : {0.5, 3.0}) {
            const LumpElements coarse(radius, 0.2), finer(radius, 0.2, fine);
            QVERIFY(finer.elementCount() > 2 * coarse.elementCount());
            for (const Press how : {Press::Punch, Press::Bell}) {
                const double a = feltBy(coarse, how, 10.0), b = feltBy(finer, how, 10.0);
                QVERIFY2(felt::excessError(a, b) < 5e-3, qPrintable(QString::number(a - b)));
            }
        }
    }

    /// A coarse subset; the full comparison is `palpate evaluate --felt`.
    void boundsHoldAndTheEstimateIsNear()
    {
        felt::Options options;
        options.isQuick = true;
        const felt::Comparison comparison = felt::compare(options);
        QVERIFY(comparison.isWhole);
        QCOMPARE(comparison.spheres.size(), std::size_t(30));
        QCOMPARE(comparison.layers.size(), std::size_t(8));
        for (const felt::SphereCase& c : comparison.spheres) {
            const QString what = QString("%1 under %2, %3").arg(c.sphereRadius).arg(c.cover).arg(c.ratio);
            QVERIFY2(felt::isWithin(c.model, c.bell), qPrintable(what));
            QVERIFY2(felt::isWithin(c.modelWithPunch, c.punch), qPrintable(what));
            QVERIFY2(std::abs(c.share - c.shareOfBell) < 1e-3, qPrintable(what));
            QVERIFY2(felt::excessError(c.model.estimate, c.bell) < 0.2, qPrintable(what));
            QVERIFY2(felt::excessError(c.modelWithPunch.estimate, c.punch) < 0.2, qPrintable(what));
        }
        QVERIFY(felt::verdictOf(comparison).isProved(comparison.spheres.size()));

        const std::string table = felt::csv(comparison), page = felt::html(comparison);
        QCOMPARE(std::count(table.begin(), table.end(), '\n'), std::ptrdiff_t(1 + 30 + 8));
        QVERIFY(page.find("30 of 30") != std::string::npos && page.find("nan") == std::string::npos);
    }

    void aBoundThatDoesNotHoldIsSaid()
    {
        felt::Comparison comparison;
        comparison.spheres.push_back(
            {1.0, 1.0, 2.0, 0.1, 0.1, 0.1, 1.2, 1.06, stiffening(0.1, 2.0), stiffening(0.1, 2.0)});
        const felt::Verdict verdict = felt::verdictOf(comparison);
        QCOMPARE(verdict.bellWithin, std::size_t(0)); // 1.2 is above 1 + S (rho - 1)
        QCOMPARE(verdict.punchWithinOwn, std::size_t(1));
        QVERIFY(!verdict.isProved(1));
        QVERIFY(felt::html(comparison).find("does not: see below") != std::string::npos);
    }

    void cancelledItEndsAtOnce()
    {
        felt::Options options;
        options.progress = [](double, const std::string&) { return false; };
        const felt::Comparison comparison = felt::compare(options);
        QVERIFY(!comparison.isWhole);
        QVERIFY(comparison.spheres.size() < 20);
    }
};

PALPATE_TEST(Felt)
#include "tst_Felt.moc"

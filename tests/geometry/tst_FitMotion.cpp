// SPDX-License-Identifier: BSD-3-Clause
#include "Motions.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/geometry/FitMotion.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace palpate;
using namespace palpate::test;
using geometry::fitMotion;
using geometry::FittedMotion;

namespace {

/// A sphere that is lifted and stretched along z, over eight frames.
std::vector<std::vector<Vec3>> breathing(const std::vector<Vec3>& rest, double stretch)
{
    std::vector<std::vector<Vec3>> frames;
    for (int f = 0; f < 8; ++f) {
        const double share = std::pow(std::sin(std::numbers::pi * f / 8.0), 2);
        auto& frame = frames.emplace_back(rest);
        for (Vec3& p : frame) {
            p += share * Vec3(0, 2.0 * std::sin(0.03 * p.z()), 10.0 + stretch * p.z());
        }
    }
    return frames;
}

} // namespace

class FitMotionTest : public QObject
{
    Q_OBJECT

    const std::vector<Vec3> m_rest = sphere(16, 40.0).vertices;

    static QString message(const core::Result<FittedMotion>& fitted)
    {
        return fitted.isOk() ? QString("fitted") : QString::fromStdString(fitted.status().message());
    }

  private Q_SLOTS:
    void followsTheFramesAndStatesItsResidual()
    {
        const auto frames = breathing(m_rest, 0.1);
        const auto fitted = fitMotion(4.0, m_rest, frames, 10.0);
        QVERIFY2(fitted.isOk(), qPrintable(message(fitted)));
        const auto& motion = *fitted.value().motion;
        QVERIFY2(fitted.value().residual_mm < 0.02, qPrintable(QString::number(fitted.value().residual_mm)));
        double most = 0.0;
        for (std::size_t f = 0; f < frames.size(); ++f) {
            const std::vector<Vec3> places = motion.placesAt(0.5 * static_cast<double>(f), m_rest);
            for (std::size_t v = 0; v < places.size(); ++v) {
                most = std::max(most, (places[v] - frames[f][v]).norm());
            }
        }
        QVERIFY(std::abs(most - fitted.value().residual_mm) < 1e-9);
        QVERIFY(motion.strain() > 0.09 && motion.strain() < 0.3);
    }

    void noiseOfVerticesDoesNotStrainTheLattice()
    {
        auto frames = breathing(m_rest, 0.1);
        const double clean = fitMotion(4.0, m_rest, frames, 10.0).value().motion->strain();
        std::mt19937 random(3);
        std::normal_distribution<double> noise_mm(0.0, 0.1); // as of segmented frames that were registered
        for (auto& frame : frames) {
            for (Vec3& p : frame) {
                p += Vec3(noise_mm(random), noise_mm(random), noise_mm(random));
            }
        }
        const auto fitted = fitMotion(4.0, m_rest, frames, 10.0);
        QVERIFY2(fitted.isOk(), qPrintable(message(fitted)));
        const double strain = fitted.value().motion->strain();
        QVERIFY2(strain < clean + 0.1, qPrintable(QString("%1 of %2").arg(strain).arg(clean)));
    }

    void badFramesAreRefusedWithTheirPlace()
    {
        auto frames = breathing(m_rest, 0.1);
        frames[3].pop_back();
        const QString fewer = QString("frame 3: found %1 vertices").arg(m_rest.size() - 1);
        QVERIFY(message(fitMotion(4.0, m_rest, frames, 10.0)).startsWith(fewer));
        frames = breathing(m_rest, 0.1);
        frames[5][17].y() = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(message(fitMotion(4.0, m_rest, frames, 10.0)).startsWith("frame 5, vertex 17"));
        frames = breathing(m_rest, 0.1);
        frames[2][1000] += Vec3(2.5, 0, 0); // a single vertex: the lattice does not follow it
        QVERIFY(message(fitMotion(4.0, m_rest, frames, 10.0)).startsWith("frame 2, vertex 1000"));
        QVERIFY(message(fitMotion(4.0, m_rest, breathing(m_rest, 0.5), 10.0)).contains("expected at most 30 %"));
        QVERIFY(message(fitMotion(4.0, m_rest, breathing(m_rest, -1.5), 10.0)).contains("may fold"));
        QVERIFY(message(fitMotion(4.0, m_rest, {frames[0]}, 10.0)).contains("found 1 frames"));
    }
};

PALPATE_TEST_NAMED("FitMotion", FitMotionTest)
#include "tst_FitMotion.moc"

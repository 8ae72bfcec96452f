// SPDX-License-Identifier: BSD-3-Clause
// Presses real closed surfaces 3 % of their size deep and slides over them for 10 s: the god-object is never inside by
// VTK's signed distance, and no legal move comes closer.
#include "TestRunner.h"

#include <palpate/haptics/Palpator.h>
#include <palpate/meshio/LoadScene.h>
#include <palpate/vtk/PolyData.h>

#include <vtkImplicitPolyDataDistance.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace palpate;
using core::Vec3;
using geometry::RepairedMesh;
using haptics::Palpator;
using haptics::TickResult;

namespace {

constexpr int kTicks = 10'000; // 10 s at 1 kHz
constexpr double kInside_mm = 1e-6;

/// Returns whether any of `triangles` blocks the move, as defined in resources/docs/god-object.md, in long double. The
/// surface is closed: front sides only.
bool isBlocked(const geometry::TriangleMesh& mesh, const std::vector<std::uint32_t>& triangles, const Vec3& from,
               const Vec3& to)
{
    using Long3 = Eigen::Matrix<long double, 3, 1>;
    const Long3 x = from.cast<long double>(), y = to.cast<long double>(), d = y - x;
    for (const std::uint32_t i : triangles) {
        const geometry::Triangle& t = mesh.triangles[i];
        const Long3 a = mesh.vertices[t[0]].cast<long double>(), b = mesh.vertices[t[1]].cast<long double>(),
                    c = mesh.vertices[t[2]].cast<long double>();
        const Long3 n = (b - a).cross(c - a);
        if (n.dot(x - a) >= 0 && n.dot(y - a) < 0 && d.dot((a - x).cross(b - x)) <= 0 &&
            d.dot((b - x).cross(c - x)) <= 0 && d.dot((c - x).cross(a - x)) <= 0) {
            return true;
        }
    }
    return false;
}

} // namespace

class ClosedMeshes : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void areNeverEnteredAndAlwaysConverge_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<double>("unit_mm");
        QTest::newRow("liver") << "liver-smooth.obj" << 10.0;
        QTest::newRow("aneurysm") << "aneurysm3d_surface.obj" << 1.0;
        QTest::newRow("scapula") << "arm-right.scapula.stl" << 30.0;
        QTest::newRow("liver scene") << "vh_f_liver_scene" << 1000.0;
        QTest::newRow("knee") << "vh_f_knee_R" << 1000.0;
        QTest::newRow("kidney") << "vh_f_kidney_L.obj" << 1000.0;
    }
    void areNeverEnteredAndAlwaysConverge()
    {
        PALPATE_SHARED_OR_SKIP(anatomy, "anatomy");
        QFETCH(QString, file);
        QFETCH(double, unit_mm);
        meshio::ReadOptions options;
        options.unit_mm = unit_mm;
        const core::Result<meshio::LoadedScene> loaded = meshio::loadScene(anatomy / file.toStdString(), options);
        QVERIFY2(loaded.isOk(), loaded.status().message().c_str());
        int closed = 0;
        for (const meshio::LoadedStructure& structure : loaded.value().structures) {
            const geometry::MeshReport& report = structure.surface->report;
            // VTK's sign is only meaningful on one manifold component that faces outwards.
            if (report.isClosed() && report.components == 1 && report.nonManifoldEdges == 0 &&
                report.volume_mm3 > 0.0) {
                ++closed;
                palpate(*structure.surface, structure.description.name);
                if (QTest::currentTestFailed()) {
                    return;
                }
            }
        }
        QVERIFY(closed > 0);
    }

  private:
    void palpate(const RepairedMesh& surface, const std::string& name)
    {
        const vtkSmartPointer<vtkPolyData> data = palpate::vtk::polyDataOf(surface.mesh);
        vtkNew<vtkImplicitPolyDataDistance> distance;
        distance->SetInput(data);
        vtkNew<vtkStaticCellLocator> locator;
        locator->SetDataSet(data);
        locator->BuildLocator();
        const Vec3 centre = surface.report.bounds.center();
        const double size = surface.report.bounds.diagonal().norm(), depth = 0.03 * size;

        const haptics::HapticScene scene({haptics::HapticStructure{
            name, std::make_shared<geometry::SurfaceIndex>(geometry::SurfaceIndex::build(surface)), {0.5, 0.0}, 0}});
        Palpator palpator;
        palpator.borrowScene(&scene);
        std::mt19937 random(3);
        std::normal_distribution<double> normal;
        int contacts = 0;
        for (int i = 0; i < kTicks; ++i) {
            // Around the organ every three seconds, rising and sinking, pressing on the nearest point. This point jumps
            // at times: fast motion is part of the path.
            const double a = 2 * std::numbers::pi * i / 3000.0, e = 1.2 * std::sin(2 * std::numbers::pi * i / 7100.0);
            const Vec3 far =
                centre + 0.6 * size * Vec3(std::cos(a) * std::cos(e), std::sin(a) * std::cos(e), std::sin(e));
            double x[3], squared = 0.0;
            vtkIdType cell = 0;
            int subId = 0;
            locator->FindClosestPoint(far.data(), x, cell, subId, squared);
            const Vec3 met(x[0], x[1], x[2]);
            const Vec3 in = (met - far).normalized();
            const double pressed = std::min(1.0, i / 200.0);
            const Vec3 hip = met + in * (depth * pressed - 0.02 * size * (1 - pressed));
            const TickResult r = palpator.step(hip, 1e-3);
            const auto where = [&] { return QString("%1, tick %2").arg(QString::fromStdString(name)).arg(i); };
            QVERIFY2(r.status == haptics::TickStatus::Converged, qPrintable(where()));
            if (r.constraints == 0) {
                continue;
            }
            ++contacts;
            Vec3 god = r.p_WG;
            const double signedDistance = distance->EvaluateFunction(god.data());
            QVERIFY2(signedDistance > -kInside_mm,
                     qPrintable(QString("%1: %2 mm inside").arg(where()).arg(-signedDistance)));
            if (i % 50 == 0) {
                checkResidual(surface.mesh, god, hip, 0.01 * size, random, where());
            }
            if (QTest::currentTestFailed()) {
                return;
            }
        }
        QVERIFY2(contacts > kTicks / 4,
                 qPrintable(QString("%1: %2 contacts").arg(QString::fromStdString(name)).arg(contacts)));
    }

    static void checkResidual(const geometry::TriangleMesh& mesh, const Vec3& god, const Vec3& hip, double reach,
                              std::mt19937& random, const QString& where)
    {
        std::normal_distribution<double> normal;
        std::vector<std::uint32_t> near;
        for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
            core::Box box;
            for (const std::uint32_t v : mesh.triangles[i]) {
                box.extend(mesh.vertices[v]);
            }
            if (box.squaredExteriorDistance(god) <= reach * reach) {
                near.push_back(i);
            }
        }
        const double spring = (hip - god).norm();
        const Vec3 straight = (hip - god) / spring;
        for (int q = 0; q < 100; ++q) {
            const Vec3 u = (straight * std::abs(normal(random)) + Vec3(normal(random), normal(random), normal(random)))
                               .normalized();
            for (const double share : {1.0, 0.1}) {
                const Vec3 to = god + u * std::min(reach, std::max(0.0, u.dot(straight)) * spring) * share;
                const double closer = spring - (hip - to).norm();
                QVERIFY2(closer <= 1e-6 || isBlocked(mesh, near, god, to),
                         qPrintable(QString("%1: %2 mm closer").arg(where).arg(closer)));
            }
        }
    }
};

PALPATE_TEST(ClosedMeshes)
#include "tst_ClosedMeshes.moc"

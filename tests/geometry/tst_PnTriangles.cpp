// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes.h"
#include "TestRunner.h"
#include "Trials.h"

#include <palpate/geometry/PnTriangles.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace palpate;
using namespace palpate::test;
using geometry::PnOptions;
using geometry::PnSurface;
using geometry::pnTriangles;
using geometry::repair;
using geometry::RepairedMesh;

namespace {

constexpr double kPi = std::numbers::pi;

/// Closed cylinder around z with flat ends, `sides` strips of `rows` squares.
TriangleMesh cylinder(int sides, int rows, double radius_mm, double height_mm)
{
    TriangleMesh mesh;
    for (int row = 0; row <= rows; ++row) {
        for (int i = 0; i < sides; ++i) {
            const double a = 2.0 * kPi * i / sides;
            mesh.vertices.emplace_back(radius_mm * std::cos(a), radius_mm * std::sin(a), height_mm * row / rows);
        }
    }
    const auto at = [sides](int row, int i) { return static_cast<std::uint32_t>(row * sides + i % sides); };
    for (int row = 0; row < rows; ++row) {
        for (int i = 0; i < sides; ++i) {
            mesh.triangles.push_back({at(row, i), at(row, i + 1), at(row + 1, i + 1)});
            mesh.triangles.push_back({at(row, i), at(row + 1, i + 1), at(row + 1, i)});
        }
    }
    const auto low = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back(0.0, 0.0, 0.0);
    mesh.vertices.emplace_back(0.0, 0.0, height_mm);
    for (int i = 0; i < sides; ++i) {
        mesh.triangles.push_back({low, at(0, i + 1), at(0, i)});
        mesh.triangles.push_back({low + 1, at(rows, i), at(rows, i + 1)});
    }
    return mesh;
}

constexpr double kRadius_mm = 30.0;

/// Largest distance of the facets from the sphere as a share of its radius, at corners, edge middles and centres.
double errorOfSphere(const TriangleMesh& mesh)
{
    double most = 0.0;
    for (const geometry::Triangle& t : mesh.triangles) {
        const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        for (const Vec3& p :
             {a, b, c, Vec3((a + b) / 2), Vec3((b + c) / 2), Vec3((c + a) / 2), Vec3((a + b + c) / 3)}) {
            most = std::max(most, std::abs(p.norm() / kRadius_mm - 1.0));
        }
    }
    return most;
}

/// Largest angle between a facet's normal and the sphere's at its centre and its corners [degree].
double turnOfSphere(const TriangleMesh& mesh)
{
    double most = 0.0;
    for (const geometry::Triangle& t : mesh.triangles) {
        const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        const Vec3 normal = (b - a).cross(c - a).normalized();
        for (const Vec3& p : {a, b, c, Vec3((a + b + c) / 3)}) {
            most = std::max(most, std::atan2(normal.cross(p).norm(), normal.dot(p)) * 180.0 / kPi);
        }
    }
    return most;
}

bool isSame(const TriangleMesh& a, const TriangleMesh& b)
{
    return a.vertices == b.vertices && a.triangles == b.triangles;
}

} // namespace

class PnTriangles : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void makesASphereRound()
    {
        if (kIsSanitized) {
            QSKIP("an accuracy, which no sanitizer judges");
        }
        const RepairedMesh coarse = repair(sphere(8, kRadius_mm));
        QCOMPARE(coarse.mesh.triangles.size(), std::size_t{1280});
        PnOptions fine;
        fine.turn_deg = 0.4;
        fine.mostPieces = 64;
        fine.leastPiece_mm = 1e-3;
        const PnSurface limit = pnTriangles(coarse, fine), usual = pnTriangles(coarse);
        QVERIFY(limit.surface && usual.surface);
        qInfo(
            "1,280 facets: %.3g, %.3g deg; usual, %zu triangles: %.3g, %.3g deg; limit, %zu triangles: %.3g, %.3g deg",
            errorOfSphere(coarse.mesh), turnOfSphere(coarse.mesh), usual.triangles, errorOfSphere(usual.surface->mesh),
            turnOfSphere(usual.surface->mesh), limit.triangles, errorOfSphere(limit.surface->mesh),
            turnOfSphere(limit.surface->mesh));
        QVERIFY(errorOfSphere(limit.surface->mesh) < 5e-5);
        // The patches' own error, and the sagitta at the centre of an equilateral piece whose edge is 1/16 of the
        // longest of the coarse facets, 10.5°.
        const double piece = 10.5 / 16.0 * kPi / 180.0;
        QVERIFY(errorOfSphere(usual.surface->mesh) < 3.2e-5 + piece * piece / 6.0);
        QVERIFY(turnOfSphere(usual.surface->mesh) < 0.7);
        QVERIFY(usual.surface->report.isClosed());
        const double volume_mm3 = 4.0 / 3.0 * kPi * std::pow(kRadius_mm, 3);
        QVERIFY(std::abs(usual.surface->report.volume_mm3 / volume_mm3 - 1.0) < 1e-4);
        QCOMPARE(usual.flatTriangles, std::size_t{0});
        QCOMPARE(usual.triangles, usual.surface->mesh.triangles.size());
    }

    void theNormalsOfASphereAreExact()
    {
        if (kIsSanitized) {
            QSKIP("an accuracy, which no sanitizer judges");
        }
        // Max's weights: even the vertices of an icosahedron's division, with five unequal triangles around, are exact,
        // so that halving the edges divides the error of the patches by about 16 (it is of fourth order).
        PnOptions fine;
        fine.turn_deg = 0.4;
        fine.mostPieces = 64;
        fine.leastPiece_mm = 1e-3;
        const double coarse = errorOfSphere(pnTriangles(repair(sphere(4, kRadius_mm)), fine).surface->mesh);
        fine.turn_deg = 0.3;
        const double half = errorOfSphere(pnTriangles(repair(sphere(8, kRadius_mm)), fine).surface->mesh);
        qInfo("320 facets: %.3g, 1,280 facets: %.3g", coarse, half);
        QVERIFY(coarse / half > 11.0 && coarse / half < 21.0);
    }

    void keepsFlatAndSharpPartsBitForBit()
    {
        for (const int n : {1, 3}) {
            const RepairedMesh cube = repair(box(Vec3(-1, -2, -3), Vec3(1.1, 2.3, 3.7), n));
            const PnSurface same = pnTriangles(cube);
            QVERIFY(!same.surface);
            QCOMPARE(same.triangles, cube.mesh.triangles.size());
        }
        const RepairedMesh open = repair(sheet(10.0, 4));
        QVERIFY(!pnTriangles(open).surface);
    }

    void keepsSharpEdgesOfARoundedShape()
    {
        const RepairedMesh coarse = repair(cylinder(24, 4, 10.0, 20.0));
        const PnSurface round = pnTriangles(coarse);
        QVERIFY(round.surface && round.surface->report.isClosed());
        double most = 0.0, cap = 0.0;
        for (const geometry::Triangle& t : round.surface->mesh.triangles) {
            Vec3 middle = Vec3::Zero();
            for (const std::uint32_t v : t) {
                middle += round.surface->mesh.vertices[v] / 3.0;
            }
            if (middle.z() > 5.1 && middle.z() < 14.9) { // away from the straight rims
                most = std::max(most, std::abs(std::hypot(middle.x(), middle.y()) - 10.0));
            }
            cap = std::max({cap, -middle.z(), middle.z() - 20.0});
        }
        qInfo("cylinder of 24 sides: %.3g mm from the true one (facets: %.3g mm)", most,
              10.0 * (1.0 - std::cos(kPi / 24)));
        QVERIFY(most < 0.005);
        QVERIFY(cap < 1e-12); // the ends stay flat
    }

    void dividesOnlyBelowTheCreaseAngle()
    {
        PnOptions options;
        const RepairedMesh prism = repair(cylinder(8, 1, 10.0, 20.0)); // facets that meet at 45°
        QVERIFY(!pnTriangles(prism, options).surface);
        options.crease_deg = 50.0;
        QVERIFY(pnTriangles(prism, options).surface.has_value());
        options.crease_deg = 0.0;
        QVERIFY(!pnTriangles(repair(sphere(4, kRadius_mm)), options).surface);
    }

    void closesEverySeamBetweenUnequalNumbersOfPieces()
    {
        for (const double bump : {0.02, 0.1, 0.3}) {
            const RepairedMesh bumpy = repair(bumpySphere(6, 30.0, bump));
            const PnSurface round = pnTriangles(bumpy);
            QVERIFY(round.surface.has_value());
            QCOMPARE(round.surface->report.openEdges, std::size_t{0});
            QCOMPARE(round.surface->report.nonManifoldEdges, std::size_t{0});
            QCOMPARE(round.surface->report.zeroAreaTriangles, std::size_t{0});
            QVERIFY(round.surface->report.isClosed());
        }
    }

    void carriesArraysSourcesAndSides()
    {
        TriangleMesh mesh = sphere(4, 10.0);
        geometry::MeshArray heights{"height", false, {}}, numbers{"number", true, {}};
        for (const Vec3& p : mesh.vertices) {
            heights.values.push_back(p.z() > 9.5 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(p.z()));
        }
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            numbers.values.push_back(static_cast<float>(i));
        }
        mesh.arrays = {heights, numbers};
        const RepairedMesh coarse = repair(mesh);
        const PnSurface round = pnTriangles(coarse);
        QVERIFY(round.surface.has_value());
        const TriangleMesh& out = round.surface->mesh;
        QCOMPARE(out.arrays[0].values.size(), out.vertices.size());
        QCOMPARE(out.arrays[1].values.size(), out.triangles.size());
        std::size_t unknown = 0;
        for (std::size_t v = 0; v < out.vertices.size(); ++v) {
            const double value = double{out.arrays[0].values[v]};
            unknown += std::isnan(value) ? 1 : 0;
            QVERIFY(std::isnan(value) || std::abs(value - out.vertices[v].z()) < 0.5);
        }
        QVERIFY(unknown > 1 && unknown < out.vertices.size() / 8);
        for (std::size_t i = 0; i < out.triangles.size(); ++i) {
            QCOMPARE(static_cast<std::uint32_t>(out.arrays[1].values[i]), round.surface->source[i]);
        }
        QCOMPARE(round.surface->twoSided.size(), out.triangles.size());
        QCOMPARE(round.surface->report.inputTriangles, coarse.report.inputTriangles);
    }

    void refusesTooManyTriangles()
    {
        PnOptions few;
        few.mostTriangles = 1'000;
        const PnSurface refused = pnTriangles(repair(sphere(4, kRadius_mm)), few);
        QVERIFY(refused.isRefused && !refused.surface && refused.triangles > few.mostTriangles);
    }

    void keepsFacetsWithContradictoryNormalsFlat()
    {
        // A fan like a folded umbrella: each facet meets the next at less than the crease angle, but the mean normal is
        // far from each.
        TriangleMesh umbrella;
        umbrella.vertices.emplace_back(0.0, 0.0, 10.0);
        constexpr int kRibs = 40;
        for (std::uint32_t i = 0; i < kRibs; ++i) {
            const double a = 2.0 * kPi * i / kRibs;
            umbrella.vertices.emplace_back(std::cos(a), std::sin(a), 0.0);
            umbrella.triangles.push_back({0, i + 1, (i + 1) % kRibs + 1});
        }
        const RepairedMesh folded = repair(umbrella);
        const PnSurface same = pnTriangles(folded);
        QCOMPARE(same.flatTriangles, std::size_t{kRibs});
        QVERIFY(!same.surface);
    }

    void dividesLessWhereItWouldBecomeTooMany()
    {
        PnOptions options;
        const RepairedMesh coarse = repair(sphere(8, kRadius_mm));
        const std::size_t fine = pnTriangles(coarse, options).triangles;
        options.manyTriangles = fine - 1;
        const std::size_t few = pnTriangles(coarse, options).triangles;
        QVERIFY2(few < fine / 3 && few > fine / 5, qPrintable(QString::number(few)));
        // No piece is shorter than 0.1 mm: edges of 0.15 mm are not divided.
        const PnSurface tiny = pnTriangles(repair(sphere(8, 1.0)));
        QVERIFY(!tiny.surface);
    }

    void isDeterministic()
    {
        const RepairedMesh bumpy = repair(bumpySphere(8, 30.0, 0.1));
        QVERIFY(isSame(pnTriangles(bumpy).surface->mesh, pnTriangles(bumpy).surface->mesh));
    }
};

PALPATE_TEST(PnTriangles)
#include "tst_PnTriangles.moc"

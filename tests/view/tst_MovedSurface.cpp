// SPDX-License-Identifier: BSD-3-Clause
// Moving structures in the view: drawn and picked where the hand feels them. Nothing is rendered.
#include "../support/Motions.h"
#include "Balls.h"
#include "TestRunner.h"

#include <palpate/view/SceneView.h>
#include <palpate/view/SurfaceMesh.h>

#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>

#include <QElapsedTimer>

#include <algorithm>
#include <cmath>
#include <random>

using namespace palpate;
using core::Vec3;
using geometry::SurfaceMotion;
using Motion = std::shared_ptr<const SurfaceMotion>;

namespace {

const core::Box kBox(Vec3::Constant(-40), Vec3::Constant(40));

Motion breathing()
{
    geometry::Breath breath;
    breath.amplitude_mm = Vec3(0, -3, -15);
    breath.still_W = Vec3(0, 0, -50);
    breath.full_W = Vec3(0, 0, 60);
    return SurfaceMotion::breath(breath, kBox).value();
}

vtkPolyData& drawn(const view::StructureActor& actor)
{
    return *vtkPolyDataMapper::SafeDownCast(actor.actor()->GetMapper())->GetInput();
}

/// Largest distance of a drawn vertex from where the hand feels it [mm].
double farthest(const view::StructureActor& actor, const geometry::RepairedMesh& rest, const SurfaceMotion& motion,
                double time_s)
{
    // A ball has no sharp edges: a point per vertex, in the same order.
    const std::vector<Vec3> places = motion.placesAt(time_s, rest.mesh.vertices);
    double most_mm = places.size() == static_cast<std::size_t>(actor.points().GetNumberOfPoints()) ? 0.0 : 1e9;
    for (std::size_t i = 0; i < places.size() && most_mm < 1e9; ++i) {
        most_mm = std::max(most_mm, (Vec3(actor.points().GetPoint(static_cast<vtkIdType>(i))) - places[i]).norm());
    }
    return most_mm;
}

} // namespace

class MovedSurface : public QObject
{
    Q_OBJECT

    const geometry::RepairedMesh m_ball = geometry::repair(test::ball(30.0, 4));

    [[nodiscard]] std::unique_ptr<view::SceneView> shown() const
    {
        auto view = std::make_unique<view::SceneView>();
        std::vector<view::ViewStructure> structures;
        structures.push_back({view::StructureActor(view::makeSurface(m_ball)),
                              std::make_shared<const geometry::SurfaceIndex>(geometry::SurfaceIndex::build(m_ball))});
        view->setStructures(std::move(structures));
        return view;
    }

  private Q_SLOTS:
    void isDrawnWhereTheHandFeelsIt()
    {
        constexpr double kSingle_mm = 1e-5; // single precision
        view::StructureActor actor(view::makeSurface(m_ball));
        for (const Motion& motion :
             {breathing(), test::randomMotion(kBox, 15.0, 3, 7), test::oscillation({9, 0, 4}, 0.5)}) {
            for (const double time_s : {0.0, 0.4, 1.3, 2.0, 3.1}) {
                actor.moveTo(motion, time_s);
                (void)actor.follow();
                const double off_mm = farthest(actor, m_ball, *motion, time_s);
                QVERIFY2(off_mm < kSingle_mm, qPrintable(QString::number(off_mm)));
            }
        }
        QVERIFY((Vec3(actor.points().GetPoint(5)) - m_ball.mesh.vertices[5]).norm() > 1.0); // not by chance at rest
        actor.moveTo(nullptr, 0.0);
        QVERIFY(actor.follow());
        QVERIFY((Vec3(actor.points().GetPoint(5)) - m_ball.mesh.vertices[5]).norm() < kSingle_mm);
        QVERIFY(!actor.follow());
    }

    /// As on the moved mesh itself, but for what the smoothing of facets differs.
    void hasTheNormalsOfTheMovedShape()
    {
        const Motion motion = test::randomMotion(kBox, 25.0, 3, 7);
        view::StructureActor actor(view::makeSurface(m_ball));
        actor.moveTo(motion, 1.3);
        (void)actor.follow();
        geometry::RepairedMesh moved = m_ball;
        moved.mesh.vertices = motion->placesAt(1.3, m_ball.mesh.vertices);
        const auto is = view::makeSurface(moved);
        const auto rest = view::makeSurface(m_ball);
        double most = 0.0, turned = 0.0;
        for (vtkIdType i = 0; i < is->GetNumberOfPoints(); ++i) {
            const Vec3 n(drawn(actor).GetPointData()->GetNormals()->GetTuple3(i));
            most = std::max(most, (n - Vec3(is->GetPointData()->GetNormals()->GetTuple3(i))).norm());
            turned = std::max(turned, (n - Vec3(rest->GetPointData()->GetNormals()->GetTuple3(i))).norm());
            QVERIFY(std::abs(n.norm() - 1.0) < 1e-5);
        }
        QVERIFY2(most < 0.03 && turned > 0.1, qPrintable(QString("%1 %2").arg(most).arg(turned)));
    }

    void heldBreathStandsStillAndAmplitudeZeroRests()
    {
        const Motion motion = breathing();
        const Motion held = motion->changedAt(1.0, 0.3, {0.0, 1.0, 1.0}),
                     flat = motion->changedAt(1.0, 0.3, {1.0, 1.0, 0.0});
        view::StructureActor actor(view::makeSurface(m_ball));
        actor.moveTo(held, 1.4);
        QVERIFY(actor.follow());
        const Vec3 p(actor.points().GetPoint(7));
        QVERIFY((p - m_ball.mesh.vertices[7]).norm() > 0.5);
        for (const double time_s : {1.5, 2.7, 60.0}) {
            actor.moveTo(held, time_s);
            QVERIFY(!actor.follow()); // nothing to draw
            QVERIFY(Vec3(actor.points().GetPoint(7)) == p);
        }
        const auto rest = view::makeSurface(m_ball);
        for (const double time_s : {1.4, 2.0, 33.0}) {
            actor.moveTo(flat, time_s);
            (void)actor.follow();
            for (vtkIdType i = 0; i < rest->GetNumberOfPoints(); ++i) {
                QVERIFY(Vec3(actor.points().GetPoint(i)) == Vec3(rest->GetPoint(i)));
            }
        }
    }

    void coloursTravel()
    {
        view::StructureActor actor(view::makeSurface(m_ball));
        actor.moveTo(breathing(), 2.0);
        QVERIFY(actor.follow());
        const Vec3 p(actor.points().GetPoint(3));
        auto coloured = vtkSmartPointer<vtkPolyData>::New();
        coloured->ShallowCopy(view::makeSurface(m_ball));
        vtkNew<vtkFloatArray> values;
        values->SetNumberOfTuples(coloured->GetNumberOfPoints());
        values->Fill(0.5);
        coloured->GetPointData()->SetScalars(values);
        actor.setPicture(coloured);
        QVERIFY(Vec3(actor.points().GetPoint(3)) == p); // at once
        QVERIFY(drawn(actor).GetPointData()->GetScalars() == values.Get());
        QVERIFY(Vec3(coloured->GetPoint(3)) != p); // the picture of the rest shape is not changed
    }

    /// A large picture is computed elsewhere: no call takes long, and the place comes.
    void largePictureDoesNotBlock()
    {
        const geometry::RepairedMesh large = geometry::repair(test::ball(30.0, 7)); // 163,842 vertices
        view::StructureActor actor(view::makeSurface(large));
        QVERIFY(large.mesh.vertices.size() > view::StructureActor::kMostAtOnce);
        const Motion motion = breathing();
        actor.moveTo(motion, 1.3);
        QVERIFY(!actor.follow()); // started
        bool isThere = false;
        PALPATE_TRY_VERIFY((isThere = isThere || actor.follow()));
        QVERIFY(farthest(actor, large, *motion, 1.3) < 1e-5);
        QVERIFY(!actor.follow());
    }

    /// A ray meets the moved surface, as on a mesh whose vertices were moved.
    void isPickedWhereItIsDrawn()
    {
        const auto view = shown();
        std::mt19937 random(3);
        std::uniform_real_distribution<double> of(-1.0, 1.0);
        int hits = 0;
        for (const Motion& motion :
             {breathing(), test::randomMotion(kBox, 15.0, 3, 7), test::oscillation({9, 0, 4}, 0.5)}) {
            view->moveTo({motion}, 1.7);
            (void)view->follow();
            geometry::TriangleMesh moved = m_ball.mesh;
            moved.vertices = motion->placesAt(1.7, m_ball.mesh.vertices);
            core::Box bounds;
            for (const Vec3& v : moved.vertices) {
                bounds.extend(v);
            }
            for (int i = 0; i < 60; ++i) {
                const Vec3 from = 120.0 * Vec3(of(random), of(random), of(random)).normalized();
                const view::Ray ray{from, (28.0 * Vec3(of(random), of(random), of(random)) - from).normalized()};
                const auto pick = view->pick(ray);
                const auto is = view::firstHit(moved, bounds, ray);
                if (!pick || !is) {
                    continue; // at the silhouette, a facet and its curved image differ
                }
                ++hits;
                // A facet of 2 mm bends with the motion, by a curvature of up to 0.14 / mm; the moved mesh has flat
                // ones.
                const double glancing = std::abs(is->n_W.dot(ray.d_W));
                QVERIFY2(std::abs(pick->hit.distance_mm - is->distance_mm) * glancing < 0.07,
                         qPrintable(QString("%1 %2").arg(pick->hit.distance_mm).arg(is->distance_mm)));
                QVERIFY((pick->hit.p_W - (ray.p_W + pick->hit.distance_mm * ray.d_W)).norm() < 1e-9);
                const auto moment = motion->at(1.7);
                QVERIFY((motion->toWorld(moment, pick->hit.rest_W) - pick->hit.p_W).norm() < 1e-8);
                QVERIFY(pick->hit.n_W.dot(is->n_W) > 0.98 && !pick->hit.isBehind);
            }
        }
        QVERIFY(hits > 120);
    }

    void findingsAndRingTravel()
    {
        const auto view = shown();
        const Motion motion = breathing();
        const Vec3 rest(0, -30, 0), note(5, 5, 5);
        view->findings().set(
            {{rest, core::FindingType::Lump, 1, "on it", 0}, {note, core::FindingType::Other, 2, "free"}});
        view->placeRing().show(rest, -Vec3::UnitY(), 4.0, 0);
        view->targets().set(
            {{rest, -Vec3::UnitY(), 3.0, "on it: missed", false, 0}, {note, Vec3::UnitZ(), 2.0, "free", true, {}}});
        view->moveTo({motion}, 1.8);
        (void)view->follow();
        const Vec3 now = motion->toWorld(motion->at(1.8), rest);
        QVERIFY((now - rest).norm() > 5.0);
        QVERIFY((view->findings().marks()[0].p_W - now).norm() < 1e-12);
        QVERIFY(view->findings().marks()[1].p_W == note);
        QVERIFY((view->targets().place_W(0) - now).norm() < 1e-12);
        QVERIFY(view->targets().place_W(1) == note);
        const auto restOf = view->structure(0).picture.restOf(now);
        QVERIFY((restOf - rest).norm() < 1e-8);
        view->moveTo({}, 0.0);
        (void)view->follow();
        QVERIFY(view->findings().marks()[0].p_W == rest);
        QVERIFY(view->targets().place_W(0) == rest);
    }
};

PALPATE_TEST(MovedSurface)
#include "tst_MovedSurface.moc"

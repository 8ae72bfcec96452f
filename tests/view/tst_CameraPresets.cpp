// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/view/CameraPresets.h>

#include <vtkNew.h>

#include <cmath>
#include <numbers>

using namespace palpate;
using core::Vec3;
using view::ViewFrom;

Q_DECLARE_METATYPE(palpate::view::ViewFrom)

class CameraPresets : public QObject
{
    Q_OBJECT
  private Q_SLOTS:
    void standsWhereThePatientSideIs_data()
    {
        QTest::addColumn<ViewFrom>("from");
        QTest::addColumn<int>("axis");
        QTest::addColumn<int>("sign");
        QTest::newRow("front is -y") << ViewFrom::Front << 1 << -1;
        QTest::newRow("back is +y") << ViewFrom::Back << 1 << 1;
        QTest::newRow("left is +x") << ViewFrom::Left << 0 << 1;
        QTest::newRow("right is -x") << ViewFrom::Right << 0 << -1;
        QTest::newRow("head is +z") << ViewFrom::Head << 2 << 1;
        QTest::newRow("feet are -z") << ViewFrom::Feet << 2 << -1;
    }
    void standsWhereThePatientSideIs()
    {
        QFETCH(ViewFrom, from);
        QFETCH(int, axis);
        QFETCH(int, sign);
        vtkNew<vtkCamera> camera;
        const core::Box box(Vec3(10, 20, 30), Vec3(110, 70, 60));
        view::lookFrom(*camera, from, box, 1.5);
        const Vec3 out = (Vec3(camera->GetPosition()) - box.center()).normalized();
        QVERIFY(out[axis] * sign > 0.999);
        QVERIFY((Vec3(camera->GetFocalPoint()) - box.center()).norm() < 1e-9);
        const Vec3 up(camera->GetViewUp());
        QVERIFY(axis == 2 ? up.y() < -0.999 : up.z() > 0.999);
    }
    void wholeBoxIsInView_data()
    {
        QTest::addColumn<double>("aspect");
        QTest::newRow("wide") << 2.2;
        QTest::newRow("square") << 1.0;
        QTest::newRow("narrow") << 0.5;
    }
    void wholeBoxIsInView()
    {
        QFETCH(double, aspect);
        vtkNew<vtkCamera> camera;
        const core::Box box(Vec3(-100, -20, -5), Vec3(100, 20, 5));
        view::lookFrom(*camera, ViewFrom::Oblique, box, aspect);
        const Vec3 eye(camera->GetPosition());
        const Vec3 back = (eye - Vec3(camera->GetFocalPoint())).normalized();
        const Vec3 right = Vec3(camera->GetViewUp()).cross(back).normalized();
        const Vec3 up = back.cross(right);
        const double tangent = std::tan(camera->GetViewAngle() * std::numbers::pi / 360.0);
        double fullest = 0.0;
        for (int i = 0; i < 8; ++i) {
            const Vec3 p = box.corner(static_cast<core::Box::CornerType>(i)) - eye;
            const double depth = -p.dot(back);
            QVERIFY(depth > 0.0);
            fullest = std::max({fullest, std::abs(p.dot(right)) / (depth * tangent * aspect),
                                std::abs(p.dot(up)) / (depth * tangent)});
        }
        QVERIFY(fullest <= 1.0);
        QVERIFY(fullest > 0.7); // and large enough in the view
    }
    void emptySceneChangesNothing()
    {
        vtkNew<vtkCamera> camera;
        const Vec3 before(camera->GetPosition());
        view::fit(*camera, core::Box(), 1.0);
        QCOMPARE(Vec3(camera->GetPosition()), before);
    }

    void turnsAboutTheFocusAndShiftsAlongTheScreen()
    {
        vtkNew<vtkCamera> camera;
        const core::Box box(core::Vec3(-10, -10, -10), core::Vec3(10, 10, 10));
        view::lookFrom(*camera, view::ViewFrom::Front, box, 1.5);
        const double distance_mm = camera->GetDistance();
        for (int i = 0; i < 6; ++i) {
            view::turn(*camera, 15.0, 0.0);
        }
        // From the front by 90° to the viewer's right: the patient's left.
        QVERIFY((core::Vec3(camera->GetPosition()) - distance_mm * core::Vec3::UnitX()).norm() < 1e-6);
        for (int i = 0; i < 24; ++i) { // over the head and around
            view::turn(*camera, 0.0, 15.0);
        }
        QVERIFY((core::Vec3(camera->GetPosition()) - distance_mm * core::Vec3::UnitX()).norm() < 1e-6);
        view::lookFrom(*camera, view::ViewFrom::Front, box, 1.5);
        view::shift(*camera, 0.0, 0.5);
        QVERIFY(camera->GetFocalPoint()[2] > 5.0 && std::abs(camera->GetFocalPoint()[0]) < 1e-9);
        QVERIFY(std::abs(camera->GetDistance() - distance_mm) < 1e-9);
        view::shift(*camera, 0.25, 0.0);
        QVERIFY(camera->GetFocalPoint()[0] > 2.0);
    }
};

PALPATE_TEST(CameraPresets)
#include "tst_CameraPresets.moc"

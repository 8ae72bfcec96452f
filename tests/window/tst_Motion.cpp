// SPDX-License-Identifier: BSD-3-Clause
// Breathing tissue in the window. Needs a display.
#include "Desk.h"
#include "TestRunner.h"
#include "window/MainWindow.h"

#include <palpate/geometry/SurfaceDistance.h>
#include <palpate/ui/ActionList.h>
#include <palpate/ui/PalpationController.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/ui/VtkViewport.h>

#include <QDockWidget>
#include <QFile>
#include <QSettings>

#include <algorithm>
#include <filesystem>
#include <system_error>

using namespace palpate;
using core::Vec3;

class Motion : public QObject
{
    Q_OBJECT

    test::Desk m_desk;

    [[nodiscard]] MainWindow& window() { return m_desk.window(); }
    [[nodiscard]] const view::StructureActor& liver() { return window().viewport().view().structure(0).picture; }
    [[nodiscard]] const meshio::LoadedStructure& loaded() { return window().model().rows()[0].loaded; }

    /// Writes the breathing phantom with its lumps as layers and the liver opaque, which saves computing how
    /// lumps feel from outside and sorting translucent surfaces.
    [[nodiscard]] std::filesystem::path breathingPhantom() const
    {
        const std::filesystem::path phantom = std::filesystem::path(PALPATE_SOURCE_DIR) / "data" / "phantom";
        std::error_code error;
        std::filesystem::copy_file(phantom / "phantom.vtp", m_desk.folder() / "phantom.vtp", error);
        QFile from(phantom / "phantom-breathing.palpate.json"), to(m_desk.folder() / "breathing.palpate.json");
        if (from.open(QIODevice::ReadOnly) && to.open(QIODevice::WriteOnly)) {
            QByteArray scene = from.readAll().replace(R"("buried": "felt")", R"("buried": "layers")");
            to.write(scene.replace(R"("opacity": 0.45)", R"("opacity": 1.0)"));
        }
        return to.filesystemFileName();
    }

    /// Largest distance of a drawn point from the nearest vertex where the hand feels it, of a sample [mm].
    [[nodiscard]] double farthest()
    {
        const auto places = loaded().motion->placesAt(liver().time_s(), loaded().surface->mesh.vertices);
        double most_mm = 0.0;
        for (vtkIdType i = 0; i < liver().points().GetNumberOfPoints(); i += 97) {
            const Vec3 p(liver().points().GetPoint(i));
            double least_mm = 1e9;
            for (const Vec3& place : places) {
                least_mm = std::min(least_mm, (place - p).norm());
            }
            most_mm = std::max(most_mm, least_mm);
        }
        return most_mm;
    }

  private Q_SLOTS:
    void initTestCase()
    {
        if (!test::Desk::hasDisplay()) {
            QSKIP(test::Desk::kNoDisplay);
        }
    }

    void isDrawnHeldAndPressed()
    {
        QSettings().setValue(QStringLiteral("fingertip_mm"), 0.0); // a point
        QVERIFY(m_desk.show({720, 480}));
        auto* panel = window().findChild<QDockWidget*>(QStringLiteral("motion"));
        QVERIFY(panel != nullptr && !panel->isVisible());
        QVERIFY(!m_desk.command("hold-breath").isEnabled());
        QVERIFY(m_desk.open({breathingPhantom()}));
        QVERIFY(panel->isVisible() && m_desk.command("hold-breath").isEnabled());

        // Drawn at the newest tick.
        PALPATE_TRY_VERIFY(liver().moved().motion != nullptr && liver().time_s() > 0.3);
        QVERIFY2(farthest() < 1e-4, qPrintable(QString::number(farthest())));

        // Held: no more frames with other places.
        m_desk.pressKeyOf("hold-breath");
        PALPATE_TRY_VERIFY(loaded().motion->pace().rate == 0.0);
        PALPATE_TRY_VERIFY(liver().time_s() > loaded().motion->settled_s() + 0.1);
        const Vec3 held(liver().points().GetPoint(11));
        const double from_s = liver().time_s();
        PALPATE_TRY_VERIFY(liver().time_s() > from_s + 0.3);
        QVERIFY(Vec3(liver().points().GetPoint(11)) == held);
        QVERIFY(farthest() < 1e-4);

        // The god-object of a pressing hand is on the surface as drawn.
        window().setPalpating(true);
        ui::VtkViewport& viewport = window().viewport();
        window().palpation().pressAt({0.5 * viewport.width(), 0.5 * viewport.height()});
        const view::TouchState& state = viewport.view().cursor().state();
        PALPATE_TRY_VERIFY(state.isInContact && (state.p_WG - state.p_WH).norm() > 2.0);
        const Vec3 rest = liver().restOf(state.p_WG);
        const auto nearest = geometry::nearestPoint(*viewport.view().structure(0).touchable, rest);
        QVERIFY(nearest.has_value());
        QVERIFY2(nearest->distance_mm < 1e-3, qPrintable(QString::number(nearest->distance_mm)));
        window().setPalpating(false);
    }
};

PALPATE_TEST(Motion)
#include "tst_Motion.moc"

// SPDX-License-Identifier: BSD-3-Clause
#include "Desk.h"
#include "TestRunner.h"

#include <palpate/session/MeasureSession.h>
#include <palpate/study/RecordedScene.h>
#include <palpate/ui/ActionList.h>
#include <palpate/ui/Playback.h>
#include <palpate/ui/TouchMap.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QLabel>
#include <QSignalSpy>
#include <QToolTip>

#include <algorithm>
#include <cmath>

using namespace palpate;

/// Tests the map of touch in the whole window: the sums are those of the results, up to the moment shown.
class TouchMap : public QObject
{
    Q_OBJECT

    std::unique_ptr<test::Desk> m_desk;

    ui::TouchMap& map() { return *m_desk->window().findChild<ui::TouchMap*>(); }
    ui::Playback& playback() { return *m_desk->window().findChild<ui::Playback*>(); }
    view::ColourLegend& legend() { return m_desk->window().viewport().view().legend(); }
    QString title() { return QString::fromStdString(legend().texts()[0]); }
    void seek(double time_s)
    {
        playback().seek(time_s);
        PALPATE_TRY_VERIFY(map().sums() != nullptr && std::abs(map().sums()->time_s - time_s) < 1e-6);
    }
    /// Greatest value of all surfaces.
    float greatest(std::vector<float> ui::TouchedStructure::*values)
    {
        float greatest = 0.0F;
        for (const auto& [key, one] : map().sums()->structures) {
            greatest = std::max(greatest, *std::max_element((one.*values).begin(), (one.*values).end()));
        }
        return greatest;
    }

  private Q_SLOTS:
    void initTestCase()
    {
        if (!test::Desk::hasDisplay()) {
            QSKIP(test::Desk::kNoDisplay);
        }
        m_desk = std::make_unique<test::Desk>();
        QVERIFY(m_desk->show());
        QVERIFY(!m_desk->command("touch-map-next").isEnabled()); // without a scene
        QVERIFY(m_desk->openPhantom());
        m_desk->window().viewport().setFocus();
    }

    void equalsTheResultsAtTheEnd()
    {
        m_desk->pressKeyOf("touch-map-next");
        QCOMPARE(map().quantity(), ui::TouchQuantity::Covered);
        const double end_s = playback().recording()->duration_s();
        seek(end_s);
        const auto reader = session::RecordingReader::open(playback().recording()->path());
        const auto meshes = study::recordedSurfaces(*reader.value());
        QVERIFY(meshes.isOk());
        const auto measured = session::measureSession(
            *reader.value(), meshes.value(), {study::defaultDistance_mm(*reader.value(), meshes.value()), nullptr});
        QVERIFY(measured.isOk());
        int touched = 0;
        for (const session::SurfaceMeasures& one : measured.value().surfaces) {
            if (one.surface == nullptr) {
                continue;
            }
            ++touched;
            const auto found =
                std::find_if(map().sums()->structures.begin(), map().sums()->structures.end(),
                             [&](const auto& structure) { return structure.first.first == one.structure; });
            QVERIFY2(found != map().sums()->structures.end(), one.structure.c_str());
            QCOMPARE(found->second.dwell_s.size(), one.surface->dwell_s().size());
            for (std::size_t v = 0; v < found->second.dwell_s.size(); ++v) {
                QCOMPARE(found->second.dwell_s[v], static_cast<float>(one.surface->dwell_s()[v]));
                QCOMPARE(found->second.peakForce_N[v], static_cast<float>(one.surface->peakForce_N()[v]));
                QCOMPARE(found->second.stiffness_N_per_mm[v], static_cast<float>(one.surface->stiffness_N_per_mm()[v]));
            }
        }
        QVERIFY(touched > 0);
    }

    void growsWithThePlayer()
    {
        seek(4.0);
        const float early_s = greatest(&ui::TouchedStructure::dwell_s);
        seek(8.0);
        const float later_s = greatest(&ui::TouchedStructure::dwell_s);
        QVERIFY(later_s >= early_s);
        seek(0.0);
        QVERIFY(map().sums()->structures.empty() || greatest(&ui::TouchedStructure::dwell_s) < early_s);
        seek(4.0); // again from the start
        QCOMPARE(greatest(&ui::TouchedStructure::dwell_s), early_s);
    }

    /// A structure that is not touched yet has its own opacity, also after the player moved back.
    void movingBackRestoresTheLook()
    {
        const auto liver = [this] { return m_desk->window().viewport().view().structure(0).picture.appearance(); };
        seek(8.0);
        QCOMPARE(liver().opacity, 1.0);
        seek(0.0);
        QVERIFY(map().sums()->structures.empty());
        QVERIFY(liver().opacity < 1.0);
    }

    void legendNamesQuantityMomentAndShare()
    {
        seek(8.0);
        QVERIFY2(title().startsWith("Examined surface\nup to 8.0 s\ntouched: "), qPrintable(title()));
        for (const char* quantity : {"Time spent, s", "Largest force, N", "Stiffness felt, N/mm"}) {
            m_desk->pressKeyOf("touch-map-next");
            QCOMPARE(title().section('\n', 0, 0), quantity);
            const QString folder = qEnvironmentVariable("PALPATE_KEEP_PICTURES");
            if (!folder.isEmpty()) {
                QVERIFY(m_desk->picture().save(folder + '/' + QString(quantity).section(',', 0, 0) + ".png"));
            }
        }
        m_desk->pressKeyOf("touch-map-next");
        QCOMPARE(map().quantity(), ui::TouchQuantity::None);
        QVERIFY(!legend().isShown());
        m_desk->pressKeyOf("touch-map-back");
        QCOMPARE(map().quantity(), ui::TouchQuantity::Stiffness);
        m_desk->pressKeyOf("felt"); // colours the organs, too
        QCOMPARE(map().quantity(), ui::TouchQuantity::None);
        m_desk->pressKeyOf("touch-map-next");
        QVERIFY(!m_desk->command("felt").isChecked());
        PALPATE_TRY_VERIFY(title().startsWith("Examined surface"));
        m_desk->pressKeyOf("distances"); // colours the lump
        QCOMPARE(map().quantity(), ui::TouchQuantity::None);
        m_desk->pressKeyOf("touch-map-next");
        QVERIFY(!m_desk->command("distances").isChecked());
    }

    /// The mouse drags the legend to another corner, which is stored, and closes it; the View menu opens it again.
    void theLegendIsDraggedAndClosed()
    {
        ui::VtkViewport& viewport = m_desk->window().viewport();
        m_desk->pressKeyOf("touch-map-next");
        PALPATE_TRY_VERIFY(!legend().box().isEmpty());
        const auto at = [&](const Eigen::Vector2d& p) {
            return QPoint(qRound(0.5 * viewport.width() + p.x()), qRound(0.5 * viewport.height() - p.y()));
        };
        // A tool tip is a child of the view with a place on the screen, and covers nothing of the view.
        PALPATE_TRY_VERIFY(title().contains("up to"));
        viewport.grabFramebuffer();
        const Eigen::AlignedBox2d shown = legend().box();
        {
            QLabel tip(QStringLiteral("tip"), &viewport, Qt::ToolTip);
            tip.setGeometry(at(shown.center()).x() - 20, viewport.height() / 3, 40, 20);
            tip.show();
            viewport.grabFramebuffer();
            QVERIFY((legend().box().center() - shown.center()).norm() < 0.25 * shown.sizes().y());
        }
        QTest::mouseMove(&viewport, at(shown.center()));
        PALPATE_TRY_VERIFY(QToolTip::isVisible());
        viewport.grabFramebuffer();
        QVERIFY((legend().box().center() - shown.center()).norm() < 0.25 * shown.sizes().y());
        QSignalSpy pressed(&viewport, &ui::VtkViewport::pointerPressed);
        m_desk->command("palpate").setChecked(true); // neither presses on the legend
        QTest::mousePress(&viewport, Qt::LeftButton, {}, at(legend().box().center()));
        const Eigen::Vector2d before = legend().box().center();
        QTest::mouseMove(&viewport, at(before) + QPoint(40, 30));
        PALPATE_TRY_VERIFY((legend().box().center() - before).norm() > 20.0); // follows the pointer
        const QPoint target(viewport.width() - 60, viewport.height() - 60);
        QTest::mouseMove(&viewport, target);
        QTest::mouseRelease(&viewport, Qt::LeftButton, {}, target);
        QCOMPARE(pressed.count(), 0);
        m_desk->command("palpate").setChecked(false);
        using Corner = view::ColourLegend::Corner;
        QVERIFY(viewport.view().legendCorner() == Corner::LowerRight);
        PALPATE_TRY_VERIFY(legend().box().min().x() > 0.0 && legend().box().min().y() < 0.0);
        QVERIFY(m_desk->command("legend-lower-right").isChecked());

        QTest::mouseMove(&viewport, at(legend().box().center()));
        PALPATE_TRY_VERIFY(legend().isHovered());
        QTest::mouseClick(&viewport, Qt::LeftButton, {}, at(legend().closeBox().center()));
        QVERIFY(!legend().isShown());
        QVERIFY(!m_desk->command("legend").isChecked());
        m_desk->pressKeyOf("touch-map-next"); // other colours do not open it
        QVERIFY(!legend().isShown());
        m_desk->command("legend").trigger();
        QVERIFY(legend().isShown());

        QVERIFY(m_desk->show()); // the next start of the program
        QVERIFY(m_desk->window().viewport().view().legendCorner() == Corner::LowerRight);
        QVERIFY(!legend().isClosed());
        m_desk->command("legend-automatic").trigger();
        QVERIFY(!m_desk->window().viewport().view().legendCorner());
    }

    /// A press by the pointer, without a recording.
    void isLiveWithoutARecording()
    {
        const std::filesystem::path phantom = std::filesystem::path(PALPATE_SOURCE_DIR) / "data" / "phantom";
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->open({phantom / "phantom.palpate.json"}));
        m_desk->pressKeyOf("touch-map-next");
        servo::TickRecord tick;
        tick.felt.contactCount = 1;
        tick.felt.contacts[0].structure = 0;
        map().add(tick, 0.016);
        PALPATE_TRY_VERIFY(map().sums() != nullptr);
        QVERIFY2(title().contains("(preview)"), qPrintable(title()));
    }

    /// Another scene takes the map off; colours that are not of this map stay when a recording is opened.
    void leavesOtherColoursAlone()
    {
        const std::filesystem::path phantom = std::filesystem::path(PALPATE_SOURCE_DIR) / "data" / "phantom";
        QVERIFY(legend().isShown());
        QVERIFY(m_desk->open({phantom / "phantom.palpate.json"}));
        QVERIFY(!legend().isShown());
        m_desk->pressKeyOf("felt");
        PALPATE_TRY_VERIFY(legend().isShown());
        m_desk->window().open({phantom / "palpation.palpate"});
        PALPATE_TRY_VERIFY(playback().recording() != nullptr);
        QVERIFY(legend().isShown());
    }
};

PALPATE_TEST(TouchMap)
#include "tst_TouchMap.moc"

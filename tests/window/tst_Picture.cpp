// SPDX-License-Identifier: BSD-3-Clause
#include "Desk.h"
#include "TestRunner.h"

#include <palpate/meshio/LoadScene.h>
#include <palpate/ui/PalpationController.h>
#include <palpate/ui/PointedStructure.h>
#include <palpate/ui/StructurePanel.h>
#include <palpate/ui/TouchPanel.h>
#include <palpate/ui/TouchSound.h>
#include <palpate/ui/VtkViewport.h>

#include <QLabel>

#include <algorithm>
#include <optional>

using namespace palpate;
using core::Vec3;

/// Tests how the view shows contacts and the structure under the pointer, and the keys for camera and pressing, in the
/// full window with the phantom. Screenshots go to the folder in PALPATE_TEST_PICTURES for visual inspection.
class Picture : public QObject
{
    Q_OBJECT

    std::unique_ptr<test::Desk> m_desk;
    std::optional<ui::TouchReading> m_reading;
    Vec3 m_lump_W = Vec3::Zero(); ///< centre of the larger lump

    ui::VtkViewport& viewport() { return m_desk->window().viewport(); }
    ui::PalpationController& palpation() { return m_desk->window().palpation(); }
    const view::TouchState& shown() { return viewport().view().cursor().state(); }

    void keep(const char* name)
    {
        QTest::qWait(700); // the camera has stopped
        const QString folder = qEnvironmentVariable("PALPATE_TEST_PICTURES");
        if (!folder.isEmpty()) {
            QVERIFY(m_desk->picture().save(QStringLiteral("%1/%2.png").arg(folder, QLatin1String(name))));
        }
    }
    /// Returns the view position of the larger lump.
    QPointF overLump() { return viewport().placeOf(m_lump_W); }
    bool sees(const std::vector<Eigen::AlignedBox2d>& boxes)
    {
        const Eigen::Vector2d half(0.5 * viewport().width(), 0.5 * viewport().height());
        return std::all_of(boxes.begin(), boxes.end(), [&](const Eigen::AlignedBox2d& box) {
            return Eigen::AlignedBox2d(-half, half).contains(box);
        });
    }
    void press(const QPointF& place, int steps)
    {
        m_desk->window().setPalpating(true);
        palpation().stepDepth(steps);
        palpation().pressAt(place);
        QVERIFY(QTest::qWaitFor(
            [this] {
                return m_reading && palpation().text().startsWith("pressing") && !palpation().text().contains("of");
            },
            20000));
        QTest::qWait(300);
    }

  private Q_SLOTS:
    void initTestCase()
    {
        if (!test::Desk::hasDisplay()) {
            QSKIP(test::Desk::kNoDisplay);
        }
        m_desk = std::make_unique<test::Desk>();
        const auto scene = meshio::loadScene(phantom());
        QVERIFY(scene.isOk());
        m_lump_W = scene.value().structures[1].surface->report.bounds.center();
    }
    void init()
    {
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->open({phantom()}));
        m_reading.reset();
        connect(&palpation(), &ui::PalpationController::touched, this,
                [this](const ui::TouchReading& reading) { m_reading = reading; });
    }
    void cleanup() { m_desk->close(); }

    /// Seen along the line of sight the force is a circle; labels avoid the cursor; the lump's depth is shown.
    void pressedAlongTheView()
    {
        viewport().view().look(view::ViewFrom::Front);
        press(overLump(), 20); // 14 mm
        const view::TouchCursor& cursor = viewport().view().cursor();
        keep("pressed-along");
        QVERIFY(shown().innerCount == 1 && cursor.arrow().circle()->GetVisibility());
        QVERIFY(cursor.contactDisc()->GetVisibility() && cursor.innerLine(0)->GetVisibility());
        QCOMPARE(cursor.labels().texts().size(), std::size_t{3});
        QVERIFY(sees(cursor.labels().boxes()));
        const view::ViewFrame frame = view::ViewFrame::of(viewport().view().renderer(), viewport().devicePixelRatioF());
        for (const Eigen::AlignedBox2d& box : cursor.labels().boxes()) {
            QVERIFY(box.exteriorDistance(frame.pixelOf(shown().p_WG)) > 10.0);
        }
        // Then from the side, with the hand held in place.
        for (int i = 0; i < 5; ++i) {
            viewport().setFocus();
            m_desk->press(Qt::Key_Right);
        }
        keep("pressed-aside");
        QVERIFY(shown().isInContact && !cursor.arrow().circle()->GetVisibility());
        QVERIFY(cursor.arrow().shaft()->GetVisibility() && sees(cursor.labels().boxes()));
    }
    /// The dimple under the finger is rendered depending on the menu setting.
    void tissueBendsUnderTheFinger()
    {
        viewport().view().look(view::ViewFrom::Front);
        press(overLump(), 20);
        QAction* dent = m_desk->window().findChild<QAction*>(QStringLiteral("dent"));
        QVERIFY(dent != nullptr && dent->isChecked() && shown().bends);
        const auto ball_W = [this] {
            viewport().grabFramebuffer();
            const double* centre = viewport().view().cursor().ball()->GetCenter();
            return Vec3(centre[0], centre[1], centre[2]);
        };
        keep("dent");
        QVERIFY((ball_W() - shown().p_WH).norm() < 0.2 * (shown().p_WG - shown().p_WH).norm());
        const QImage bent = viewport().grabFramebuffer();
        dent->trigger();
        QVERIFY((ball_W() - shown().p_WG).norm() < 1e-3);
        const QImage straight = viewport().grabFramebuffer();
        const QPoint beside = viewport().placeOf(shown().p_WG).toPoint() + QPoint(30, 30);
        int changed = 0;
        for (int dy = -8; dy <= 8; ++dy) {
            for (int dx = -8; dx <= 8; ++dx) {
                changed += bent.pixel(beside + QPoint(dx, dy)) != straight.pixel(beside + QPoint(dx, dy)) ? 1 : 0;
            }
        }
        QVERIFY2(changed > 30, qPrintable(QString::number(changed)));
        dent->trigger();
    }
    /// Without an audio device the command gives a reason and stays off; the touch continues.
    void touchIsHeardWhereThereIsALoudspeaker()
    {
        QAction* sound = m_desk->window().findChild<QAction*>(QStringLiteral("sound"));
        QVERIFY(sound != nullptr && !sound->isChecked() && sound->isEnabled());
        const QString whyNot = ui::TouchSound::whyNot();
        press(overLump(), 20);
        sound->trigger();
        QCOMPARE(sound->isChecked(), whyNot.isEmpty());
        QCOMPARE(sound->isEnabled(), whyNot.isEmpty());
        QVERIFY2(sound->text().contains(whyNot), qPrintable(sound->text()));
        QVERIFY(shown().isInContact);
        sound->setChecked(false);
    }
    void pressedAtTheBorder()
    {
        viewport().view().look(view::ViewFrom::Front);
        const double half = 0.5 * viewport().width() / viewport().height();
        for (const double side : {-1.0, 1.0}) {
            // Move the lump to the border of the view.
            viewport().view().centreOn(m_lump_W);
            view::shift(viewport().view().camera(), side * (half - 0.02), 0.4);
            press(overLump(), side < 0.0 ? 20 : 0);
            keep(side < 0.0 ? "border-right" : "border-left");
            QVERIFY(shown().isInContact && sees(viewport().view().cursor().labels().boxes()));
            palpation().letGo();
            PALPATE_TRY_VERIFY(!shown().isInContact);
        }
    }
    /// A whole palpation with a finding, using only the keyboard.
    void keysAlonePalpateThePhantom()
    {
        viewport().setFocus();
        m_desk->press(Qt::Key_1);
        m_desk->press(Qt::Key_Return);
        QVERIFY(palpation().isPalpating());
        PALPATE_TRY_VERIFY(shown().isInContact && shown().hasCrosshair);
        m_desk->press(Qt::Key_Return);
        PALPATE_TRY_VERIFY(!shown().isInContact);
        // To the lump, visible through the liver.
        const double stride_mm = 2.0;
        for (int i = 0; i < 80; ++i) {
            const Vec3 way = m_lump_W - shown().p_WH;
            if (std::abs(way.x()) > stride_mm) {
                m_desk->press(way.x() > 0.0 ? Qt::Key_Right : Qt::Key_Left, Qt::ControlModifier);
            } else if (std::abs(way.z()) > stride_mm) {
                m_desk->press(way.z() > 0.0 ? Qt::Key_Up : Qt::Key_Down, Qt::ControlModifier);
            }
            QTest::qWait(20);
        }
        keep("keys-crosshair");
        for (int i = 0; i < 40; ++i) {
            m_desk->press(Qt::Key_PageDown);
        }
        QVERIFY(std::abs(palpation().depth_mm() - 24.0) < 1e-9);
        m_desk->press(Qt::Key_Return);
        PALPATE_TRY_VERIFY(m_reading && m_reading->layers.size() == 2);
        QCOMPARE(m_reading->layers[1].name, QStringLiteral("lump 20 mm"));
        m_desk->pressKeyOf("mark");
        PALPATE_TRY_COMPARE(viewport().view().findings().count(), std::size_t{1});
        keep("keys-lump");
        m_desk->press(Qt::Key_Return);
        PALPATE_TRY_VERIFY(!shown().isInContact);
    }
    void keysMoveTheCamera()
    {
        viewport().setFocus();
        m_desk->press(Qt::Key_1);
        vtkCamera& camera = viewport().view().camera();
        const Vec3 before(camera.GetPosition());
        const double distance_mm = camera.GetDistance();
        m_desk->press(Qt::Key_Right);
        QVERIFY(camera.GetPosition()[0] > before.x() + 0.2 * distance_mm);
        m_desk->press(Qt::Key_Left);
        QVERIFY((Vec3(camera.GetPosition()) - before).norm() < 1e-6 * distance_mm);
        const double focus_mm = camera.GetFocalPoint()[2];
        m_desk->press(Qt::Key_Up, Qt::ShiftModifier);
        QVERIFY(camera.GetFocalPoint()[2] > focus_mm + 1.0);
        m_desk->press(Qt::Key_Plus);
        QVERIFY(camera.GetDistance() < 0.95 * distance_mm);
        m_desk->press(Qt::Key_Minus);
        QVERIFY(std::abs(camera.GetDistance() - distance_mm) < 1e-6 * distance_mm);
    }
    void hoveringNamesAndAClickSelects()
    {
        viewport().view().look(view::ViewFrom::Front);
        viewport().grabFramebuffer();
        auto* name = viewport().findChild<QLabel*>(QStringLiteral("pointed"));
        QVERIFY(name != nullptr && !name->isVisible());
        const QPoint over = overLump().toPoint();
        QTest::mouseMove(&viewport(), over);
        PALPATE_TRY_VERIFY(name->isVisible());
        QCOMPARE(name->text(), QStringLiteral("liver")); // the lump is behind the wall of the liver
        keep("hover");
        QVERIFY(viewport().rect().contains(name->geometry()));
        QVERIFY(!name->geometry().contains(over));
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, over);
        QVERIFY(!name->isVisible());
        QCOMPARE(selectedRow(), 0);
        // A structure without contact is named and found as well: the vein below the liver.
        const auto vein = placeOf(3);
        QVERIFY(vein.has_value());
        QTest::mouseMove(&viewport(), *vein);
        PALPATE_TRY_COMPARE(name->text(), QStringLiteral("portal vein"));
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, *vein);
        QCOMPARE(selectedRow(), 3);
        QTest::mouseMove(&viewport(), {3, 3});
        PALPATE_TRY_VERIFY(!name->isVisible());
    }

  private:
    int selectedRow() { return m_desk->window().findChild<ui::StructurePanel*>()->currentRow(); }
    /// Returns a view position where a structure is in front of all others.
    std::optional<QPoint> placeOf(int row)
    {
        const auto* pointed = m_desk->window().findChild<ui::PointedStructure*>();
        for (int y = 10; y < viewport().height(); y += 10) {
            for (int x = 10; x < viewport().width(); x += 10) {
                const auto found = pointed->at(QPointF(x, y));
                if (found && found->row == row) {
                    return QPoint(x, y);
                }
            }
        }
        return std::nullopt;
    }
    static std::filesystem::path phantom()
    {
        return std::filesystem::path(PALPATE_SOURCE_DIR) / "data/phantom/phantom-layers.palpate.json";
    }
};

PALPATE_TEST(Picture)
#include "tst_Picture.moc"

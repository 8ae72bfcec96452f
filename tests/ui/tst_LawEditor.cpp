// SPDX-License-Identifier: BSD-3-Clause
// Tests the force law editor in the panel: choosing, typing, dragging, loading, rejecting and undo.
#include "Rows.h"
#include "TestRunner.h"

#include <palpate/haptics/ForceTable.h>
#include <palpate/ui/LawEditor.h>
#include <palpate/ui/StructurePanel.h>
#include <palpate/ui/TouchPanel.h>

#include "tissue/LawPlot.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>
#include <QTemporaryDir>

#include <cmath>

using namespace palpate;
using core::ForceLaw;
using core::LawKind;

namespace {

/// A panel with two structures, the first selected, for a device with a stable stiffness of 2 N/mm.
struct Panel
{
    ui::StructureModel model;
    ui::StructurePanel panel{model};
    Panel()
    {
        model.setRows(test::twoRows());
        haptics::Tissue greatest = core::unbounded();
        greatest.stiffness_N_per_mm = 2.0;
        panel.setGreatest(greatest, QStringLiteral("The test's device holds at most 2 N/mm."));
        panel.resize(300, 900);
        panel.show();
        panel.select(0);
    }
    [[nodiscard]] const core::Tissue& tissue() const { return model.structure(0).tissue; }
    [[nodiscard]] QComboBox* box(const QString& name) const
    {
        for (QComboBox* one : panel.findChildren<QComboBox*>()) {
            if (one->accessibleName() == name) {
                return one;
            }
        }
        return nullptr;
    }
    void choose(LawKind kind) const
    {
        box(QStringLiteral("Force law"))->setCurrentIndex(static_cast<int>(kind));
        Q_EMIT box(QStringLiteral("Force law"))->activated(static_cast<int>(kind));
    }
    [[nodiscard]] QDoubleSpinBox* number(const QString& name) const
    {
        for (QDoubleSpinBox* one : panel.findChildren<QDoubleSpinBox*>()) {
            if (one->accessibleName().startsWith(name)) {
                return one;
            }
        }
        return nullptr;
    }
    [[nodiscard]] QString refusal() const
    {
        for (const QLabel* one : panel.findChildren<QLabel*>()) {
            if (one->accessibleDescription().contains(QStringLiteral("rejecting"))) {
                return one->isVisible() ? one->text() : QString();
            }
        }
        return QStringLiteral("no line for it");
    }
    [[nodiscard]] ui::LawPlot* plot() const { return panel.findChild<ui::LawPlot*>(); }
    void keep(const char* name) const
    {
        if (const QByteArray to = qgetenv("PALPATE_LAW_PICTURES"); !to.isEmpty()) {
            QTest::qWait(50);
            const_cast<ui::StructurePanel&>(panel).grab().save(
                QString::fromLocal8Bit(to + "/" + QByteArray(name) + ".png")); // for visual inspection
        }
    }
};

} // namespace

class LawEditor : public QObject
{
    Q_OBJECT
  private Q_SLOTS:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        QSettings().setValue(QStringLiteral("properties/advanced"), true); // the group of the law is folded at first
    }
    void cleanupTestCase() { QSettings().remove(QStringLiteral("properties/advanced")); }

    void aLawIsChosenTypedAndUndone()
    {
        Panel p;
        const core::Tissue before = p.tissue();
        QVERIFY(p.number(QStringLiteral("Stiffness in"))->isVisible());
        p.choose(LawKind::Exponential);
        QCOMPARE(p.tissue().law.kind, LawKind::Exponential);
        QVERIFY(core::check(p.tissue().law).isOk());
        QVERIFY(!p.number(QStringLiteral("Stiffness in"))->isVisible()); // not the active law
        QDoubleSpinBox* growth = p.number(QStringLiteral("Growth with depth"));
        QVERIFY(growth->isVisible());
        growth->setValue(0.5);
        QCOMPARE(p.tissue().law.numbers[1], 0.5);
        QCOMPARE(p.tissue().law.numbers[0], core::usualLaw(LawKind::Exponential).numbers[0]); // unchanged
        ui::TouchReading reading;
        reading.structure = ui::readableName(p.model.structure(0).name);
        reading.depth_mm = 5.0;
        p.panel.showTouch(reading);
        p.keep("exponential");
        QTest::qWait(750); // quick successive steps undo together
        p.choose(LawKind::Layer);
        QVERIFY(p.panel.findChild<QCheckBox*>()->isVisible());
        p.panel.findChild<QCheckBox*>()->setChecked(false);
        QCOMPARE(p.tissue().law.numbers[3], 0.0);
        p.keep("layer");
        p.model.undoStack().undo();
        QCOMPARE(p.tissue().law.kind, LawKind::Exponential);
        QCOMPARE(p.box(QStringLiteral("Force law"))->currentIndex(), static_cast<int>(LawKind::Exponential));
        p.model.undoStack().undo();
        QVERIFY(p.tissue() == before);
    }
    void whatTheDeviceDoesNotHoldIsRefused()
    {
        Panel p;
        p.choose(LawKind::Exponential);
        const core::Tissue before = p.tissue();
        p.number(QStringLiteral("Maximum stiffness"))->setValue(3.0);
        QVERIFY(p.tissue() == before);
        QVERIFY2(p.refusal().contains(QStringLiteral("too steep: up to 3 N/mm")), qPrintable(p.refusal()));
        QVERIFY(p.refusal().contains(QStringLiteral("at most 2.00 N/mm")));
        QCOMPARE(p.number(QStringLiteral("Maximum stiffness"))->value(), 2.0);
        p.number(QStringLiteral("Initial stiffness"))->setValue(0.0);
        QVERIFY(p.tissue() == before);
        QVERIFY2(p.refusal().contains(QStringLiteral("Initial stiffness: found 0")), qPrintable(p.refusal()));
        p.keep("refused");
        p.number(QStringLiteral("Initial stiffness"))->setValue(0.2);
        QVERIFY(p.refusal().isEmpty());
        QCOMPARE(p.tissue().law.numbers[0], 0.2);
    }
    void whatASceneAsksForIsBoundedToWhatTheDeviceHolds()
    {
        Panel p;
        meshio::SceneStructure steep = p.model.structure(0);
        steep.tissue.law = {LawKind::Click, {4.0, 2.0, 1.0, 1.0, 0.5}, {}};
        p.model.edit(0, steep);
        p.keep("bounded");
        haptics::Tissue greatest = core::unbounded();
        greatest.stiffness_N_per_mm = 2.0;
        const auto scene = p.model.hapticScene(greatest);
        const auto& law = scene->structures()[0].law;
        QVERIFY(law != nullptr);
        QVERIFY(law->greatestSlope_N_per_mm() <= 2.0 * (1.0 + 1e-5));
        QVERIFY(std::abs(law->force(0.3) - 0.6) < 1e-12); // 2 N/mm instead of 4
        QVERIFY(std::abs(law->force(1.5) - 1.0) < 1e-6);  // where the force falls, the original law applies
        QVERIFY(scene->structures()[1].law == nullptr);
        bool isSaid = false;
        for (const QLabel* one : p.panel.findChildren<QLabel*>()) {
            isSaid = isSaid || (one->isVisible() && one->text().contains(QStringLiteral("limited to 2 N/mm")));
        }
        QVERIFY(isSaid);
    }
    void measuredPointsBeginAsWhatIsThereAndAreDragged()
    {
        Panel p;
        const double stiffness = p.tissue().stiffness_N_per_mm;
        p.choose(LawKind::Points);
        const std::vector<ForceLaw::Point> before = p.tissue().law.points;
        QCOMPARE(before.size(), std::size_t{7});
        for (const ForceLaw::Point& point : before) {
            QVERIFY(std::abs(point[1] - stiffness * point[0]) < 1e-12);
        }
        p.keep("points");
        QTest::qWait(750); // quick successive steps undo together
        ui::LawPlot* plot = p.plot();
        const int steps = p.model.undoStack().count();
        const QPoint from = plot->placeOf(before[3][0], before[3][1]).toPoint();
        const QPoint to = plot->placeOf(before[3][0], 0.5 * before[3][1]).toPoint();
        QTest::mousePress(plot, Qt::LeftButton, {}, from);
        QTest::mouseMove(plot, (from + to) / 2);
        QTest::mouseMove(plot, to);
        QVERIFY(p.tissue().law.points == before); // one undo step, on release
        QTest::mouseRelease(plot, Qt::LeftButton, {}, to);
        QCOMPARE(p.model.undoStack().count(), steps + 1);
        const ForceLaw::Point& moved = p.tissue().law.points[3];
        QVERIFY2(std::abs(moved[1] - 0.5 * before[3][1]) < 0.05 * before.back()[1],
                 qPrintable(QString::number(moved[1])));
        p.keep("dragged");
        p.model.undoStack().undo();
        QVERIFY(p.tissue().law.points == before);
        plot->setFocus();
        QTest::keyClick(plot, Qt::Key_Right);
        QTest::keyClick(plot, Qt::Key_Up);
        QVERIFY(p.tissue().law.points[2][1] > before[2][1] || p.tissue().law.points[4][1] > before[4][1]);
    }
    void aPointIsNotDraggedPastItsNeighbour()
    {
        Panel p;
        p.choose(LawKind::Points);
        const std::vector<ForceLaw::Point> before = p.tissue().law.points;
        ui::LawPlot* plot = p.plot();
        const QPoint from = plot->placeOf(before[3][0], before[3][1]).toPoint();
        const QPoint steep = plot->placeOf(before[3][0], 0.0).toPoint();
        QTest::mousePress(plot, Qt::LeftButton, {}, from);
        QTest::mouseMove(plot, (from + steep) / 2);
        QTest::mouseMove(plot, steep);
        QTest::mouseRelease(plot, Qt::LeftButton, {}, steep);
        QVERIFY(p.tissue().law.points == before); // above the stable stiffness: moved back
        QVERIFY(p.refusal().contains(QStringLiteral("too steep")));
        p.panel.setGreatest(core::unbounded(), {});
        QTest::qWait(20); // the line is gone and the layout shifted
        const QPoint start = plot->placeOf(before[3][0], before[3][1]).toPoint();
        const QPoint to = plot->placeOf(before[5][0], before[3][1]).toPoint();
        QTest::mousePress(plot, Qt::LeftButton, {}, start);
        QTest::mouseMove(plot, (start + to) / 2);
        QTest::mouseMove(plot, to);
        QTest::mouseRelease(plot, Qt::LeftButton, {}, to);
        QVERIFY(core::check(p.tissue().law).isOk());
        QVERIFY(p.tissue().law.points[3][0] < before[4][0]);
        QVERIFY(p.tissue().law.points[3][0] > before[3][0]);
    }
    /// The dot shows the current force: the law times the map's scale at the contact, in any layer.
    void theDotIsWhereTheTouchIs()
    {
        Panel p;
        const double k = p.tissue().stiffness_N_per_mm;
        ui::TouchReading reading;
        ui::LayerShare here;
        here.name = ui::readableName(p.model.structure(0).name);
        here.depth_mm = 4.0;
        ui::LayerShare above = here;
        above.name = QStringLiteral("another");
        above.depth_mm = 9.0;
        reading.structure = above.name;
        reading.depth_mm = above.depth_mm;
        reading.layers = {above, here};
        p.panel.showTouch(reading);
        QCOMPARE(p.plot()->touchedPlace(), p.plot()->placeOf(4.0, 4.0 * k));
        reading.layers[1].stiffnessScale = 1.5;
        p.panel.showTouch(reading);
        QCOMPARE(p.plot()->touchedPlace(), p.plot()->placeOf(4.0, 1.5 * 4.0 * k));
        p.keep("dot-scaled");
    }
    /// In a narrow panel nothing overlaps the axis name or the current value.
    void textsOfANarrowPlotDoNotMeet()
    {
        core::Tissue tissue;
        tissue.stiffness_N_per_mm = 0.2;
        const auto draw = [&](int width, double greatest_N_per_mm, double depth_mm) {
            ui::LawPlot plot;
            plot.resize(width, plot.sizeHint().height());
            plot.show(tissue, greatest_N_per_mm);
            plot.setTouch(depth_mm, 1.0);
            return std::pair(plot.grab().toImage(), QRectF(plot.placeOf(0.0, 5.0), plot.placeOf(12.0, 0.0)));
        };
        const auto head = [](const auto& drawn) {
            constexpr int kLine_px = 14;
            const QRectF in = drawn.second;
            return drawn.first.copy(int(in.left()), int(in.top()) - kLine_px, int(in.width()), kLine_px);
        };
        const auto foot = [](const auto& drawn) {
            const QRectF in = drawn.second;
            return drawn.first.copy(int(in.left()), int(in.bottom()) + 2, 100, 14);
        };
        constexpr int kNarrow_px = 165, kWide_px = 400;
        QCOMPARE(head(draw(kNarrow_px, 5.0, 0.0)), head(draw(kNarrow_px, core::unbounded().stiffness_N_per_mm, 0.0)));
        QCOMPARE(foot(draw(kNarrow_px, 5.0, 3.97)), foot(draw(kWide_px, 5.0, 3.97)));
    }
    void aDepthIsWrittenAsInThePanel()
    {
        ui::LawPlot plot;
        plot.show(core::Tissue(), 5.0);
        plot.setTouch(3.97, 1.0);
        QVERIFY2(plot.touchText().contains(ui::depthText(3.97) + QStringLiteral(" mm")), qPrintable(plot.touchText()));
        plot.setTouch(3.97, 1.5);
        QVERIFY2(plot.touchText().contains(ui::depthText(3.97) + QStringLiteral(" mm")), qPrintable(plot.touchText()));
    }
    void aCurveIsLoadedOrItsFaultIsSaid()
    {
        Panel p;
        QTemporaryDir folder;
        const auto write = [&](const char* text) {
            QFile file(folder.filePath(QStringLiteral("curve.csv")));
            if (!file.open(QIODevice::WriteOnly)) {
                qFatal("no file");
            }
            file.write(text);
            return std::filesystem::path(file.fileName().toStdString());
        };
        auto* editor = p.panel.findChild<ui::LawEditor*>();
        editor->load(write("depth_mm,force_N\n0,0\n4,0.5\n8,3\n"));
        const std::vector<ForceLaw::Point> expected{{0, 0}, {4, 0.5}, {8, 3}};
        QVERIFY(p.tissue().law.points == expected);
        editor->load(write("depth_mm,force_N\n0,0\n4,-0.5\n8,3\n"));
        QVERIFY(p.tissue().law.points == expected);
        QVERIFY2(p.refusal().startsWith(QStringLiteral("curve.csv: line 3: point 2 of 3: found (4 mm, -0.5 N)")),
                 qPrintable(p.refusal()));
    }
    void presetsSayTheirSourceAndKeepFriction()
    {
        Panel p;
        QComboBox* friction = p.box(QStringLiteral("Friction"));
        friction->setCurrentIndex(2);
        Q_EMIT friction->activated(2);
        QCOMPARE(p.tissue().friction_static, 0.15);
        QCOMPARE(p.tissue().friction_dynamic, 0.15);
        QComboBox* presets = p.box(QStringLiteral("Tissue"));
        for (std::size_t i = 0; i < ui::tissuePresets().size(); ++i) {
            const ui::TissuePreset& preset = ui::tissuePresets()[i];
            Q_EMIT presets->activated(static_cast<int>(i) + 1);
            QVERIFY(p.tissue() == ui::withPreset(p.tissue(), preset));
            QCOMPARE(p.tissue().friction_static, 0.15);
            QCOMPARE(presets->currentIndex(), static_cast<int>(i) + 1);
            QVERIFY(core::check(preset.tissue.law).isOk());
            const QString source = QString::fromUtf8(preset.source);
            const QRegularExpression publication(QStringLiteral("PMC|\\b20\\d\\d\\b")); // an archive number or a year
            QVERIFY(source.contains(QStringLiteral("assumed")) || source.contains(publication));
            bool isSaid = false;
            for (const QLabel* one : p.panel.findChildren<QLabel*>()) {
                isSaid = isSaid || (one->isVisible() && one->text().contains(source));
            }
            QVERIFY(isSaid);
        }
        p.keep("preset");
    }
};

PALPATE_TEST(LawEditor)
#include "tst_LawEditor.moc"

// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Shapes.h"
#include "Desk.h"
#include "TestRunner.h"

#include <palpate/meshio/SceneFile.h>
#include <palpate/study/FeltFile.h>
#include <palpate/study/RecordedScene.h>
#include <palpate/ui/FeltOverlay.h>
#include <palpate/ui/FeltPanel.h>
#include <palpate/ui/LumpMaps.h>
#include <palpate/ui/StructurePanel.h>
#include <palpate/ui/Theme.h>
#include <palpate/ui/VtkViewport.h>

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QScopeGuard>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTabBar>
#include <QTableWidget>
#include <QToolButton>

#include <vtkMapper.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <fstream>

using namespace palpate;
using core::Vec3;
using ui::FeltOverlay;
using ui::FeltPanel;

/// Palpability of the phantom's lumps in the window: colours, legend, texts at the pointer, the table.
class FeltHere : public QObject
{
    Q_OBJECT

    std::unique_ptr<test::Desk> m_desk;
    bool m_hasResult = false; ///< the window shows the phantom as it was opened, with its lumps computed

    FeltOverlay& felt() { return *m_desk->window().findChild<FeltOverlay*>(); }
    QTableWidget& table() { return *m_desk->window().findChild<QTableWidget*>(QStringLiteral("feltTable")); }
    ui::VtkViewport& viewport() { return m_desk->window().viewport(); }
    QString cell(int row, int column) { return table().item(row, column)->text(); }

    template<class Widget>
    Widget& named(const QString& name)
    {
        for (Widget* one : m_desk->window().findChildren<Widget*>()) {
            if (one->accessibleName() == name) {
                return *one;
            }
        }
        qFatal("no such widget");
    }

    /// Shows the result for a coarse ball with two lumps, which takes far less to compute than the phantom. For tests
    /// that change the scene, whose window is not used again.
    void showCoarse()
    {
        m_hasResult = false;
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->open({coarseScene()}));
        viewport().setFocus();
        m_desk->pressKeyOf("felt");
        PALPATE_TRY_VERIFY(felt().isUpToDate());
    }

    /// Writes an organ with the tissues and lumps of the phantom, on few triangles.
    std::filesystem::path coarseScene() const
    {
        m_desk->writeStl("liver.stl", test::sphere(16, 40.0));
        m_desk->writeStl("lump-12-mm.stl", test::moved(test::sphere(6, 6.0), Vec3(0, -28, 0)));
        m_desk->writeStl("lump-20-mm.stl", test::moved(test::sphere(6, 10.0), Vec3(0, 24, 0)));
        const std::filesystem::path scene = m_desk->folder() / "coarse.palpate.json";
        std::ofstream(scene) << R"({"version": 1, "buried": "felt", "structures": [
            {"mesh": "liver.stl", "name": "liver", "stiffness_N_per_mm": 0.2},
            {"mesh": "lump-20-mm.stl", "name": "lump 20 mm", "inside": "liver", "young_ratio": 3, "stiffness_N_per_mm": 0.6},
            {"mesh": "lump-12-mm.stl", "name": "lump 12 mm", "inside": "liver", "young_ratio": 3, "stiffness_N_per_mm": 0.6}]})";
        return scene;
    }

    /// Shows the result for the phantom. Computing it takes seconds, so a window that holds it is used again, in the
    /// state that opening gives it; a test that changes the scene closes the window.
    void showFelt(QSize size = {1280, 800})
    {
        if (!m_hasResult) {
            QVERIFY(m_desk->show(size));
            QVERIFY(m_desk->openPhantom());
            viewport().setFocus();
            m_desk->pressKeyOf("felt");
            PALPATE_TRY_VERIFY(felt().isUpToDate());
            m_hasResult = true;
            return;
        }
        m_desk->window().resize(size);
        m_desk->command("view-front").trigger();
        viewport().setFocus();
        if (!m_desk->command("felt").isChecked()) {
            m_desk->pressKeyOf("felt");
        }
        named<QComboBox>(QStringLiteral("Press depth of the finger")).setCurrentIndex(0);
        table().selectRow(0);
        PALPATE_TRY_VERIFY(felt().isUpToDate());
        QTest::qWait(2 * ui::CameraFlight::kTime_ms);
    }

    void keep(const char* name)
    {
        if (const QByteArray to = qgetenv("PALPATE_FELT_PICTURES"); !to.isEmpty()) {
            QTest::qWait(600);
            QVERIFY(m_desk->picture().save(QString::fromLocal8Bit(to + "/" + QByteArray(name) + ".png")));
        }
    }

    /// The text beside the pointer in the middle of the view.
    QString saidInTheMiddle()
    {
        const QPointF middle(0.5 * viewport().width(), 0.5 * viewport().height());
        Q_EMIT viewport().hovered(middle);
        auto* label = viewport().findChild<QLabel*>(QStringLiteral("pointed"));
        (void)QTest::qWaitFor([&] { return label->isVisible(); }, test::kPatience_ms);
        return label->text();
    }

  private Q_SLOTS:
    void initTestCase()
    {
        if (!test::Desk::hasDisplay()) {
            QSKIP(test::Desk::kNoDisplay);
        }
        m_desk = std::make_unique<test::Desk>();
    }
    void cleanupTestCase() { m_desk.reset(); }

    void costsNothingUntilItIsWanted()
    {
        QVERIFY(m_desk->show());
        QVERIFY(!m_desk->command("felt").isEnabled()); // without a scene
        QVERIFY(m_desk->openPhantom());
        QTest::qWait(500);
        QVERIFY(!felt().isBusy() && felt().organs().empty());
        QVERIFY(!viewport().view().legend().isShown());
    }

    /// Its words get smaller where the view is small.
    void theLegendLeavesTheOrganInView()
    {
        showFelt({1024, 700});
        PALPATE_TRY_VERIFY(!viewport().view().legend().box().isEmpty());
        QTest::qWait(300);
        const double wide = viewport().view().legend().box().sizes().x();
        QVERIFY2(wide <= 0.4 * viewport().width(),
                 qPrintable(QStringLiteral("%1 of %2 px").arg(wide).arg(viewport().width())));
        const auto middle = [this] { return Eigen::Vector2d(viewport().view().legend().box().center()); };
        QVERIFY(middle().x() > 0.0 && middle().y() < 0.0); // before the front the phantom's liver is small there
        m_desk->pressKeyOf("view-back");
        PALPATE_TRY_VERIFY(middle().x() < 0.0 || middle().y() > 0.0); // from behind, the other way round
    }

    /// A narrow table uses short texts: no column is hidden, and a screen reader gets the full texts.
    void theTableHasAllColumnsInView()
    {
        showFelt({1024, 700});
        const auto restore = qScopeGuard([this] { m_desk->command("text-size-100").trigger(); });
        m_desk->command("text-size-125").trigger();
        PALPATE_TRY_VERIFY(table().rowCount() == 2);
        const QTableWidgetItem& light = *table().item(0, FeltPanel::FirstPress);
        PALPATE_TRY_VERIFY2(!light.text().contains(QStringLiteral("hand")), qPrintable(light.text()));
        PALPATE_TRY_COMPARE(table().horizontalScrollBar()->maximum(), 0);
        QVERIFY(light.data(Qt::AccessibleTextRole).toString().contains(QStringLiteral("not by hand")));
        const auto key = [this] {
            const QList<QLabel*> labels = m_desk->window().findChild<FeltPanel*>()->findChildren<QLabel*>();
            return std::any_of(labels.begin(), labels.end(), [](const QLabel* one) {
                return one->isVisible() && one->text().contains(QStringLiteral("by a trained hand"));
            });
        };
        QVERIFY(key());
        m_desk->command("text-size-100").trigger();
        m_desk->window().resize(1800, 900);
        PALPATE_TRY_VERIFY(light.text().contains(QStringLiteral("not by hand")));
        QVERIFY(!key());
        PALPATE_TRY_COMPARE(table().horizontalScrollBar()->maximum(), 0);
    }

    /// Tabs of panels: all in view, and only the longest title is shortened.
    void tabsOfPanelsAreAllInView()
    {
        showFelt({1024, 700});
        bool isAny = false;
        for (const QTabBar* tabs : m_desk->window().findChildren<QTabBar*>()) {
            if (!tabs->isVisible() || tabs->parentWidget() != &m_desk->window()) {
                continue;
            }
            int longest = 0;
            for (int i = 1; i < tabs->count(); ++i) {
                longest = tabs->tabText(i).size() > tabs->tabText(longest).size() ? i : longest;
            }
            for (int i = 0; i < tabs->count(); ++i) {
                const int title = tabs->fontMetrics().size(Qt::TextShowMnemonic, tabs->tabText(i)).width();
                QVERIFY2(tabs->tabRect(i).right() <= tabs->width(), qPrintable(tabs->tabText(i)));
                QVERIFY2(i == longest || tabs->tabRect(i).width() >= title, qPrintable(tabs->tabText(i)));
                isAny = true;
            }
        }
        QVERIFY(isAny);
    }

    void coloursTheOrganWithALegend()
    {
        showFelt();
        const auto marks = viewport().view().legend().markTexts();
        QCOMPARE(marks.size(), std::size_t(4));
        QVERIFY(marks[1].find("7 %") == 0 && marks[2].find("14 %") == 0 && marks[3].find("28 %") == 0);
        vtkActor* liver = viewport().view().structure(0).picture.actor();
        const auto arrays = [&] {
            return vtkPolyData::SafeDownCast(liver->GetMapper()->GetInputDataObject(0, 0))->GetPointData();
        };
        QVERIFY(arrays()->GetScalars() != nullptr);
        keep("lightly");
        named<QComboBox>(QStringLiteral("Press depth of the finger")).setCurrentIndex(3);
        keep("pressed");
        m_desk->pressKeyOf("felt");
        QVERIFY(arrays()->GetScalars() == nullptr);
        QVERIFY(!viewport().view().legend().isShown());
        QVERIFY(!felt().isBusy());
    }

    void theTableSaysWhatTheCommandSays()
    {
        showFelt();
        const auto scene = study::openScene(
            std::filesystem::path(PALPATE_SOURCE_DIR) / "data/phantom/phantom.palpate.json", meshio::ReadOptions());
        QVERIFY(scene.isOk());
        const auto organs = study::organsWithLumps(scene.value());
        QVERIFY(organs.isOk());
        buried::FeltOptions how;
        how.radius_mm = organs.value().front().radius_mm;
        const auto expected = study::feltSurface(scene.value(), organs.value().front(), how);
        QVERIFY(expected.isOk());
        QCOMPARE(table().rowCount(), static_cast<int>(expected.value().lumps.size()));
        for (int row = 0; row < table().rowCount(); ++row) {
            const buried::FeltSurface::Lump& lump = expected.value().lumps[static_cast<std::size_t>(row)];
            QVERIFY(cell(row, FeltPanel::Lump).startsWith(QString::fromStdString(lump.name)));
            QVERIFY(cell(row, FeltPanel::Ratio).contains(QStringLiteral("as typed")));
            for (int press = 0; press < 4; ++press) {
                const auto& at = lump.press[static_cast<std::size_t>(press)];
                const QString verdict =
                    QString::fromStdString(std::string(buried::kVerdictNames[static_cast<std::size_t>(at.verdict)]));
                const QString change = QStringLiteral("+%1 %").arg(std::lround(100.0 * (at.felt.estimate - 1.0)));
                const QString said = cell(row, FeltPanel::FirstPress + press);
                QVERIFY2(said.startsWith(change) && said.endsWith(verdict), qPrintable(said));
            }
        }
    }

    void thePointerSaysItAndTheBestPlaceIsShown()
    {
        showFelt();
        const int lump12 = cell(0, FeltPanel::Lump).startsWith(QStringLiteral("lump 12")) ? 0 : 1;
        table().selectRow(lump12);
        QVERIFY(felt().showBestPlace(0, static_cast<std::size_t>(lump12)));
        QVERIFY(viewport().view().placeRing().isShown());
        QTest::qWait(2 * ui::CameraFlight::kTime_ms);
        const QString said = saidInTheMiddle();
        QVERIFY2(said.simplified().contains(
                     QStringLiteral("lump 12 mm: 6 mm below, +8 % (5 … 14 %): too little for a trained hand; "
                                    "+17 % when pressed 4 mm")),
                 qPrintable(said));
        keep("best-place");
    }

    void anotherRatioMakesItAnewAndIsUndone()
    {
        showCoarse();
        const QString before = cell(0, FeltPanel::FirstPress);
        auto& ratio = named<QDoubleSpinBox>(QStringLiteral("Stiffness of the lump relative to the organ"));
        QCOMPARE(ratio.value(), 3.0);
        QSignalSpy changed(&felt(), &FeltOverlay::changed);
        ratio.setValue(100.0);
        QVERIFY(!felt().isUpToDate()); // at once: nothing old is shown
        QVERIFY(!viewport().view().legend().isShown());
        PALPATE_TRY_VERIFY(felt().isUpToDate());
        QVERIFY(cell(0, FeltPanel::FirstPress) != before);
        QVERIFY(cell(0, FeltPanel::Ratio).startsWith(QStringLiteral("100\nas typed")));
        QVERIFY(viewport().view().legend().isShown());
        QVERIFY(m_desk->window().isWindowModified());
        m_desk->command("save").trigger();
        const auto saved = meshio::readScene(m_desk->folder() / "coarse.palpate.json");
        QVERIFY(saved.isOk());
        QVERIFY(saved.value().structures[1].young_ratio == 100.0);
        m_desk->command("undo").trigger();
        PALPATE_TRY_VERIFY(felt().isUpToDate());
        QCOMPARE(cell(0, FeltPanel::FirstPress), before);
        QCOMPARE(ratio.value(), 3.0);
        m_desk->command("save").trigger();
    }

    void presetsAndModuliAreTaken()
    {
        showCoarse();
        auto& source = named<QComboBox>(QStringLiteral("Source of the stiffness ratio"));
        const auto choose = [&](int index) {
            source.setCurrentIndex(index);
            Q_EMIT source.activated(index);
            PALPATE_TRY_VERIFY(felt().isUpToDate());
        };
        choose(source.findText(QStringLiteral("Published: malignant tumour of the liver"), Qt::MatchStartsWith));
        QVERIFY(cell(0, FeltPanel::Ratio).startsWith(QStringLiteral("4.4\n")));
        choose(source.findText(QStringLiteral("From the two"), Qt::MatchStartsWith));
        named<QDoubleSpinBox>(QStringLiteral("Young's modulus of the lump [kPa]")).setValue(20.0);
        named<QDoubleSpinBox>(QStringLiteral("Young's modulus of the organ [kPa]")).setValue(5.0);
        PALPATE_TRY_VERIFY(felt().isUpToDate());
        QCOMPARE(cell(0, FeltPanel::Ratio), QStringLiteral("4\nfrom the moduli"));
        choose(source.findText(QStringLiteral("From tissues"), Qt::MatchStartsWith));
        QCOMPARE(cell(0, FeltPanel::Ratio), QStringLiteral("3\nfrom the tissues' stiffness"));
    }

    void aStructureThatGoesIsNotFelt()
    {
        showCoarse();
        QCOMPARE(table().rowCount(), 2);
        auto* list = m_desk->window().findChild<ui::StructurePanel*>();
        list->select(2);
        m_desk->command("remove").trigger();
        QVERIFY(!felt().isUpToDate());
        PALPATE_TRY_VERIFY(felt().isUpToDate());
        QCOMPARE(table().rowCount(), 1);
        m_desk->command("undo").trigger();
        PALPATE_TRY_COMPARE(table().rowCount(), 2);
    }

    void isCancelled()
    {
        m_hasResult = false;
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->openPhantom()); // takes long enough to be cancelled
        viewport().setFocus();
        QSignalSpy cancelled(m_desk->window().findChild<ui::LumpMaps*>(), &ui::LumpMaps::cancelled);
        m_desk->pressKeyOf("felt");
        QVERIFY(felt().isBusy());
        for (auto* button : m_desk->window().findChildren<QToolButton*>()) {
            if (button->text() == QStringLiteral("Cancel")) {
                button->click();
            }
        }
        QCOMPARE(cancelled.count(), 1);
        QVERIFY(!felt().isBusy());
        QTest::qWait(500);
        QVERIFY(felt().organs().empty());
        QVERIFY(!m_desk->command("felt").isChecked());
        QVERIFY(!viewport().view().legend().isShown());
        m_desk->pressKeyOf("felt"); // and again
        PALPATE_TRY_VERIFY(felt().isUpToDate());
        QVERIFY(!felt().organs().empty());
        m_hasResult = true;
    }

    void looksWellInTheDark()
    {
        showFelt();
        named<QComboBox>(QStringLiteral("Press depth of the finger")).setCurrentIndex(2);
        QVERIFY(viewport().view().legend().texts()[0].find("pressed 4 mm") != std::string::npos);
        m_desk->command("appearance-dark").trigger();
        QVERIFY(ui::isDarkTheme());
        keep("dark");
        m_desk->command("appearance-light").trigger();
    }

    void fitsASmallWindow()
    {
        showFelt({1024, 700});
        QVERIFY2(m_desk->window().width() <= 1024 && m_desk->window().height() <= 700,
                 qPrintable(QStringLiteral("%1 x %2").arg(m_desk->window().width()).arg(m_desk->window().height())));
        keep("small");
    }
};

PALPATE_TEST(FeltHere)
#include "tst_FeltHere.moc"

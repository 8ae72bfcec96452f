// SPDX-License-Identifier: BSD-3-Clause
#include "Desk.h"
#include "TestRunner.h"

#include <palpate/meshio/SceneFile.h>
#include <palpate/study/FindingsFile.h>
#include <palpate/ui/FindingsModel.h>
#include <palpate/ui/Playback.h>
#include <palpate/ui/VtkViewport.h>

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QMenu>

#include <vtkCamera.h>

using namespace palpate;
using core::Vec3;

/// Tests findings in the whole window by keyboard alone: marked at a contact in a recording, named, annotated, deleted,
/// saved, flown to.
class MarkedPlaces : public QObject
{
    Q_OBJECT

    std::unique_ptr<test::Desk> m_desk;
    std::filesystem::path m_scene;

    QAbstractItemView& table() { return *m_desk->window().findChild<QAbstractItemView*>("findingsTable"); }
    QAbstractItemModel& model() { return *table().model(); }
    QString cell(int row, int column) { return model().index(row, column).data().toString(); }
    ui::VtkViewport& viewport() { return m_desk->window().viewport(); }
    Vec3 eye() { return Vec3(viewport().view().camera().GetPosition()); }

    void type(const QString& text)
    {
        PALPATE_TRY_VERIFY(qobject_cast<QLineEdit*>(QApplication::focusWidget()) != nullptr);
        QTest::keyClicks(QApplication::focusWidget(), text);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QCoreApplication::processEvents();
    }

    /// Plays the recording until the first contact.
    void playToTouch()
    {
        m_desk->pressKeyOf("play");
        PALPATE_TRY_VERIFY(viewport().view().cursor().state().isInContact);
        m_desk->pressKeyOf("play");
    }

    void openScene()
    {
        const std::filesystem::path phantom = std::filesystem::path(PALPATE_SOURCE_DIR) / "data" / "phantom";
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->open({m_scene, phantom / "palpation.palpate"}));
        viewport().setFocus();
    }

  private Q_SLOTS:
    void initTestCase()
    {
        if (!test::Desk::hasDisplay()) {
            QSKIP(test::Desk::kNoDisplay);
        }
        m_desk = std::make_unique<test::Desk>();
    }
    void init()
    {
        const std::filesystem::path phantom = std::filesystem::path(PALPATE_SOURCE_DIR) / "data" / "phantom";
        m_scene = m_desk->folder() / "case.palpate.json";
        const auto scene = meshio::readScene(phantom / "phantom.palpate.json");
        QVERIFY(scene.isOk() && meshio::writeScene(m_scene, scene.value()).isOk());
        openScene();
    }
    void cleanupTestCase() { m_desk.reset(); }

    void isMarkedNamedUndoneSavedAndFlownTo()
    {
        playToTouch();
        const Vec3 place = viewport().view().cursor().state().p_WG;
        const Vec3 from = eye();
        m_desk->pressKeyOf("mark");
        QCOMPARE(model().rowCount(), 1);
        // the new row does not take the focus
        QCOMPARE(m_desk->window().focusWidget(), static_cast<QWidget*>(&viewport()));
        m_desk->pressKeyOf("mark-and-write");
        QCOMPARE(model().rowCount(), 2);
        type("hard, 2 cm");
        QCOMPARE(cell(1, ui::FindingsModel::Note), QString("hard, 2 cm"));
        PALPATE_TRY_COMPARE(m_desk->window().focusWidget(), static_cast<QWidget*>(&viewport()));
        m_desk->pressKeyOf("note");
        type("cirrhotic");
        QCOMPARE(model().rowCount(), 3);
        QCOMPARE(cell(2, ui::FindingsModel::Note), QString("cirrhotic"));
        QCOMPARE(m_desk->window().focusWidget(), static_cast<QWidget*>(&viewport()));

        table().setFocus();
        m_desk->press(Qt::Key_Up); // from the note to the second finding, in the column of notes
        for (int column = ui::FindingsModel::Note; column > ui::FindingsModel::Name; --column) {
            m_desk->press(Qt::Key_Left);
        }
        m_desk->press(Qt::Key_F2);
        type("tumour");
        QCOMPARE(cell(1, ui::FindingsModel::Name), QString("tumour"));
        m_desk->press(Qt::Key_Delete);
        QCOMPARE(model().rowCount(), 2);
        m_desk->pressKeyOf("undo"); // reverts the deletion
        m_desk->pressKeyOf("undo"); // reverts the name
        m_desk->pressKeyOf("undo"); // reverts the note without a position
        QCOMPARE(model().rowCount(), 2);
        QCOMPARE(cell(1, ui::FindingsModel::Name), QString("Finding 2"));
        m_desk->pressKeyOf("redo");
        m_desk->pressKeyOf("redo");
        QCOMPARE(cell(1, ui::FindingsModel::Name), QString("tumour"));
        m_desk->pressKeyOf("save");

        openScene();
        QCOMPARE(model().rowCount(), 3);
        QCOMPARE(cell(1, ui::FindingsModel::Name), QString("tumour"));
        m_desk->pressKeyOf("view-head");
        QVERIFY((eye() - from).norm() > 10.0);
        m_desk->pressKeyOf("next-finding");
        PALPATE_TRY_VERIFY((eye() - from).norm() < 1e-9);
        QCOMPARE(viewport().view().findings().marks().size(), std::size_t{2});
        QVERIFY((viewport().view().findings().marks()[0].p_W - place).norm() < 1e-9);
        QCOMPARE(viewport().view().findings().textOf(0), std::string("1  Finding 1"));
        m_desk->pressKeyOf("previous-finding"); // wraps around to the note
        QVERIFY(table().currentIndex().row() == 2);
        m_desk->pressKeyOf("next-finding");
        table().setFocus();
        m_desk->press(Qt::Key_C, Qt::ControlModifier);
        QVERIFY2(QApplication::clipboard()->text().startsWith("1\t○ other\tFinding 1\tliver\t"),
                 qPrintable(QApplication::clipboard()->text()));
        m_desk->press(Qt::Key_Return, Qt::ShiftModifier);
        QVERIFY(m_desk->window().playback().isPlaying());
        m_desk->pressKeyOf("play");
    }

    void aSizeThatIsNoneIsRefused()
    {
        playToTouch();
        m_desk->pressKeyOf("mark");
        const QModelIndex size = model().index(0, ui::FindingsModel::Size);
        for (const char* bad : {"12 cm", "-3", "1e9", "nan"}) {
            QVERIFY(!model().setData(size, bad, Qt::EditRole));
        }
        QVERIFY(model().setData(size, QLocale().toString(12.5), Qt::EditRole));
        QCOMPARE(size.data().toString(), QLocale().toString(12.5));
        m_desk->pressKeyOf("undo");
        QCOMPARE(size.data().toString(), QString());
    }

    /// A click on the type of the selected row opens the list of types; the right button opens a menu.
    void isEditedWithTheMouse()
    {
        auto& findings = dynamic_cast<ui::FindingsModel&>(model());
        findings.add({{.name = "first", .p_W = Vec3(1, 2, 3)}, {.name = "second", .p_W = Vec3(3, 2, 1)}}, "test");
        auto* dock = m_desk->window().findChild<QDockWidget*>(QStringLiteral("findings"));
        dock->show();
        dock->raise();
        QCoreApplication::processEvents();
        const QPoint place = table().visualRect(model().index(1, ui::FindingsModel::Type)).center();
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, place);
        QVERIFY(table().findChild<QComboBox*>() == nullptr);
        QTest::qWait(QApplication::doubleClickInterval() + 100);
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, place);
        PALPATE_TRY_VERIFY(table().findChild<QComboBox*>() != nullptr);
        auto* types = table().findChild<QComboBox*>();
        types->setCurrentIndex(static_cast<int>(core::FindingType::Lump));
        Q_EMIT types->activated(types->currentIndex());
        QVERIFY(findings.findings()[1].type == core::FindingType::Lump);

        Q_EMIT table().customContextMenuRequested(place);
        QMenu* menu = nullptr;
        for (auto* one : m_desk->window().findChildren<QMenu*>()) {
            menu = one->isVisible() ? one : menu;
        }
        QVERIFY(menu != nullptr);
        QStringList entries;
        for (QAction* one : menu->actions()) {
            entries << one->text();
            if (one->text() == QStringLiteral("Delete")) {
                one->trigger();
            }
        }
        QVERIFY2(entries.contains(QStringLiteral("Rename")), qPrintable(entries.join(QLatin1Char(','))));
        menu->close();
        QCOMPARE(model().rowCount(), 1);
        QCOMPARE(cell(0, ui::FindingsModel::Name), QStringLiteral("first"));
    }

    /// A marker behind the organ is hollow, and filled when seen from its side.
    void whatLiesBehindIsHollow()
    {
        m_desk->pressKeyOf("view-front");
        const auto front = viewport().view().pick(viewport().rayAt(QRectF(viewport().rect()).center()));
        QVERIFY(front.has_value());
        auto& findings = dynamic_cast<ui::FindingsModel&>(model());
        findings.add({{.name = "front", .p_W = front->hit.p_W}}, "test");
        PALPATE_TRY_COMPARE(viewport().view().findings().count(), std::size_t{1});
        viewport().grabFramebuffer();
        QVERIFY(!viewport().view().findings().isHidden(0));
        m_desk->pressKeyOf("view-back");
        viewport().grabFramebuffer();
        QVERIFY(viewport().view().findings().isHidden(0));
    }
};

PALPATE_TEST(MarkedPlaces)
#include "tst_MarkedPlaces.moc"

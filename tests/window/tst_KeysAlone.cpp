// SPDX-License-Identifier: BSD-3-Clause
#include "Desk.h"
#include "TestRunner.h"

#include <palpate/session/Findings.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/ui/FindingsModel.h>
#include <palpate/ui/Playback.h>
#include <palpate/ui/RecordedTouch.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>
#include <QTableView>
#include <QTimer>

#include <fstream>
#include <sstream>

using namespace palpate;

/// Palpates from the start page to an exported finding without a pointer: only keys, sent to the focus widget.
class KeysAlone : public QObject
{
    Q_OBJECT

    std::unique_ptr<test::Desk> m_desk;

    [[nodiscard]] MainWindow& window() const { return m_desk->window(); }
    [[nodiscard]] bool isTouching() const { return window().viewport().view().cursor().state().isInContact; }

    template<class Is>
    bool pressUntil(Qt::Key key, const Is& is)
    {
        for (int i = 0; i < 60 && !is(window().focusWidget()); ++i) {
            m_desk->press(key);
        }
        return is(window().focusWidget());
    }

    bool goToView()
    {
        return pressUntil(Qt::Key_F6, [this](const QWidget* at) { return at == &window().viewport(); });
    }

    /// Types into the editor of the focused list.
    void type(const QString& text)
    {
        PALPATE_TRY_VERIFY(qobject_cast<QLineEdit*>(QApplication::focusWidget()) != nullptr);
        QTest::keyClicks(QApplication::focusWidget(), text);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        QCoreApplication::processEvents();
    }

    /// Chooses a command in the File menu and types a path into the dialog.
    void chooseInFileMenu(const char* id, const std::filesystem::path& file)
    {
        QTimer typist;
        bool isTyped = false;
        connect(&typist, &QTimer::timeout, this, [&] {
            auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
            if (dialog == nullptr) {
                return;
            }
            QWidget* names = QApplication::activePopupWidget(); // the completer's list of files
            if (!isTyped) {
                isTyped = true;
                QTest::keyClick(dialog->focusWidget(), Qt::Key_A, Qt::ControlModifier);
                QTest::keyClicks(dialog->focusWidget(), QString::fromStdString(file.string()));
            } else {
                QTest::keyClick(names != nullptr ? names : dialog->focusWidget(), Qt::Key_Return);
            }
        });
        typist.start(100);
        m_desk->press(Qt::Key_F, Qt::AltModifier);
        PALPATE_TRY_VERIFY(qobject_cast<QMenu*>(QApplication::activePopupWidget()) != nullptr);
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        for (int i = 0; i < 30 && menu->activeAction() != &m_desk->command(id); ++i) {
            QTest::keyClick(menu, Qt::Key_Down);
        }
        QCOMPARE(menu->activeAction(), &m_desk->command(id));
        QTest::keyClick(menu, Qt::Key_Return);
        PALPATE_TRY_VERIFY(isTyped && QApplication::activeModalWidget() == nullptr);
    }

  private Q_SLOTS:
    void initTestCase()
    {
        if (!test::Desk::hasDisplay()) {
            QSKIP(test::Desk::kNoDisplay);
        }
        QCoreApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
        m_desk = std::make_unique<test::Desk>();
        QVERIFY(m_desk->show());
    }
    void cleanupTestCase() { m_desk.reset(); }

    void fromTheStartPageToAnExportedFinding()
    {
        QVERIFY(pressUntil(Qt::Key_Tab, [](const QWidget* at) {
            const auto* button = qobject_cast<const QPushButton*>(at);
            return button != nullptr && button->text() == QStringLiteral("Try the phantom");
        }));
        QSignalSpy ready(&window(), &MainWindow::ready);
        m_desk->press(Qt::Key_Space);
        PALPATE_TRY_COMPARE(ready.count(), 1);

        QVERIFY(goToView());
        m_desk->pressKeyOf("record");
        PALPATE_TRY_COMPARE(m_desk->command("record").text(), QStringLiteral("Stop"));
        m_desk->press(Qt::Key_Right, Qt::ControlModifier);
        m_desk->press(Qt::Key_Return);
        PALPATE_TRY_VERIFY(isTouching());
        for (int i = 0; i < 4; ++i) {
            m_desk->press(Qt::Key_PageDown);
        }
        QTest::qWait(500);
        QVERIFY(isTouching());

        m_desk->pressKeyOf("mark-and-write");
        type(QStringLiteral("hard, 2 cm"));
        PALPATE_TRY_COMPARE(window().focusWidget(), static_cast<QWidget*>(&window().viewport()));
        QVERIFY(pressUntil(Qt::Key_F6,
                           [](const QWidget* at) { return at->objectName() == QStringLiteral("findingsTable"); }));
        const auto* table = window().findChild<QTableView*>(QStringLiteral("findingsTable"));
        while (table->currentIndex().column() > ui::FindingsModel::Name) {
            m_desk->press(Qt::Key_Left);
        }
        m_desk->press(Qt::Key_F2);
        type(QStringLiteral("lump in IV"));
        QVERIFY(goToView());
        m_desk->press(Qt::Key_Return); // releases the press
        PALPATE_TRY_VERIFY(!isTouching());
        m_desk->pressKeyOf("record");
        PALPATE_TRY_COMPARE(m_desk->command("record").text(), QStringLiteral("Record"));

        const ui::RecordedTouch* recorded = window().playback().recording();
        QVERIFY(recorded != nullptr && recorded->duration_s() > 0.4);
        const auto reader = session::RecordingReader::open(recorded->path());
        QVERIFY(reader.isOk() && reader.value()->verify().isOk());
        const auto findings = session::findingsOf(reader.value()->events());
        QCOMPARE(findings.size(), std::size_t{1});
        QCOMPARE(findings.front().second.name, std::string("lump in IV"));
        QCOMPARE(findings.front().second.note, std::string("hard, 2 cm"));
        QVERIFY(findings.front().second.force_N > 0.0);

        const std::filesystem::path file = m_desk->folder() / "findings.csv";
        chooseInFileMenu("export-findings", file);
        std::ifstream in(file);
        std::stringstream text;
        text << in.rdbuf();
        QVERIFY2(text.str().find("lump in IV") != std::string::npos &&
                     text.str().find("hard, 2 cm") != std::string::npos,
                 text.str().c_str());
    }
};

PALPATE_TEST(KeysAlone)
#include "tst_KeysAlone.moc"

// SPDX-License-Identifier: BSD-3-Clause
#include "Desk.h"
#include "ResidentMemory.h"
#include "TestRunner.h"

#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDrag>
#include <QElapsedTimer>
#include <QTimer>
#include <QWheelEvent>

#include <algorithm>
#include <cstdio>
#include <random>
#include <vector>

using namespace palpate;

namespace {

QStringList& complaints()
{
    static QStringList lines;
    return lines;
}

void noteComplaint(QtMsgType type, const QMessageLogContext& /*context*/, const QString& text)
{
    if (type != QtDebugMsg && type != QtInfoMsg) {
        complaints() << text;
    }
}

} // namespace

/// Sends random keys and pointer events while the hand palpates, records and plays: nothing fails, stderr stays empty
/// and the memory use does not grow. PALPATE_MONKEY_S in the environment sets the duration [s], PALPATE_MONKEY_SEED the
/// seed. Requires a display.
class Monkey : public QObject
{
    Q_OBJECT

    std::unique_ptr<test::Desk> m_desk;
    std::mt19937 m_random;
    QTimer m_closer;

    int upTo(int count) { return static_cast<int>(m_random() % static_cast<unsigned>(count)); }

    /// Closes what blocks the test: a dialog, a menu, or a text drag, which waits for the real pointer.
    static void closeWhatHolds()
    {
        QDrag::cancel();
        if (QWidget* popup = QApplication::activePopupWidget()) {
            popup->close();
        } else if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget())) {
            dialog->reject();
        }
    }

    /// Returns a visible widget of the window, most often the view.
    QWidget& target()
    {
        std::vector<QWidget*> shown{&m_desk->window().viewport()};
        for (QWidget* one : m_desk->window().findChildren<QWidget*>()) {
            if (one->isVisible() && one->width() > 2 && one->height() > 2) {
                shown.push_back(one);
            }
        }
        return upTo(3) > 0 ? *shown.front() : *shown[static_cast<std::size_t>(upTo(static_cast<int>(shown.size())))];
    }

    void pressAKey()
    {
        if (upTo(2) == 0) {
            const std::vector<QAction*> commands = m_desk->window().commands().all();
            const QAction* one = commands[static_cast<std::size_t>(upTo(static_cast<int>(commands.size())))];
            if (!one->shortcut().isEmpty() && one->objectName() != QLatin1String("quit")) {
                m_desk->press(one->shortcut()[0].key(), one->shortcut()[0].keyboardModifiers());
            }
            return;
        }
        constexpr Qt::Key kKeys[] = {Qt::Key_Tab,  Qt::Key_Backtab, Qt::Key_Return, Qt::Key_Space,    Qt::Key_Escape,
                                     Qt::Key_Left, Qt::Key_Right,   Qt::Key_Up,     Qt::Key_Down,     Qt::Key_PageUp,
                                     Qt::Key_1,    Qt::Key_9,       Qt::Key_Delete, Qt::Key_PageDown, Qt::Key_F2,
                                     Qt::Key_F4,   Qt::Key_F6,      Qt::Key_A,      Qt::Key_Plus,     Qt::Key_Minus};
        constexpr Qt::KeyboardModifier kModifiers[] = {Qt::NoModifier, Qt::NoModifier, Qt::ShiftModifier,
                                                       Qt::ControlModifier};
        m_desk->press(kKeys[upTo(std::size(kKeys))], kModifiers[upTo(std::size(kModifiers))]);
    }

    void useThePointer()
    {
        QWidget& on = target();
        const auto place = [&] { return QPoint(upTo(on.width()), upTo(on.height())); };
        constexpr Qt::MouseButton kButtons[] = {Qt::LeftButton, Qt::LeftButton, Qt::LeftButton, Qt::RightButton,
                                                Qt::MiddleButton};
        const Qt::MouseButton button = kButtons[upTo(std::size(kButtons))];
        const QPointer<QWidget> there(&on); // the event may destroy the widget
        switch (upTo(4)) {
        case 0: {
            const QPointF at(place());
            QWheelEvent turn(at, on.mapToGlobal(at), {}, {0, 120 * (upTo(7) - 3)}, Qt::NoButton, Qt::NoModifier,
                             Qt::NoScrollPhase, false);
            QApplication::sendEvent(&on, &turn);
            break;
        }
        case 1:
            QTest::mouseDClick(&on, button, {}, place());
            break;
        default:
            QTest::mousePress(&on, button, {}, place());
            for (int i = upTo(12); i > 0 && there != nullptr; --i) {
                QTest::mouseMove(there, place());
                QTest::qWait(10);
            }
            if (there != nullptr) {
                QTest::mouseRelease(there, button, {}, QPoint(there->width() / 2, there->height() / 2));
            }
        }
    }

  private Q_SLOTS:
    void initTestCase()
    {
        if (!test::Desk::hasDisplay()) {
            QSKIP(test::Desk::kNoDisplay);
        }
        m_desk = std::make_unique<test::Desk>();
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->openPhantom());
        connect(&m_closer, &QTimer::timeout, &m_closer, &Monkey::closeWhatHolds);
        m_closer.start(250);
    }
    void cleanupTestCase() { m_desk.reset(); }

    void nothingBreaks()
    {
        const int seconds = std::max(qEnvironmentVariableIntValue("PALPATE_MONKEY_S"), 15);
        const auto seed = static_cast<unsigned>(qEnvironmentVariableIntValue("PALPATE_MONKEY_SEED"));
        m_random.seed(seed);
        std::printf("seed %u, %d s\n", seed, seconds);
        const auto before = qInstallMessageHandler(noteComplaint);
        std::vector<double> resident_MB; // once per second
        QElapsedTimer clock;
        clock.start();
        int done = 0;
        while (clock.elapsed() < 1000 * seconds) {
            upTo(2) == 0 ? pressAKey() : useThePointer();
            ++done;
            QTest::qWait(upTo(60));
            if (clock.elapsed() >= 1000 * static_cast<qint64>(resident_MB.size())) {
                resident_MB.push_back(test::residentBytes() * 1e-6);
            }
            QVERIFY(m_desk->window().isVisible());
        }
        qInstallMessageHandler(before);
        std::printf("%d deeds; resident %.0f MB at first, %.0f MB at last\n", done, resident_MB.front(),
                    resident_MB.back());
        QVERIFY2(complaints().isEmpty(), qPrintable(complaints().join(QLatin1Char('\n'))));
        // Flat after two minutes: repeated undo, recording and playback add less than a tenth.
        constexpr std::size_t kSettled_s = 120;
        if (resident_MB.size() > 2 * kSettled_s) {
            const auto settled = resident_MB.begin() + kSettled_s;
            const double early = *std::max_element(settled, settled + (resident_MB.end() - settled) / 2);
            const double late = *std::max_element(settled + (resident_MB.end() - settled) / 2, resident_MB.end());
            QVERIFY2(late < 1.1 * early, qPrintable(QStringLiteral("%1 MB, then %2 MB").arg(early).arg(late)));
        }
    }
};

PALPATE_TEST(Monkey)
#include "tst_Monkey.moc"

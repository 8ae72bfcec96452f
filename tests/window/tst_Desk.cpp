// SPDX-License-Identifier: BSD-3-Clause
#include "Desk.h"
#include "TestRunner.h"
#include "shared/ProgramFolders.h"
#include "shell/Help.h"

#include <palpate/session/Recording.h>
#include <palpate/ui/Pieces.h>
#include <palpate/ui/VtkViewport.h>

#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QSet>
#include <QTimer>

#include <algorithm>
#include <filesystem>
#include <functional>

using namespace palpate;

namespace {

/// Intercepts a key before its command and records the event.
class ShortcutCatcher : public QObject
{
  public:
    bool isCaught = false;
    bool eventFilter(QObject* /*watched*/, QEvent* event) override
    {
        isCaught = isCaught || event->type() == QEvent::Shortcut;
        return event->type() == QEvent::Shortcut;
    }
};

} // namespace

/// Tests the window's commands: each appears once in the list that menus, the key card and these tests read.
class Desk : public QObject
{
    Q_OBJECT

    std::unique_ptr<test::Desk> m_desk;

  private Q_SLOTS:
    void initTestCase()
    {
        if (!test::Desk::hasDisplay()) {
            QSKIP(test::Desk::kNoDisplay);
        }
        m_desk = std::make_unique<test::Desk>();
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->openPhantom());
    }
    void cleanupTestCase() { m_desk.reset(); }

    void noKeyAndNoNameIsTakenTwice()
    {
        QSet<QString> names;
        QSet<QString> keys;
        for (const QAction* action : m_desk->window().commands().all()) {
            QVERIFY2(!action->objectName().isEmpty() && !names.contains(action->objectName()),
                     qPrintable(action->objectName()));
            names << action->objectName();
            QVERIFY2(!action->text().isEmpty(), qPrintable(action->objectName()));
            for (const QKeySequence& key : action->shortcuts()) {
                QVERIFY2(!key.isEmpty(), qPrintable(action->objectName()));
                QVERIFY2(!keys.contains(key.toString()), qPrintable(key.toString()));
                keys << key.toString();
            }
        }
    }

    /// Each key on the card triggers its command under any platform theme.
    void everyKeyTriggersItsCommand()
    {
        for (QAction* action : m_desk->window().commands().all()) {
            const bool wasEnabled = action->isEnabled();
            action->setEnabled(true);
            for (const QKeySequence& key : action->shortcuts()) {
                ShortcutCatcher catcher; // in place of the command
                action->installEventFilter(&catcher);
                m_desk->window().viewport().setFocus();
                const QKeyCombination combination = key[0];
                m_desk->press(combination.key(), combination.keyboardModifiers());
                QVERIFY2(catcher.isCaught, qPrintable(action->objectName() + " by " + key.toString()));
            }
            action->setEnabled(wasEnabled);
        }
    }

    void theKeyCardTellsEachKey()
    {
        auto* card = m_desk->window().findChild<ui::KeysCard*>();
        QVERIFY(card != nullptr);
        m_desk->window().viewport().setFocus();
        m_desk->pressKeyOf("keys");
        QVERIFY(card->isVisible());
        QStringList shown;
        for (const QLabel* label : card->findChildren<QLabel*>()) {
            shown << label->text();
        }
        for (const QAction* action : m_desk->window().commands().all()) {
            const QString key = action->shortcut().toString(QKeySequence::NativeText);
            const bool isThere = key.isEmpty() || std::any_of(shown.begin(), shown.end(), [&](const QString& one) {
                                     return one.split(QStringLiteral("  ")).contains(key);
                                 });
            QVERIFY2(isThere, qPrintable(action->objectName()));
        }
        m_desk->press(Qt::Key_Escape);
        QVERIFY(!card->isVisible());
    }

    /// All menu entries are in the command list, except those created at run time.
    void menusAreMadeOfTheList()
    {
        const std::vector<QAction*> all = m_desk->window().commands().all();
        for (const char* id : {"open", "save-as", "undo", "fit", "palpate", "measures", "keys"}) {
            QAction& action = m_desk->command(id);
            const QList<QMenu*> menus = m_desk->window().menuBar()->findChildren<QMenu*>();
            QVERIFY2(std::any_of(menus.begin(), menus.end(),
                                 [&](const QMenu* menu) { return menu->actions().contains(&action); }),
                     id);
        }
        QVERIFY(all.size() > 20);
    }

    /// No menu is higher than a screen of 768 pixels, and every command of the View menu can still be reached there.
    void menusFitALowScreen()
    {
        constexpr int kScreen_px = 700; // 768 without the frame of the window and a task bar
        QList<QAction*> reached;
        std::function<void(const QMenu&)> visit = [&](const QMenu& menu) {
            QVERIFY2(menu.sizeHint().height() <= kScreen_px,
                     qPrintable(menu.title() + QString(": %1").arg(menu.sizeHint().height())));
            for (QAction* action : menu.actions()) {
                reached << action;
                if (action->menu() != nullptr) {
                    visit(*action->menu());
                }
            }
        };
        for (const QAction* top : m_desk->window().menuBar()->actions()) {
            visit(*top->menu());
        }
        for (const char* id : {"fit",
                               "view-front",
                               "view-feet",
                               "view-oblique",
                               "felt",
                               "touch-map-next",
                               "distances",
                               "tape",
                               "legend",
                               "section",
                               "section-deeper",
                               "finger-section",
                               "peek",
                               "show-findings",
                               "dent",
                               "sound",
                               "frame-ras",
                               "motion",
                               "messages",
                               "engineering",
                               "next-panel",
                               "panels",
                               "touch-map-back",
                               "text-size-150",
                               "legend-upper-left",
                               "safe-colours"}) {
            QVERIFY2(reached.contains(&m_desk->command(id)), id);
        }
        for (const char* panel : {"Structures", "Touch", "Findings", "Device", "Session"}) {
            const auto* dock = m_desk->window().findChild<QDockWidget*>(QString(panel).toLower());
            QVERIFY2(dock != nullptr && reached.contains(dock->toggleViewAction()), panel);
        }
    }

    /// Messages stand off the touched place, at the upper or the lower edge of the view.
    void messagesLeaveTheTouchedPlace()
    {
        auto* messages = m_desk->window().findChild<ui::MessageBar*>();
        ui::VtkViewport& viewport = m_desk->window().viewport();
        messages->forgetScene();
        viewport.view().camera().Dolly(4.0); // tissue everywhere in the view
        viewport.update();
        QTest::qWait(200);
        messages->showError("Something went wrong");
        PALPATE_TRY_VERIFY(messages->isVisible() && messages->height() > 10);
        const auto isBelow = [&] { return messages->y() > viewport.height() / 2; };
        view::TouchState touch;
        touch.isPresent = touch.isInContact = true;
        touch.n_W = core::Vec3::UnitZ();
        for (const bool isTop : {true, false, true}) {
            const double y = isTop ? 5.0 : viewport.height() - 5.0;
            const view::Ray ray = viewport.rayAt({0.5 * viewport.width(), y});
            touch.p_WG = touch.p_WH = ray.p_W + 100.0 * ray.d_W;
            viewport.view().cursor().setState(touch);
            Q_EMIT viewport.frameSwapped(); // before the live hand moves the cursor
            QCoreApplication::processEvents();
            PALPATE_TRY_VERIFY(isBelow() == isTop);
        }
        viewport.view().cursor().setState({});
        messages->forgetScene();
        m_desk->command("fit").trigger();
    }

    /// A label's accessible name replaces its text: a name that only describes a number would hide the number.
    void aScreenReaderHearsWhatLabelsSay()
    {
        int heard = 0;
        for (QLabel* label : m_desk->window().findChildren<QLabel*>()) {
            if (!label->isVisible() || label->text().isEmpty() || Qt::mightBeRichText(label->text())) {
                continue;
            }
            QAccessibleInterface* reader = QAccessible::queryAccessibleInterface(label);
            QVERIFY(reader != nullptr);
            const QString name = reader->text(QAccessible::Name);
            QVERIFY2(name.contains(QString(label->text()).remove(QLatin1Char('&'))),
                     qPrintable(label->text() + " is heard as " + name));
            ++heard;
        }
        QVERIFY(heard > 10);
    }

    void helpTellsVersionsAndFindsTheDocuments()
    {
        const QString text = app::Help::versions();
        for (const QString& one : {QString::fromStdString(session::palpateVersion()), QString(qVersion()),
                                   QString("VTK "), QString("SQLite "), QString("Eigen ")}) {
            QVERIFY2(text.contains(one), qPrintable(text));
        }
        const auto folder = app::docsFolder();
        QVERIFY(folder && std::filesystem::exists(*folder / "glossary.md"));
        QTimer::singleShot(200, [] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            QVERIFY(box != nullptr);
            for (QAbstractButton* button : box->buttons()) {
                if (box->buttonRole(button) == QMessageBox::ActionRole) {
                    button->click(); // copies, and keeps the box open
                }
            }
            QVERIFY(!box->iconPixmap().isNull());
            QVERIFY(box->isVisible() && box->informativeText().contains(QStringLiteral("Not a medical device")));
            box->reject();
        });
        m_desk->command("about").trigger();
        QCOMPARE(QGuiApplication::clipboard()->text(), text);
    }
};

PALPATE_TEST(Desk)
#include "tst_Desk.moc"

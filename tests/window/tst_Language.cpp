// SPDX-License-Identifier: BSD-3-Clause
#include "Desk.h"
#include "TestRunner.h"
#include "shell/Language.h"

#include <palpate/ui/Playback.h>
#include <palpate/ui/VtkViewport.h>

#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QSettings>
#include <QStyleOptionComboBox>
#include <QTranslator>

#include <QScopeGuard>

#include <algorithm>

using namespace palpate;

namespace {

/// Pseudo-locale: every text in brackets and a third longer, like German compared to English.
class PseudoLanguage : public QTranslator
{
  public:
    [[nodiscard]] bool isEmpty() const override { return false; }
    QString translate(const char* /*context*/, const char* text, const char* /*comment*/, int /*n*/) const override
    {
        const QString english = QString::fromUtf8(text);
        return QChar(0x27E6) + english + QString(english.size() / 3, QLatin1Char('~')) + QChar(0x27E7);
    }
};

/// Returns the text without its translated part.
QString untranslated(QString text)
{
    static const QRegularExpression inner(QStringLiteral("⟦[^⟦⟧]*⟧"));
    while (text.contains(inner)) {
        text.remove(inner);
    }
    return text;
}

} // namespace

/// Checks that every text of the window is translated and fits, also when a third longer and in each supported
/// language. Requires a display.
class Language : public QObject
{
    Q_OBJECT

    std::unique_ptr<test::Desk> m_desk;
    PseudoLanguage m_pseudo;

    /// Collects texts that are neither translated nor data: names of files, structures, languages, devices and
    /// threads.
    static void check(const QString& text, const QString& where, QStringList& found)
    {
        static const QStringList kData{"Palpate", "liver", "English", "Deutsch", "Français"};
        static const QStringList kEngine{"mouse", "palpate-servo"};
        for (const QString& line : untranslated(text).split(QLatin1Char('\n'))) {
            const QString left = QString(line).remove(QRegularExpression(QStringLiteral("[^\\p{L}]")));
            const bool isKnown =
                std::any_of(kData.begin(), kData.end(), [&](const QString& one) { return line.startsWith(one); }) ||
                std::any_of(kEngine.begin(), kEngine.end(),
                            [&](const QString& one) { return line.contains(one, Qt::CaseInsensitive); });
            const bool isUnit = left.size() <= 4 && left == QString(left).remove(QRegularExpression("[^Nms]"));
            const bool isLetter = line == QLatin1String("A") || line == QLatin1String("B"); // names of two recordings
            if (!left.isEmpty() && !isKnown && !isUnit && !isLetter && !line.contains(QStringLiteral(".palpate"))) {
                found << where + QStringLiteral(": ") + line;
            }
        }
    }

    /// Collects visible texts of labels and buttons that are wider than their widget.
    static QStringList cutLabels(const QWidget& window)
    {
        QStringList found;
        for (const QWidget* widget : window.findChildren<QWidget*>()) {
            const auto* label = qobject_cast<const QLabel*>(widget);
            const auto* button = qobject_cast<const QAbstractButton*>(widget);
            if (!widget->isVisible() || (label == nullptr && button == nullptr)) {
                continue;
            }
            const QString text = label != nullptr ? label->text() : button->text();
            const bool isWrapped = label != nullptr && label->wordWrap();
            if (!text.isEmpty() && !isWrapped && widget->width() < widget->minimumSizeHint().width()) {
                found << QStringLiteral("%1 of %2: %3")
                             .arg(widget->width())
                             .arg(widget->minimumSizeHint().width())
                             .arg(text);
            }
        }
        return found;
    }
    /// Collects visible texts that are wider than their widget once the layout has settled.
    static QStringList cutTexts(const QWidget& window)
    {
        QStringList found;
        (void)QTest::qWaitFor(
            [&] {
                found = cutLabels(window);
                return found.isEmpty();
            },
            test::kPatience_ms);
        for (QComboBox* box : window.findChildren<QComboBox*>()) {
            const int now = box->currentIndex();
            for (int i = 0; i < box->count() && box->isVisible(); ++i) {
                box->setCurrentIndex(i);
                const int wide = box->fontMetrics().horizontalAdvance(box->currentText());
                const auto isWhole = [&] { return roomFor(*box) >= wide && isOnTop(*box); };
                if (box->isVisible() && !QTest::qWaitFor(isWhole, test::kPatience_ms)) {
                    found << QStringLiteral("%1 of %2: %3 (%4)")
                                 .arg(roomFor(*box))
                                 .arg(wide)
                                 .arg(box->currentText(), box->accessibleName());
                }
            }
            box->setCurrentIndex(now);
        }
        return found;
    }
    /// Returns whether a widget has its full height and no sibling of the panel covers the widget.
    static bool isOnTop(const QWidget& widget)
    {
        const QWidget* ground = &widget; // up to the scrolled content of a panel, or the window
        while (ground->parentWidget() != nullptr &&
               qobject_cast<const QAbstractScrollArea*>(ground->parentWidget()->parentWidget()) == nullptr) {
            ground = ground->parentWidget();
        }
        return widget.height() >= widget.minimumSizeHint().height() &&
               ground->childAt(widget.mapTo(ground, widget.rect().center())) == &widget;
    }
    /// Returns the width available for a combo box's entry [px].
    static int roomFor(const QComboBox& box)
    {
        QStyleOptionComboBox option;
        option.initFrom(&box);
        option.subControls = QStyle::SC_All;
        option.frame = box.hasFrame();
        return box.style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, &box).width();
    }
    /// Installs a language as at program start; show the window afterwards.
    static void speak(const QString& code)
    {
        QSettings().setValue(QStringLiteral("language"), code);
        app::applyChosenLanguage();
    }
    /// Restores the state before `speak`.
    static void beSilent()
    {
        qDeleteAll(QCoreApplication::instance()->findChildren<QTranslator*>(QString(), Qt::FindDirectChildrenOnly));
        QSettings().remove(QStringLiteral("language"));
        QLocale::setDefault(QLocale::system());
    }

    /// Collects texts of the window, at the peak of the recording, whose decimal point is another.
    QStringList wrongNumbers(const QString& right)
    {
        ui::Playback& playback = m_desk->window().playback();
        if (!QTest::qWaitFor([&] { return playback.peakTime_s() > 0.0; },
                             test::kPatience_ms)) { // computed in the background
            return {QStringLiteral("no peak of the recording")};
        }
        playback.seek(playback.peakTime_s());
        QCoreApplication::processEvents();
        QStringList shown, found;
        for (const QLabel* label : m_desk->window().findChildren<QLabel*>()) {
            shown << label->text();
        }
        for (const QDoubleSpinBox* field : m_desk->window().findChildren<QDoubleSpinBox*>()) {
            shown << field->text();
        }
        const QRegularExpression written(QStringLiteral("\\d\\%1\\d").arg(right));
        if (shown.filter(written).isEmpty()) {
            found << QStringLiteral("no number with \"%1\"").arg(right);
        }
        const QString wrong = right == QLatin1String(",") ? QStringLiteral("\\.") : QStringLiteral(",");
        found << shown.filter(QRegularExpression(QStringLiteral("\\d%1\\d{1,2}(?!\\d)").arg(wrong)));
        if (QString::fromStdString(m_desk->window().viewport().view().textStyle().decimalPoint) != right) {
            found << QStringLiteral("the view has another decimal point");
        }
        return found;
    }

  private Q_SLOTS:
    void initTestCase()
    {
        if (!test::Desk::hasDisplay()) {
            QSKIP(test::Desk::kNoDisplay);
        }
        QCoreApplication::installTranslator(&m_pseudo);
        m_desk = std::make_unique<test::Desk>();
        QVERIFY(m_desk->show({1280, 800}));
        QVERIFY(m_desk->openPhantom());
        QTest::qWait(500);
    }
    void cleanupTestCase()
    {
        m_desk.reset();
        QCoreApplication::removeTranslator(&m_pseudo);
    }

    void everyTextIsTranslated()
    {
        QStringList found;
        for (const QAction* action : m_desk->window().findChildren<QAction*>()) {
            check(action->text(), QStringLiteral("action"), found);
            check(action->toolTip(), QStringLiteral("action's tip"), found);
        }
        for (const QWidget* widget : m_desk->window().findChildren<QWidget*>()) {
            const QString where = QLatin1String(widget->metaObject()->className());
            check(widget->accessibleName(), where + QStringLiteral("'s name"), found);
            check(widget->accessibleDescription(), where + QStringLiteral("'s description"), found);
            check(widget->toolTip(), where + QStringLiteral("'s tip"), found);
            if (const auto* label = qobject_cast<const QLabel*>(widget)) {
                check(label->text(), where, found);
            } else if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
                check(button->text(), where, found);
            } else if (const auto* box = qobject_cast<const QGroupBox*>(widget)) {
                check(box->title(), where, found);
            } else if (const auto* dock = qobject_cast<const QDockWidget*>(widget)) {
                check(dock->windowTitle(), where, found);
            }
        }
        QVERIFY2(found.isEmpty(), qPrintable(found.join(QLatin1Char('\n'))));
    }

    void noTextIsCut()
    {
        m_desk->picture().save(QString::fromStdString(m_desk->folder() / "pseudo.png"));
        const QStringList found = cutTexts(m_desk->window());
        QVERIFY2(found.isEmpty(), qPrintable(found.join(QLatin1Char('\n'))));
    }

    void everyLanguageIsWhole_data()
    {
        QTest::addColumn<QString>("code");
        for (const app::Language& language : app::languages()) {
            QTest::newRow(qPrintable(language.code)) << language.code;
        }
    }
    /// Checks the window in a language: no text is cut, at two sizes, and numbers have the decimal point of the
    /// language.
    void everyLanguageIsWhole()
    {
        QFETCH(QString, code);
        QCoreApplication::removeTranslator(&m_pseudo);
        speak(code);
        const auto restore = qScopeGuard([] {
            ui::applyTextSize(100);
            beSilent();
        });
        QVERIFY(m_desk->show({1280, 800}));
        for (const QLabel* label : m_desk->window().findChildren<QLabel*>()) {
            QVERIFY2(code == QLatin1String("en") || !label->text().contains(QStringLiteral(" or ")),
                     qPrintable(label->text()));
        }
        QVERIFY(m_desk->openPhantom());
        QStringList found;
        for (const int percent : {150, 100}) {
            ui::applyTextSize(percent);
            for (const QString& text : cutTexts(m_desk->window())) {
                found << QStringLiteral("%1 %: ").arg(percent) + text;
            }
            QCOMPARE(m_desk->window().size(), QSize(1280, 800));
        }
        found << wrongNumbers(QLocale(code).decimalPoint());
        QVERIFY2(found.isEmpty(), qPrintable(found.join(QLatin1Char('\n'))));
    }
};

PALPATE_TEST(Language)
#include "tst_Language.moc"

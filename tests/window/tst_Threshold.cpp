// SPDX-License-Identifier: BSD-3-Clause
#include "Desk.h"
#include "Shapes.h"
#include "TestRunner.h"
#include "touch/ThresholdDialog.h"

#include <palpate/ui/FeltWords.h>
#include <palpate/ui/OwnThreshold.h>

#include <QAction>
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>

#include <cmath>
#include <random>

using namespace palpate;

/// Tests the dialog that measures the threshold of a hand, with a simulated observer.
class Threshold : public QObject
{
    Q_OBJECT

    std::unique_ptr<test::Desk> m_desk;

    app::ThresholdDialog* dialog() { return m_desk->window().findChild<app::ThresholdDialog*>(); }
    QPushButton* button(const QString& text)
    {
        for (QPushButton* one : dialog()->findChildren<QPushButton*>()) {
            if (one->text().remove(QLatin1Char('&')).startsWith(text)) {
                return one;
            }
        }
        qFatal("no such button");
    }
    QString shown()
    {
        QString all;
        for (const QLabel* one : dialog()->findChildren<QLabel*>()) {
            all += one->text() + QLatin1Char('\n');
        }
        return all;
    }
    /// Answers trials like a hand with a threshold of 20 %, without the event loop, in which the simulated hand might
    /// touch the wall.
    void answer(int trials, unsigned seed)
    {
        std::mt19937 random(seed);
        for (int i = 0; i < trials && dialog()->series(); ++i) {
            for (int press = 0; press < 2; ++press) {
                QVERIFY(!button("The first")->isEnabled());
                dialog()->takeForce(0.3); // a touch is no press
                dialog()->takeForce(0.0);
                dialog()->takeForce(1.5);
                dialog()->takeForce(0.0);
            }
            const study::PressedPairs& pairs = *dialog()->series();
            const double u = (static_cast<double>(random()) + 0.5) / 4294967296.0;
            const bool isRight = u < study::rightAnswers(pairs.series().percent(), 20.0, 3.5, 2);
            button(pairs.isSecondStiffer() == isRight ? "The second" : "The first")->click();
        }
    }

  private Q_SLOTS:
    void initTestCase()
    {
        if (!test::Desk::hasDisplay()) {
            QSKIP(test::Desk::kNoDisplay);
        }
        m_desk = std::make_unique<test::Desk>();
        const std::filesystem::path organ = m_desk->writeStl("organ.stl", test::sphere(8, 40.0));
        QVERIFY(m_desk->show());
        QVERIFY(m_desk->open({organ}));
    }
    void cleanupTestCase() { m_desk.reset(); }

    void needsADeviceWithForce()
    {
        m_desk->command("threshold").trigger();
        QVERIFY(!button("Start")->isEnabled() && shown().contains("device that renders force"));
        dialog()->close();
        PALPATE_TRY_VERIFY(dialog() == nullptr);
    }

    void estimatesStoresUsesAndForgetsTheThreshold()
    {
        m_desk->window().chooseDevice("simulated");
        PALPATE_TRY_VERIFY(!m_desk->window().usesPointer());
        m_desk->command("threshold").trigger();
        button("Start")->click();
        QVERIFY(dialog()->series().has_value());
        answer(19, 1);
        button("Interrupt")->click();
        QVERIFY(!ui::OwnThreshold::stored() && shown().contains("after 19 trials"));

        button("Start")->click();
        answer(1000, 2);
        QVERIFY(!dialog()->series());
        const auto own = ui::OwnThreshold::stored();
        QVERIFY(own.has_value());
        QCOMPARE(own->trials, 60);
        QVERIFY2(own->measured.low_percent < 20.0 && 20.0 < own->measured.high_percent,
                 qPrintable(ui::weberText(own->measured)));
        QVERIFY2(shown().contains("Weber fraction " + ui::weberText(own->measured)), qPrintable(shown()));
        if (const QString folder = qEnvironmentVariable("PALPATE_KEEP_PICTURES"); !folder.isEmpty()) {
            dialog()->grab().save(folder + QStringLiteral("/threshold.png"));
        }

        // Verdicts for this hand only if asked for.
        QCOMPARE(ui::verdictPhrase(1.5), QStringLiteral("plainly felt"));
        auto* use = dialog()->findChild<QCheckBox*>();
        use->click();
        QCOMPARE(ui::verdictPhrase(1.5), QStringLiteral("plainly felt (for your hand: felt)"));
        QCOMPARE(ui::verdictPhrase(1.08), QStringLiteral("too little for a trained hand (for your hand: not felt)"));
        button("Delete")->click();
        QVERIFY(!ui::OwnThreshold::stored() && !use->isEnabled());
        QCOMPARE(ui::verdictPhrase(1.5), QStringLiteral("plainly felt"));
        dialog()->close();
        PALPATE_TRY_VERIFY(dialog() == nullptr);
    }
};

PALPATE_TEST(Threshold)
#include "tst_Threshold.moc"

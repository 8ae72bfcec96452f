// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/ui/ClipboardCell.h>
#include <palpate/ui/FeltPanel.h>
#include <palpate/ui/FeltWords.h>

#include <QLocale>
#include <QTest>

#include <limits>

using namespace palpate;
using buried::FeltSurface;

/// Tests the texts for a position, with synthetic values.
class FeltWords : public QObject
{
    Q_OBJECT

    /// Four vertices: a lump that is palpable when pressed, an impalpable lump, a lump without a verdict, a cyst.
    static FeltSurface made()
    {
        constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
        FeltSurface felt;
        felt.lumps = {{"lump_a", 0, 3.0, 6.0, {}}, {"cyst", 1, 0.05, 4.0, {}}};
        felt.press = {{0.0, {1.05F, 1.0F, 1.4F, 0.8F}, {1.08F, 1.0F, 1.5F, 0.85F}, {1.14F, 1.0F, 1.6F, 0.9F}},
                      {2.0, {1.07F, 1.0F, 1.4F, 0.7F}, {1.12F, 1.0F, 1.5F, 0.77F}, {1.2F, 1.0F, 1.6F, 0.8F}},
                      {8.0, {1.3F, 1.0F, 1.4F, 0.6F}, {1.48F, 1.0F, 1.5F, 0.6F}, {1.7F, 1.0F, 1.6F, 0.7F}}};
        felt.cover_mm = {6.1F, kNone, 3.0F, 4.0F};
        felt.lump = {1, 0, 1, 2};
        felt.notJudged = {0, 0, buried::kCurved | buried::kThin, 0};
        return felt;
    }
    static QString said(std::size_t vertex, std::size_t press)
    {
        return ui::palpabilityText(made(), vertex, press).simplified();
    }

  private Q_SLOTS:
    /// A name that a spreadsheet would treat as a formula is copied as text, a number as a number.
    void clipboardHoldsNoFormula()
    {
        QCOMPARE(ui::clipboardCell(QStringLiteral("=1+1")), QStringLiteral("'=1+1"));
        QCOMPARE(ui::clipboardCell(QStringLiteral("\t@sum(a\n)")), QStringLiteral("'@sum(a )"));
        QCOMPARE(ui::clipboardCell(QStringLiteral("+8 %")), QStringLiteral("'+8 %"));
        QCOMPARE(ui::clipboardCell(QStringLiteral("-0.25")), QStringLiteral("-0.25"));
        QCOMPARE(ui::clipboardCell(QStringLiteral("liver\tleft")), QStringLiteral("liver left"));
    }

    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void changesHaveTheirSign()
    {
        QCOMPARE(ui::responseChangeText(1.084), QStringLiteral("+8 %"));
        QCOMPARE(ui::responseChangeText(1.004), QStringLiteral("0 %"));
        QCOMPARE(ui::responseChangeText(0.996), QStringLiteral("0 %"));
        QCOMPARE(ui::responseChangeText(0.85), QStringLiteral("-15 %"));
        QCOMPARE(ui::responseChangeText(2.04), QStringLiteral("+104 %"));
    }

    void aPlaceIsSaidInWords()
    {
        QCOMPARE(said(0, 0), QStringLiteral("lump a: 6 mm below, +8 % (5 … 14 %): too little for a trained hand; "
                                            "+48 % when pressed 8 mm"));
        QCOMPARE(said(0, 2), QStringLiteral("lump a: 6 mm below, +48 % (30 … 70 %): plainly felt"));
        QCOMPARE(said(1, 0), QStringLiteral("no palpable lump here"));
        QCOMPARE(said(3, 0),
                 QStringLiteral("cyst: 4 mm below, -15 % (-20 … -10 %): felt by a trained hand; -23 % when "
                                "pressed 2 mm")); // a change of 30 %: clear wording
    }

    void whatIsNotJudgedHasNoNumber()
    {
        QCOMPARE(said(2, 0), QStringLiteral("not judged here: surface too curved, organ too thin"));
    }

    /// Window and engine use the same English texts.
    void verdictsAndRatiosAreSaidAsByTheEngine()
    {
        FeltSurface::LumpPress press;
        press.verdict = buried::Verdict::ByTrainedHand;
        press.verdictAtLow = buried::Verdict::NotByHand;
        press.verdictAtHigh = buried::Verdict::Plainly;
        const buried::RatioRange range(2.5, 4.4, 10.0);
        QCOMPARE(ui::verdictRangeText(press, range), QString::fromStdString(buried::verdictText(press, range)));
        QCOMPARE(ui::verdictRangeText(press, range),
                 QStringLiteral("by a trained hand (at 2.5: not by hand; at 10: plainly)"));
        press.verdictAtLow = press.verdictAtHigh = press.verdict;
        QCOMPARE(ui::verdictRangeText(press, range), QStringLiteral("by a trained hand"));
        QCOMPARE(ui::ratioRangeText(std::nullopt), QStringLiteral("unknown"));
        for (const study::PublishedRatio& one : study::publishedRatios()) {
            QCOMPARE(ui::publishedName(one), QString::fromUtf8(one.name.text().data()));
        }
    }
};

PALPATE_TEST(FeltWords)
#include "tst_FeltWords.moc"

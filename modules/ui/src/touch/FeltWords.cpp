// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/FeltWords.h"

#include "palpate/ui/OwnThreshold.h"
#include "palpate/ui/StructureModel.h"
#include "palpate/ui/Translated.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include <array>
#include <cmath>

namespace palpate::ui {

namespace {

constexpr const char* kContext = "palpate::ui::FeltWords";

/// Texts of buried::kVerdictNames and study::sourceText, listed for the translation catalogues.
[[maybe_unused]] constexpr std::array<const char*, 9> kTranslated{
    QT_TRANSLATE_NOOP("palpate::ui::FeltWords", "not by hand"),
    QT_TRANSLATE_NOOP("palpate::ui::FeltWords", "by a trained hand"),
    QT_TRANSLATE_NOOP("palpate::ui::FeltWords", "plainly"),
    QT_TRANSLATE_NOOP("palpate::ui::FeltWords", "not judged"),
    QT_TRANSLATE_NOOP("palpate::ui::FeltWords", "as typed"),
    QT_TRANSLATE_NOOP("palpate::ui::FeltWords", "from the moduli"),
    QT_TRANSLATE_NOOP("palpate::ui::FeltWords", "from the tissues' stiffness"),
    QT_TRANSLATE_NOOP("palpate::ui::FeltWords", "stiffness ratio not known"),
    QT_TRANSLATE_NOOP("palpate::ui::FeltWords", "published for such lumps"),
};

QString shortText(double ratio)
{
    return numberText(ratio, 3);
}

QString percent(double ratio)
{
    return QLocale().toString(static_cast<int>(std::lround(100.0 * (ratio - 1.0))));
}

QString notEvaluatedText(std::uint8_t why)
{
    QStringList reasons;
    if ((why & buried::kCurved) != 0) {
        reasons << QCoreApplication::translate("palpate::ui::FeltWords", "surface too curved");
    }
    if ((why & buried::kThin) != 0) {
        reasons << QCoreApplication::translate("palpate::ui::FeltWords", "organ too thin");
    }
    if ((why & buried::kOverlapping) != 0) {
        reasons << QCoreApplication::translate("palpate::ui::FeltWords", "lumps overlap");
    }
    return QCoreApplication::translate("palpate::ui::FeltWords", "not judged here: %1")
        .arg(reasons.join(QStringLiteral(", ")));
}

/// Effect of a deeper press: "; +17 % when pressed 4 mm". Uses the shallowest press that improves the verdict, else the
/// deepest press.
QString whenPressed(const buried::FeltSurface& felt, std::size_t vertex, std::size_t press)
{
    const buried::Verdict now = buried::verdictOf(felt.press[press].ratio[vertex]);
    if (press + 1 >= felt.press.size() || now == buried::Verdict::Plainly) {
        return {};
    }
    std::size_t deeper = felt.press.size() - 1;
    for (std::size_t i = press + 1; i < felt.press.size(); ++i) {
        if (buried::verdictOf(felt.press[i].ratio[vertex]) > now) {
            deeper = i;
            break;
        }
    }
    return QCoreApplication::translate("palpate::ui::FeltWords", ";\n%1 when pressed %2 mm")
        .arg(responseChangeText(felt.press[deeper].ratio[vertex]), numberText(felt.press[deeper].press_mm));
}

} // namespace

QString responseChangeText(double ratio)
{
    const QString sign = std::lround(100.0 * (ratio - 1.0)) > 0 ? QStringLiteral("+") : QString();
    return QStringLiteral("%1%2 %").arg(sign, percent(ratio));
}

QString verdictPhrase(buried::Verdict verdict)
{
    switch (verdict) {
    case buried::Verdict::Plainly:
        return QCoreApplication::translate("palpate::ui::FeltWords", "plainly felt");
    case buried::Verdict::ByTrainedHand:
        return QCoreApplication::translate("palpate::ui::FeltWords", "felt by a trained hand");
    default:
        return QCoreApplication::translate("palpate::ui::FeltWords", "too little for a trained hand");
    }
}

QString verdictPhrase(double ratio)
{
    const QString general = verdictPhrase(buried::verdictOf(ratio)), own = ownVerdictText(ratio);
    return own.isEmpty() ? general : QCoreApplication::translate("palpate::ui::FeltWords", "%1 (%2)").arg(general, own);
}

QString verdictRangeText(const buried::FeltSurface::LumpPress& press, const std::optional<buried::RatioRange>& ratio)
{
    if (!ratio || (press.verdictAtLow == press.verdict && press.verdictAtHigh == press.verdict)) {
        return verdictText(press.verdict);
    }
    return QCoreApplication::translate("palpate::ui::FeltWords", "%1 (at %2: %3; at %4: %5)")
        .arg(verdictText(press.verdict), shortText(ratio->low), verdictText(press.verdictAtLow), shortText(ratio->high),
             verdictText(press.verdictAtHigh));
}

QString ratioRangeText(const std::optional<study::StiffnessRatio>& ratio)
{
    if (!ratio) {
        return QCoreApplication::translate("palpate::ui::FeltWords", "unknown");
    }
    return ratio->isRange() ? QStringLiteral("%1 (%2 … %3)")
                                  .arg(shortText(ratio->typical), shortText(ratio->low), shortText(ratio->high))
                            : shortText(ratio->typical);
}

QString publishedName(const study::PublishedRatio& published)
{
    return translated(core::Message(published.name));
}

QString verdictText(buried::Verdict verdict)
{
    return QCoreApplication::translate(kContext, buried::kVerdictNames[static_cast<std::size_t>(verdict)].data());
}

QString verdictSign(buried::Verdict verdict)
{
    switch (verdict) {
    case buried::Verdict::Plainly:
        return QStringLiteral("●");
    case buried::Verdict::ByTrainedHand:
        return QStringLiteral("◐");
    case buried::Verdict::NotByHand:
        return QStringLiteral("○");
    case buried::Verdict::NotKnown:
        return QStringLiteral("?");
    case buried::Verdict::NotJudged:
        break;
    }
    return QStringLiteral("–");
}

QString ratioSourceText(study::RatioSource source)
{
    return QCoreApplication::translate(kContext, study::sourceText(source).data());
}

QString palpabilityText(const buried::FeltSurface& felt, std::size_t vertex, std::size_t press)
{
    if (felt.notJudged[vertex] != 0) {
        return notEvaluatedText(felt.notJudged[vertex]);
    }
    if (felt.lump[vertex] == 0) {
        return QCoreApplication::translate("palpate::ui::FeltWords", "no palpable lump here");
    }
    const buried::FeltSurface::Press& here = felt.press[press];
    const buried::FeltSurface::Lump& lump = felt.lumps[felt.lump[vertex] - 1U];
    const QString name = lump.ratio && lump.ratio->isRange()
                             ? QCoreApplication::translate("palpate::ui::FeltWords", "%1 (stiffness ratio %2)")
                                   .arg(readableName(lump.name), shortText(lump.ratio->typical))
                             : readableName(lump.name);
    return QCoreApplication::translate("palpate::ui::FeltWords", "%1: %2 mm below, %3 (%4 … %5 %): %6")
               .arg(name, QLocale().toString(felt.cover_mm[vertex], 'f', 0), responseChangeText(here.ratio[vertex]),
                    percent(here.low[vertex]), percent(here.high[vertex]), verdictPhrase(here.ratio[vertex])) +
           whenPressed(felt, vertex, press);
}

} // namespace palpate::ui

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/OwnThreshold.h"

#include <QCoreApplication>
#include <QLocale>
#include <QSettings>

#include <cmath>

namespace palpate::ui {

namespace {

constexpr auto kThresholdGroup = "own_threshold";

} // namespace

std::optional<OwnThreshold> OwnThreshold::stored()
{
    QSettings settings;
    settings.beginGroup(QLatin1String(kThresholdGroup));
    OwnThreshold own;
    own.measured = {settings.value(QStringLiteral("percent")).toDouble(),
                    settings.value(QStringLiteral("low_percent")).toDouble(),
                    settings.value(QStringLiteral("high_percent")).toDouble()};
    own.device = settings.value(QStringLiteral("device")).toString();
    own.trials = settings.value(QStringLiteral("trials")).toInt();
    own.isUsed = settings.value(QStringLiteral("used")).toBool();
    return own.measured.percent > 0.0 && std::isfinite(own.measured.percent) ? std::optional(own) : std::nullopt;
}

void OwnThreshold::store() const
{
    QSettings settings;
    settings.beginGroup(QLatin1String(kThresholdGroup));
    settings.setValue(QStringLiteral("percent"), measured.percent);
    settings.setValue(QStringLiteral("low_percent"), measured.low_percent);
    settings.setValue(QStringLiteral("high_percent"), measured.high_percent);
    settings.setValue(QStringLiteral("device"), device);
    settings.setValue(QStringLiteral("trials"), trials);
    settings.setValue(QStringLiteral("used"), isUsed);
}

void OwnThreshold::reset()
{
    QSettings().remove(QLatin1String(kThresholdGroup));
}

QString weberText(const study::HandThreshold& threshold)
{
    const QLocale locale;
    return QCoreApplication::translate("OwnThreshold", "%1 ± %2")
        .arg(locale.toString(0.01 * threshold.percent, 'f', 2),
             locale.toString(0.005 * (threshold.high_percent - threshold.low_percent), 'f', 2));
}

QString ownVerdictText(double ratio)
{
    const auto own = OwnThreshold::stored();
    if (!own || !own->isUsed || !(ratio > 0.0)) {
        return {};
    }
    return std::abs(std::log(ratio)) >= std::log1p(0.01 * own->measured.percent)
               ? QCoreApplication::translate("OwnThreshold", "for your hand: felt")
               : QCoreApplication::translate("OwnThreshold", "for your hand: not felt");
}

} // namespace palpate::ui

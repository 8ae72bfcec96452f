// SPDX-License-Identifier: BSD-3-Clause
#include "database/LawText.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

namespace palpate::session::internal {

namespace {

QString text(std::string_view utf8)
{
    return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
}

/// @return empty if any entry is not a pair of numbers.
std::optional<std::vector<core::ForceLaw::Point>> parsePoints(const QJsonArray& array)
{
    std::vector<core::ForceLaw::Point> points;
    for (const QJsonValue& value : array) {
        const QJsonArray pair = value.toArray();
        if (pair.size() != 2 || !pair[0].isDouble() || !pair[1].isDouble()) {
            return std::nullopt;
        }
        points.push_back({pair[0].toDouble(), pair[1].toDouble()});
    }
    return points;
}

} // namespace

std::string lawText(const core::ForceLaw& law)
{
    if (law.kind == core::LawKind::Linear) {
        return {};
    }
    QJsonObject json{{QStringLiteral("kind"), text(core::lawName(law.kind))}};
    const auto terms = core::lawParameters(law.kind);
    for (std::size_t i = 0; i < terms.size(); ++i) {
        json[text(terms[i].key)] = law.numbers[i];
    }
    if (law.kind == core::LawKind::Points) {
        QJsonArray points;
        for (const core::ForceLaw::Point& point : law.points) {
            points.append(QJsonArray{point[0], point[1]});
        }
        json[QStringLiteral("points")] = points;
    }
    return QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString();
}

std::optional<core::ForceLaw> parseLaw(std::string_view utf8)
{
    core::ForceLaw law;
    if (utf8.empty()) {
        return law;
    }
    const QJsonObject json =
        QJsonDocument::fromJson(QByteArray(utf8.data(), static_cast<qsizetype>(utf8.size()))).object();
    const QString name = json[QStringLiteral("kind")].toString();
    const auto kind = std::find_if(core::kLawKinds.begin(), core::kLawKinds.end(),
                                   [&](core::LawKind k) { return text(core::lawName(k)) == name; });
    if (kind == core::kLawKinds.end() || *kind == core::LawKind::Linear) {
        return std::nullopt;
    }
    law.kind = *kind;
    const auto terms = core::lawParameters(law.kind);
    for (std::size_t i = 0; i < terms.size(); ++i) {
        const QJsonValue number = json[text(terms[i].key)];
        law.numbers[i] = number.toDouble();
        if (!number.isDouble()) {
            return std::nullopt;
        }
    }
    if (law.kind == core::LawKind::Points) {
        auto points = parsePoints(json[QStringLiteral("points")].toArray());
        if (!points) {
            return std::nullopt;
        }
        law.points = std::move(*points);
    }
    return core::check(law).isOk() ? std::optional(law) : std::nullopt;
}

} // namespace palpate::session::internal

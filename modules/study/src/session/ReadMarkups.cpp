// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/FindingsFile.h"

#include <palpate/core/Text.h>
#include <palpate/session/Findings.h>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>

#include <cctype>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace palpate::study {

using core::Finding;
using core::Result;
using core::Status;
using core::StatusCode;

namespace {

constexpr qint64 kMostBytes = 64 * 1024 * 1024;
constexpr qsizetype kMostLetters = 1000; // of a label or a description
constexpr double kMostMm = 1e7;          // same limit as in a scene file

/// Collects omitted data: one line per cause with the count and the first location.
class LossList
{
  public:
    explicit LossList(std::string file)
        : m_file(std::move(file))
    {
    }
    void add(const core::Message& what, const std::string& place)
    {
        for (Loss& loss : m_losses) {
            if (loss.what.english() == what.english()) {
                ++loss.count;
                return;
            }
        }
        m_losses.push_back({what, place, 1});
    }
    [[nodiscard]] std::vector<core::Message> lines() const
    {
        std::vector<core::Message> out;
        for (const Loss& loss : m_losses) {
            out.push_back(loss.count > 1 ? core::Message(PALPATE_TEXT("%1: %2: %3 (and %4 more)"), m_file, loss.place,
                                                         loss.what, core::Count(loss.count - 1))
                                         : core::Message(PALPATE_TEXT("%1: %2: %3"), m_file, loss.place, loss.what));
        }
        return out;
    }

  private:
    struct Loss
    {
        core::Message what;
        std::string place;
        int count = 0;
    };
    std::string m_file;
    std::vector<Loss> m_losses;
};

/// Replaces NaN and Infinity by null. Some programs write these words, which JSON does not allow.
QByteArray withoutWords(const QByteArray& text)
{
    QByteArray out;
    out.reserve(text.size());
    bool isInText = false;
    for (qsizetype i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const bool startsWord = !isInText && std::isalpha(static_cast<unsigned char>(c)) != 0;
        if (!startsWord) {
            out += c;
            if (isInText && c == '\\' && i + 1 < text.size()) {
                out += text[++i];
            } else if (c == '"') {
                isInText = !isInText;
            }
            continue;
        }
        qsizetype end = i;
        while (end < text.size() && std::isalpha(static_cast<unsigned char>(text[end])) != 0) {
            ++end;
        }
        const QByteArray word = text.mid(i, end - i).toLower();
        if (word == "nan" || word == "inf" || word == "infinity") {
            out.chop(out.endsWith('-') ? 1 : 0);
            out += "null";
        } else {
            out += text.mid(i, end - i); // includes the e of 1e5
        }
        i = end - 1;
    }
    return out;
}

/// @return millimetres per unit; empty for a unit that markups do not define.
std::optional<double> unitOf(const QJsonValue& value)
{
    const QString unit = value.isArray() ? value.toArray().first().toString() : value.toString(QStringLiteral("mm"));
    return unit == QLatin1String("mm")   ? std::optional(1.0)
           : unit == QLatin1String("um") ? std::optional(1e-3)
                                         : std::nullopt;
}

class MarkupsReader
{
  public:
    explicit MarkupsReader(std::string file)
        : m_losses(std::move(file))
    {
    }

    void checkSchema(const QJsonValue& schema)
    {
        static const QRegularExpression kVersion(QStringLiteral("v(\\d+)\\.(\\d+)"));
        const QRegularExpressionMatch found = kVersion.match(schema.toString());
        if (found.hasMatch() ? found.captured(1) != QLatin1String("1") : true) {
            m_losses.add(
                found.hasMatch()
                    ? core::Message(PALPATE_TEXT("found version %1, expected 1.0: read as far as it is the same"),
                                    (found.captured(1) + '.' + found.captured(2)).toStdString())
                    : core::Message(PALPATE_TEXT("found no version, expected 1.0: read as far as it is the same")),
                "@schema");
        }
    }

    void addList(const QJsonObject& list, const std::string& place)
    {
        const QString type = list["type"].toString();
        if (type != QLatin1String("Fiducial") && type != QLatin1String("Line")) {
            m_losses.add(
                {PALPATE_TEXT("found %1, expected points or a line: left out"), core::inQuotes(type.toStdString())},
                place + ".type");
            return;
        }
        const QString system = list["coordinateSystem"].toString(QStringLiteral("LPS"));
        m_isRas = system == QLatin1String("RAS") || system == QLatin1String("0");
        const bool isLps = system == QLatin1String("LPS") || system == QLatin1String("1");
        if (!m_isRas && !isLps) {
            m_losses.add({PALPATE_TEXT("found %1, expected LPS or RAS: the list is left out"),
                          core::inQuotes(system.toStdString())},
                         place + ".coordinateSystem");
            return;
        }
        const auto unit_mm = unitOf(list["coordinateUnits"]);
        if (!unit_mm) {
            m_losses.add({PALPATE_TEXT("found another unit, expected mm or um: the list is left out")},
                         place + ".coordinateUnits");
            return;
        }
        m_unit_mm = *unit_mm;
        m_type = core::findingType(list["name"].toString().toLower().toStdString());
        const QJsonArray points = list["controlPoints"].toArray();
        if (type == QLatin1String("Line")) {
            addLine(list["name"], points, place);
            return;
        }
        for (qsizetype i = 0; i < points.size(); ++i) {
            addPoint(points[i].toObject(), place + ".controlPoints[" + std::to_string(i) + "]");
        }
    }

    [[nodiscard]] Markups result() { return {std::move(m_findings), m_losses.lines()}; }

  private:
    void addPoint(const QJsonObject& point, const std::string& place)
    {
        if (m_findings.size() >= kMaxMarkups) {
            m_losses.add({PALPATE_TEXT("found more than %1 points: left out"), core::Count(kMaxMarkups)}, place);
            return;
        }
        const bool isOurs = point["palpate"].isObject();
        Finding finding = isOurs ? session::findingFrom(point["palpate"].toObject()) : Finding{};
        const bool isNote = isOurs && !finding.hasPlace && point["positionStatus"] == QLatin1String("undefined");
        if (!isNote && !readPlace(point, place, finding)) {
            return;
        }
        finding.name = bounded(point["label"], place + ".label");
        if (!isOurs) {
            finding.type = m_type.value_or(core::FindingType::Other);
            finding.note = bounded(point["description"], place + ".description");
        }
        m_findings.push_back(std::move(finding));
    }

    /// Adds a line as a finding in its middle, with its length as the size.
    void addLine(const QJsonValue& name, const QJsonArray& points, const std::string& place)
    {
        Finding first, second;
        if (points.size() != 2) {
            m_losses.add({PALPATE_TEXT("found a line without two points: left out")}, place + ".controlPoints");
        } else if (m_findings.size() >= kMaxMarkups) {
            m_losses.add({PALPATE_TEXT("found more than %1 points: left out"), core::Count(kMaxMarkups)}, place);
        } else if (readPlace(points[0].toObject(), place + ".controlPoints[0]", first) &&
                   readPlace(points[1].toObject(), place + ".controlPoints[1]", second)) {
            Finding& line = m_findings.emplace_back();
            line.name = bounded(name, place + ".name");
            line.hasPlace = true;
            line.p_W = 0.5 * (first.p_W + second.p_W);
            line.size_mm = (second.p_W - first.p_W).norm();
        }
    }

    bool readPlace(const QJsonObject& point, const std::string& place, Finding& finding)
    {
        const QString status = point["positionStatus"].toString(QStringLiteral("defined"));
        const QJsonArray numbers = point["position"].toArray();
        if (status != QLatin1String("defined") || numbers.size() != 3) {
            m_losses.add({PALPATE_TEXT("found no position: left out")}, place);
            return false;
        }
        for (int axis = 0; axis < 3; ++axis) {
            const double value = numbers[axis].toDouble(std::nan("")) * m_unit_mm;
            if (!(std::abs(value) <= kMostMm)) {
                m_losses.add({PALPATE_TEXT("found a coordinate that is not a number within 10⁷ mm: left out")},
                             place + ".position");
                return false;
            }
            finding.p_W[axis] = m_isRas && axis < 2 ? -value : value;
        }
        finding.hasPlace = true;
        return true;
    }

    std::string bounded(const QJsonValue& value, const std::string& place)
    {
        const QString text = value.toString();
        if (text.size() <= kMostLetters) {
            return text.toStdString();
        }
        m_losses.add({PALPATE_TEXT("found a text of %1 characters, expected at most %2: shortened"),
                      core::Count(text.size()), core::Count(kMostLetters)},
                     place);
        const bool cutsPair = text[kMostLetters - 1].isHighSurrogate();
        return text.left(kMostLetters - (cutsPair ? 1 : 0)).toStdString();
    }

    LossList m_losses;
    std::vector<Finding> m_findings;
    std::optional<core::FindingType> m_type; // of the current list
    double m_unit_mm = 1.0;
    bool m_isRas = false;
};

} // namespace

Result<Markups> readMarkups(const std::filesystem::path& path)
{
    const std::string name = path.filename().string();
    QFile file(QString::fromStdU16String(path.u16string()));
    if (!file.open(QIODevice::ReadOnly)) {
        return Status(StatusCode::Unreadable, PALPATE_TEXT("%1: cannot be opened: %2"), name,
                      file.errorString().toStdString());
    }
    const QByteArray bytes = file.read(kMostBytes + 1);
    if (bytes.size() > kMostBytes) {
        return Status(StatusCode::BadFormat, PALPATE_TEXT("%1: found more than 64 MiB, expected a list of points"),
                      name);
    }
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(withoutWords(bytes), &error);
    if (!document.isObject()) {
        return Status(
            StatusCode::BadFormat, PALPATE_TEXT("%1: byte %2: found %3, expected markups of 3D Slicer (.mrk.json)"),
            name, error.offset,
            error.error == QJsonParseError::NoError ? core::Message(PALPATE_TEXT("no JSON object"))
                                                    : core::Message::untranslated(error.errorString().toStdString()));
    }
    if (!document["markups"].isArray()) {
        return Status(StatusCode::BadFormat,
                      PALPATE_TEXT("%1: markups: found nothing, expected lists of points: is this a .mrk.json of 3D "
                                   "Slicer?"),
                      name);
    }
    MarkupsReader reader(name);
    reader.checkSchema(document["@schema"]);
    const QJsonArray lists = document["markups"].toArray();
    for (qsizetype i = 0; i < lists.size(); ++i) {
        reader.addList(lists[i].toObject(), "markups[" + std::to_string(i) + "]");
    }
    return reader.result();
}

} // namespace palpate::study

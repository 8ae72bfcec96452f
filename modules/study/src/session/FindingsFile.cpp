// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/FindingsFile.h"

#include <palpate/core/CsvCell.h>
#include <palpate/session/Findings.h>

#include <QByteArray>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>

#include <algorithm>
#include <array>
#include <optional>

namespace palpate::study {

using core::Finding;
using core::FindingType;

namespace {

/// Formats with the fewest digits that restore the same double.
std::string digits(double value)
{
    return QByteArray::number(value, 'g', QLocale::FloatingPointShortest).toStdString();
}

/// Returns the total force on the hand. The layers contain components along the total force, so their sum is the total.
/// In older files, the finding's force is the total.
std::optional<double> totalForce_N(const Finding& finding)
{
    if (organOf(finding).empty()) {
        return finding.force_N;
    }
    double sum_N = 0.0;
    for (const core::FindingLayer& layer : finding.layers) {
        sum_N += layer.force_N;
    }
    return sum_N;
}

std::string numberCell(const std::optional<double>& value)
{
    return value ? digits(*value) : std::string();
}

/// Returns the note followed by the measured values, for display in other programs.
QString description(const Finding& finding)
{
    QStringList felt;
    const std::string organ = organOf(finding);
    if (!finding.structure.empty()) {
        felt << QString::fromStdString(finding.structure) +
                    (organ.empty() ? QString() : QStringLiteral(" in ") + QString::fromStdString(organ));
    }
    const auto add = [&](const std::optional<double>& value, const char* unit) {
        if (value) {
            felt << QString::number(*value, 'f', 2) + QLatin1String(unit);
        }
    };
    add(finding.size_mm, " mm across");
    add(finding.force_N, " N");
    add(finding.depth_mm, " mm deep");
    add(core::felt_N_per_mm(finding), " N/mm");
    QStringList lines;
    for (const QString& line : {QString::fromStdString(finding.note), felt.join(QStringLiteral(", "))}) {
        if (!line.isEmpty()) {
            lines << line;
        }
    }
    return lines.join(QLatin1Char('\n'));
}

QJsonObject controlPoint(const Finding& finding, std::size_t number)
{
    QJsonObject point{{"id", finding.id.empty() ? QString::number(number) : QString::fromStdString(finding.id)},
                      {"label", QString::fromStdString(finding.name)},
                      {"description", description(finding)},
                      {"associatedNodeID", ""},
                      {"orientation", QJsonArray{-1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 1.0}},
                      {"selected", true},
                      {"locked", false},
                      {"visibility", true},
                      {"positionStatus", finding.hasPlace ? "defined" : "undefined"},
                      {"palpate", session::toJson(finding)}};
    if (finding.hasPlace) {
        point["position"] = QJsonArray{finding.p_W.x(), finding.p_W.y(), finding.p_W.z()};
    }
    return point;
}

QJsonObject display(FindingType type, double size_mm)
{
    const auto& colour = core::kFindingColours[static_cast<std::size_t>(type)];
    const QJsonArray rgb{colour[0], colour[1], colour[2]};
    return {{"visibility", true},
            {"opacity", 1.0},
            {"color", rgb},
            {"selectedColor", rgb}, // new points are selected, which would otherwise make them pink
            {"activeColor", rgb},
            {"propertiesLabelVisibility", false},
            {"pointLabelsVisibility", true},
            {"textScale", 3.0},
            {"glyphType", "Sphere3D"},
            {"glyphScale", 1.0},
            {"glyphSize", size_mm},
            {"useGlyphScale", false}};
}

} // namespace

std::string organOf(const Finding& finding)
{
    const std::vector<core::FindingLayer>& layers = finding.layers;
    return layers.empty() || layers.front().structure == finding.structure ? std::string() : layers.front().structure;
}

std::string findingRow(const Finding& one, std::size_t number)
{
    std::vector<std::string> cells{core::csvCell(one.id.empty() ? std::to_string(number) : one.id),
                                   core::csvCell(one.name), core::csvCell(core::nameOf(one.type)),
                                   core::csvCell(one.structure)};
    for (int axis = 0; axis < 3; ++axis) {
        cells.push_back(one.hasPlace ? digits(one.p_W[axis]) : std::string());
    }
    cells.emplace_back(one.hasPlace ? "LPS" : "");
    for (const auto& value : {one.size_mm, one.force_N, one.depth_mm, core::felt_N_per_mm(one)}) {
        cells.push_back(numberCell(value));
    }
    cells.push_back(one.recording ? digits(one.recording->time_s) : std::string());
    cells.push_back(one.recording ? core::csvCell(std::filesystem::path(one.recording->file).filename().string())
                                  : std::string());
    cells.push_back(core::csvCell(one.note));
    cells.push_back(core::csvCell(organOf(one)));
    cells.push_back(numberCell(totalForce_N(one)));
    std::string row;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        row += (i > 0 ? "," : "") + cells[i];
    }
    return row;
}

std::string findingsCsv(const std::vector<Finding>& findings)
{
    std::string out = std::string(kFindingColumns) + "\r\n";
    for (std::size_t i = 0; i < findings.size(); ++i) {
        out += findingRow(findings[i], i + 1) + "\r\n";
    }
    return out;
}

std::string findingsMarkups(const std::vector<Finding>& findings)
{
    constexpr double kUsualSize_mm = 5.0; // default in 3D Slicer
    QJsonArray lists;
    for (std::size_t t = 0; t < core::kFindingTypeNames.size(); ++t) {
        const auto type = static_cast<FindingType>(t);
        QJsonArray points;
        double size_mm = 0.0;
        for (std::size_t i = 0; i < findings.size(); ++i) {
            if (findings[i].type == type) {
                points.append(controlPoint(findings[i], i + 1));
                size_mm = std::max(size_mm, findings[i].size_mm.value_or(0.0));
            }
        }
        if (points.isEmpty()) {
            continue;
        }
        lists.append(QJsonObject{{"type", "Fiducial"},
                                 {"name", QString::fromStdString(std::string(core::nameOf(type)))},
                                 {"coordinateSystem", "LPS"},
                                 {"coordinateUnits", "mm"},
                                 {"locked", false},
                                 {"fixedNumberOfControlPoints", false},
                                 {"labelFormat", "%N-%d"},
                                 {"lastUsedControlPointNumber", points.size()},
                                 {"controlPoints", points},
                                 {"measurements", QJsonArray()},
                                 {"display", display(type, size_mm > 0.0 ? size_mm : kUsualSize_mm)}});
    }
    const QJsonObject out{{"@schema", "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/"
                                      "Resources/Schema/markups-schema-v1.0.3.json#"},
                          {"markups", lists}};
    return QJsonDocument(out).toJson(QJsonDocument::Indented).toStdString();
}

std::vector<Finding> recordedFindings(const session::RecordingReader& reader)
{
    std::vector<Finding> out;
    for (auto& [tick, finding] : session::findingsOf(reader.events())) {
        const double time_s = static_cast<double>(tick - reader.extent().firstTick) * reader.info().dt_s;
        finding.recording = core::RecordedMoment{reader.path().string(), {}, tick, std::max(0.0, time_s)};
        out.push_back(std::move(finding));
    }
    return out;
}

} // namespace palpate::study

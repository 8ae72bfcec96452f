// SPDX-License-Identifier: BSD-3-Clause
#include "reports/ResultTables.h"

#include <palpate/core/Quantity.h>
#include <palpate/ui/ClipboardCell.h>
#include <palpate/ui/FindingsModel.h>
#include <palpate/ui/SessionPanel.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/ui/Translated.h>

#include <QCoreApplication>
#include <QLocale>

#include <optional>
#include <utility>

using namespace palpate;

namespace {

struct ResultTexts
{
    Q_DECLARE_TR_FUNCTIONS(ResultTables)
};

QString number(double value, int digits = 2)
{
    return QLocale().toString(value, 'f', digits);
}

QString orDash(const std::optional<double>& value)
{
    return value ? number(*value, 0) : QStringLiteral("–");
}

QString count(std::int64_t value)
{
    return QLocale().toString(static_cast<qlonglong>(value));
}

ResultTable sessionTable(const session::SessionMeasures& m)
{
    return {
        ResultTexts::tr("Session"),
        {{ResultTexts::tr("Duration"), ResultTexts::tr("In contact"), ResultTexts::tr("Contacts"),
          ResultTexts::tr("Path of the hand"), ResultTexts::tr("Path on the surface"), ResultTexts::tr("Late samples"),
          ResultTexts::tr("Lost samples")},
         {ui::clockText(m.sums.duration_s), ui::clockText(m.sums.contact.time_s), count(m.sums.contact.contacts),
          ui::translated(core::pathText(m.sums.pathLength_mm)), ui::translated(core::pathText(m.sums.contactPath_mm)),
          m.lateTicks ? count(*m.lateTicks) : ResultTexts::tr("not stated"), count(m.lostTicks)}}};
}

ResultTable touchTable(const session::SessionMeasures& m)
{
    ResultTable table{
        ResultTexts::tr("Touch"),
        {{ResultTexts::tr("Force and depth"), ResultTexts::tr("Time spent [s]"), ResultTexts::tr("Mean [N]"),
          ResultTexts::tr("Median [N]"), ResultTexts::tr("95th percentile [N]"), ResultTexts::tr("Peak [N]"),
          ResultTexts::tr("Maximum depth [mm]"), ResultTexts::tr("Presses")}}};
    const auto contact = [&](const QString& name, const session::ContactMeasures& c,
                             const std::vector<session::Phase>& phases) {
        table.rows.push_back({name, number(c.time_s, 1), number(c.meanForce_N), number(c.medianForce_N),
                              number(c.p95Force_N), number(c.peakForce_N), number(c.peakDepth_mm, 1),
                              count(session::summary(phases, session::Phase::Kind::Press).phases)});
    };
    contact(ResultTexts::tr("All"), m.sums.contact, m.phases);
    for (const auto& [name, part] : m.sums.structures) {
        const auto phases = m.structurePhases.find(name);
        contact(ui::readableName(name), part,
                phases != m.structurePhases.end() ? phases->second : std::vector<session::Phase>());
    }
    return table;
}

ResultTable phaseTable(const session::SessionMeasures& m)
{
    ResultTable table{ResultTexts::tr("Searching and pressing"),
                      {{ResultTexts::tr("Hand"), ResultTexts::tr("Phases"), ResultTexts::tr("Time spent [s]"),
                        ResultTexts::tr("Mean [N]"), ResultTexts::tr("Peak [N]")}}};
    for (const auto kind : {session::Phase::Kind::Search, session::Phase::Kind::Press}) {
        const session::PhaseSummary sum = session::summary(m.phases, kind);
        table.rows.push_back(
            {kind == session::Phase::Kind::Search ? ResultTexts::tr("Searching") : ResultTexts::tr("Pressing"),
             count(sum.phases), number(sum.time_s, 1), number(sum.meanForce_N), number(sum.peakForce_N)});
    }
    return table;
}

ResultTable surfaceTable(const session::SessionMeasures& m, bool isFingertip)
{
    const QString distance = ResultTexts::tr("%1 mm").arg(ui::numberText(m.distance_mm));
    ResultTable table{
        isFingertip ? ResultTexts::tr("Examined share of the surface (within %1, the fingertip radius)").arg(distance)
                    : ResultTexts::tr("Examined share of the surface (within %1)").arg(distance),
        {{ResultTexts::tr("Surface"), ResultTexts::tr("Area [cm²]"), ResultTexts::tr("Examined [%]"),
          ResultTexts::tr("Longest time at one point [s]")}}};
    for (const session::SurfaceMeasures& surface : m.surfaces) {
        table.rows.push_back({ui::readableName(surface.structure), number(0.01 * surface.area_mm2, 1),
                              number(100.0 * surface.coverage(), 1), number(surface.longestDwell_s, 1)});
    }
    for (const std::string& name : m.unmeasured) {
        table.rows.push_back({ui::readableName(name), ResultTexts::tr("mesh not found"), {}, {}});
    }
    return table;
}

ResultTable findingTable(const session::SessionMeasures& m)
{
    ResultTable table{ResultTexts::tr("Findings"),
                      {{ResultTexts::tr("Finding"), ResultTexts::tr("On"), ResultTexts::tr("Marked"),
                        ResultTexts::tr("First touched"), ResultTexts::tr("Time spent [s]"),
                        ResultTexts::tr("Revisits"), ResultTexts::tr("Mean [N]"), ResultTexts::tr("Peak [N]")}}};
    for (const session::FindingMeasures& one : m.findings) {
        if (!one.finding.hasPlace) {
            continue;
        }
        table.rows.push_back(
            {ui::typeSign(one.finding.type) + QLatin1Char(' ') + QString::fromStdString(one.finding.name),
             ui::whereText(one.finding), ui::clockText(one.marked_s),
             one.firstTouched_s ? ui::clockText(*one.firstTouched_s) : ResultTexts::tr("never"), number(one.dwell_s, 1),
             count(one.visits), number(one.meanForce_N), number(one.peakForce_N)});
    }
    return table;
}

ResultTable noteTable(const session::SessionMeasures& m)
{
    ResultTable table{ResultTexts::tr("Notes"), {{ResultTexts::tr("Note"), ResultTexts::tr("Written")}}};
    for (const session::FindingMeasures& one : m.findings) {
        if (!one.finding.note.empty()) {
            const QString about = one.finding.hasPlace ? QString::fromStdString(one.finding.name + ": ") : QString();
            table.rows.push_back({about + QString::fromStdString(one.finding.note), ui::clockText(one.marked_s)});
        }
    }
    return table;
}

ResultTable lumpTable(const session::SessionMeasures& m)
{
    ResultTable table{
        ResultTexts::tr("Lumps: recorded response and model prediction (estimate)"),
        {{ResultTexts::tr("Lump"), ResultTexts::tr("Organ"), ResultTexts::tr("Palpable by a trained hand [cm²]"),
          ResultTexts::tr("Pressed hard enough [%]"), ResultTexts::tr("Largest recorded change [%]"),
          ResultTexts::tr("Predicted by the model [%]")}}};
    for (const session::LumpSearch& one : m.lumps) {
        table.rows.push_back({ui::readableName(one.lump), ui::readableName(one.organ),
                              number(0.01 * one.detectable_mm2, 1),
                              one.share() ? number(100.0 * *one.share(), 1) : ResultTexts::tr("not by hand"),
                              orDash(one.recorded_percent), orDash(one.predicted_percent)});
    }
    return table;
}

ResultTable layerTable(const session::SessionMeasures& m)
{
    ResultTable table{ResultTexts::tr("Findings by layer"),
                      {{ResultTexts::tr("Finding"), ResultTexts::tr("Structure"), ResultTexts::tr("Force [N]"),
                        ResultTexts::tr("Depth [mm]")}}};
    for (const session::FindingMeasures& one : m.findings) {
        for (const core::FindingLayer& layer : one.finding.layers) {
            table.rows.push_back({QString::fromStdString(one.finding.name), ui::readableName(layer.structure),
                                  number(layer.force_N), number(layer.depth_mm, 1)});
        }
    }
    return table;
}

/// Converts a table to HTML and escapes all cells. The width is 99 %, because Qt rounds 100 % up.
QString htmlOf(const ResultTable& table)
{
    QString html = QStringLiteral("<h3>%1</h3><table cellspacing='0' cellpadding='4' width='99%'>")
                       .arg(table.title.toHtmlEscaped());
    bool isHead = true;
    for (const QStringList& row : table.rows) {
        html += QStringLiteral("<tr>");
        for (qsizetype i = 0; i < row.size(); ++i) {
            const QString tag = isHead ? QStringLiteral("th") : QStringLiteral("td");
            html += QStringLiteral("<%1 align='%2'>%3</%1>")
                        .arg(tag, i == 0 ? QStringLiteral("left") : QStringLiteral("right"), row[i].toHtmlEscaped());
        }
        html += QStringLiteral("</tr>");
        isHead = false;
    }
    return html + QStringLiteral("</table>");
}

/// Duration in a sentence: "3.4 s", from a minute on "02:05.0 min".
QString durationText(double seconds)
{
    return seconds < 59.95 ? ResultTexts::tr("%1 s").arg(number(seconds, 1))
                           : ResultTexts::tr("%1 min").arg(ui::clockText(seconds));
}

} // namespace

std::vector<ResultTable> resultTables(const session::SessionMeasures& measures, bool isFingertip)
{
    std::vector<ResultTable> tables{sessionTable(measures), touchTable(measures), phaseTable(measures),
                                    surfaceTable(measures, isFingertip)};
    for (ResultTable table : {lumpTable(measures), findingTable(measures), noteTable(measures), layerTable(measures)}) {
        if (table.rows.size() > 1) {
            tables.push_back(std::move(table));
        }
    }
    return tables;
}

QString summaryOf(const session::SessionMeasures& measures)
{
    QStringList examined;
    for (const session::SurfaceMeasures& surface : measures.surfaces) {
        if (surface.coverage() > 0.0) {
            examined << ResultTexts::tr("%1 % of the surface of %2")
                            .arg(number(100.0 * surface.coverage(), 1), ui::readableName(surface.structure));
        }
    }
    const QString peak = number(measures.sums.contact.peakForce_N);
    const QString first = examined.isEmpty()
                              ? ResultTexts::tr("The hand was in contact for %1, with a peak force of %2 N.")
                                    .arg(durationText(measures.sums.contact.time_s), peak)
                              : ResultTexts::tr("Examined: %1, with a peak force of %2 N.")
                                    .arg(examined.join(QStringLiteral(", ")), peak);
    int palpable = 0, pressed = 0;
    for (const session::LumpSearch& lump : measures.lumps) {
        palpable += lump.share() ? 1 : 0;
        pressed += lump.share().value_or(0.0) > 0.0 ? 1 : 0;
    }
    const QString second =
        measures.lumps.empty()
            ? ResultTexts::tr("%n finding(s) were marked.", nullptr, static_cast<int>(measures.findings.size()))
            : ResultTexts::tr("Of %1 lumps, %2 are palpable by a trained hand; %3 of these were pressed hard enough to "
                              "feel.")
                  .arg(measures.lumps.size())
                  .arg(palpable)
                  .arg(pressed);
    return first + QLatin1Char(' ') + second;
}

QString toHtml(const std::vector<ResultTable>& tables)
{
    QString html;
    for (const ResultTable& table : tables) {
        html += htmlOf(table);
    }
    return html + QStringLiteral("<p style='margin-top: 14px'>%1</p>")
                      .arg(ResultTexts::tr("95th percentile: the force stayed below this value for 95 % of the contact "
                                           "time. Research measures, not a diagnosis."));
}

QString toTsv(const std::vector<ResultTable>& tables)
{
    QString text;
    for (const ResultTable& table : tables) {
        text += (text.isEmpty() ? QString() : QStringLiteral("\n")) + table.title + QLatin1Char('\n');
        for (QStringList row : table.rows) {
            for (QString& cell : row) {
                cell = ui::clipboardCell(cell);
            }
            text += row.join(QLatin1Char('\t')) + QLatin1Char('\n');
        }
    }
    return text;
}

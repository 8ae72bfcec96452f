// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/Report.h"

#include "palpate/study/ReadableName.h"
#include "report/ReportSections.h"

#include <palpate/core/Finding.h>
#include <palpate/core/Quantity.h>

#include <QDateTime>

#include <algorithm>
#include <array>
#include <charconv>
#include <map>
#include <utility>

namespace palpate::study {

namespace internal {

core::MessageArgument fixed(double value, int decimals)
{
    std::array<char, 400> text{}; // the greatest double has 309 digits
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals).ptr;
    core::MessageArgument number{std::string(text.data(), end)};
    number.kind = core::MessageArgument::Kind::Number;
    return number;
}

core::MessageArgument dash()
{
    return {"–"};
}

core::MessageArgument percent(const std::optional<double>& value)
{
    if (!value) {
        return dash();
    }
    return *value < 0.0 ? core::Message(PALPATE_TEXT("%1 %"), core::Rounded{*value, 3})
                        : core::Message(PALPATE_TEXT("+%1 %"), core::Rounded{*value, 3});
}

core::MessageArgument lengthText(double length_mm)
{
    constexpr double kShortest_mm = 0.1;
    return length_mm > 0.0 && length_mm < 0.5 * kShortest_mm
               ? core::MessageArgument(core::Message(PALPATE_TEXT("< %1"), kShortest_mm))
               : fixed(length_mm, 1);
}

core::MessageArgument lengthText(const std::optional<double>& length_mm)
{
    return length_mm ? lengthText(*length_mm) : dash();
}

core::MessageArgument forceText(double force_N)
{
    if (force_N <= 0.0) {
        return core::Count(0);
    }
    constexpr int kMostDecimals = 4;
    double power = 1.0; // of ten; 9.96 rounds to 10
    int decimals = 1;
    for (; decimals > 0 && force_N >= 9.95 * power; --decimals) {
        power *= 10.0;
    }
    for (; decimals < kMostDecimals && decimals > 0 && force_N < 0.995 * power; ++decimals) {
        power /= 10.0;
    }
    return fixed(force_N, decimals);
}

core::MessageArgument forceText(const std::optional<double>& force_N)
{
    return force_N ? forceText(*force_N) : dash();
}

core::MessageArgument timeText(double time_s)
{
    return fixed(time_s, 1);
}

core::Message placeText(const core::Vec3& p_W)
{
    return {PALPATE_TEXT("%1 %2 %3"), fixed(p_W.x(), 1), fixed(p_W.y(), 1), fixed(p_W.z(), 1)};
}

core::MessageArgument namesText(const std::vector<std::string>& names, std::size_t most)
{
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), most); ++i) {
        text.append(i == 0 ? "" : ", ").append(readableName(names[i]));
    }
    return names.size() > most ? core::MessageArgument(core::Message(PALPATE_TEXT("%1 and %2 more"), text,
                                                                     core::Count(names.size() - most)))
                               : core::MessageArgument(text);
}

core::MessageArgument nameOrDash(const std::string& name)
{
    return name.empty() ? dash() : core::MessageArgument(name);
}

core::MessageArgument structureOrDash(const std::string& name)
{
    return nameOrDash(readableName(name));
}

// "2026-11-28T05:18:01Z" as "2026-11-28 05:18:01 UTC"; other texts unchanged.
std::string readableTime(const std::string& utc)
{
    const QDateTime time = QDateTime::fromString(QString::fromStdString(utc), Qt::ISODate);
    return time.isValid() && utc.ends_with('Z')
               ? time.toString(QStringLiteral("yyyy-MM-dd HH:mm:ss 'UTC'")).toStdString()
               : utc;
}

} // namespace internal

namespace {

using core::Count;
using core::Message;
using core::MessageArgument;
using core::Rounded;
using internal::column;
using internal::dash;
using internal::fixed;
using internal::forceText;
using internal::lengthText;
using internal::nameOrDash;
using internal::paragraph;
using internal::readableTime;
using internal::timeText;
using session::Phase;

constexpr int kPathDigits = 3, kAreaDigits = 3;

/// Composes the sections that need no more than the facts.
class Composition
{
  public:
    explicit Composition(const ReportFacts& facts)
        : m_facts(facts)
        , m_measures(facts.measures)
    {
        for (const session::FindingMeasures& one : m_measures.findings) {
            if (one.finding.hasPlace) {
                m_places.push_back(&one);
            }
        }
    }

    Report run(const Message& unpictured)
    {
        m_hasPictures = m_facts.scene != nullptr && unpictured.isEmpty();
        m_report.title = {PALPATE_TEXT("Palpation report")};
        m_report.notice = {PALPATE_TEXT("Research, training and planning rehearsal. Not a medical device.")};
        m_report.subject = m_facts.caseText.empty() ? m_facts.recording->path().filename().string() : m_facts.caseText;
        for (const session::FindingMeasures* one : m_places) {
            m_report.places.push_back(one->finding);
        }
        m_report.places.insert(m_report.places.end(), m_facts.outside.begin(), m_facts.outside.end());
        add(head(unpictured));
        add(views());
        add(findings());
        add(notes());
        add(touch());
        add(internal::tapeSection(m_facts));
        add(internal::lumpSection(m_facts));
        add(internal::distanceSection(m_facts));
        add(internal::sizeSection(m_facts));
        add(mapsOfTouch());
        add(force());
        add(internal::methodSection(m_facts));
        add(internal::dataSection(m_facts));
        return std::move(m_report);
    }

  private:
    void add(ReportSection section)
    {
        if (!section.blocks.empty()) {
            m_report.sections.push_back(std::move(section));
        }
    }

    std::size_t addView(ReportView view)
    {
        m_report.views.push_back(view);
        return m_report.views.size() - 1;
    }

    ReportSection head(const Message& unpictured) const
    {
        ReportSection section;
        ReportTable table;
        const auto row = [&table](core::MessageText<> name, MessageArgument value) {
            table.rows.push_back({Message(name), std::move(value)});
        };
        const session::RecordingReader& reader = *m_facts.recording;
        const auto stated = [](const std::string& text) {
            return text.empty() ? MessageArgument(Message(PALPATE_TEXT("not stated"))) : MessageArgument(text);
        };
        row(PALPATE_TEXT("Case"), stated(m_facts.caseText));
        row(PALPATE_TEXT("Examiner"), stated(m_facts.examiner));
        row(PALPATE_TEXT("Recording"), reader.path().filename());
        row(PALPATE_TEXT("Recorded"), stated(readableTime(reader.info().startedUtc)));
        row(PALPATE_TEXT("Report made"),
            readableTime(QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString()));
        section.blocks.emplace_back(std::move(table));

        const session::ContactMeasures& contact = m_measures.sums.contact;
        section.blocks.emplace_back(ReportText{
            {PALPATE_TEXT("The hand was in contact for %1 s of %2 s. The greatest force was %3 N, the median "
                          "%4 N. Marked findings: %5."),
             timeText(contact.time_s), timeText(m_measures.sums.duration_s), forceText(contact.peakForce_N),
             forceText(contact.medianForce_N), Count(m_places.size())}});
        addDone(section);
        if (!m_facts.outside.empty()) {
            section.blocks.emplace_back(
                ReportText{{PALPATE_TEXT("Findings marked outside of this recording: %1, in a table of their own."),
                            Count(m_facts.outside.size())},
                           false});
        }
        std::vector<Message> missing = m_facts.missing;
        if (!unpictured.isEmpty()) {
            missing.push_back({PALPATE_TEXT("This report has no pictures: %1."), unpictured});
        }
        for (const Message& one : missing) {
            section.blocks.emplace_back(ReportText{one, true});
        }
        return section;
    }

    /// What was touched and measured, one sentence each.
    void addDone(ReportSection& section) const
    {
        std::vector<std::pair<double, std::string>> touched;
        for (const auto& [name, part] : m_measures.sums.structures) {
            touched.emplace_back(-part.time_s, name);
        }
        std::sort(touched.begin(), touched.end()); // the longest contact first
        std::vector<std::string> names;
        for (const auto& [time_s, name] : touched) {
            names.push_back(name);
        }
        constexpr std::size_t kNames = 12;
        if (!names.empty()) {
            section.blocks.emplace_back(
                ReportText{{PALPATE_TEXT("Touched structures: %1."), internal::namesText(names, kNames)}});
        }
        if (!m_facts.tapes.empty()) {
            std::vector<Message> tapes;
            constexpr std::size_t kTapes = 6;
            for (std::size_t i = 0; i < std::min(kTapes, m_facts.tapes.size()); ++i) {
                const core::Tape& tape = m_facts.tapes[i];
                tapes.push_back({PALPATE_TEXT("%1 %2 mm"), tape.name, lengthText(tape.length_mm())});
            }
            section.blocks.emplace_back(ReportText{{PALPATE_TEXT("Distances measured with the tape: %1 (%2)."),
                                                    Count(m_facts.tapes.size()), core::joined(tapes)}});
        }
    }

    ReportSection views()
    {
        ReportSection section{{PALPATE_TEXT("Views")}, {}};
        if (!m_hasPictures) {
            return {};
        }
        const Count count(m_report.places.size());
        ReportPictures both;
        both.pictures.push_back({addView({ReportView::From::Front}),
                                 {PALPATE_TEXT("From the front")},
                                 {PALPATE_TEXT("The scene from the front with %1 findings and a scale bar."), count}});
        both.pictures.push_back({addView({ReportView::From::Left}),
                                 {PALPATE_TEXT("From the patient's left")},
                                 {PALPATE_TEXT("The scene from the left with %1 findings and a scale bar."), count}});
        section.blocks.emplace_back(std::move(both));
        section.blocks.emplace_back(
            paragraph(PALPATE_TEXT("The scale bar holds at the depth of the middle of the picture. Numbers are those "
                                   "of the findings.")));
        return section;
    }

    /// Pictures of the first findings, with and without a recorded examination.
    void addPictures(ReportSection& section)
    {
        const std::vector<core::Finding>& places = m_report.places;
        ReportPictures pictures;
        for (std::size_t i = 0; i < std::min(places.size(), kReportedPictures); ++i) {
            pictures.pictures.push_back(
                {addView({ReportView::From::Finding, i}),
                 {PALPATE_TEXT("%1. %2"), Count(i + 1), nameOrDash(places[i].name)},
                 {PALPATE_TEXT("The place of finding %1, %2, with a scale bar."), Count(i + 1), places[i].name}});
        }
        section.blocks.emplace_back(std::move(pictures));
        if (places.size() > kReportedPictures) {
            section.blocks.emplace_back(ReportText{{PALPATE_TEXT("Pictures are shown of the first %1 of %2 findings."),
                                                    Count(kReportedPictures), Count(places.size())},
                                                   false});
        }
    }

    ReportSection findings()
    {
        ReportSection section{{PALPATE_TEXT("Findings")}, {}};
        if (m_report.places.empty()) {
            section.blocks.emplace_back(paragraph(PALPATE_TEXT("No findings were marked.")));
            return section;
        }
        const auto add = [&section](ReportTable table) {
            if (!table.rows.empty()) {
                section.blocks.emplace_back(std::move(table));
            }
        };
        add(internal::findingTable(m_facts));
        add(internal::outsideTable(m_facts));
        if (m_hasPictures) {
            addPictures(section);
        }
        add(internal::visitTable(m_facts));
        add(internal::layerTable(m_facts));
        return section;
    }

    /// Free texts of the examiner, with and without a place.
    ReportSection notes() const
    {
        ReportSection section{{PALPATE_TEXT("Notes")}, {}};
        ReportTable table;
        table.caption = {PALPATE_TEXT("Notes of the examiner")};
        table.columns = {column(PALPATE_TEXT("Finding")), column(PALPATE_TEXT("Note")),
                         column(PALPATE_TEXT("Written at [s]"), true)};
        std::size_t number = 0;
        for (const session::FindingMeasures& one : m_measures.findings) {
            number += one.finding.hasPlace ? 1 : 0;
            if (!one.finding.note.empty()) {
                table.rows.push_back(
                    {one.finding.hasPlace
                         ? MessageArgument(Message(PALPATE_TEXT("%1. %2"), Count(number), nameOrDash(one.finding.name)))
                         : dash(),
                     one.finding.note, fixed(one.marked_s, 1)});
            }
        }
        for (const core::Finding& one : m_facts.outside) {
            ++number;
            if (!one.note.empty()) {
                table.rows.push_back(
                    {Message(PALPATE_TEXT("%1. %2"), Count(number), nameOrDash(one.name)), one.note, dash()});
            }
        }
        if (!table.rows.empty()) {
            section.blocks.emplace_back(std::move(table));
        }
        return section;
    }

    ReportTable contactTable() const
    {
        ReportTable table;
        table.caption = {PALPATE_TEXT("Contact with each structure; forces are those of its own layer")};
        table.columns = {column(PALPATE_TEXT("Structure")),
                         column(PALPATE_TEXT("Contact [s]"), true),
                         column(PALPATE_TEXT("Presses"), true),
                         column(PALPATE_TEXT("Mean force [N]"), true),
                         column(PALPATE_TEXT("95th percentile [N]"), true),
                         column(PALPATE_TEXT("Peak force [N]"), true),
                         column(PALPATE_TEXT("Peak depth [mm]"), true),
                         column(PALPATE_TEXT("Covered [%]"), true),
                         column(PALPATE_TEXT("Longest dwell [s]"), true)};
        std::map<std::string, const session::SurfaceMeasures*> surfaces;
        for (const session::SurfaceMeasures& surface : m_measures.surfaces) {
            surfaces[surface.structure] = &surface;
        }
        for (const auto& [name, part] : m_measures.sums.structures) {
            const auto phases = m_measures.structurePhases.find(name);
            const std::int64_t presses = phases == m_measures.structurePhases.end()
                                             ? 0
                                             : session::summary(phases->second, Phase::Kind::Press).phases;
            const auto surface = surfaces.find(name);
            const bool isMeasured = surface != surfaces.end();
            table.rows.push_back(
                {readableName(name), timeText(part.time_s), Count(presses), forceText(part.meanForce_N),
                 forceText(part.p95Force_N), forceText(part.peakForce_N), lengthText(part.peakDepth_mm),
                 isMeasured ? MessageArgument(Rounded{100.0 * surface->second->coverage(), 3}) : dash(),
                 isMeasured ? timeText(surface->second->longestDwell_s) : dash()});
        }
        return table;
    }

    ReportTable phaseTable() const
    {
        ReportTable table;
        table.caption = {PALPATE_TEXT("Searching (the contact moves faster than 10 mm/s) and pressing (slower)")};
        table.columns = {column(PALPATE_TEXT("Hand")), column(PALPATE_TEXT("Phases"), true),
                         column(PALPATE_TEXT("Time [s]"), true), column(PALPATE_TEXT("Mean force [N]"), true),
                         column(PALPATE_TEXT("Peak force [N]"), true)};
        for (const auto kind : {Phase::Kind::Search, Phase::Kind::Press}) {
            const session::PhaseSummary sum = session::summary(m_measures.phases, kind);
            table.rows.push_back(
                {kind == Phase::Kind::Search ? Message(PALPATE_TEXT("searching")) : Message(PALPATE_TEXT("pressing")),
                 Count(sum.phases), timeText(sum.time_s), forceText(sum.meanForce_N), forceText(sum.peakForce_N)});
        }
        return table;
    }

    ReportTable sumTable() const
    {
        const session::Measures& sums = m_measures.sums;
        const session::ContactMeasures& all = sums.contact;
        ReportTable table;
        table.caption = {PALPATE_TEXT("Whole session")};
        const auto row = [&table](core::MessageText<> name, Message value) {
            table.rows.push_back({Message(name), std::move(value)});
        };
        row(PALPATE_TEXT("Duration"), {PALPATE_TEXT("%1 s"), timeText(sums.duration_s)});
        row(PALPATE_TEXT("In contact"),
            {PALPATE_TEXT("%1 s, contacts: %2"), timeText(all.time_s), Count(all.contacts)});
        row(PALPATE_TEXT("Path of the hand"), core::pathText(sums.pathLength_mm, kPathDigits));
        row(PALPATE_TEXT("Path on the surface"), core::pathText(sums.contactPath_mm, kPathDigits));
        row(PALPATE_TEXT("Force in contact"),
            {PALPATE_TEXT("peak %1 N, mean %2 N, median %3 N, 95th percentile %4 N"), forceText(all.peakForce_N),
             forceText(all.meanForce_N), forceText(all.medianForce_N), forceText(all.p95Force_N)});
        row(PALPATE_TEXT("Depth in contact"),
            {PALPATE_TEXT("peak %1 mm, mean %2 mm, 95th percentile %3 mm"), lengthText(all.peakDepth_mm),
             lengthText(all.meanDepth_mm), lengthText(all.p95Depth_mm)});
        return table;
    }

    ReportSection touch() const
    {
        ReportSection section{{PALPATE_TEXT("Touch")}, {}};
        section.blocks.emplace_back(sumTable());
        if (m_measures.sums.structures.empty()) {
            section.blocks.emplace_back(paragraph(PALPATE_TEXT("Nothing was touched.")));
            return section;
        }
        section.blocks.emplace_back(contactTable());
        section.blocks.emplace_back(
            ReportText{{PALPATE_TEXT("Covered: share of the surface within %1 mm of the contact. 95th percentile: the "
                                     "force stayed below this value for 95 % of the contact time."),
                        Rounded{m_measures.distance_mm, 3}},
                       false});
        section.blocks.emplace_back(phaseTable());
        return section;
    }

    /// Makes a map of all touched surfaces.
    ReportMap mapOf(ReportMap::Quantity quantity) const
    {
        std::vector<float> values;
        double all_mm2 = 0.0, covered_mm2 = 0.0, above_mm2 = 0.0;
        for (const session::SurfaceMeasures* one : m_touched) {
            const std::vector<float> own = mapValues(*one->surface, quantity);
            values.insert(values.end(), own.begin(), own.end());
            all_mm2 += one->area_mm2;
            covered_mm2 += one->coveredArea_mm2;
        }
        ReportMap map{quantity, session::mapEnd(values), {}};
        std::size_t place = 0;
        for (const session::SurfaceMeasures* one : m_touched) {
            for (const double share_mm2 : one->surface->share_mm2()) {
                above_mm2 += double{values[place++]} > map.end ? share_mm2 : 0.0;
            }
        }
        const auto area = [all_mm2](double mm2) {
            return Message(PALPATE_TEXT("%1, %2 %"), core::areaText(mm2, kAreaDigits),
                           Rounded{100.0 * mm2 / all_mm2, 3});
        };
        map.legend.push_back(quantity == ReportMap::Quantity::Dwell ? Message(PALPATE_TEXT("Time spent, s"))
                                                                    : Message(PALPATE_TEXT("Largest force, N")));
        map.legend.push_back({PALPATE_TEXT("touched: %1"), area(covered_mm2)});
        if (above_mm2 > 0.0) {
            map.legend.push_back({PALPATE_TEXT("above %1: %2"), map.end, area(above_mm2)});
        }
        return map;
    }

    /// Time and force on the touched surfaces, each from the front and the left.
    ReportSection mapsOfTouch()
    {
        for (const session::SurfaceMeasures& surface : m_measures.surfaces) {
            if (surface.surface != nullptr && surface.coveredArea_mm2 > 0.0) {
                m_touched.push_back(&surface);
            }
        }
        if (!m_hasPictures || m_touched.empty()) {
            return {};
        }
        ReportSection section{{PALPATE_TEXT("Map of touch")}, {}};
        for (const auto quantity : {ReportMap::Quantity::Dwell, ReportMap::Quantity::PeakForce}) {
            const std::size_t number = m_report.maps.size();
            m_report.maps.push_back(mapOf(quantity));
            const std::vector<Message>& legend = m_report.maps.back().legend;
            ReportPictures both;
            for (const auto from : {ReportView::From::Front, ReportView::From::Left}) {
                const Message side = from == ReportView::From::Front ? Message(PALPATE_TEXT("from the front"))
                                                                     : Message(PALPATE_TEXT("from the patient's left"));
                both.pictures.push_back({addView({from, 0, number}),
                                         {PALPATE_TEXT("%1: %2"), legend.front(), side},
                                         {PALPATE_TEXT("Map of touch %1. %2, colours up to %3; %4."), side,
                                          legend.front(), m_report.maps.back().end, legend[1]}});
            }
            section.blocks.emplace_back(std::move(both));
        }
        section.blocks.emplace_back(ReportText{
            {PALPATE_TEXT(
                 "The brighter a place, the longer or more firmly the contact came within %1 mm. Places in the "
                 "colour of the structure were not touched. Shares refer to the surfaces of the touched "
                 "structures, which are drawn opaque. The colours end at the 98th percentile, rounded up."),
             Rounded{m_measures.distance_mm, 3}},
            false});
        return section;
    }

    ReportSection force() const
    {
        ReportSection section{{PALPATE_TEXT("Force over time")}, {}};
        if (m_facts.force.spans.empty()) {
            section.blocks.emplace_back(paragraph(PALPATE_TEXT("The recording contains no ticks.")));
            return section;
        }
        section.blocks.emplace_back(
            ReportCurve{m_facts.force,
                        {PALPATE_TEXT("Smallest and greatest force of each of %1 spans of time; the numbers mark when "
                                      "the findings were marked"),
                         Count(m_facts.force.spans.size())},
                        {PALPATE_TEXT("Curve of the force over %1 s, at most %2 N, with %3 findings."),
                         timeText(m_facts.force.duration_s), forceText(m_measures.sums.contact.peakForce_N),
                         Count(m_places.size())}});
        return section;
    }

    const ReportFacts& m_facts;
    const session::SessionMeasures& m_measures;
    std::vector<const session::FindingMeasures*> m_places; ///< findings with a place, by number
    std::vector<const session::SurfaceMeasures*> m_touched;
    bool m_hasPictures = false;
    Report m_report;
};

} // namespace

std::vector<float> mapValues(const session::TouchedSurface& surface, ReportMap::Quantity quantity)
{
    const std::vector<double>& values =
        quantity == ReportMap::Quantity::Dwell ? surface.dwell_s() : surface.peakForce_N();
    std::vector<float> out(values.size());
    std::transform(values.begin(), values.end(), out.begin(), [](double value) { return static_cast<float>(value); });
    return out;
}

Report composeReport(const ReportFacts& facts, const Message& unpictured)
{
    return Composition(facts).run(unpictured);
}

} // namespace palpate::study

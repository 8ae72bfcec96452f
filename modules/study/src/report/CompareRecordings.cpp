// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/CompareRecordings.h"

#include "palpate/study/RecordedScene.h"
#include "palpate/study/SearchedLumps.h"
#include "report/ReportSections.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace palpate::study {

namespace {

using core::Message;
using core::MessageArgument;
using core::Result;
using core::Rounded;
using core::Status;
using core::StatusCode;
using internal::column;
using session::RecordingReader;

using Readers = std::array<std::unique_ptr<RecordingReader>, 2>;

/// Opens two recordings that can be compared.
Result<Readers> openBoth(const std::filesystem::path& first, const std::filesystem::path& second)
{
    Readers readers;
    for (std::size_t i = 0; i < readers.size(); ++i) {
        auto opened = RecordingReader::open(i == 0 ? first : second);
        if (!opened.isOk()) {
            return opened.status();
        }
        readers[i] = std::move(opened).value();
    }
    std::error_code error;
    if (std::filesystem::equivalent(first, second, error)) {
        return Status(StatusCode::BadCommandLine, PALPATE_TEXT("%1: found the same recording twice, expected two"),
                      first);
    }
    if (Status status = session::checkSameSurfaces(*readers[0], *readers[1]); !status.isOk()) {
        return status;
    }
    return readers;
}

/// Returns the larger of the default distances. [mm]
double sharedDistance_mm(const RecordingReader& first, const RecordingReader& second,
                         const session::MeshesByHash& surfaces)
{
    return std::max(defaultDistance_mm(first, surfaces), defaultDistance_mm(second, surfaces));
}

/// Compares step by step.
class Comparing
{
  public:
    Comparing(const RecordingReader& first, const RecordingReader& second, const CompareOptions& options)
        : m_readers{&first, &second}
        , m_options(options)
    {
    }

    Result<RecordingComparison> run()
    {
        Status status = readSurfaces();
        status = status.isOk() ? measure() : status;
        if (!status.isOk()) {
            return status;
        }
        listConditions();
        listMissing();
        m_out.sessions = session::compareSessions(m_measures[0], m_measures[1]);
        return std::move(m_out);
    }

  private:
    bool goesOn(double share) const { return !m_options.progress || m_options.progress(share); }

    /// Takes the surfaces of the first recording, else of the second, else the open ones.
    Status readSurfaces()
    {
        m_surfaces = m_options.opened;
        Status why;
        for (const RecordingReader* reader : m_readers) {
            auto found = recordedSurfaces(*reader, m_options.scene);
            if (found.isOk()) {
                m_surfaces.merge(found.value());
                return {};
            }
            why = found.status();
        }
        if (!m_options.scene.empty()) {
            return why;
        }
        if (m_surfaces.empty()) {
            m_out.missing.push_back({PALPATE_TEXT("No coverage: %1."), why.text()});
        }
        return {};
    }

    Status measure()
    {
        const auto scene =
            m_options.scene.empty() ? sceneOfRecording(m_readers[0]->path()) : openScene(m_options.scene);
        std::vector<OrganPalpability> organs;
        if (scene.isOk()) { // else readSurfaces has named the reason
            auto computed =
                computePalpability(scene.value(), {}, nullptr, [this](double share) { return goesOn(0.2 * share); });
            if (!computed.isOk()) {
                return computed.status();
            }
            organs = std::move(computed).value();
        }
        for (std::size_t i = 0; i < m_readers.size(); ++i) {
            session::MeasureOptions how;
            how.distance_mm =
                m_options.distance_mm.value_or(sharedDistance_mm(*m_readers[0], *m_readers[1], m_surfaces));
            how.progress = [this, i](double share) { return goesOn(0.2 + 0.4 * (static_cast<double>(i) + share)); };
            auto measures = scene.isOk()
                                ? measureSearch(*m_readers[i], m_surfaces, scene.value(), organs, std::move(how))
                                : session::measureSession(*m_readers[i], m_surfaces, how);
            if (!measures.isOk()) {
                return measures.status();
            }
            m_measures[i] = std::move(measures).value();
        }
        return {};
    }

    /// Lists the conditions of the recordings that influence forces and were not the same.
    void listConditions()
    {
        const RecordingReader &a = *m_readers[0], &b = *m_readers[1];
        if (a.scenes().empty() || b.scenes().empty()) {
            return;
        }
        const session::SceneRecord &first = a.scenes().front(), &second = b.scenes().front();
        if (first.fingertip_mm != second.fingertip_mm) {
            m_out.conditions.push_back({PALPATE_TEXT("The fingertip was a ball of %1 mm radius in A and %2 mm in B "
                                                     "(0: a point)."),
                                        first.fingertip_mm, second.fingertip_mm});
        }
        if (a.info().device.name != b.info().device.name) {
            m_out.conditions.push_back(
                {PALPATE_TEXT("The device was %1 in A and %2 in B."), a.info().device.name, b.info().device.name});
        }
        for (const session::StructureRecord& one : first.structures) {
            const auto other = std::find_if(second.structures.begin(), second.structures.end(),
                                            [&](const auto& structure) { return structure.name == one.name; });
            if (other == second.structures.end() || !one.palpable) {
                continue;
            }
            if (one.tissue.stiffness_N_per_mm != other->tissue.stiffness_N_per_mm) {
                m_out.conditions.push_back({PALPATE_TEXT("The stiffness of %1 was %2 N/mm in A and %3 N/mm in B."),
                                            one.name, one.tissue.stiffness_N_per_mm, other->tissue.stiffness_N_per_mm});
            } else if (!(one.tissue == other->tissue) || one.lawTable != other->lawTable || one.maps != other->maps) {
                m_out.conditions.push_back({PALPATE_TEXT("The tissue of %1 was not the same in A and B."), one.name});
            }
        }
    }

    void listMissing()
    {
        for (std::size_t i = 0; i < m_readers.size(); ++i) {
            if (!m_measures[i].damaged.empty()) {
                m_out.missing.push_back({PALPATE_TEXT("%1 is damaged, or was changed after it was made. Damaged "
                                                      "places: %2. Ticks that do not match their checksum are left out "
                                                      "of all numbers."),
                                         m_readers[i]->path(), core::Count(m_measures[i].damaged.size())});
            }
        }
        if (m_out.missing.empty() && !m_measures[0].unmeasured.empty()) {
            std::string names;
            for (const std::string& name : m_measures[0].unmeasured) {
                names.append(names.empty() ? "" : ", ").append(name);
            }
            m_out.missing.push_back({PALPATE_TEXT("Surfaces not available, so without coverage: %1."), names});
        }
    }

    std::array<const RecordingReader*, 2> m_readers;
    const CompareOptions& m_options;
    session::MeshesByHash m_surfaces;
    std::array<session::SessionMeasures, 2> m_measures;
    RecordingComparison m_out;
};

MessageArgument valueText(const std::optional<double>& value, int digits)
{
    return value ? MessageArgument(Rounded{*value, digits}) : internal::dash();
}

MessageArgument noticeableText(const session::ComparedMeasure& measure)
{
    const auto is = measure.isNoticeable();
    return !is ? internal::dash()
               : MessageArgument(*is ? Message(PALPATE_TEXT("noticeable")) : Message(PALPATE_TEXT("not noticeable")));
}

ReportTable groupTable(const session::ComparedGroup& group)
{
    ReportTable table;
    table.caption = group.structure.empty() ? Message(PALPATE_TEXT("Whole session"))
                    : group.isSearch        ? Message(PALPATE_TEXT("Search for %1"), group.structure)
                                            : Message(PALPATE_TEXT("Contact with %1"), group.structure);
    table.columns = {column(PALPATE_TEXT("Measure")),
                     column(PALPATE_TEXT("A"), true),
                     column(PALPATE_TEXT("B"), true),
                     column(PALPATE_TEXT("B − A"), true),
                     column(PALPATE_TEXT("Relative to A"), true),
                     column(PALPATE_TEXT("By hand (7 %)"))};
    for (const session::ComparedMeasure& one : group.measures) {
        table.rows.push_back({one.name, valueText(one.first, one.digits), valueText(one.second, one.digits),
                              valueText(one.difference(), one.digits), internal::percent(one.difference_percent()),
                              noticeableText(one)});
    }
    return table;
}

ReportTable surfaceTable(const session::SessionComparison& sessions)
{
    ReportTable table;
    table.caption = {PALPATE_TEXT("Touched surface, within %1 mm of the contact"), Rounded{sessions.distance_mm, 3}};
    table.columns = {column(PALPATE_TEXT("Structure")), column(PALPATE_TEXT("Area [cm²]"), true),
                     column(PALPATE_TEXT("Both [cm²]"), true), column(PALPATE_TEXT("Only A [cm²]"), true),
                     column(PALPATE_TEXT("Only B [cm²]"), true)};
    const auto area = [](double part_mm2, double all_mm2) {
        return Message(PALPATE_TEXT("%1 (%2 %)"), Rounded{0.01 * part_mm2, 4},
                       Rounded{all_mm2 > 0.0 ? 100.0 * part_mm2 / all_mm2 : 0.0, 3});
    };
    for (const session::ComparedSurface& one : sessions.surfaces) {
        table.rows.push_back({one.structure, Rounded{0.01 * one.area_mm2, 4}, area(one.both_mm2, one.area_mm2),
                              area(one.onlyFirst_mm2, one.area_mm2), area(one.onlySecond_mm2, one.area_mm2)});
    }
    return table;
}

QJsonValue jsonOrNull(const std::optional<double>& value)
{
    return value ? QJsonValue(*value) : QJsonValue();
}

} // namespace

Result<double> checkComparable(const std::filesystem::path& first, const std::filesystem::path& second,
                               const session::MeshesByHash& surfaces)
{
    const auto opened = openBoth(first, second);
    return opened.isOk() ? Result<double>(sharedDistance_mm(*opened.value()[0], *opened.value()[1], surfaces))
                         : opened.status();
}

Result<RecordingComparison> compareRecordings(const std::filesystem::path& first, const std::filesystem::path& second,
                                              const CompareOptions& options)
{
    const auto opened = openBoth(first, second);
    return opened.isOk() ? Comparing(*opened.value()[0], *opened.value()[1], options).run() : opened.status();
}

std::vector<ReportTable> comparisonTables(const session::SessionComparison& sessions)
{
    std::vector<ReportTable> tables;
    if (!sessions.surfaces.empty()) {
        tables.push_back(surfaceTable(sessions));
    }
    for (const session::ComparedGroup& group : sessions.groups) {
        tables.push_back(groupTable(group));
    }
    return tables;
}

std::string comparisonJson(const RecordingComparison& comparison)
{
    const session::SessionComparison& sessions = comparison.sessions;
    QJsonArray measures, surfaces, conditions, missing;
    for (const session::ComparedGroup& group : sessions.groups) {
        for (const session::ComparedMeasure& one : group.measures) {
            const auto is = one.isNoticeable();
            measures.append(QJsonObject{{"structure", QString::fromStdString(group.structure)},
                                        {"measure", one.key},
                                        {"first", jsonOrNull(one.first)},
                                        {"second", jsonOrNull(one.second)},
                                        {"difference", jsonOrNull(one.difference())},
                                        {"difference_percent", jsonOrNull(one.difference_percent())},
                                        {"noticeable", is ? QJsonValue(*is) : QJsonValue()}});
        }
    }
    for (const session::ComparedSurface& one : sessions.surfaces) {
        surfaces.append(QJsonObject{{"structure", QString::fromStdString(one.structure)},
                                    {"area_mm2", one.area_mm2},
                                    {"both_mm2", one.both_mm2},
                                    {"only_first_mm2", one.onlyFirst_mm2},
                                    {"only_second_mm2", one.onlySecond_mm2}});
    }
    for (const Message& one : comparison.conditions) {
        conditions.append(QString::fromStdString(one.english()));
    }
    for (const Message& one : comparison.missing) {
        missing.append(QString::fromStdString(one.english()));
    }
    return QJsonDocument(QJsonObject{{"coverage_distance_mm", sessions.distance_mm},
                                     {"force_threshold_percent", session::kForceThreshold_percent},
                                     {"measures", measures},
                                     {"surfaces", surfaces},
                                     {"conditions", conditions},
                                     {"missing", missing}})
        .toJson()
        .toStdString();
}

} // namespace palpate::study

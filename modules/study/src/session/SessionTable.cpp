// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/SessionTable.h"

#include "palpate/study/FindingsFile.h"
#include "palpate/study/SessionExport.h"

#include <palpate/core/CsvCell.h>
#include <palpate/meshio/SceneFile.h>

#include <QByteArray>
#include <QJsonArray>
#include <QJsonObject>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>

namespace palpate::study {

namespace {

namespace fs = std::filesystem;

constexpr const char* kRecordingExtension = ".palpate";
constexpr const char* kLineEnd = "\r\n";

/// Formats with the fewest digits that restore the same double; whole numbers without an exponent.
std::string tableNumber(double value)
{
    constexpr double kMostWhole = 9007199254740992.0; // 2^53
    if (value == std::floor(value) && std::abs(value) < kMostWhole) {
        return std::to_string(static_cast<long long>(value));
    }
    return QByteArray::number(value, 'g', QLocale::FloatingPointShortest).toStdString();
}

/// Derives the unit from the end of the measure's name; "1" without a unit.
std::string_view unitOf(std::string_view measure)
{
    static constexpr std::pair<std::string_view, std::string_view> kUnits[] = {
        {"_N_per_mm", "N/mm"}, {"_mm2", "mm2"}, {"_mm", "mm"}, {"_N", "N"}, {"_s", "s"}, {"_percent", "%"}};
    for (const auto& [suffix, unit] : kUnits) {
        if (measure.ends_with(suffix)) {
            return unit;
        }
    }
    return "1";
}

std::string sessionCells(const TableSession& session)
{
    const std::string name =
        QString::fromStdString(session.name).toStdString(); // bytes that are not UTF-8 are replaced
    return core::csvCell(name) + ',' + session.sha256 + ',' + core::csvCell(session.startedUtc) + ',' +
           core::csvCell(session.device);
}

/// Appends rows for the values of JSON objects.
class RowsOfSession
{
  public:
    explicit RowsOfSession(const TableSession& session)
        : m_session(sessionCells(session))
    {
    }

    void addValue(const std::string& structure, const std::string& measure, const QJsonValue& value)
    {
        m_out += m_session + ',' + core::csvCell(structure) + ',' + measure + ',';
        m_out += value.isDouble() ? tableNumber(value.toDouble()) : std::string();
        m_out.append(",").append(unitOf(measure)).append(kLineEnd);
    }

    /// Adds the numbers of an object, and of the objects in it with their name as a prefix. Lists and texts are
    /// skipped.
    void addNumbers(const std::string& structure, const QJsonObject& object, const std::string& prefix = {})
    {
        for (auto one = object.begin(); one != object.end(); ++one) {
            const std::string name = prefix + one.key().toStdString();
            if (one->isDouble() || one->isNull()) {
                addValue(structure, name, *one);
            } else if (one->isObject()) {
                addNumbers(structure, one->toObject(), name + '_');
            }
        }
    }

    [[nodiscard]] const std::string& text() const noexcept { return m_out; }

  private:
    std::string m_session, m_out;
};

/// A recording and the number of last components of the path that form the name.
struct Candidate
{
    fs::path path;
    std::vector<std::string> parts; ///< of the resolved path
    std::size_t used = 1;

    [[nodiscard]] std::string name() const
    {
        std::string out;
        for (std::size_t i = parts.size() - std::min(used, parts.size()); i < parts.size(); ++i) {
            out += (out.empty() ? "" : "/") + parts[i];
        }
        return out;
    }
};

class RecordingSearch
{
  public:
    void take(const fs::path& input)
    {
        std::error_code error;
        if (fs::is_directory(input, error)) {
            takeFolder(input);
        } else {
            add(input, 1);
        }
    }

    FoundRecordings result() &&
    {
        lengthenNames();
        for (const Candidate& one : m_candidates) {
            m_found.recordings.push_back({one.path, one.name()});
        }
        return std::move(m_found);
    }

  private:
    /// @param used  components of the name
    void add(const fs::path& path, std::size_t used)
    {
        std::error_code error;
        fs::path place = fs::weakly_canonical(path.parent_path().empty() ? fs::path(".") : path.parent_path(), error);
        place /= path.filename();
        if (!m_places.insert(place).second) {
            return;
        }
        Candidate candidate{path, {}, used};
        for (const fs::path& part : place.relative_path()) {
            candidate.parts.push_back(part.string());
        }
        m_candidates.push_back(std::move(candidate));
    }

    void takeFolder(const fs::path& folder)
    {
        std::error_code error;
        std::vector<fs::path> files;
        search(folder, files);
        std::sort(files.begin(), files.end());
        if (files.empty()) {
            m_found.losses.push_back({PALPATE_TEXT("%1: found no recording, expected files named *.palpate"), folder});
        }
        for (const fs::path& file : files) {
            const fs::path inside = file.lexically_relative(folder);
            add(file, static_cast<std::size_t>(std::distance(inside.begin(), inside.end())));
        }
    }

    /// Does not follow links to folders, which could form a cycle.
    void search(const fs::path& folder, std::vector<fs::path>& files)
    {
        std::error_code error;
        fs::directory_iterator at(folder, error);
        for (; !error && at != fs::directory_iterator(); at.increment(error)) {
            const fs::path path = at->path();
            std::error_code unknown;
            if (path.filename().string().starts_with('.')) {
                continue;
            }
            if (at->is_directory(unknown)) {
                if (!at->is_symlink(unknown)) {
                    search(path, files);
                }
            } else if (path.extension() == kRecordingExtension) {
                files.push_back(path);
            }
        }
        if (error) {
            m_found.losses.push_back(
                {PALPATE_TEXT("%1: the folder cannot be read: %2"), folder, core::systemError(error.value())});
        }
    }

    void lengthenNames()
    {
        for (bool hasChanged = true; hasChanged;) {
            hasChanged = false;
            std::map<std::string, std::vector<Candidate*>> byName;
            for (Candidate& one : m_candidates) {
                byName[one.name()].push_back(&one);
            }
            for (const auto& [name, all] : byName) {
                for (Candidate* one : all) {
                    if (all.size() > 1 && one->used < one->parts.size()) {
                        ++one->used;
                        hasChanged = true;
                    }
                }
            }
        }
    }

    std::set<fs::path> m_places;
    std::vector<Candidate> m_candidates;
    FoundRecordings m_found;
};

} // namespace

FoundRecordings findRecordings(const std::vector<fs::path>& inputs)
{
    RecordingSearch search;
    for (const fs::path& input : inputs) {
        search.take(input);
    }
    return std::move(search).result();
}

TableSession tableSession(const session::RecordingReader& reader, std::string name)
{
    return {std::move(name), meshio::fileHash(reader.path()), reader.info().startedUtc, reader.info().device.id};
}

std::string measureRows(const TableSession& session, const session::SessionMeasures& measures)
{
    QJsonObject all = measuresObject(measures);
    const QJsonObject structures = all.take("structures").toObject();
    const QJsonObject phases = all.take("phases").toObject();
    const QJsonArray lumps = all.take("lumps").toArray();
    RowsOfSession rows(session);
    rows.addNumbers({}, all);
    rows.addNumbers({}, phases);
    const std::pair<const char*, const char*> kCounts[]{
        {"damaged", "damaged_parts"}, {"findings", "findings"}, {"notes", "notes"}};
    for (const auto& [key, measure] : kCounts) {
        rows.addValue({}, measure, all[QLatin1String(key)].toArray().size());
    }
    for (auto one = structures.begin(); one != structures.end(); ++one) {
        rows.addNumbers(one.key().toStdString(), one->toObject());
    }
    for (const QJsonValue& one : lumps) {
        rows.addNumbers(one["name"].toString().toStdString(), one.toObject());
    }
    return rows.text();
}

std::string findingRows(const TableSession& session, const session::SessionMeasures& measures, const fs::path& file)
{
    const std::string cells = sessionCells(session);
    std::string out;
    std::size_t number = 0;
    for (const session::FindingMeasures& one : measures.findings) {
        core::Finding finding = one.finding;
        finding.recording = core::RecordedMoment{file.filename().string(), {}, 0, std::max(0.0, one.marked_s)};
        out += cells + ',' + findingRow(finding, ++number);
        if (finding.hasPlace) {
            out += ',' + (one.firstTouched_s ? tableNumber(*one.firstTouched_s) : std::string());
            for (const double value :
                 {one.dwell_s, static_cast<double>(one.visits), one.meanForce_N, one.peakForce_N, one.peakDepth_mm}) {
                out += ',' + tableNumber(value);
            }
        } else {
            out += ",,,,,,";
        }
        out += kLineEnd;
    }
    return out;
}

} // namespace palpate::study

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/MotionFile.h"

#include <palpate/core/Numbers.h>
#include <palpate/core/Text.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

namespace palpate::session {

namespace {

using core::Status;
using core::StatusCode;

constexpr std::array<std::string_view, 4> kColumns{"x", "y", "z", "time_s"};
constexpr std::size_t kTimeColumn = 3;
constexpr double kLargest_mm = 1e9;             // squares of larger distances lose palpable precision
constexpr std::size_t kLongestLine = 1'000'000; // bytes; a device or binary file may lack line ends
constexpr std::size_t kMostRows = 86'400'000;   // one day at 1 kHz, 2 GB
constexpr double kShortestPeriod_s = 1e-5, kLongestPeriod_s = 1.0; // same limits as in a recording

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view kBlanks = " \t\r";
    const auto first = text.find_first_not_of(kBlanks);
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// Removes quotation marks, which many programs write around fields or headers.
std::string_view unquoted(std::string_view field)
{
    field = trimmed(field);
    const bool isQuoted = field.size() >= 2 && field.front() == '"' && field.back() == '"';
    return isQuoted ? field.substr(1, field.size() - 2) : field;
}

/// Removes the text up to `separator` from the front of `rest`.
std::string_view take(std::string_view& rest, char separator)
{
    const auto end = rest.find(separator);
    const auto part = rest.substr(0, end);
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    return part;
}

std::size_t fieldCount(std::string_view line)
{
    return static_cast<std::size_t>(std::count(line.begin(), line.end(), ',')) + 1;
}

/// Parses a motion line by line, so that memory use depends on the number of rows only.
class MotionParser
{
  public:
    explicit MotionParser(std::string_view name)
        : m_name(name)
    {
    }

    /// Parses one line without its line feed.
    Status add(std::string_view line)
    {
        ++m_line;
        if (m_line == 1) {
            return readHeader(line.starts_with("\xef\xbb\xbf") ? line.substr(3) : line);
        }
        if (trimmed(line).empty()) { // an error only if a row follows
            m_firstBlank = m_firstBlank == 0 ? m_line : m_firstBlank;
            return {};
        }
        if (m_firstBlank != 0) {
            m_line = m_firstBlank;
            return wrongFieldCount(1);
        }
        return readRow(line);
    }

    /// Reports a line longer than kLongestLine bytes.
    Status refuseLongLine()
    {
        ++m_line;
        return wrong(StatusCode::OutOfRange,
                     core::Message(PALPATE_TEXT("found more than %1 bytes without a line end, expected a CSV"),
                                   core::Count(kLongestLine)));
    }

    core::Result<Motion> finish()
    {
        if (m_line == 0) {
            return add("");
        }
        if (m_motion.p_WH.empty()) {
            m_line = 1;
            return wrong(StatusCode::Empty,
                         core::Message(PALPATE_TEXT("found no rows after the header, expected one a servo tick")));
        }
        return finished();
    }

  private:
    Status wrong(StatusCode code, const core::Message& what, std::string_view column = {}) const
    {
        return column.empty() ? Status(code, PALPATE_TEXT("%1: line %2: %3"), m_name, m_line, what)
                              : Status(code, PALPATE_TEXT("%1: line %2, column %3: %4"), m_name, m_line, column, what);
    }

    Status wrongFieldCount(std::size_t fields) const
    {
        return wrong(StatusCode::BadFormat,
                     fields == 1 ? core::Message(PALPATE_TEXT("found 1 field, expected %1 as in the header"), m_fields)
                                 : core::Message(PALPATE_TEXT("found %1 fields, expected %2 as in the header"), fields,
                                                 m_fields));
    }

    Status readHeader(std::string_view header)
    {
        if (trimmed(header).empty()) {
            return wrong(StatusCode::Empty,
                         core::Message(PALPATE_TEXT("found an empty line, expected a header with x, y and z")));
        }
        m_fields = fieldCount(header);
        m_place.fill(m_fields);
        std::string_view rest = header;
        for (std::size_t i = 0; i < m_fields; ++i) {
            const auto known = std::find(kColumns.begin(), kColumns.end(), unquoted(take(rest, ',')));
            if (known == kColumns.end()) {
                continue;
            }
            std::size_t& place = m_place[static_cast<std::size_t>(known - kColumns.begin())];
            if (place != m_fields) {
                return wrong(StatusCode::BadFormat,
                             core::Message(PALPATE_TEXT("found the column twice, expected it once")), *known);
            }
            place = i;
        }
        for (std::size_t c = 0; c < kTimeColumn; ++c) {
            if (m_place[c] == m_fields) {
                return wrong(StatusCode::BadFormat,
                             core::Message(PALPATE_TEXT("found no column %1 in %2, expected a header with x, y and z"),
                                           kColumns[c], core::inQuotes(trimmed(header))));
            }
        }
        return {};
    }

    Status readRow(std::string_view row)
    {
        if (const std::size_t fields = fieldCount(row); fields != m_fields) {
            return wrongFieldCount(fields);
        }
        if (m_motion.p_WH.size() == kMostRows) {
            return wrong(
                StatusCode::OutOfRange,
                core::Message(PALPATE_TEXT("found more than %1 rows, expected at most a day at 1 kHz: split the file"),
                              core::Count(kMostRows)));
        }
        std::array<double, 4> values{};
        for (std::size_t i = 0; i < m_fields; ++i) {
            const std::string_view field = unquoted(take(row, ','));
            const auto c = static_cast<std::size_t>(std::find(m_place.begin(), m_place.end(), i) - m_place.begin());
            if (c == m_place.size()) {
                continue;
            }
            const auto value = core::parseNumber(field);
            if (!value) {
                return wrong(StatusCode::BadFormat,
                             core::Message(PALPATE_TEXT("found %1, expected a number"), core::inQuotes(trimmed(field))),
                             kColumns[c]);
            }
            if (!std::isfinite(*value)) {
                return wrong(
                    StatusCode::NonFinite,
                    core::Message(PALPATE_TEXT("found %1, expected a finite number"), core::inQuotes(trimmed(field))),
                    kColumns[c]);
            }
            if (c != kTimeColumn && std::abs(*value) > kLargest_mm) {
                return wrong(StatusCode::OutOfRange,
                             core::Message(PALPATE_TEXT("found %1, expected a coordinate within 10⁹ mm"),
                                           core::inQuotes(trimmed(field))),
                             kColumns[c]);
            }
            values[c] = *value;
        }
        if (m_motion.p_WH.empty()) {
            m_first_s = values[kTimeColumn];
        } else if (hasTime() && !(values[kTimeColumn] >= m_last_s)) {
            return wrong(
                StatusCode::BadFormat,
                core::Message(PALPATE_TEXT("found a time before the previous row's, expected ascending times")),
                kColumns[kTimeColumn]);
        }
        m_last_s = values[kTimeColumn];
        m_motion.p_WH.emplace_back(values[0], values[1], values[2]);
        return {};
    }

    core::Result<Motion> finished()
    {
        if (hasTime() && m_motion.p_WH.size() > 1) {
            // One row is one servo tick, so the mean spacing is the period. The mean is independent of the rounding of
            // single times.
            m_motion.dt_s = (m_last_s - m_first_s) / static_cast<double>(m_motion.p_WH.size() - 1);
            if (std::abs(m_motion.dt_s - kNominalPeriod_s) < 1e-9 * kNominalPeriod_s) {
                m_motion.dt_s = kNominalPeriod_s;
            }
            if (m_last_s == m_first_s) {
                return wrong(StatusCode::BadFormat,
                             core::Message(PALPATE_TEXT("found that no time passes, expected ascending times")),
                             kColumns[kTimeColumn]);
            }
            if (!(m_motion.dt_s >= kShortestPeriod_s && m_motion.dt_s <= kLongestPeriod_s)) {
                return wrong(
                    StatusCode::OutOfRange,
                    core::Message(PALPATE_TEXT("found %1 s between rows on average, expected 0.00001 to 1 s: one "
                                               "row a servo tick"),
                                  m_motion.dt_s),
                    kColumns[kTimeColumn]);
            }
        }
        return std::move(m_motion);
    }

    bool hasTime() const { return m_place[kTimeColumn] != m_fields; }

    std::string_view m_name;
    std::size_t m_line = 0;
    std::size_t m_firstBlank = 0; ///< line number after the header; 0: none so far
    std::size_t m_fields = 0;
    std::array<std::size_t, 4> m_place{}; ///< field index of each known column; `m_fields` if absent
    double m_first_s = 0.0;
    double m_last_s = 0.0;
    Motion m_motion;
};

} // namespace

core::Result<Motion> parseMotion(std::string_view text, std::string_view name)
{
    MotionParser parser(name);
    while (!text.empty()) {
        const std::string_view line = take(text, '\n');
        if (Status status = line.size() > kLongestLine ? parser.refuseLongLine() : parser.add(line); !status.isOk()) {
            return status;
        }
    }
    return parser.finish();
}

core::Result<Motion> readMotion(const std::filesystem::path& path)
{
    const std::string name = path.string();
    const auto unreadable = [&name](int error) {
        return error == ENOENT
                   ? Status(StatusCode::NotFound, PALPATE_TEXT("%1: no such file, expected a motion CSV"), name)
                   : Status(StatusCode::Unreadable, PALPATE_TEXT("%1: cannot be read: %2, expected a motion CSV"), name,
                            core::systemError(error));
    };
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
        return Status(StatusCode::Unreadable, PALPATE_TEXT("%1: found a directory, expected a motion CSV"), name);
    }
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rbe"), &std::fclose);
    if (file == nullptr) {
        return unreadable(errno);
    }
    MotionParser parser(name);
    std::string pending; // beginning of an incomplete line
    std::vector<char> block(1U << 16U);
    while (const std::size_t count = std::fread(block.data(), 1, block.size(), file.get())) {
        std::string_view rest(block.data(), count);
        for (auto end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
            pending.append(rest.substr(0, end));
            if (Status status = pending.size() > kLongestLine ? parser.refuseLongLine() : parser.add(pending);
                !status.isOk()) {
                return status;
            }
            pending.clear();
            rest.remove_prefix(end + 1);
        }
        pending.append(rest);
        if (pending.size() > kLongestLine) {
            return parser.refuseLongLine();
        }
    }
    if (std::ferror(file.get()) != 0) {
        return unreadable(errno);
    }
    if (!pending.empty()) {
        if (Status status = parser.add(pending); !status.isOk()) {
            return status;
        }
    }
    return parser.finish();
}

} // namespace palpate::session

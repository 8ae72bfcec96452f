// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/MotionFile.h"

#include <palpate/core/Numbers.h>
#include <palpate/core/Text.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

namespace palpate::session {

namespace {

using core::Status;
using core::StatusCode;

constexpr std::array<std::string_view, 4> kColumns{"x", "y", "z", "time_s"};
constexpr std::size_t kTimeColumn = 3;
constexpr double kLargest_mm = 1e9; // beyond it the squares of distances lose what a hand can feel

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view kBlanks = " \t\r";
    const auto first = text.find_first_not_of(kBlanks);
    return first == std::string_view::npos ? std::string_view()
                                           : text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// Many programs write each field, or the header's, in quotation marks.
std::string_view unquoted(std::string_view field)
{
    field = trimmed(field);
    const bool isQuoted = field.size() >= 2 && field.front() == '"' && field.back() == '"';
    return isQuoted ? field.substr(1, field.size() - 2) : field;
}

/// Cuts the text up to `separator` off the front of `rest`.
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

class MotionParser
{
  public:
    MotionParser(std::string_view text, std::string_view name)
        : m_rest(text)
        , m_name(name)
    {
    }

    core::Result<Motion> parse()
    {
        if (m_rest.starts_with("\xef\xbb\xbf")) {
            m_rest.remove_prefix(3);
        }
        const auto end = m_rest.find_last_not_of(" \t\r\n");
        m_rest = m_rest.substr(0, end == std::string_view::npos ? 0 : end + 1);
        if (Status status = readHeader(); !status.isOk()) {
            return status;
        }
        while (!m_rest.empty()) {
            if (Status status = readRow(); !status.isOk()) {
                return status;
            }
        }
        if (m_motion.p_WH.empty()) {
            return wrong(StatusCode::Empty, "found no rows after the header, expected one a servo tick");
        }
        return finished();
    }

  private:
    Status wrong(StatusCode code, const std::string& what, std::string_view column = {}) const
    {
        std::string message = std::string(m_name) + ": line " + std::to_string(m_line);
        if (!column.empty()) {
            message += ", column " + std::string(column);
        }
        return {code, message + ": " + what};
    }

    Status readHeader()
    {
        ++m_line;
        std::string_view header = take(m_rest, '\n');
        if (trimmed(header).empty()) {
            return wrong(StatusCode::Empty, "found an empty line, expected a header with x, y and z");
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
                return wrong(StatusCode::BadFormat, "found the column twice, expected it once", *known);
            }
            place = i;
        }
        for (std::size_t c = 0; c < kTimeColumn; ++c) {
            if (m_place[c] == m_fields) {
                return wrong(StatusCode::BadFormat, "found no column " + std::string(kColumns[c]) + " in " +
                                                        core::inQuotes(trimmed(header)) +
                                                        ", expected a header with x, y and z");
            }
        }
        return {};
    }

    Status readRow()
    {
        ++m_line;
        std::string_view row = take(m_rest, '\n');
        if (const std::size_t fields = fieldCount(row); fields != m_fields) {
            return wrong(StatusCode::BadFormat, "found " + std::to_string(fields) +
                                                    (fields == 1 ? " field" : " fields") + ", expected " +
                                                    std::to_string(m_fields) + " as in the header");
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
                return wrong(StatusCode::BadFormat, "found " + core::inQuotes(trimmed(field)) + ", expected a number",
                             kColumns[c]);
            }
            if (!std::isfinite(*value)) {
                return wrong(StatusCode::NonFinite,
                             "found " + core::inQuotes(trimmed(field)) + ", expected a finite number", kColumns[c]);
            }
            if (c != kTimeColumn && std::abs(*value) > kLargest_mm) {
                return wrong(StatusCode::OutOfRange,
                             "found " + core::inQuotes(trimmed(field)) + ", expected a coordinate within 1e9 mm",
                             kColumns[c]);
            }
            values[c] = *value;
        }
        if (m_motion.p_WH.empty()) {
            m_first_s = values[kTimeColumn];
        } else if (hasTime() && !(values[kTimeColumn] >= m_last_s)) {
            return wrong(StatusCode::BadFormat, "found a time before the previous row's, expected ascending times",
                         kColumns[kTimeColumn]);
        }
        m_last_s = values[kTimeColumn];
        m_motion.p_WH.emplace_back(values[0], values[1], values[2]);
        return {};
    }

    core::Result<Motion> finished()
    {
        if (hasTime() && m_motion.p_WH.size() > 1) {
            // One row is one servo tick: the mean spacing is its period, free of the rounding of single times.
            m_motion.dt_s = (m_last_s - m_first_s) / static_cast<double>(m_motion.p_WH.size() - 1);
            if (std::abs(m_motion.dt_s - kNominalPeriod_s) < 1e-9 * kNominalPeriod_s) {
                m_motion.dt_s = kNominalPeriod_s;
            }
            if (!(m_motion.dt_s > 0.0) || !std::isfinite(m_motion.dt_s)) {
                return wrong(StatusCode::BadFormat, "found that no time passes, expected ascending times",
                             kColumns[kTimeColumn]);
            }
        }
        return std::move(m_motion);
    }

    bool hasTime() const { return m_place[kTimeColumn] != m_fields; }

    std::string_view m_rest;
    std::string_view m_name;
    std::size_t m_line = 0;
    std::size_t m_fields = 0;
    std::array<std::size_t, 4> m_place{}; ///< field of each known column, `m_fields` when absent
    double m_first_s = 0.0;
    double m_last_s = 0.0;
    Motion m_motion;
};

} // namespace

core::Result<Motion> parseMotion(std::string_view text, std::string_view name)
{
    return MotionParser(text, name).parse();
}

core::Result<Motion> readMotion(const std::filesystem::path& path)
{
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) {
        return Status(StatusCode::NotFound, path.string() + ": no such file, expected a motion CSV");
    }
    if (std::filesystem::is_directory(status)) {
        return Status(StatusCode::Unreadable, path.string() + ": found a directory, expected a motion CSV");
    }
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (!file.good() && !file.eof()) {
        return Status(StatusCode::Unreadable, path.string() + ": cannot be read");
    }
    return parseMotion(text, path.string());
}

} // namespace palpate::session

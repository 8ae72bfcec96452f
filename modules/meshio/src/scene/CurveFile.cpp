// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/meshio/CurveFile.h"

#include "guard/FileImage.h"
#include "text/Fault.h"

#include <palpate/core/Numbers.h>

#include <algorithm>
#include <array>

namespace palpate::meshio {

namespace {

using core::ForceLaw;
using core::StatusCode;

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view kBlank = " \t\r\"";
    const std::size_t first = text.find_first_not_of(kBlank);
    return first == text.npos ? std::string_view() : text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::vector<std::string_view> cells(std::string_view line)
{
    std::vector<std::string_view> found;
    for (std::size_t at = 0; at <= line.size();) {
        const std::size_t comma = std::min(line.find(',', at), line.size());
        found.push_back(trimmed(line.substr(at, comma - at)));
        at = comma + 1;
    }
    return found;
}

constexpr std::array<std::string_view, 2> kColumns{"depth_mm", "force_N"};

} // namespace

core::Result<std::vector<ForceLaw::Point>> readCurve(const std::filesystem::path& path)
{
    const std::string file = path.filename().string();
    const auto image = internal::FileImage::load(path);
    if (!image.isOk()) {
        return image.status();
    }
    std::array<std::size_t, 2> column{};
    ForceLaw law{core::LawKind::Points, {}, {}};
    bool hasHeader = false;
    std::uint64_t number = 0;
    std::vector<std::uint64_t> lines; // line number of each point
    std::string_view rest = image.value().bytes();
    if (rest.starts_with("\xEF\xBB\xBF")) {
        rest.remove_prefix(3);
    }
    while (!rest.empty() && law.points.size() <= ForceLaw::kMaxPoints) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view line = trimmed(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
        ++number;
        if (line.empty()) {
            continue;
        }
        const std::vector<std::string_view> found = cells(line);
        ForceLaw::Point point{};
        for (std::size_t i = 0; i < kColumns.size(); ++i) {
            if (!hasHeader) {
                column[i] =
                    static_cast<std::size_t>(std::find(found.begin(), found.end(), kColumns[i]) - found.begin());
                if (column[i] == found.size()) {
                    return internal::fault(StatusCode::BadFormat, file, internal::onLine(number),
                                           {PALPATE_TEXT("no column %1"), kColumns[i]},
                                           {PALPATE_TEXT("a header with %1 and %2"), kColumns[0], kColumns[1]});
                }
                continue;
            }
            const auto value = column[i] < found.size() ? core::parseNumber(found[column[i]]) : std::nullopt;
            if (!value) {
                const std::string_view cell = column[i] < found.size() ? found[column[i]] : "";
                return internal::fault(StatusCode::BadFormat, file, internal::onLine(number),
                                       {PALPATE_TEXT("%1 is %2"), kColumns[i], internal::inQuotes(cell)},
                                       {PALPATE_TEXT("a number")});
            }
            point[i] = *value;
        }
        if (hasHeader) {
            law.points.push_back(point);
            lines.push_back(number);
        }
        hasHeader = true;
    }
    if (const core::PointFault fault = core::firstFault(law.points); !fault.what.isEmpty()) {
        return internal::fault(StatusCode::OutOfRange, file,
                               fault.point < lines.size() ? internal::onLine(lines[fault.point]) : core::Message(),
                               fault.what);
    }
    return std::move(law.points);
}

} // namespace palpate::meshio

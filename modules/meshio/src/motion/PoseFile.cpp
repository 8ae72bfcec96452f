// SPDX-License-Identifier: BSD-3-Clause
#include "guard/FileImage.h"
#include "palpate/meshio/SceneMotion.h"
#include "text/Fault.h"

#include <palpate/core/Numbers.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace palpate::meshio {

namespace {

using core::StatusCode;
using core::Vec3;

constexpr std::array<std::string_view, 8> kPoseColumns{"time_s", "x", "y", "z", "qw", "qx", "qy", "qz"};
constexpr std::size_t kPlaceColumns = 4; ///< these are required
constexpr std::size_t kMostPoses = 1'000'000;

std::string_view withoutBlanks(std::string_view text)
{
    constexpr std::string_view kBlank = " \t\r\"";
    const std::size_t first = text.find_first_not_of(kBlank);
    return first == text.npos ? std::string_view() : text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::vector<std::string_view> cellsOf(std::string_view line)
{
    std::vector<std::string_view> found;
    for (std::size_t at = 0; at <= line.size();) {
        const std::size_t comma = std::min(line.find(',', at), line.size());
        found.push_back(withoutBlanks(line.substr(at, comma - at)));
        at = comma + 1;
    }
    return found;
}

} // namespace

core::Result<std::vector<geometry::PoseKey>> readPoses(const std::filesystem::path& path)
{
    const std::string file = path.filename().string();
    const auto image = internal::FileImage::load(path);
    if (!image.isOk()) {
        return image.status();
    }
    std::vector<geometry::PoseKey> keys;
    std::array<std::size_t, kPoseColumns.size()> column{};
    std::size_t columns = 0; // that are used; 0 before the header
    std::uint64_t number = 0;
    std::string_view rest = image.value().bytes();
    if (rest.starts_with("\xEF\xBB\xBF")) {
        rest.remove_prefix(3);
    }
    while (!rest.empty() && keys.size() < kMostPoses) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view line = withoutBlanks(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
        ++number;
        if (line.empty()) {
            continue;
        }
        const std::vector<std::string_view> found = cellsOf(line);
        if (columns == 0) {
            const auto placeOf = [&](std::string_view name) {
                return static_cast<std::size_t>(std::find(found.begin(), found.end(), name) - found.begin());
            };
            std::transform(kPoseColumns.begin(), kPoseColumns.end(), column.begin(), placeOf);
            columns = column[kPlaceColumns] == found.size() ? kPlaceColumns : kPoseColumns.size();
            for (std::size_t i = 0; i < columns; ++i) {
                if (column[i] == found.size()) {
                    return internal::fault(
                        StatusCode::BadFormat, file, internal::onLine(number),
                        {PALPATE_TEXT("no column %1"), kPoseColumns[i]},
                        {PALPATE_TEXT("a header with time_s, x, y, z and optionally qw, qx, qy, qz")});
                }
            }
            continue;
        }
        std::array<double, kPoseColumns.size()> value{0, 0, 0, 0, 1, 0, 0, 0};
        for (std::size_t i = 0; i < columns; ++i) {
            const std::string_view cell = column[i] < found.size() ? found[column[i]] : "";
            const auto parsed = core::parseNumber(cell);
            if (!parsed || !std::isfinite(*parsed)) {
                return internal::fault(StatusCode::BadFormat, file, internal::onLine(number),
                                       {PALPATE_TEXT("%1 is %2"), kPoseColumns[i], internal::inQuotes(cell)},
                                       {PALPATE_TEXT("a number")});
            }
            value[i] = *parsed;
        }
        const core::Quaternion q(value[4], value[5], value[6], value[7]);
        if (!(std::abs(q.norm() - 1.0) <= 1e-3)) {
            return internal::fault(StatusCode::OutOfRange, file, internal::onLine(number),
                                   {PALPATE_TEXT("a quaternion of length %1"), q.norm()}, {PALPATE_TEXT("1")});
        }
        geometry::PoseKey& key = keys.emplace_back();
        key.time_s = value[0];
        key.X_WR.linear() = q.normalized().toRotationMatrix();
        key.X_WR.translation() = Vec3(value[1], value[2], value[3]);
    }
    return keys;
}

} // namespace palpate::meshio

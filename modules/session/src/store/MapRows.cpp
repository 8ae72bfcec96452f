// SPDX-License-Identifier: BSD-3-Clause
#include "store/MapRows.h"

#include "tables/Packing.h"

#include <palpate/core/TissueMapping.h>

#include <QByteArray>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <iterator>
#include <memory>
#include <span>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace palpate::session::internal {

namespace {

constexpr std::array<std::string_view, haptics::kFeltPress_mm.size()> kFeltNames{"felt_0_mm", "felt_2_mm", "felt_4_mm",
                                                                                 "felt_8_mm"};

/// Name and validity of each map, in the order of `TissueMaps::all`: the mapped quantities, then the effect of lumps.
struct NamedMap
{
    std::string_view quantity;
    bool isAboveZero; ///< zero is not allowed
};
constexpr auto kMaps = [] {
    std::array<NamedMap, core::kMappedQuantities.size() + kFeltNames.size()> maps{};
    auto* at = maps.data();
    for (const core::QuantityTraits& quantity : core::kMappedQuantities) {
        *at++ = {quantity.name, quantity.isAboveZero};
    }
    for (const std::string_view name : kFeltNames) {
        *at++ = {name, true};
    }
    return maps;
}();
static_assert(kMaps.size() == std::tuple_size_v<decltype(haptics::TissueMaps().all())>);

constexpr const char* kMotion = "motion";

QLatin1String latin1(std::string_view text)
{
    return QLatin1String(text.data(), static_cast<qsizetype>(text.size()));
}

using Corners = std::vector<std::array<float, 3>>;

std::string_view bytesOf(const haptics::TissueMap& map)
{
    return {reinterpret_cast<const char*>(map.corners->data()), map.corners->size() * sizeof(Corners::value_type)};
}

std::string_view text(const std::vector<std::byte>& bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string hashOf(std::string_view bytes)
{
    const std::string hash = sha256(bytes);
    return QByteArray(hash.data(), static_cast<qsizetype>(hash.size())).toHex().toStdString();
}

/// Returns true if all values of a map are in range.
bool isValid(const Corners& corners, double factor, bool isAboveZero)
{
    const bool isPossible = std::all_of(corners.begin(), corners.end(), [isAboveZero](const std::array<float, 3>& at) {
        return std::all_of(at.begin(), at.end(),
                           [isAboveZero](float v) { return std::isfinite(v) && (isAboveZero ? v > 0.0F : v >= 0.0F); });
    });
    return isPossible && factor > 0.0 && std::isfinite(factor);
}

} // namespace

std::string mapsText(const StoredMaps& stored)
{
    const haptics::TissueMaps& maps = stored.maps;
    QJsonArray out;
    for (std::size_t i = 0; i < kMaps.size(); ++i) {
        const haptics::TissueMap& map = *maps.all()[i];
        if (!map.isEmpty()) {
            out.append(QJsonObject{{"quantity", latin1(kMaps[i].quantity)},
                                   {"factor", map.factor},
                                   {"sha256", QString::fromStdString(hashOf(bytesOf(map)))}});
        }
    }
    if (stored.motion != nullptr) {
        out.append(QJsonObject{{"quantity", kMotion},
                               {"sha256", QString::fromStdString(hashOf(text(stored.motion->bytes())))}});
    }
    return out.isEmpty() ? std::string() : QJsonDocument(out).toJson(QJsonDocument::Compact).toStdString();
}

void forEachMap(const StoredMaps& stored,
                const std::function<void(const std::string& sha256, std::string_view bytes)>& take)
{
    for (const haptics::TissueMap* map : stored.maps.all()) {
        if (!map->isEmpty()) {
            take(hashOf(bytesOf(*map)), bytesOf(*map));
        }
    }
    if (stored.motion != nullptr) {
        const std::vector<std::byte> bytes = stored.motion->bytes();
        take(hashOf(text(bytes)), text(bytes));
    }
}

StoredMaps mapsOf(const std::string& text, const std::function<std::optional<std::string>(const std::string&)>& find)
{
    StoredMaps stored;
    const std::array all = stored.maps.all();
    for (const QJsonValue& entry : QJsonDocument::fromJson(QByteArray::fromStdString(text)).array()) {
        const QString quantity = entry["quantity"].toString();
        const auto* const named =
            std::find_if(kMaps.begin(), kMaps.end(), [&](const NamedMap& n) { return quantity == latin1(n.quantity); });
        const std::string hash = entry["sha256"].toString().toStdString();
        const std::optional<std::string> bytes = find(hash);
        if (quantity == QLatin1String(kMotion) && bytes && hashOf(*bytes) == hash) {
            auto motion = geometry::SurfaceMotion::fromBytes(std::as_bytes(std::span(*bytes)));
            stored.motion = motion.isOk() ? std::move(motion).value() : nullptr;
            continue;
        }
        if (named == kMaps.end() || !bytes || hashOf(*bytes) != hash ||
            bytes->size() % sizeof(Corners::value_type) != 0) {
            continue;
        }
        auto corners = std::make_shared<Corners>(bytes->size() / sizeof(Corners::value_type));
        if (!bytes->empty()) {
            std::memcpy(static_cast<void*>(corners->data()), bytes->data(), bytes->size());
        }
        const double factor = entry["factor"].toDouble();
        if (isValid(*corners, factor, named->isAboveZero)) {
            *all[static_cast<std::size_t>(named - kMaps.begin())] = {std::move(corners), factor};
        }
    }
    return stored;
}

} // namespace palpate::session::internal

// SPDX-License-Identifier: BSD-3-Clause
#include "tables/Packing.h"

#include "database/Bytes.h"
#include "database/LawText.h"
#include "tables/Contacts.h"
#include "tables/MetaTable.h"
#include "tables/Schema.h"
#include "tables/TickColumns.h"

#include <QCryptographicHash>

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

namespace palpate::session::internal {

bool sameBits(double a, double b) noexcept
{
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

bool sameBits(const core::Vec3& a, const core::Vec3& b) noexcept
{
    return sameBits(a.x(), b.x()) && sameBits(a.y(), b.y()) && sameBits(a.z(), b.z());
}

void packTick(std::string& out, const servo::TickRecord& tick, int version)
{
    const servo::TickRecord none{};
    for (const std::size_t width : {8U, 4U, 2U, 1U}) {
        for (const TickColumn& column : kTickColumns) {
            const bool isNull = column.stored == Stored::InContact && tick.felt.structure < 0;
            useValue(column, isNull ? none : tick, [&]<class Value>(const Value& value) {
                constexpr std::size_t kWidth = std::is_same_v<Value, core::Vec3> ? sizeof(double) : sizeof(Value);
                if constexpr (!std::is_same_v<Value, haptics::TickResult>) {
                    if (column.isStored(version) && kWidth == width) {
                        put(out, value);
                    }
                }
            });
        }
    }
    if (version >= 3) {
        putText(out, packLayers(tick));
    }
}

void packScene(std::string& out, const SceneRecord& scene, int version)
{
    put(out, scene.generation);
    put(out, static_cast<std::uint64_t>(scene.structures.size()));
    put(out, scene.fingertip_mm);
    for (const StructureRecord& structure : scene.structures) {
        putText(out, structure.name);
        putText(out, structure.source.mesh);
        putText(out, structure.source.part);
        putNumber(out, structure.source.unit_mm);
        put(out, static_cast<std::uint8_t>(structure.source.flipped));
        putText(out, poseText(structure.source));
        putText(out, structure.source.sha256);
        for (const core::TissueTerm& term : tissueTerms(version)) {
            putNumber(out, structure.tissue.*term.member + 0.0); // a REAL column loses the sign of zero
        }
        put(out, structure.layer);
        put(out, static_cast<std::uint8_t>(structure.palpable));
        if (version >= 3) {
            putText(out, lawText(structure.tissue.law));
            putText(out, structure.lawTable);
            putText(out, structure.maps);
        }
    }
}

void packEvent(std::string& out, std::int64_t id, const RecordingEvent& event)
{
    put(out, id);
    put(out, event.tick);
    putText(out, event.kind);
    putText(out, event.json);
}

std::string embeddedHash(const geometry::RepairedMesh& surface)
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    const auto add = [&hash](const auto& values) {
        const auto bytes = std::as_bytes(std::span(values));
        hash.addData(QByteArrayView(reinterpret_cast<const char*>(bytes.data()), static_cast<qsizetype>(bytes.size())));
    };
    add(surface.mesh.vertices);
    add(surface.mesh.triangles);
    add(surface.twoSided);
    add(surface.source);
    return hash.result().toStdString();
}

namespace {

/// Returns true if the state is one of moving tissue. Others are stored as before moving tissue was added.
bool isMoving(const haptics::PalpatorState& state)
{
    return std::any_of(state.p_RH.begin(), state.p_RH.end(), [](const core::Vec3& p) { return !p.isZero(0.0); });
}

} // namespace

std::string packState(const haptics::PalpatorState& state, int version)
{
    std::string out;
    for (const auto& layer : state.layers) {
        put(out, layer.p_WG);
        for (const auto value : layer.structure) {
            put(out, value);
        }
        for (const auto value : layer.triangle) {
            put(out, value);
        }
        for (const auto value : layer.side) {
            put(out, value);
        }
        put(out, layer.constraints);
        put(out, layer.placed);
        if (version >= 3) {
            put(out, layer.slides);
        }
    }
    put(out, state.p_WH);
    put(out, state.started);
    if (version >= 4) {
        for (const haptics::LostContact& left : state.left) {
            put(out, left.p_WG);
            put(out, left.p_WH);
            put(out, left.age_s);
            put(out, left.structure);
            put(out, left.isKept);
            put(out, left.isOnSheet);
        }
    }
    if (isMoving(state)) {
        for (const core::Vec3& p_RH : state.p_RH) {
            put(out, p_RH);
        }
    }
    return out;
}

std::optional<haptics::PalpatorState> unpackState(std::string_view bytes)
{
    haptics::PalpatorState state;
    const bool hasRest = bytes.size() == packState(state).size() + sizeof state.p_RH;
    const bool hasLeft = hasRest || bytes.size() == packState(state).size();
    const bool hasFriction = hasLeft || bytes.size() == packState(state, 3).size();
    if (!hasFriction && bytes.size() != packState(state, 2).size()) {
        return std::nullopt;
    }
    for (auto& layer : state.layers) {
        take(bytes, layer.p_WG);
        for (auto& value : layer.structure) {
            take(bytes, value);
        }
        for (auto& value : layer.triangle) {
            take(bytes, value);
        }
        for (auto& value : layer.side) {
            take(bytes, value);
        }
        take(bytes, layer.constraints);
        take(bytes, layer.placed);
        if (hasFriction) {
            take(bytes, layer.slides);
        }
        if (layer.constraints > layer.triangle.size() || layer.placed > haptics::GodObjectState::kTight ||
            layer.slides > 1 || !layer.p_WG.allFinite()) {
            return std::nullopt;
        }
    }
    take(bytes, state.p_WH);
    take(bytes, state.started);
    if (!state.p_WH.allFinite()) {
        return std::nullopt;
    }
    for (haptics::LostContact& left : state.left) {
        if (!hasLeft) {
            break;
        }
        take(bytes, left.p_WG);
        take(bytes, left.p_WH);
        take(bytes, left.age_s);
        take(bytes, left.structure);
        take(bytes, left.isKept);
        take(bytes, left.isOnSheet);
        if (left.isKept > 1 || left.isOnSheet > 1 || !left.p_WG.allFinite() || !left.p_WH.allFinite() ||
            !std::isfinite(left.age_s)) {
            return std::nullopt;
        }
    }
    for (core::Vec3& p_RH : state.p_RH) {
        if (hasRest) {
            take(bytes, p_RH);
        }
        if (!p_RH.allFinite()) {
            return std::nullopt;
        }
    }
    return state;
}

std::string sha256(std::string_view bytes)
{
    const QByteArrayView view(bytes.data(), static_cast<qsizetype>(bytes.size()));
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(view);
    return hash.result().toStdString();
}

std::string metaHash(const std::vector<std::pair<std::string, std::string>>& meta)
{
    std::string bytes;
    for (const auto& [key, value] : meta) {
        putText(bytes, key);
        putText(bytes, value);
    }
    return sha256(bytes);
}

} // namespace palpate::session::internal

// SPDX-License-Identifier: BSD-3-Clause
#include "Packing.h"

#include "Schema.h"

#include "MetaTable.h"
#include "TickColumns.h"

#include <QCryptographicHash>

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>

namespace palpate::session::internal {

static_assert(std::endian::native == std::endian::little, "the format is little-endian");

namespace {

template<class T>
void put(std::string& out, T value)
{
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    out.append(bytes, sizeof value);
}

void putNumber(std::string& out, double value)
{
    // NULL stands for every NaN in a table, so that its bits cannot count.
    put(out, std::isnan(value) ? std::numeric_limits<double>::quiet_NaN() : value);
}

void put(std::string& out, const core::Vec3& v)
{
    for (const double value : v) {
        putNumber(out, value);
    }
}

void putText(std::string& out, std::string_view text)
{
    put(out, static_cast<std::uint64_t>(text.size()));
    out += text;
}

template<class T>
void take(std::string_view& in, T& value)
{
    std::memcpy(&value, in.data(), sizeof value);
    in.remove_prefix(sizeof value);
}

void take(std::string_view& in, core::Vec3& v)
{
    for (double& value : v) {
        take(in, value);
    }
}

} // namespace

bool sameBits(double a, double b) noexcept
{
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) || (std::isnan(a) && std::isnan(b));
}

bool sameBits(const core::Vec3& a, const core::Vec3& b) noexcept
{
    return sameBits(a.x(), b.x()) && sameBits(a.y(), b.y()) && sameBits(a.z(), b.z());
}

void packTick(std::string& out, const servo::TickRecord& tick)
{
    const servo::TickRecord none{};
    for (const std::size_t width : {8U, 4U, 2U, 1U}) {
        for (const TickColumn& column : kTickColumns) {
            const bool isNull = column.stored == Stored::InContact && tick.felt.structure < 0;
            useValue(column, isNull ? none : tick, [&]<class Value>(const Value& value) {
                constexpr std::size_t kWidth = std::is_same_v<Value, core::Vec3> ? sizeof(double) : sizeof(Value);
                if (column.isStored() && kWidth == width) {
                    put(out, value);
                }
            });
        }
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
        putText(out, poseText(structure.source.X_WM));
        putText(out, structure.source.sha256);
        for (const core::TissueTerm& term : tissueTerms(version)) {
            putNumber(out, structure.tissue.*term.member + 0.0); // a REAL column keeps no sign of a zero
        }
        put(out, structure.layer);
        put(out, static_cast<std::uint8_t>(structure.palpable));
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

std::string packState(const haptics::PalpatorState& state)
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
    }
    put(out, state.p_WH);
    put(out, state.started);
    return out;
}

std::optional<haptics::PalpatorState> unpackState(std::string_view bytes)
{
    haptics::PalpatorState state;
    if (bytes.size() != packState(state).size()) {
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
        if (layer.constraints > layer.triangle.size() || layer.placed > 1 || !layer.p_WG.allFinite()) {
            return std::nullopt;
        }
    }
    take(bytes, state.p_WH);
    take(bytes, state.started);
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

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/igtl/Wire.h"

#include <palpate/core/Text.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>

namespace palpate::igtl {

namespace {

constexpr std::array<std::uint64_t, 256> makeCrcTable()
{
    constexpr std::uint64_t kPolynomial = 0x42F0E1EBA9EA3693U;
    constexpr std::uint64_t kTop = std::uint64_t{1} << 63;
    std::array<std::uint64_t, 256> table{};
    for (std::uint64_t i = 0; i < table.size(); ++i) {
        std::uint64_t crc = i << 56;
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc & kTop) != 0 ? (crc << 1) ^ kPolynomial : crc << 1;
        }
        table[i] = crc;
    }
    return table;
}

constexpr std::array<std::uint64_t, 256> kCrcTable = makeCrcTable();

constexpr std::array<std::string_view, 6> kStoredTypes{"TRANSFORM", "POSITION", "TDATA", "STATUS", "STRING", "SENSOR"};
constexpr std::array<std::string_view, 4> kQueryPrefixes{"GET_", "STT_", "STP_", "RTS_"};

} // namespace

std::uint64_t crc64(ByteView bytes, std::uint64_t crc) noexcept
{
    for (const std::uint8_t byte : bytes) {
        crc = kCrcTable[(crc >> 56) ^ byte] ^ (crc << 8);
    }
    return crc;
}

Bytes encodeMessage(std::string_view type, std::string_view name, ByteView content, std::uint64_t timestamp,
                    std::uint16_t version)
{
    FieldWriter body;
    if (version >= 2) {
        body.number(kExtendedHeader_bytes, 2);
        body.zeros(kExtendedHeader_bytes - 2); // no metadata, message 0
    }
    body.append(content);
    FieldWriter message;
    message.number(version, 2);
    message.text(type, kTypeLength);
    message.text(name, kNameLength);
    message.number(timestamp, 8);
    message.number(body.bytes().size(), 8);
    message.number(crc64(body.bytes()), 8);
    message.append(body.bytes());
    return std::move(message).bytes();
}

std::uint64_t timestampNow() noexcept
{
    using namespace std::chrono;
    const auto now_ns =
        static_cast<std::uint64_t>(duration_cast<nanoseconds>(system_clock::now().time_since_epoch()).count());
    constexpr std::uint64_t kSecond_ns = 1'000'000'000;
    return ((now_ns / kSecond_ns) << 32) | (((now_ns % kSecond_ns) << 32) / kSecond_ns);
}

void MessageReader::add(ByteView bytes)
{
    const auto skipped = static_cast<std::size_t>(std::min<std::uint64_t>(m_skip_bytes, bytes.size()));
    m_skip_bytes -= skipped;
    bytes = bytes.subspan(skipped);
    if (m_begin == m_bytes.size()) {
        m_bytes.clear();
        m_begin = 0;
        constexpr std::size_t kKept_bytes = 1 << 20;
        if (m_bytes.capacity() > kKept_bytes) { // gives back the memory of a large surface
            m_bytes = Bytes();
        }
    } else if (m_begin > m_bytes.size() / 2) {
        m_bytes.erase(m_bytes.begin(), m_bytes.begin() + static_cast<std::ptrdiff_t>(m_begin));
        m_begin = 0;
    }
    m_bytes.insert(m_bytes.end(), bytes.begin(), bytes.end());
}

/// Largest body of a type that is stored; 0: the type has no use.
std::uint64_t MessageReader::bodyLimit(std::string_view type) const noexcept
{
    if (type == "POLYDATA") {
        return m_takesSurfaces ? kMaxSurface_bytes : 0;
    }
    const bool isStored = std::find(kStoredTypes.begin(), kStoredTypes.end(), type) != kStoredTypes.end();
    const bool isQuery = std::any_of(kQueryPrefixes.begin(), kQueryPrefixes.end(),
                                     [type](std::string_view prefix) { return type.starts_with(prefix); });
    return isStored || isQuery ? kMaxBody_bytes : 0;
}

MessageReader::Step MessageReader::next()
{
    if (m_isLost) {
        return Step::Lost;
    }
    MessageHeader& header = m_message.header;
    if (!m_hasHeader) {
        if (stored_bytes() < kHeader_bytes) {
            return Step::NeedsMore;
        }
        FieldReader fields(ByteView(m_bytes).subspan(m_begin, kHeader_bytes));
        header.version = static_cast<std::uint16_t>(fields.number(2));
        header.type = fields.text(kTypeLength);
        header.name = fields.text(kNameLength);
        header.timestamp = fields.number(8);
        header.body_bytes = fields.number(8);
        header.crc = fields.number(8);
        m_begin += kHeader_bytes;
        if (header.version < 1 || header.version > 2) {
            m_isLost = true;
            m_problem = "found header version " + std::to_string(header.version) + ", expected 1 or 2 of OpenIGTLink";
            return Step::Lost;
        }
        const std::uint64_t limit = bodyLimit(header.type);
        if (header.body_bytes > (limit > 0 ? limit : kMaxSkipped_bytes)) {
            m_isLost = true;
            m_problem = core::inQuotes(header.type) + ": found a body of " + core::grouped(header.body_bytes) +
                        " bytes, expected at most " + core::grouped(limit > 0 ? limit : kMaxSkipped_bytes);
            return Step::Lost;
        }
        if (limit == 0) {
            const std::uint64_t here = std::min<std::uint64_t>(stored_bytes(), header.body_bytes);
            m_begin += static_cast<std::size_t>(here);
            m_skip_bytes = header.body_bytes - here;
            return Step::Skipped;
        }
        m_hasHeader = true;
    }
    return stored_bytes() < header.body_bytes ? Step::NeedsMore : finish();
}

MessageReader::Step MessageReader::finish()
{
    const MessageHeader& header = m_message.header;
    const ByteView body = ByteView(m_bytes).subspan(m_begin, static_cast<std::size_t>(header.body_bytes));
    m_begin += body.size();
    m_hasHeader = false;
    if (crc64(body) != header.crc) {
        m_problem = header.type + ": found a wrong checksum";
        return Step::Refused;
    }
    m_message.content = body;
    if (header.version == 1 || body.empty()) {
        return Step::Complete;
    }
    std::uint64_t extended_bytes = 0;
    std::uint64_t metadata_bytes = 0;
    if (body.size() >= kExtendedHeader_bytes) {
        FieldReader fields(body);
        extended_bytes = fields.number(2);
        metadata_bytes = fields.number(2);
        metadata_bytes += fields.number(4);
    }
    if (extended_bytes < kExtendedHeader_bytes || extended_bytes + metadata_bytes > body.size()) {
        m_problem = header.type + ": found an extended header of " + std::to_string(extended_bytes) +
                    " bytes and metadata of " + std::to_string(metadata_bytes) + " in a body of " +
                    std::to_string(body.size());
        return Step::Refused;
    }
    m_message.content = body.subspan(static_cast<std::size_t>(extended_bytes),
                                     body.size() - static_cast<std::size_t>(extended_bytes + metadata_bytes));
    return Step::Complete;
}

std::uint64_t FieldReader::number(std::size_t bytes) noexcept
{
    std::uint64_t value = 0;
    for (const std::uint8_t byte : m_bytes.first(bytes)) {
        value = (value << 8) | byte;
    }
    skip(bytes);
    return value;
}

float FieldReader::real32() noexcept
{
    return std::bit_cast<float>(static_cast<std::uint32_t>(number(4)));
}

double FieldReader::real64() noexcept
{
    return std::bit_cast<double>(number(8));
}

std::string FieldReader::text(std::size_t bytes)
{
    const ByteView field = m_bytes.first(bytes);
    skip(bytes);
    return {field.begin(), std::find(field.begin(), field.end(), std::uint8_t{0})};
}

void FieldWriter::number(std::uint64_t value, std::size_t bytes)
{
    for (std::size_t i = bytes; i > 0; --i) {
        m_bytes.push_back(static_cast<std::uint8_t>(value >> (8 * (i - 1))));
    }
}

void FieldWriter::real32(double value)
{
    number(std::bit_cast<std::uint32_t>(static_cast<float>(value)), 4);
}

void FieldWriter::real64(double value)
{
    number(std::bit_cast<std::uint64_t>(value), 8);
}

void FieldWriter::text(std::string_view value, std::size_t bytes)
{
    value = value.substr(0, bytes);
    m_bytes.insert(m_bytes.end(), value.begin(), value.end());
    zeros(bytes - value.size());
}

} // namespace palpate::igtl

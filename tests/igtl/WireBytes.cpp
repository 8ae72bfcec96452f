// SPDX-License-Identifier: BSD-3-Clause
#include "WireBytes.h"

#include <bit>

namespace palpate::test {

WireBytes& WireBytes::number(std::uint64_t value, int size)
{
    for (int shift = 8 * (size - 1); shift >= 0; shift -= 8) {
        m_bytes.push_back(static_cast<std::uint8_t>(value >> shift));
    }
    return *this;
}

WireBytes& WireBytes::f32(std::initializer_list<double> values)
{
    for (const double value : values) {
        u32(std::bit_cast<std::uint32_t>(static_cast<float>(value)));
    }
    return *this;
}

WireBytes& WireBytes::f64(double value)
{
    return u64(std::bit_cast<std::uint64_t>(value));
}

WireBytes& WireBytes::text(std::string_view value, std::size_t size)
{
    for (std::size_t i = 0; i < size; ++i) {
        u8(i < value.size() ? static_cast<unsigned char>(value[i]) : 0U);
    }
    return *this;
}

WireBytes& WireBytes::raw(const std::vector<std::uint8_t>& bytes)
{
    m_bytes.insert(m_bytes.end(), bytes.begin(), bytes.end());
    return *this;
}

std::uint64_t slowCrc64(std::span<const std::uint8_t> bytes)
{
    std::uint64_t crc = 0;
    for (const std::uint8_t byte : bytes) {
        for (int bit = 7; bit >= 0; --bit) {
            const bool isOne = ((crc >> 63) ^ ((byte >> bit) & 1U)) != 0;
            crc = (crc << 1) ^ (isOne ? 0x42F0E1EBA9EA3693U : 0U);
        }
    }
    return crc;
}

std::vector<std::uint8_t> wireMessage(std::string_view type, std::string_view name,
                                      const std::vector<std::uint8_t>& content, const Framing& framing)
{
    WireBytes body;
    if (framing.version == 2) {
        body.u16(framing.extended).u16(0).u32(framing.metadata).u32(77);
    }
    body.raw(content);
    if (framing.version == 2) {
        body.text("metadata", framing.metadata);
    }
    const std::uint64_t size = framing.size < 0 ? body.bytes().size() : static_cast<std::uint64_t>(framing.size);
    WireBytes message;
    message.u16(framing.version).text(type, 12).text(name, 20).u64(framing.timestamp).u64(size);
    message.u64(slowCrc64(body.bytes()) ^ (framing.isChecksumWrong ? 1U : 0U));
    return message.raw(body.bytes()).bytes();
}

std::vector<std::uint8_t> transformAt(std::string_view name, double x, double y, double z, const Framing& framing)
{
    return wireMessage("TRANSFORM", name, WireBytes().f32({1, 0, 0, 0, 1, 0, 0, 0, 1, x, y, z}).bytes(), framing);
}

std::vector<std::uint8_t> tetrahedron()
{
    WireBytes content;
    content.u32(4).u32(0).u32(0).u32(0).u32(0).u32(4).u32(64).u32(0).u32(0).u32(0);
    content.f32({10, 0, 0, 0, 10, 0, 0, 0, 10, -10, -10, -10});
    for (const auto& triangle : {std::vector<unsigned>{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}) {
        content.u32(3);
        for (const unsigned corner : triangle) {
            content.u32(corner);
        }
    }
    return content.bytes();
}

} // namespace palpate::test

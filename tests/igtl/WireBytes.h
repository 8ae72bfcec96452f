// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::test {

/// Bytes of OpenIGTLink, written without the code under test.
class WireBytes
{
  public:
    WireBytes& u8(unsigned value) { return number(value, 1); }
    WireBytes& u16(unsigned value) { return number(value, 2); }
    WireBytes& u32(std::uint64_t value) { return number(value, 4); }
    WireBytes& u64(std::uint64_t value) { return number(value, 8); }
    WireBytes& f32(std::initializer_list<double> values);
    WireBytes& f64(double value);
    /// Text filled with zeros to `size`, or cut.
    WireBytes& text(std::string_view value, std::size_t size);
    WireBytes& raw(const std::vector<std::uint8_t>& bytes);
    [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return m_bytes; }

  private:
    WireBytes& number(std::uint64_t value, int size);
    std::vector<std::uint8_t> m_bytes;
};

/// Differences from a valid message.
struct Framing
{
    unsigned version = 1;
    std::uint64_t timestamp = 0;
    std::int64_t size = -1; ///< stated body size; -1: the true one
    bool isChecksumWrong = false;
    unsigned extended = 12; ///< stated size of the extended header, with version 2
    unsigned metadata = 0;  ///< bytes of metadata behind the content, with version 2
};

/// CRC-64 of ECMA-182, bit by bit.
std::uint64_t slowCrc64(std::span<const std::uint8_t> bytes);

std::vector<std::uint8_t> wireMessage(std::string_view type, std::string_view name,
                                      const std::vector<std::uint8_t>& content, const Framing& framing = {});

/// TRANSFORM without rotation.
std::vector<std::uint8_t> transformAt(std::string_view name, double x, double y, double z, const Framing& framing = {});

/// Content of a POLYDATA: a tetrahedron of four triangles around the origin.
std::vector<std::uint8_t> tetrahedron();

} // namespace palpate::test

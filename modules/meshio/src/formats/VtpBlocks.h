// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "VtpHeader.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::meshio::internal {

/// The numbers of an array as they are stored: in blocks, compressed or not, behind a header that says how long they
/// are. Made only when the header fits the bytes that are there.
class VtpBlocks
{
  public:
    /// Finds the array's data and checks its header: no block lies outside the bytes, none unpacks to more than its
    /// compression can give.
    /// @param array  of format Binary or Appended
    [[nodiscard]] static core::Result<VtpBlocks> find(const VtpDataArray& array, const VtpHeader& header,
                                                      const ScanContext& context);

    /// Bytes after unpacking.
    [[nodiscard]] std::uint64_t size() const noexcept { return m_size; }
    /// Unpacks everything. @return nothing when the data are damaged
    [[nodiscard]] std::optional<std::vector<unsigned char>> unpack() const;

  private:
    friend class VtpBlockFinder;
    struct Block
    {
        std::uint64_t begin = 0; ///< in m_data
        std::uint64_t packed = 0;
        std::uint64_t unpacked = 0;
    };

    VtpCompressor m_compressor = VtpCompressor::None;
    std::string_view m_data;
    std::shared_ptr<const std::string> m_decoded; ///< what m_data points into when the file has it as base64
    std::vector<Block> m_blocks;
    std::uint64_t m_size = 0;
};

/// @return bytes of one number of a VTP type, 0 for one that is not a number
[[nodiscard]] std::size_t vtpTypeSize(std::string_view type);
[[nodiscard]] bool isVtpIntegerType(std::string_view type);

/// The whole numbers in `bytes`, of a VTP integer type and byte order.
[[nodiscard]] std::vector<std::int64_t> vtpIntegers(std::span<const unsigned char> bytes, std::string_view type,
                                                    bool isBigEndian);

} // namespace palpate::meshio::internal

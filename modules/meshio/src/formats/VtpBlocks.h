// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "formats/VtpHeader.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::meshio::internal {

/// The stored numbers of an array: in blocks, compressed or not, after a header with the lengths
/// of the blocks. Created only if the header is consistent with the available bytes.
class VtpBlocks
{
  public:
    /// Finds the array's data and checks the header: all blocks are inside the available bytes, and no block
    /// decompresses to more than the maximum ratio permits.
    /// @param array  of format Binary or Appended
    [[nodiscard]] static core::Result<VtpBlocks> find(const VtpDataArray& array, const VtpHeader& header,
                                                      const ScanContext& context);

    /// Size of the decompressed data [bytes].
    [[nodiscard]] std::uint64_t size() const noexcept { return m_size; }
    /// Decompresses all data. @return nothing if the data are damaged
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
    std::shared_ptr<const std::string> m_decoded; ///< owner of m_data for base64 content
    std::vector<Block> m_blocks;
    std::uint64_t m_size = 0;
};

/// @return size of a VTP number type [bytes]; 0 for other types
[[nodiscard]] std::size_t vtpTypeSize(std::string_view type);
[[nodiscard]] bool isVtpIntegerType(std::string_view type);

/// Converts `bytes` from a VTP integer type and byte order.
[[nodiscard]] std::vector<std::int64_t> vtpIntegers(std::span<const unsigned char> bytes, std::string_view type,
                                                    bool isBigEndian);

/// Converts `bytes` from any VTP number type and byte order.
[[nodiscard]] std::vector<double> vtpNumbers(std::span<const unsigned char> bytes, std::string_view type,
                                             bool isBigEndian);

} // namespace palpate::meshio::internal

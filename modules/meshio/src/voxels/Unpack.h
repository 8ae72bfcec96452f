// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string_view>

namespace palpate::meshio::internal {

/// Reads a stream piece by piece: as it is, or unpacked from zlib or gzip (one or more members).
class ByteStream
{
  public:
    /// @param next  returns the next piece of the stored bytes, empty at the end; the piece stays valid until the next
    ///              call
    ByteStream(std::function<std::string_view()> next, bool isPacked);
    ~ByteStream();
    ByteStream(const ByteStream&) = delete;
    ByteStream& operator=(const ByteStream&) = delete;

    /// Fills `to`. @return the number of bytes, less at the end of the stream or at damaged data
    std::size_t read(std::span<char> to);
    [[nodiscard]] bool isDamaged() const noexcept { return m_isDamaged; } ///< invalid or cut-off compressed data

  private:
    struct Inflater;
    std::size_t inflateInto(std::span<char> to);

    std::function<std::string_view()> m_next;
    std::string_view m_rest;
    std::unique_ptr<Inflater> m_inflater; ///< null: not packed
    bool m_isDamaged = false;
};

} // namespace palpate::meshio::internal

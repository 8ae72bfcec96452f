// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Message.h>
#include <palpate/core/Status.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::meshio::internal {

// Transfer format between the reader process and the program: frames in a memory file, each with the head size, the
// head, and the numbers in native layout. Both ends are the same build on the same machine.

/// Head of a frame: status, names and counts.
class WireHead
{
  public:
    template<class T>
    void put(T value)
    {
        m_bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
    }
    void put(const std::string& text)
    {
        put(std::uint64_t{text.size()});
        m_bytes.append(text);
    }
    void put(const core::Message& message);
    /// Writes the status, which begins the head of an outcome. An error has no further content.
    void put(const core::Status& status);
    [[nodiscard]] const std::string& bytes() const noexcept { return m_bytes; }
    /// Writes the size and the head. @return false when writing fails
    [[nodiscard]] bool write(int descriptor) const;

  private:
    std::string m_bytes;
};

/// Reads values from a head. After the first missing value, `isGood` is false and all further values are zero.
class WireHeadReader
{
  public:
    explicit WireHeadReader(std::string_view bytes)
        : m_rest(bytes)
    {
    }
    template<class T>
    T take()
    {
        T value{};
        if (m_rest.size() < sizeof(value)) {
            m_isGood = false;
            return value;
        }
        std::memcpy(&value, m_rest.data(), sizeof(value));
        m_rest.remove_prefix(sizeof(value));
        return value;
    }
    std::string text();
    /// Reads a message of one line. Missing or excessive parts make the head invalid.
    core::Message message();
    /// Reads a status. @param file  name for messages
    /// @return the error of the reader process, one line with the file name; or an error about an invalid head
    core::Status status(const std::string& file);
    [[nodiscard]] bool isGood() const noexcept { return m_isGood; }
    [[nodiscard]] bool isAtEnd() const noexcept { return m_isGood && m_rest.empty(); }

  private:
    core::Message message(int depth);

    std::string_view m_rest;
    bool m_isGood = true;
};

/// A frame after reading the head, before the numbers.
struct WireFrame
{
    std::string head;
    std::uint64_t begin = 0; ///< offset of the numbers [bytes]
    std::uint64_t size = 0;  ///< of the memory file, which may grow [bytes]
};
/// @param at  offset of the frame [bytes]
/// @param file  name for messages
/// @return an error about an invalid head
[[nodiscard]] core::Result<WireFrame> readFrame(int descriptor, std::uint64_t at, const std::string& file);

/// Describes an invalid outcome.
/// @param what  invalid part of the outcome
[[nodiscard]] core::Status wireFault(const std::string& file, const core::Message& what);

[[nodiscard]] bool writeAll(int descriptor, const void* data, std::size_t size);
[[nodiscard]] bool readAll(int descriptor, void* data, std::size_t size, std::uint64_t at);

/// Reads `count` items from the memory file into `out` in blocks of 4 MiB and checks each block right after reading.
/// Releases the pages of each block in the file, so that at most one block is in memory twice.
template<class T, class Check>
[[nodiscard]] bool moveItems(int descriptor, std::uint64_t& at, std::uint64_t count, std::vector<T>& out,
                             Check&& isGood)
{
    constexpr std::size_t kItems = (std::size_t{1} << 22) / sizeof(T);
    out.reserve(count);
    while (out.size() < count) {
        const std::size_t begin = out.size();
        const std::size_t items = std::min<std::size_t>(kItems, count - begin);
        out.resize(begin + items);
        if (!readAll(descriptor, &out[begin], items * sizeof(T), at)) {
            return false;
        }
        (void)::fallocate(descriptor, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE, static_cast<off_t>(at),
                          static_cast<off_t>(items * sizeof(T))); // a failure only costs memory
        at += items * sizeof(T);
        if (!std::all_of(out.begin() + static_cast<std::ptrdiff_t>(begin), out.end(), isGood)) {
            return false;
        }
    }
    return true;
}

} // namespace palpate::meshio::internal

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace palpate::igtl {

using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

// Sizes of OpenIGTLink 3, headers 1 and 2 (openigtlink.org, Protocol/header.md). Numbers are big-endian.
inline constexpr std::size_t kHeader_bytes = 58;
inline constexpr std::size_t kExtendedHeader_bytes = 12;
inline constexpr std::size_t kTypeLength = 12;
inline constexpr std::size_t kNameLength = 20; ///< a longer name is cut and no longer matches in 3D Slicer

/// Largest body that is stored, except for surfaces. [bytes]
inline constexpr std::uint64_t kMaxBody_bytes = std::uint64_t{4} << 20;
/// Largest POLYDATA body: about 9 million triangles without attributes. [bytes]
inline constexpr std::uint64_t kMaxSurface_bytes = std::uint64_t{256} << 20;
/// Largest body of an unused type that is skipped: an image or a video frame. A larger size is nonsense. [bytes]
inline constexpr std::uint64_t kMaxSkipped_bytes = std::uint64_t{1} << 30;

inline constexpr std::uint16_t kDefaultPort = 18944;

/// CRC-64 of ECMA-182: polynomial 0x42F0E1EBA9EA3693, not reflected, initially 0.
/// @param crc  result for the preceding bytes
[[nodiscard]] std::uint64_t crc64(ByteView bytes, std::uint64_t crc = 0) noexcept;

/// Header of a message.
struct MessageHeader
{
    std::uint16_t version = 1;   ///< 1, or 2 with an extended header
    std::string type;            ///< "TRANSFORM", "STT_TDATA"; at most 12 bytes
    std::string name;            ///< device name; at most 20 bytes, any encoding
    std::uint64_t timestamp = 0; ///< seconds since 1970 in 32.32 fixed point; 0: unknown
    std::uint64_t body_bytes = 0;
    std::uint64_t crc = 0; ///< of the body
};

/// Received message. `content` excludes extended header and metadata, and is valid until the next call to the reader.
struct Message
{
    MessageHeader header;
    ByteView content;
};

/// Message with a valid header and checksum. A name or type that is too long is cut.
/// @param version  of the header; 2 adds an extended header without metadata
[[nodiscard]] Bytes encodeMessage(std::string_view type, std::string_view name, ByteView content,
                                  std::uint64_t timestamp = 0, std::uint16_t version = 1);

/// Time of day as a timestamp of the wire.
[[nodiscard]] std::uint64_t timestampNow() noexcept;

/// Splits a received stream into messages. Stores only bodies of used types within the limits above, and allocates as
/// bytes arrive, never by a number in the stream. A body without use is skipped by its size.
///
///     reader.add(received);
///     while (reader.next() == MessageReader::Step::Complete) {
///         use(reader.message());
///     }
///
/// @par Thread One thread at a time.
class MessageReader
{
  public:
    enum class Step : std::uint8_t
    {
        NeedsMore, ///< no further complete message
        Complete,  ///< `message` holds the next message
        Skipped,   ///< the header of an unused type; its body is being skipped
        Refused,   ///< the message had a wrong checksum or an inconsistent extended header; the next one may be fine
        Lost,      ///< the stream has no valid header here; `problem` gives the reason. Close the connection
    };

    /// @param takesSurfaces  stores POLYDATA; otherwise skips it
    explicit MessageReader(bool takesSurfaces)
        : m_takesSurfaces(takesSurfaces)
    {
    }

    void add(ByteView bytes);
    [[nodiscard]] Step next();
    /// The message of the last `next` that returned Complete.
    [[nodiscard]] const Message& message() const noexcept { return m_message; }
    /// Reason of Refused and Lost, with the value found and the one expected; for the user, in English.
    [[nodiscard]] const std::string& problem() const noexcept { return m_problem; }
    /// Number of stored bytes.
    [[nodiscard]] std::size_t stored_bytes() const noexcept { return m_bytes.size() - m_begin; }

  private:
    [[nodiscard]] std::uint64_t bodyLimit(std::string_view type) const noexcept;
    [[nodiscard]] Step finish();

    bool m_takesSurfaces;
    bool m_isLost = false;
    bool m_hasHeader = false; ///< m_message.header is valid and its body is awaited
    Bytes m_bytes;
    std::size_t m_begin = 0; ///< start of unused bytes in m_bytes
    std::uint64_t m_skip_bytes = 0;
    Message m_message;
    std::string m_problem;
};

/// Reads big-endian numbers and fixed-length texts, in order.
/// @pre The caller has compared the size of the content with the bytes to read.
class FieldReader
{
  public:
    explicit FieldReader(ByteView bytes)
        : m_bytes(bytes)
    {
    }
    /// @param bytes  1 to 8
    [[nodiscard]] std::uint64_t number(std::size_t bytes) noexcept;
    [[nodiscard]] float real32() noexcept;
    [[nodiscard]] double real64() noexcept;
    /// @return the text up to its first zero byte, which may be missing
    [[nodiscard]] std::string text(std::size_t bytes);
    [[nodiscard]] std::size_t left() const noexcept { return m_bytes.size(); }
    void skip(std::size_t bytes) noexcept { m_bytes = m_bytes.subspan(bytes); }

  private:
    ByteView m_bytes;
};

/// Appends big-endian numbers and fixed-length texts.
class FieldWriter
{
  public:
    /// @param bytes  1 to 8
    void number(std::uint64_t value, std::size_t bytes);
    void zeros(std::size_t bytes) { m_bytes.resize(m_bytes.size() + bytes, 0); }
    void real32(double value);
    void real64(double value);
    /// Writes a text, cut or filled with zeros to `bytes`.
    void text(std::string_view value, std::size_t bytes);
    void append(ByteView bytes) { m_bytes.insert(m_bytes.end(), bytes.begin(), bytes.end()); }
    [[nodiscard]] const Bytes& bytes() const& noexcept { return m_bytes; }
    [[nodiscard]] Bytes bytes() && noexcept { return std::move(m_bytes); }

  private:
    Bytes m_bytes;
};

} // namespace palpate::igtl

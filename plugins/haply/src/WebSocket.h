// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Connection.h"

#include <palpate/core/Status.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace palpate::haply {

/// Client of a WebSocket on this machine (RFC 6455), for one thread that must never wait longer than it wants to: a
/// call of `receive` is one ppoll and one recv, where Qt's client would need an event loop in the I/O thread and in
/// each caller of `DevicePlugin::find`. Memory is bounded whatever the peer sends: kLargestMessage for a message, and
/// as much again for bytes that have been received but not read.
class WebSocket
{
  public:
    /// A full inventory of several devices is some 10 kB.
    static constexpr std::size_t kLargestMessage = 256 * 1024;

    /// Connects and upgrades. @return NotFound: nobody listens; Mismatch: the answer is not that of a WebSocket, or
    /// none came until the deadline
    [[nodiscard]] static core::Result<WebSocket> open(std::uint16_t port, std::int64_t deadline_ns);

    /// Sends a text message without waiting. @return false: not sent, because the peer takes no more or is lost
    [[nodiscard]] bool send(std::string_view text);

    enum class Received : std::uint8_t
    {
        Nothing, ///< until the deadline
        Text,    ///< not checked for UTF-8
        Other,   ///< a binary message, which is skipped
        Closed,  ///< by the peer, or here because the peer broke the protocol
    };
    /// Waits for the next message. Answers pings.
    /// @param text  valid until the next call
    [[nodiscard]] Received receive(std::string_view& text, std::int64_t deadline_ns);

    /// Announces the end to the peer.
    void sayGoodbye() noexcept;

  private:
    explicit WebSocket(Connection connection)
        : m_connection(std::move(connection))
    {
    }
    /// Frames and masks. @return false: nothing was sent
    bool sendFrame(std::uint8_t opcode, std::string_view payload);
    bool flush() noexcept;
    struct Frame
    {
        std::uint8_t opcode = 0;
        bool isFinal = false;
        std::string_view payload;
    };
    /// Takes the next frame out of the received bytes, if it is complete.
    /// @param isBroken  set where the peer broke the protocol, or where the message would be too large
    [[nodiscard]] std::optional<Frame> takeFrame(bool& isBroken) noexcept;
    /// Takes the next message out of the received bytes. @return Nothing: more bytes are needed
    [[nodiscard]] Received takeMessage(std::string_view& text);

    Connection m_connection;
    std::string m_out;         ///< rest of a frame of which the peer took only a part
    std::string m_in;          ///< received bytes
    std::size_t m_taken = 0;   ///< of m_in, already returned
    std::string m_message;     ///< fragments of the current message
    std::uint8_t m_opcode = 0; ///< of the current fragmented message; 0: none
    std::uint32_t m_mask = 0;
};

/// Answer to `GET path` of a web server on this machine. @return nothing: no answer with status 200 and at most 64 KiB
/// until the deadline. May throw bad_alloc.
[[nodiscard]] std::optional<std::string> httpGet(std::uint16_t port, std::string_view path, std::int64_t deadline_ns);

} // namespace palpate::haply

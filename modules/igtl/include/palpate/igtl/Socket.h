// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/igtl/Wire.h"

#include <palpate/core/Status.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace palpate::igtl {

/// TCP socket that never blocks. Closed in the destructor.
class Socket
{
  public:
    Socket() = default;
    explicit Socket(int descriptor) noexcept
        : m_descriptor(descriptor)
    {
    }
    Socket(Socket&& other) noexcept
        : m_descriptor(std::exchange(other.m_descriptor, -1))
    {
    }
    Socket& operator=(Socket&& other) noexcept
    {
        std::swap(m_descriptor, other.m_descriptor);
        return *this;
    }
    Socket(const Socket&) = delete;
    Socket& operator=(const Socket&) = delete;
    ~Socket();

    [[nodiscard]] bool isOpen() const noexcept { return m_descriptor >= 0; }
    [[nodiscard]] int descriptor() const noexcept { return m_descriptor; }
    [[nodiscard]] std::uint16_t localPort() const noexcept; ///< 0 on failure
    [[nodiscard]] std::string peerAddress() const;          ///< "127.0.0.1"; empty on failure

    /// Result of `receive` and `send`.
    struct Transfer
    {
        std::size_t bytes = 0;
        bool isClosed = false; ///< by the peer, or failed
    };
    /// Copies the bytes that have arrived, at most `size` bytes.
    [[nodiscard]] Transfer receive(std::uint8_t* to, std::size_t size) noexcept;
    /// Sends as much as the system takes at once.
    [[nodiscard]] Transfer send(ByteView bytes) noexcept;
    /// Accepts a waiting connection of a listening socket; closed if there is none.
    [[nodiscard]] Socket accept() noexcept;

  private:
    int m_descriptor = -1;
};

/// Connects to a server. Names other than localhost are refused, because a name server could keep the caller waiting.
/// @param host  "localhost", or a numeric address of version 4 or 6
/// @param timeout_ms  longest wait for the server
/// @return BadCommandLine for another host; NotFound with the reason if nothing answers
[[nodiscard]] core::Result<Socket> connectTo(const std::string& host, std::uint16_t port, int timeout_ms);

/// Listens at a numeric local address. @param port  0: any free port
/// @return BadCommandLine for an invalid address; Unreadable with the reason if the port is not available
[[nodiscard]] core::Result<Socket> listenAt(const std::string& address, std::uint16_t port);

} // namespace palpate::igtl

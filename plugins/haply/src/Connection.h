// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace palpate::haply {

/// TCP connection to a port of this machine (127.0.0.1). No call waits beyond its deadline [ns, monotonic].
/// @par Thread One at a time.
class Connection
{
  public:
    /// @return nothing if nobody listens at the port, or does not accept until the deadline
    [[nodiscard]] static std::optional<Connection> open(std::uint16_t port, std::int64_t deadline_ns) noexcept;
    Connection(Connection&& other) noexcept;
    Connection& operator=(Connection&& other) noexcept;
    ~Connection();

    /// Sends as much as the peer takes without waiting. @return number of bytes sent; -1: the connection is lost
    [[nodiscard]] long send(std::string_view bytes) noexcept;
    /// Waits for bytes and appends them, at most `most`. @return number of bytes, 0: none until the deadline; -1: the
    /// connection is lost. May throw bad_alloc.
    [[nodiscard]] long receive(std::string& into, std::size_t most, std::int64_t deadline_ns);

  private:
    explicit Connection(int socket) noexcept
        : m_socket(socket)
    {
    }
    int m_socket;
};

} // namespace palpate::haply

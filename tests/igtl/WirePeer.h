// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace palpate::test {

/// Message as received, decoded without the code under test.
struct WireText
{
    std::string type;
    std::string name;
    std::vector<std::uint8_t> content;
    std::uint64_t timestamp = 0;
    bool isChecksumRight = false;

    /// Big-endian single-precision number at a byte of the content; 0 beyond its end.
    [[nodiscard]] double f32(std::size_t at) const;
};

/// One end of a TCP connection on the loopback, as a peer's server or client. Writes bytes as they are given.
class WirePeer
{
  public:
    WirePeer() = default;
    ~WirePeer();
    WirePeer(const WirePeer&) = delete;
    WirePeer& operator=(const WirePeer&) = delete;

    /// Listens, at any free port or again at `port`. @return the port
    std::uint16_t listen(std::uint16_t port = 0);
    /// Waits for a client. @return false if none comes
    bool accept();
    bool connect(std::uint16_t port);
    /// Closes the connection; `closeAll` also stops to listen.
    void close();
    void closeAll();
    [[nodiscard]] bool isOpen() const { return m_peer >= 0; }

    /// Writes all bytes, in pieces of at most `chunk`.
    bool write(const std::vector<std::uint8_t>& bytes, std::size_t chunk = 65536);
    /// Waits for the next message, of this type if given. @return an empty type at the end of the connection or after
    /// `timeout_ms`
    WireText read(const std::string& type = {}, int timeout_ms = 10000);
    /// True when the other side has closed the connection; discards incoming bytes. Waits up to `timeout_ms`.
    bool isClosedByOther(int timeout_ms);

  private:
    bool fill(int timeout_ms);
    int m_listener = -1;
    int m_peer = -1;
    std::vector<std::uint8_t> m_bytes;
};

} // namespace palpate::test

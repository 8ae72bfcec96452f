// SPDX-License-Identifier: BSD-3-Clause
#include "WirePeer.h"

#include "WireBytes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>
#include <utility>

namespace palpate::test {

namespace {

constexpr std::size_t kHead_bytes = 58;
constexpr int kWait_ms = 10000;

std::uint64_t bigEndian(const std::vector<std::uint8_t>& bytes, std::size_t at, std::size_t size)
{
    std::uint64_t value = 0;
    for (std::size_t i = at; i < at + size; ++i) {
        value = (value << 8) | bytes[i];
    }
    return value;
}

std::string cText(const std::vector<std::uint8_t>& bytes, std::size_t at, std::size_t size)
{
    const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(at);
    return {begin, std::find(begin, begin + static_cast<std::ptrdiff_t>(size), std::uint8_t{0})};
}

sockaddr_in loopback(std::uint16_t port)
{
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    return address;
}

bool isReady(int descriptor, int timeout_ms)
{
    pollfd waiting{descriptor, POLLIN, 0};
    return ::poll(&waiting, 1, timeout_ms) == 1;
}

} // namespace

double WireText::f32(std::size_t at) const
{
    return at + 4 > content.size()
               ? 0.0
               : static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bigEndian(content, at, 4))));
}

WirePeer::~WirePeer()
{
    closeAll();
}

std::uint16_t WirePeer::listen(std::uint16_t port)
{
    m_listener = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const int on = 1;
    ::setsockopt(m_listener, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    sockaddr_in address = loopback(port);
    socklen_t size = sizeof address;
    if (::bind(m_listener, reinterpret_cast<sockaddr*>(&address), size) != 0 || ::listen(m_listener, 4) != 0 ||
        ::getsockname(m_listener, reinterpret_cast<sockaddr*>(&address), &size) != 0) {
        return 0;
    }
    return ntohs(address.sin_port);
}

bool WirePeer::accept()
{
    close();
    if (isReady(m_listener, kWait_ms)) {
        m_peer = ::accept(m_listener, nullptr, nullptr);
    }
    const int on = 1;
    ::setsockopt(m_peer, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    return m_peer >= 0;
}

bool WirePeer::connect(std::uint16_t port)
{
    close();
    m_peer = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const sockaddr_in address = loopback(port);
    const int on = 1;
    ::setsockopt(m_peer, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    return ::connect(m_peer, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
}

void WirePeer::close()
{
    if (m_peer >= 0) {
        ::close(std::exchange(m_peer, -1));
    }
    m_bytes.clear();
}

void WirePeer::closeAll()
{
    close();
    if (m_listener >= 0) {
        ::close(std::exchange(m_listener, -1));
    }
}

bool WirePeer::write(const std::vector<std::uint8_t>& bytes, std::size_t chunk)
{
    for (std::size_t at = 0; at < bytes.size();) {
        const ssize_t sent = ::send(m_peer, bytes.data() + at, std::min(chunk, bytes.size() - at), MSG_NOSIGNAL);
        if (sent <= 0) {
            return false;
        }
        at += static_cast<std::size_t>(sent);
    }
    return true;
}

bool WirePeer::fill(int timeout_ms)
{
    std::array<std::uint8_t, 65536> buffer;
    if (!isReady(m_peer, timeout_ms)) {
        return false;
    }
    const ssize_t received = ::recv(m_peer, buffer.data(), buffer.size(), 0);
    if (received <= 0) {
        return false;
    }
    m_bytes.insert(m_bytes.end(), buffer.begin(), buffer.begin() + received);
    return true;
}

WireText WirePeer::read(const std::string& type, int timeout_ms)
{
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::milliseconds(timeout_ms);
    for (;;) {
        const std::size_t body = m_bytes.size() < kHead_bytes ? 0 : bigEndian(m_bytes, 42, 8);
        if (m_bytes.size() < kHead_bytes || m_bytes.size() < kHead_bytes + body) {
            const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
            if (left <= 0 || !fill(static_cast<int>(left))) {
                return {};
            }
            continue;
        }
        WireText message{cText(m_bytes, 2, 12), cText(m_bytes, 14, 20), {}, bigEndian(m_bytes, 34, 8), false};
        const auto begin = m_bytes.begin() + kHead_bytes;
        message.content.assign(begin, begin + static_cast<std::ptrdiff_t>(body));
        message.isChecksumRight = slowCrc64(message.content) == bigEndian(m_bytes, 50, 8);
        m_bytes.erase(m_bytes.begin(), begin + static_cast<std::ptrdiff_t>(body));
        if (type.empty() || message.type == type) {
            return message;
        }
    }
}

bool WirePeer::isClosedByOther(int timeout_ms)
{
    std::array<std::uint8_t, 65536> buffer;
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::milliseconds(timeout_ms);
    while (Clock::now() < end) {
        if (isReady(m_peer, 20) && ::recv(m_peer, buffer.data(), buffer.size(), 0) <= 0) {
            return true;
        }
    }
    return false;
}

} // namespace palpate::test

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/igtl/Socket.h"

#include <palpate/core/Text.h>

#include <arpa/inet.h>
#include <array>
#include <cerrno>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>
#include <vector>

namespace palpate::igtl {

using core::Result;
using core::Status;
using core::StatusCode;

namespace {

/// Address of a socket, of either version.
struct SocketAddress
{
    sockaddr_storage storage{};
    socklen_t size = 0;

    [[nodiscard]] const sockaddr* get() const noexcept { return reinterpret_cast<const sockaddr*>(&storage); }
    [[nodiscard]] sockaddr* get() noexcept { return reinterpret_cast<sockaddr*>(&storage); }
};

/// @return an address of size 0 for a text that is no numeric address
SocketAddress numericAddress(const std::string& text, std::uint16_t port)
{
    SocketAddress address;
    auto* four = reinterpret_cast<sockaddr_in*>(&address.storage);
    if (::inet_pton(AF_INET, text.c_str(), &four->sin_addr) == 1) {
        four->sin_family = AF_INET;
        four->sin_port = htons(port);
        address.size = sizeof(sockaddr_in);
        return address;
    }
    auto* six = reinterpret_cast<sockaddr_in6*>(&address.storage);
    if (::inet_pton(AF_INET6, text.c_str(), &six->sin6_addr) == 1) {
        six->sin6_family = AF_INET6;
        six->sin6_port = htons(port);
        address.size = sizeof(sockaddr_in6);
    }
    return address;
}

Socket makeSocket(const SocketAddress& address)
{
    return Socket(::socket(address.storage.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
}

void setOption(const Socket& socket, int level, int option)
{
    const int on = 1;
    (void)::setsockopt(socket.descriptor(), level, option, &on, sizeof on); // an improvement only
}

/// @return 0, or the reason as an errno value
int connectWithin(const Socket& socket, const SocketAddress& address, int timeout_ms)
{
    if (::connect(socket.descriptor(), address.get(), address.size) == 0) {
        return 0;
    }
    if (errno != EINPROGRESS) {
        return errno;
    }
    pollfd waiting{socket.descriptor(), POLLOUT, 0};
    const int ready = ::poll(&waiting, 1, timeout_ms);
    if (ready <= 0) {
        return ready == 0 ? ETIMEDOUT : errno;
    }
    int error = 0;
    socklen_t size = sizeof error;
    return ::getsockopt(socket.descriptor(), SOL_SOCKET, SO_ERROR, &error, &size) == 0 ? error : errno;
}

} // namespace

Socket::~Socket()
{
    if (m_descriptor >= 0) {
        ::close(m_descriptor);
    }
}

std::uint16_t Socket::localPort() const noexcept
{
    SocketAddress address;
    address.size = sizeof address.storage;
    if (::getsockname(m_descriptor, address.get(), &address.size) != 0) {
        return 0;
    }
    return ntohs(address.storage.ss_family == AF_INET6
                     ? reinterpret_cast<const sockaddr_in6*>(&address.storage)->sin6_port
                     : reinterpret_cast<const sockaddr_in*>(&address.storage)->sin_port);
}

std::string Socket::peerAddress() const
{
    SocketAddress address;
    address.size = sizeof address.storage;
    std::array<char, INET6_ADDRSTRLEN> text{};
    if (::getpeername(m_descriptor, address.get(), &address.size) != 0) {
        return {};
    }
    const void* number = address.storage.ss_family == AF_INET6
                             ? static_cast<const void*>(&reinterpret_cast<sockaddr_in6*>(&address.storage)->sin6_addr)
                             : static_cast<const void*>(&reinterpret_cast<sockaddr_in*>(&address.storage)->sin_addr);
    return ::inet_ntop(address.storage.ss_family, number, text.data(), text.size()) != nullptr ? text.data() : "";
}

Socket::Transfer Socket::receive(std::uint8_t* to, std::size_t size) noexcept
{
    const ssize_t received = ::recv(m_descriptor, to, size, 0);
    if (received > 0) {
        return {static_cast<std::size_t>(received), false};
    }
    const bool isNothing = received < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR);
    return {0, !isNothing};
}

Socket::Transfer Socket::send(ByteView bytes) noexcept
{
    const ssize_t sent = ::send(m_descriptor, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent >= 0) {
        return {static_cast<std::size_t>(sent), false};
    }
    return {0, errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR};
}

Socket Socket::accept() noexcept
{
    Socket accepted(::accept4(m_descriptor, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (accepted.isOpen()) {
        setOption(accepted, IPPROTO_TCP, TCP_NODELAY);
    }
    return accepted;
}

Result<Socket> connectTo(const std::string& host, std::uint16_t port, int timeout_ms)
{
    const std::vector<std::string> addresses =
        host == "localhost" ? std::vector<std::string>{"127.0.0.1", "::1"} : std::vector<std::string>{host};
    int error = 0;
    for (const std::string& text : addresses) {
        const SocketAddress address = numericAddress(text, port);
        if (address.size == 0) {
            return Status(
                StatusCode::BadCommandLine,
                PALPATE_TEXT("found the host %1, expected localhost or a numeric address such as 192.168.0.10"),
                core::inQuotes(host));
        }
        Socket socket = makeSocket(address);
        const int failed = socket.isOpen() ? connectWithin(socket, address, timeout_ms) : errno;
        if (failed == 0) {
            setOption(socket, IPPROTO_TCP, TCP_NODELAY);
            return socket;
        }
        if (error == 0) {
            error = failed;
        }
    }
    return Status(StatusCode::NotFound, PALPATE_TEXT("nothing answers at %1, port %2: %3"), host, std::to_string(port),
                  core::systemError(error));
}

Result<Socket> listenAt(const std::string& text, std::uint16_t port)
{
    constexpr int kWaiting = 4;
    const SocketAddress address = numericAddress(text, port);
    if (address.size == 0) {
        return Status(StatusCode::BadCommandLine,
                      PALPATE_TEXT("found the address %1, expected a numeric address such as 127.0.0.1"),
                      core::inQuotes(text));
    }
    Socket socket = makeSocket(address);
    int error = socket.isOpen() ? 0 : errno;
    if (error == 0) {
        setOption(socket, SOL_SOCKET, SO_REUSEADDR); // a port is free again at once after the program has ended
        if (::bind(socket.descriptor(), address.get(), address.size) != 0 ||
            ::listen(socket.descriptor(), kWaiting) != 0) {
            error = errno;
        }
    }
    if (error == EADDRINUSE) {
        return Status(
            StatusCode::Unreadable,
            PALPATE_TEXT("Port %1 is used by another program, perhaps a second Palpate. Choose another port."),
            std::to_string(port));
    }
    if (error != 0) {
        return Status(StatusCode::Unreadable, PALPATE_TEXT("%1, port %2: %3"), text, std::to_string(port),
                      core::systemError(error));
    }
    return socket;
}

} // namespace palpate::igtl

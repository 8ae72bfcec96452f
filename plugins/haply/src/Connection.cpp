// SPDX-License-Identifier: BSD-3-Clause
#include "Connection.h"

#include <palpate/core/Clock.h>

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>
#include <utility>

namespace palpate::haply {

namespace {

/// Waits for an event of the socket. @return false: none until the deadline
bool waitFor(int socket, short events, std::int64_t deadline_ns) noexcept
{
    for (;;) {
        const std::int64_t left_ns = std::max<std::int64_t>(deadline_ns - core::monotonicNow_ns(), 0);
        const timespec left{left_ns / 1'000'000'000, left_ns % 1'000'000'000};
        pollfd one{socket, events, 0};
        const int count = ppoll(&one, 1, &left, nullptr);
        if (count > 0) {
            return true; // also for an error, which the next call on the socket returns
        }
        if (count == 0 || errno != EINTR) {
            return false;
        }
    }
}

} // namespace

std::optional<Connection> Connection::open(std::uint16_t port, std::int64_t deadline_ns) noexcept
{
    const int fd = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (fd < 0) {
        return std::nullopt;
    }
    Connection made(fd);
    const int isOn = 1; // each message is sent at once
    setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &isOn, sizeof isOn);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
        int error = errno;
        socklen_t size = sizeof error;
        if (error != EINPROGRESS || !waitFor(fd, POLLOUT, deadline_ns) ||
            getsockopt(fd, SOL_SOCKET, SO_ERROR, &error, &size) != 0 || error != 0) {
            return std::nullopt;
        }
    }
    return made;
}

Connection::Connection(Connection&& other) noexcept
    : m_socket(std::exchange(other.m_socket, -1))
{
}

Connection& Connection::operator=(Connection&& other) noexcept
{
    std::swap(m_socket, other.m_socket);
    return *this;
}

Connection::~Connection()
{
    if (m_socket >= 0) {
        close(m_socket);
    }
}

long Connection::send(std::string_view bytes) noexcept
{
    const ssize_t count = ::send(m_socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count >= 0) {
        return count;
    }
    return errno == EAGAIN || errno == EINTR ? 0 : -1;
}

long Connection::receive(std::string& into, std::size_t most, std::int64_t deadline_ns)
{
    if (!waitFor(m_socket, POLLIN, deadline_ns)) {
        return 0;
    }
    const std::size_t before = into.size();
    into.resize(before + most);
    const ssize_t count = recv(m_socket, into.data() + before, most, 0);
    const int error = errno;
    into.resize(before + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    if (count > 0) {
        return count;
    }
    return count < 0 && (error == EAGAIN || error == EINTR) ? 0 : -1;
}

} // namespace palpate::haply

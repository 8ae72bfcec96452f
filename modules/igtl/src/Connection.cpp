// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/igtl/Connection.h"

#include <array>

namespace palpate::igtl {

std::size_t Connection::fill()
{
    std::array<std::uint8_t, 65536> buffer;
    const Socket::Transfer arrived = m_socket.receive(buffer.data(), buffer.size());
    m_isClosed = m_isClosed || arrived.isClosed;
    m_reader.add({buffer.data(), arrived.bytes});
    return arrived.bytes;
}

/// @return true if the reader may have another message
bool Connection::note(MessageReader::Step step) noexcept
{
    switch (step) {
    case MessageReader::Step::NeedsMore:
        return false;
    case MessageReader::Step::Complete:
        ++m_received;
        return true;
    case MessageReader::Step::Skipped:
        return true;
    case MessageReader::Step::Refused:
        ++m_refused;
        return true;
    case MessageReader::Step::Lost:
        break;
    }
    ++m_refused;
    m_isClosed = true;
    return false;
}

bool Connection::send(ByteView message)
{
    if (m_isClosed || queued_bytes() + message.size() > kMaxQueue_bytes) {
        return false;
    }
    if (m_sent > 0) {
        m_queue.erase(m_queue.begin(), m_queue.begin() + static_cast<std::ptrdiff_t>(m_sent));
        m_sent = 0;
    }
    m_queue.insert(m_queue.end(), message.begin(), message.end());
    (void)flush(); // a closed connection is reported by the next receive
    return true;
}

bool Connection::flush()
{
    while (hasQueue() && !m_isClosed) {
        const Socket::Transfer sent = m_socket.send(ByteView(m_queue).subspan(m_sent));
        m_sent += sent.bytes;
        m_isClosed = sent.isClosed;
        if (sent.bytes == 0) {
            break;
        }
    }
    return !m_isClosed;
}

} // namespace palpate::igtl

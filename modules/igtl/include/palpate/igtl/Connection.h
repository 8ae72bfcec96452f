// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/igtl/Socket.h"
#include "palpate/igtl/Wire.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace palpate::igtl {

/// Connection to one peer: received messages, and a bounded queue of messages to send. Nothing here waits; a peer that
/// does not read loses messages instead of delaying the caller.
/// @par Thread One thread.
class Connection
{
  public:
    /// Largest number of queued bytes, beyond which messages are dropped: two of the longest texts.
    static constexpr std::size_t kMaxQueue_bytes = std::size_t{1} << 18;

    /// @param takesSurfaces  also receives POLYDATA
    Connection(Socket socket, bool takesSurfaces)
        : m_socket(std::move(socket))
        , m_reader(takesSurfaces)
    {
    }

    [[nodiscard]] int descriptor() const noexcept { return m_socket.descriptor(); }
    [[nodiscard]] const Socket& socket() const noexcept { return m_socket; }

    /// Receives the bytes that have arrived, at most 1 MB, and calls `take(message)` for each complete message.
    /// @return false when the peer has closed the connection or sends something else than OpenIGTLink; see `problem`
    template<class Take>
    bool receive(Take take)
    {
        constexpr int kMaxReads = 16;
        for (int i = 0; i < kMaxReads; ++i) {
            const std::size_t bytes = fill();
            for (bool isMore = bytes > 0; isMore;) {
                const MessageReader::Step step = m_reader.next();
                isMore = note(step);
                if (step == MessageReader::Step::Complete) {
                    take(m_reader.message());
                }
            }
            if (bytes == 0 || m_isClosed) {
                break;
            }
        }
        return !m_isClosed;
    }

    /// Queues a message and sends as much as the system takes.
    /// @return false if the queue is full; the message is dropped then
    bool send(ByteView message);
    /// Sends queued bytes. @return false when the connection is closed
    bool flush();
    [[nodiscard]] bool hasQueue() const noexcept { return m_sent < m_queue.size(); }
    [[nodiscard]] std::size_t queued_bytes() const noexcept { return m_queue.size() - m_sent; }

    [[nodiscard]] std::uint64_t received() const noexcept { return m_received; } ///< complete messages
    [[nodiscard]] std::uint64_t refused() const noexcept { return m_refused; }   ///< with an error
    /// Reason of the latest refused message, or of the end of the connection by an invalid stream; empty: none.
    [[nodiscard]] const std::string& problem() const noexcept { return m_reader.problem(); }

  private:
    std::size_t fill();
    bool note(MessageReader::Step step) noexcept;

    Socket m_socket;
    MessageReader m_reader;
    Bytes m_queue;
    std::size_t m_sent = 0; ///< bytes of m_queue that are sent
    bool m_isClosed = false;
    std::uint64_t m_received = 0;
    std::uint64_t m_refused = 0;
};

} // namespace palpate::igtl

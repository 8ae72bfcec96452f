// SPDX-License-Identifier: BSD-3-Clause
#include "WebSocket.h"

#include <palpate/core/Clock.h>

#include <QByteArray>
#include <QCryptographicHash>

#include <algorithm>
#include <array>
#include <new>
#include <random>
#include <utility>

namespace palpate::haply {

using core::Status;
using core::StatusCode;

namespace {

constexpr std::size_t kChunk = 16 * 1024;
constexpr std::size_t kLargestHeader = 8 * 1024;
constexpr std::size_t kLargestPage = 64 * 1024;

// RFC 6455, section 5.2.
constexpr std::uint8_t kFinal = 0x80;
constexpr std::uint8_t kReserved = 0x70;
constexpr std::uint8_t kMasked = 0x80;
constexpr std::uint8_t kContinuation = 0x0;
constexpr std::uint8_t kText = 0x1;
constexpr std::uint8_t kBinary = 0x2;
constexpr std::uint8_t kClose = 0x8;
constexpr std::uint8_t kPing = 0x9;
constexpr std::uint8_t kPong = 0xA;
constexpr std::size_t kLargestControl = 125;

std::uint8_t byteAt(std::string_view bytes, std::size_t i)
{
    return static_cast<std::uint8_t>(bytes[i]);
}

/// Receives until the end of a header. @return the header without the empty line, removed from `in`; nothing on failure
std::optional<std::string> receiveHeader(Connection& connection, std::string& in, std::int64_t deadline_ns)
{
    for (;;) {
        const std::size_t end = in.find("\r\n\r\n");
        if (end != std::string::npos) {
            std::string header = in.substr(0, end + 2);
            in.erase(0, end + 4);
            return header;
        }
        if (in.size() > kLargestHeader || connection.receive(in, kChunk, deadline_ns) <= 0) {
            return std::nullopt;
        }
    }
}

/// Value of a header field, whatever the case of its name; empty: absent.
QByteArray headerField(const std::string& header, const char* name)
{
    for (const QByteArray& line : QByteArray::fromStdString(header).split('\n')) {
        const qsizetype colon = line.indexOf(':');
        if (colon > 0 && line.first(colon).trimmed().compare(name, Qt::CaseInsensitive) == 0) {
            return line.sliced(colon + 1).trimmed();
        }
    }
    return {};
}

std::string requestFor(std::uint16_t port, std::string_view path)
{
    return "GET " + std::string(path) + " HTTP/1.1\r\nHost: localhost:" + std::to_string(port) + "\r\n";
}

} // namespace

core::Result<WebSocket> WebSocket::open(std::uint16_t port, std::int64_t deadline_ns)
{
    std::optional<Connection> connection = Connection::open(port, deadline_ns);
    if (!connection) {
        return Status(StatusCode::NotFound,
                      PALPATE_TEXT("haply: the Inverse Service does not answer at port %1: install it, or start it "
                                   "with Haply Hub or \"sudo systemctl start haply-inverse-service\""),
                      static_cast<int>(port));
    }
    std::random_device random;
    std::array<std::uint32_t, 4> nonce{};
    for (std::uint32_t& word : nonce) {
        word = random();
    }
    const QByteArray key = QByteArray(reinterpret_cast<const char*>(nonce.data()), sizeof nonce).toBase64();
    WebSocket made(*std::move(connection));
    made.m_mask = random();
    made.m_out = requestFor(port, "/") + "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n" +
                 "Sec-WebSocket-Key: " + key.toStdString() + "\r\n\r\n";
    std::optional<std::string> header;
    if (made.flush()) {
        header = receiveHeader(made.m_connection, made.m_in, deadline_ns);
    }
    if (!header) {
        return Status(StatusCode::Mismatch,
                      PALPATE_TEXT("haply: found a program at port %1 that does not answer like the Inverse Service; "
                                   "set \"port\" in ~/.config/Palpate/haply.json to the service's websocket port"),
                      static_cast<int>(port));
    }
    const QByteArray accept =
        QCryptographicHash::hash(key + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11", QCryptographicHash::Sha1).toBase64();
    if (!header->starts_with("HTTP/1.1 101") || headerField(*header, "Sec-WebSocket-Accept") != accept) {
        return Status(StatusCode::Mismatch,
                      PALPATE_TEXT("haply: found \"%1\" at port %2, expected a WebSocket; set \"port\" in "
                                   "~/.config/Palpate/haply.json to the service's websocket port"),
                      header->substr(0, std::min<std::size_t>(header->find('\r'), 60)), static_cast<int>(port));
    }
    return made;
}

bool WebSocket::flush() noexcept
{
    if (!m_out.empty()) {
        const long count = m_connection.send(m_out);
        if (count > 0) {
            m_out.erase(0, static_cast<std::size_t>(count));
        }
    }
    return m_out.empty();
}

bool WebSocket::sendFrame(std::uint8_t opcode, std::string_view payload)
{
    if (!flush()) {
        return false;
    }
    m_out.push_back(static_cast<char>(kFinal | opcode));
    if (payload.size() <= kLargestControl) {
        m_out.push_back(static_cast<char>(kMasked | payload.size()));
    } else {
        m_out.push_back(static_cast<char>(kMasked | 126)); // no message of the plugin has 64 KiB
        m_out.push_back(static_cast<char>(payload.size() >> 8));
        m_out.push_back(static_cast<char>(payload.size() & 0xFF));
    }
    // Masks protect proxies from scripts of web pages (RFC 6455, section 10.3). There are neither: a cheap sequence is
    // enough.
    m_mask = m_mask * 1664525U + 1013904223U;
    std::array<char, 4> mask{};
    for (std::size_t i = 0; i < mask.size(); ++i) {
        mask[i] = static_cast<char>(m_mask >> (8 * i));
        m_out.push_back(mask[i]);
    }
    for (std::size_t i = 0; i < payload.size(); ++i) {
        m_out.push_back(static_cast<char>(payload[i] ^ mask[i % 4]));
    }
    (void)flush(); // the rest follows with the next frame
    return true;
}

bool WebSocket::send(std::string_view text)
{
    return text.size() <= 0xFFFF && sendFrame(kText, text);
}

void WebSocket::sayGoodbye() noexcept
{
    try {
        (void)sendFrame(kClose, std::string_view("\x03\xe8", 2)); // 1000: normal closure
    } catch (const std::bad_alloc&) {                             // the end of the connection has the same effect
    }
}

std::optional<WebSocket::Frame> WebSocket::takeFrame(bool& isBroken) noexcept
{
    const std::string_view in = std::string_view(m_in).substr(m_taken);
    if (in.size() < 2) {
        return std::nullopt;
    }
    Frame frame;
    frame.opcode = byteAt(in, 0) & 0xF;
    frame.isFinal = (byteAt(in, 0) & kFinal) != 0;
    std::uint64_t length = byteAt(in, 1);
    isBroken = (byteAt(in, 0) & kReserved) != 0 || (length & kMasked) != 0; // only clients mask
    std::size_t header = 2;
    if (length >= 126) {
        const std::size_t bytes = length == 126 ? 2 : 8;
        if (in.size() < header + bytes) {
            return std::nullopt;
        }
        length = 0;
        for (std::size_t i = 0; i < bytes; ++i) {
            length = length << 8 | byteAt(in, header + i);
        }
        header += bytes;
    }
    // Compared before a byte of the payload is waited for or stored.
    isBroken = isBroken || length > kLargestMessage || m_message.size() + length > kLargestMessage;
    if (isBroken || in.size() < header + length) {
        return std::nullopt;
    }
    frame.payload = in.substr(header, length);
    m_taken += header + length;
    return frame;
}

WebSocket::Received WebSocket::takeMessage(std::string_view& text)
{
    std::optional<std::string_view> ping;
    Received received = Received::Nothing;
    bool isBroken = false;
    while (received == Received::Nothing) {
        const std::optional<Frame> frame = takeFrame(isBroken);
        if (!frame) {
            received = isBroken ? Received::Closed : received;
            break;
        }
        const auto end = [&](std::uint8_t opcode, std::string_view message) {
            text = message;
            received = opcode == kText ? Received::Text : Received::Other;
        };
        const bool isControl = frame->opcode >= kClose;
        const bool isContinued = frame->opcode == kContinuation;
        if (isControl) {
            if (!frame->isFinal || frame->payload.size() > kLargestControl || frame->opcode == kClose) {
                received = Received::Closed;
            } else if (frame->opcode == kPing) {
                ping = frame->payload;
            }
        } else if (isContinued != (m_opcode != 0) || frame->opcode > kBinary) {
            received = Received::Closed; // a continuation of nothing, or a message within another, or unknown
        } else if (!isContinued && frame->isFinal) {
            end(frame->opcode, frame->payload);
        } else {
            m_opcode = isContinued ? m_opcode : frame->opcode;
            m_message += frame->payload;
            if (frame->isFinal) {
                end(std::exchange(m_opcode, std::uint8_t{0}), m_message);
            }
        }
    }
    if (ping) { // of several, the last one is answered (RFC 6455, section 5.5.3)
        (void)sendFrame(kPong, *ping);
    }
    return received;
}

WebSocket::Received WebSocket::receive(std::string_view& text, std::int64_t deadline_ns)
{
    if (m_opcode == 0) {
        m_message.clear();
    }
    for (;;) {
        const Received received = takeMessage(text);
        if (received != Received::Nothing) {
            return received;
        }
        m_in.erase(0, std::exchange(m_taken, 0));
        const long count = m_connection.receive(m_in, kChunk, deadline_ns);
        if (count <= 0) {
            return count < 0 ? Received::Closed : Received::Nothing;
        }
        if (core::monotonicNow_ns() > deadline_ns) { // frames without a message may go on for ever
            return takeMessage(text);
        }
    }
}

std::optional<std::string> httpGet(std::uint16_t port, std::string_view path, std::int64_t deadline_ns)
{
    std::optional<Connection> connection = Connection::open(port, deadline_ns);
    const std::string request = requestFor(port, path) + "Connection: close\r\n\r\n";
    if (!connection || connection->send(request) != static_cast<long>(request.size())) {
        return std::nullopt;
    }
    std::string in;
    const std::optional<std::string> header = receiveHeader(*connection, in, deadline_ns);
    if (!header || header->find(" 200") == std::string::npos || header->find(" 200") > header->find('\r')) {
        return std::nullopt;
    }
    bool hasLength = false;
    const qulonglong length = headerField(*header, "Content-Length").toULongLong(&hasLength);
    // Without a length the page ends with the connection.
    while (in.size() <= kLargestPage && (!hasLength || in.size() < length)) {
        const long count = connection->receive(in, kChunk, deadline_ns);
        if (count == 0) {
            return std::nullopt;
        }
        if (count < 0) {
            break;
        }
    }
    return in.size() > kLargestPage || (hasLength && in.size() < length) ? std::nullopt : std::optional(std::move(in));
}

} // namespace palpate::haply

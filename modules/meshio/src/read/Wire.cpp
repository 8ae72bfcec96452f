// SPDX-License-Identifier: BSD-3-Clause
#include "read/Wire.h"

#include "text/Fault.h"

#include <cerrno>
#include <sys/stat.h>
#include <unistd.h>

namespace palpate::meshio::internal {

namespace {

using core::Status;
using core::StatusCode;

constexpr std::size_t kMostHead = std::size_t{1} << 28;
constexpr std::size_t kMostMessage = 4000;

/// Converts an error of the child process to one line with the file name.
Status statusOf(std::uint8_t code, std::string message, const std::string& file)
{
    message.resize(std::min(message.size(), kMostMessage));
    std::replace_if(
        message.begin(), message.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
    if (!message.starts_with(file + ": ")) {
        message.insert(0, file + ": ");
    }
    return {code <= static_cast<std::uint8_t>(StatusCode::Internal) ? static_cast<StatusCode>(code)
                                                                    : StatusCode::Internal,
            std::move(message)};
}

} // namespace

void WireHead::put(const Status& status)
{
    put(static_cast<std::uint8_t>(status.code()));
    if (!status.isOk()) {
        put(status.message());
    }
}

bool WireHead::write(int descriptor) const
{
    const std::uint64_t size = m_bytes.size();
    return writeAll(descriptor, &size, sizeof(size)) && writeAll(descriptor, m_bytes.data(), size);
}

std::string WireHeadReader::text()
{
    const auto size = take<std::uint64_t>();
    if (!m_isGood || size > m_rest.size()) {
        m_isGood = false;
        return {};
    }
    std::string out(m_rest.substr(0, size));
    m_rest.remove_prefix(size);
    return out;
}

bool writeAll(int descriptor, const void* data, std::size_t size)
{
    const auto* from = static_cast<const char*>(data);
    while (size > 0) {
        const ssize_t done = ::write(descriptor, from, std::min(size, std::size_t{1} << 30));
        if (done < 0 && errno != EINTR) {
            return false;
        }
        from += std::max<ssize_t>(done, 0);
        size -= static_cast<std::size_t>(std::max<ssize_t>(done, 0));
    }
    return true;
}

bool readAll(int descriptor, void* data, std::size_t size, std::uint64_t at)
{
    auto* to = static_cast<char*>(data);
    while (size > 0) {
        const ssize_t done = ::pread(descriptor, to, size, static_cast<off_t>(at));
        if (done == 0 || (done < 0 && errno != EINTR)) {
            return false;
        }
        to += std::max<ssize_t>(done, 0);
        at += static_cast<std::uint64_t>(std::max<ssize_t>(done, 0));
        size -= static_cast<std::size_t>(std::max<ssize_t>(done, 0));
    }
    return true;
}

WireOutcome readHead(int descriptor, const std::string& file, std::string_view expected)
{
    WireOutcome outcome;
    const auto nonsense = [&](const char* what) {
        outcome.status =
            fault(StatusCode::Internal, file, "", std::string("the import process handed back ") + what, expected);
        return outcome;
    };
    struct stat info = {};
    std::uint64_t headSize = 0;
    if (::fstat(descriptor, &info) != 0 || !readAll(descriptor, &headSize, sizeof(headSize), 0)) {
        return nonsense("nothing");
    }
    outcome.size = static_cast<std::uint64_t>(info.st_size);
    if (headSize > std::min<std::uint64_t>(outcome.size - sizeof(headSize), kMostHead)) {
        return nonsense("a head without an end");
    }
    outcome.head.resize(headSize);
    if (!readAll(descriptor, outcome.head.data(), headSize, sizeof(headSize))) {
        return nonsense("half a head");
    }
    outcome.begin = sizeof(headSize) + headSize;
    WireHeadReader head(outcome.head);
    if (const auto code = head.take<std::uint8_t>(); code != 0) {
        std::string message = head.text();
        if (!head.isAtEnd()) {
            return nonsense("an error without its text");
        }
        outcome.status = statusOf(code, std::move(message), file);
        return outcome;
    }
    outcome.head.erase(0, std::min<std::size_t>(outcome.head.size(), 1));
    return outcome;
}

} // namespace palpate::meshio::internal

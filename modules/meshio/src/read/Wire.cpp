// SPDX-License-Identifier: BSD-3-Clause
#include "read/Wire.h"

#include "text/Fault.h"

#include <algorithm>
#include <cerrno>
#include <string>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace palpate::meshio::internal {

namespace {

using core::Status;
using core::StatusCode;

constexpr std::size_t kMostHead = std::size_t{1} << 28;
constexpr std::size_t kMostMessage = 4000; ///< English text of a message [bytes]
constexpr std::size_t kMostArguments = 9;  ///< %1 to %9
constexpr int kDeepestMessage = 8;         ///< messages within messages

/// Converts an error of the child process to one line with the file name.
Status statusOf(std::uint8_t code, core::Message message, const std::string& file)
{
    const Status status(code <= static_cast<std::uint8_t>(StatusCode::Internal) ? static_cast<StatusCode>(code)
                                                                                : StatusCode::Internal,
                        std::move(message));
    return status.message().starts_with(file + ": ") ? status : status.at(file);
}

std::string onOneLine(std::string text)
{
    std::replace_if(
        text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20; }, ' ');
    return text;
}

} // namespace

void WireHead::put(const Status& status)
{
    put(static_cast<std::uint8_t>(status.code()));
    if (!status.isOk()) {
        put(status.text());
    }
}

void WireHead::put(const core::Message& message)
{
    put(message.text());
    put(static_cast<std::uint8_t>(message.arguments().size()));
    for (const core::MessageArgument& argument : message.arguments()) {
        put(static_cast<std::uint8_t>(argument.kind));
        if (argument.message != nullptr) {
            put(*argument.message);
        } else {
            put(argument.english);
        }
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

Status WireHeadReader::status(const std::string& file)
{
    const auto code = take<std::uint8_t>();
    if (code == 0) {
        return m_isGood ? Status() : wireFault(file, {PALPATE_TEXT("its header is incomplete")});
    }
    core::Message error = message();
    if (!isAtEnd() || error.isEmpty()) {
        return wireFault(file, {PALPATE_TEXT("it has an error without a message")});
    }
    return statusOf(code, std::move(error), file);
}

core::Message WireHeadReader::message()
{
    return message(kDeepestMessage);
}

core::Message WireHeadReader::message(int depth)
{
    using Kind = core::MessageArgument::Kind;
    std::string pattern = onOneLine(text());
    std::vector<core::MessageArgument> arguments;
    const auto count = take<std::uint8_t>();
    m_isGood = m_isGood && depth > 0 && count <= kMostArguments && pattern.size() <= kMostMessage;
    for (std::size_t i = 0; i < count && m_isGood; ++i) {
        const auto kind = take<std::uint8_t>();
        if (kind == static_cast<std::uint8_t>(Kind::Message)) {
            arguments.emplace_back(message(depth - 1));
            continue;
        }
        core::MessageArgument& argument = arguments.emplace_back(onOneLine(text()));
        argument.kind = kind == static_cast<std::uint8_t>(Kind::Number) ? Kind::Number : Kind::Name;
        m_isGood = m_isGood && argument.english.size() <= kMostMessage;
    }
    if (!m_isGood) {
        return {};
    }
    core::Message message = core::Message::fromParts(std::move(pattern), std::move(arguments));
    m_isGood = message.english().size() <= kMostMessage; // bounds the text that a repeated place can make of it
    return m_isGood ? message : core::Message();
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

Status wireFault(const std::string& file, const core::Message& what)
{
    return fault(StatusCode::Internal, file, {},
                 {PALPATE_TEXT("the result of the import process is damaged: %1"), what},
                 {PALPATE_TEXT("a result that passed all checks")});
}

core::Result<WireFrame> readFrame(int descriptor, std::uint64_t at, const std::string& file)
{
    struct stat info = {};
    std::uint64_t headSize = 0;
    if (::fstat(descriptor, &info) != 0 || !readAll(descriptor, &headSize, sizeof(headSize), at)) {
        return wireFault(file, {PALPATE_TEXT("it is empty")});
    }
    WireFrame frame;
    frame.size = static_cast<std::uint64_t>(info.st_size);
    frame.begin = at + sizeof(headSize);
    if (frame.size < frame.begin || headSize > std::min<std::uint64_t>(frame.size - frame.begin, kMostHead)) {
        return wireFault(file, {PALPATE_TEXT("its header has no end")});
    }
    frame.head.resize(headSize);
    if (!readAll(descriptor, frame.head.data(), headSize, frame.begin)) {
        return wireFault(file, {PALPATE_TEXT("its header is incomplete")});
    }
    frame.begin += headSize;
    return frame;
}

} // namespace palpate::meshio::internal

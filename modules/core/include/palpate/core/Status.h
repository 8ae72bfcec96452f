// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Message.h"

#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace palpate::core {

/// Error category, one for each cause that requires a different reaction of the user.
enum class StatusCode : std::uint8_t
{
    Ok,
    BadCommandLine, ///< an argument is missing, unknown or out of range
    NotFound,       ///< the file, device or element does not exist
    Unreadable,     ///< the file exists but cannot be opened, read or written
    BadFormat,      ///< the content violates the format
    NonFinite,      ///< a number is NaN or infinite
    OutOfRange,     ///< an index, count or coordinate exceeds its bounds
    Empty,          ///< no usable content: no triangle of positive area, no row
    Mismatch,       ///< belongs to another object: another mesh, another version
    Unsupported,    ///< valid, but not supported by Palpate
    NoSpace,        ///< the disk is full, or the user's quota is exceeded
    Cancelled,      ///< the user asked to stop
    DeviceLost,     ///< the device no longer answers
    Internal,       ///< violated internal invariant
};

/// Result of an operation without a value: a code and a one-line message for the user that names the file, the
/// position, the value found and the value expected.
/// @par Thread Value type without shared state.
class [[nodiscard]] Status
{
  public:
    Status() = default;
    Status(StatusCode code, Message message)
        : m_code(code)
        , m_text(std::move(message))
        , m_message(m_text.english())
    {
    }
    /// Example: `return {StatusCode::BadFormat, PALPATE_TEXT("found %1 corners, expected 3"), count};`
    template<class... Arguments>
    Status(StatusCode code, MessageText<std::type_identity_t<Arguments>...> text, const Arguments&... arguments)
        : Status(code, Message(text, arguments...))
    {
    }

    [[nodiscard]] bool isOk() const noexcept { return m_code == StatusCode::Ok; }
    [[nodiscard]] StatusCode code() const noexcept { return m_code; }
    /// English message.
    [[nodiscard]] const std::string& message() const noexcept { return m_message; }
    /// Translatable message for the window.
    [[nodiscard]] const Message& text() const noexcept { return m_text; }
    /// Prefixes the message with a place: "liver.stl: the file is empty". Success is returned unchanged.
    [[nodiscard]] Status at(const MessageArgument& place) const
    {
        return isOk() ? Status() : Status(m_code, Message(PALPATE_TEXT("%1: %2"), place, m_text));
    }

  private:
    StatusCode m_code = StatusCode::Ok;
    Message m_text;
    std::string m_message; ///< English text of m_text
};

/// A value, or the Status of the error.
///
///     const Result<std::filesystem::path> file = writeNew(path, bytes); // AtomicFile.h
///     if (!file.isOk()) {
///         return file.status();
///     }
///     show(file.value());
template<class T>
class [[nodiscard]] Result
{
  public:
    Result(T value)
        : m_value(std::move(value))
    {
    }
    /// @pre `!status.isOk()`
    Result(Status status)
        : m_status(std::move(status))
    {
    }

    [[nodiscard]] bool isOk() const noexcept { return m_value.has_value(); }
    [[nodiscard]] const Status& status() const noexcept { return m_status; }
    /// @pre isOk()
    [[nodiscard]] T& value() & { return *m_value; }
    [[nodiscard]] const T& value() const& { return *m_value; }
    [[nodiscard]] T&& value() && { return std::move(*m_value); }

  private:
    std::optional<T> m_value;
    Status m_status;
};

} // namespace palpate::core

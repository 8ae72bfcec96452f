// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

/// Marks the English source text of a message. `resources/translations/update.sh` collects marked texts for the
/// translation catalogues, and `core::Message` accepts only marked texts. The argument may consist of adjacent string
/// literals, but not of expressions.
#define PALPATE_TEXT(text) (::palpate::core::internal::MarkedText{text})

namespace palpate::core {

// Without <concepts>, which Qt's moc cannot parse: device plugins include this header.

class Message;

namespace internal {

struct MarkedText
{
    const char* text;
};

/// Rejects at compile time a text whose placeholders are not exactly %1 to %N. Not constexpr: a call aborts the
/// constant evaluation.
void placesOfTextDifferFromArguments();

} // namespace internal

/// Message text with one placeholder for each argument, checked at compile time like a `std::format_string`.
template<class... Arguments>
class MessageText
{
  public:
    constexpr MessageText() = default; ///< empty text
    consteval MessageText(internal::MarkedText marked)
        : m_text(marked.text)
    {
        static_assert(sizeof...(Arguments) <= 9, "a message has the places %1 to %9");
        bool isUsed[10] = {};
        for (std::size_t i = 0; i + 1 < m_text.size(); ++i) {
            if (m_text[i] == '%' && m_text[i + 1] >= '1' && m_text[i + 1] <= '9') {
                isUsed[m_text[i + 1] - '0'] = true;
            }
        }
        for (std::size_t place = 1; place <= 9; ++place) {
            if (isUsed[place] != (place <= sizeof...(Arguments))) {
                internal::placesOfTextDifferFromArguments();
            }
        }
    }
    [[nodiscard]] constexpr std::string_view text() const noexcept { return m_text; }

  private:
    std::string_view m_text;
};

/// Whole number displayed with digit grouping: "1,234,567".
struct Count
{
    template<class T, std::enable_if_t<std::is_integral_v<T>, int> = 0>
    explicit Count(T value)
        : magnitude(std::cmp_less(value, 0) ? std::uint64_t{0} - static_cast<std::uint64_t>(value)
                                            : static_cast<std::uint64_t>(value))
        , isNegative(std::cmp_less(value, 0))
    {
    }
    std::uint64_t magnitude;
    bool isNegative;
};

/// Number displayed with at most this many significant digits, "0.62", instead of six.
struct Rounded
{
    double value;
    int digits;
};

/// Argument of a message.
struct MessageArgument
{
    enum class Kind : std::uint8_t
    {
        Name,   ///< not translated: a path, a name, a text of the operating system
        Number, ///< formatted with the decimal point and digit grouping of the user's locale
        Message ///< translated separately
    };

    MessageArgument(std::string name)
        : english(std::move(name))
    {
    }
    MessageArgument(std::string_view name)
        : english(name)
    {
    }
    MessageArgument(const char* name)
        : english(name)
    {
    }
    MessageArgument(const std::filesystem::path& path)
        : english(path.string())
    {
    }
    template<class T, std::enable_if_t<std::is_integral_v<T>, int> = 0>
    MessageArgument(T number)
        : english(std::to_string(number))
        , kind(Kind::Number)
    {
    }
    MessageArgument(double number); ///< formatted by `shortNumber` with at most six significant digits
    MessageArgument(Count count);
    MessageArgument(Rounded number);
    MessageArgument(Message part);

    std::string english; ///< English text
    Kind kind = Kind::Name;
    std::shared_ptr<const Message> message; ///< only for Kind::Message
};

/// Translatable message for the user: an English text and its arguments, which may be messages themselves. The engine
/// and the command line print `english()`; the window translates the text and each argument (`ui::translated`).
///
///     core::Message(PALPATE_TEXT("%1: found %2 triangles, expected at least 1"), path, 0)
///
/// @par Thread Value type without shared state. Allocates memory, so not for the servo thread.
class Message
{
  public:
    Message() = default;
    template<class... Arguments>
    Message(MessageText<std::type_identity_t<Arguments>...> text, const Arguments&... arguments)
        : m_text(text.text())
        , m_arguments{MessageArgument(arguments)...}
    {
    }
    /// Creates a message received from another process. The text is translated if a catalogue contains it.
    [[nodiscard]] static Message fromParts(std::string text, std::vector<MessageArgument> arguments);
    /// Creates a message from a foreign text, e.g. of VTK or of a plugin, which is shown unchanged in every language.
    [[nodiscard]] static Message untranslated(std::string sentence);

    [[nodiscard]] bool isEmpty() const noexcept { return m_text.empty(); }
    [[nodiscard]] const std::string& text() const noexcept { return m_text; }
    [[nodiscard]] const std::vector<MessageArgument>& arguments() const noexcept { return m_arguments; }
    [[nodiscard]] std::string english() const;
    [[nodiscard]] bool isTranslatable() const noexcept; ///< false for messages made by `untranslated`

  private:
    std::string m_text;
    std::vector<MessageArgument> m_arguments;
};

/// @return `text` with each placeholder %1 to %9 replaced by the part of that number; other per cent signs are kept
[[nodiscard]] std::string filled(std::string_view text, const std::vector<std::string>& parts);

/// @return the meaning of an `errno` value: "No such file or directory"
[[nodiscard]] Message systemError(int error);

/// @return the messages joined by "; "
[[nodiscard]] Message joined(const std::vector<Message>& messages);

} // namespace palpate::core

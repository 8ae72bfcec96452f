// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/core/Message.h"

#include "palpate/core/Numbers.h"
#include "palpate/core/Text.h"

#include <cerrno>
#include <cstring>

namespace palpate::core {

namespace {

constexpr const char* kVerbatim = "%1"; // needs no catalogue entry

} // namespace

MessageArgument::MessageArgument(double number)
    : english(shortNumber(number))
    , kind(Kind::Number)
{
}

MessageArgument::MessageArgument(Count count)
    : english(internal::grouped(count.magnitude, count.isNegative))
    , kind(Kind::Number)
{
}

MessageArgument::MessageArgument(Rounded number)
    : english(shortNumber(number.value, number.digits))
    , kind(Kind::Number)
{
}

MessageArgument::MessageArgument(Message part)
    : english(part.english())
    , kind(Kind::Message)
    , message(std::make_shared<const Message>(std::move(part)))
{
}

Message Message::fromParts(std::string text, std::vector<MessageArgument> arguments)
{
    Message message;
    message.m_text = std::move(text);
    message.m_arguments = std::move(arguments);
    return message;
}

Message Message::untranslated(std::string sentence)
{
    return sentence.empty() ? Message() : fromParts(kVerbatim, {MessageArgument(std::move(sentence))});
}

std::string Message::english() const
{
    std::vector<std::string> parts;
    parts.reserve(m_arguments.size());
    for (const MessageArgument& argument : m_arguments) {
        parts.push_back(argument.english);
    }
    return filled(m_text, parts);
}

bool Message::isTranslatable() const noexcept
{
    return m_text != kVerbatim;
}

std::string filled(std::string_view text, const std::vector<std::string>& parts)
{
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool isPlace = text[i] == '%' && i + 1 < text.size() && text[i + 1] >= '1' && text[i + 1] <= '9';
        const std::size_t part = isPlace ? static_cast<std::size_t>(text[i + 1] - '1') : parts.size();
        if (part < parts.size()) {
            out += parts[part];
            ++i;
        } else {
            out += text[i];
        }
    }
    return out;
}

Message systemError(int error)
{
    switch (error) { // the errors that files meet; the words are those of the C library
    case ENOENT:
        return Message(PALPATE_TEXT("No such file or directory"));
    case EACCES:
    case EPERM:
        return Message(PALPATE_TEXT("Permission denied"));
    case EROFS:
        return Message(PALPATE_TEXT("Read-only file system"));
    case ENOSPC:
        return Message(PALPATE_TEXT("No space left on device"));
    case EDQUOT:
        return Message(PALPATE_TEXT("Disk quota exceeded"));
    case EFBIG:
        return Message(PALPATE_TEXT("File too large"));
    case EISDIR:
        return Message(PALPATE_TEXT("Is a directory"));
    case ENOTDIR:
        return Message(PALPATE_TEXT("Not a directory"));
    case EEXIST:
        return Message(PALPATE_TEXT("File exists"));
    case EIO:
        return Message(PALPATE_TEXT("Input/output error"));
    case ENAMETOOLONG:
        return Message(PALPATE_TEXT("File name too long"));
    case EMFILE:
    case ENFILE:
        return Message(PALPATE_TEXT("Too many open files"));
    case ENOTSUP: // of something that is not a file
        return Message(PALPATE_TEXT("not a file"));
    default:
        const char* const reason = ::strerrordesc_np(error); // in English, unlike strerror
        return Message::untranslated(reason == nullptr ? "unknown error" : reason);
    }
}

Message joined(const std::vector<Message>& messages)
{
    Message all;
    for (const Message& message : messages) {
        all = all.isEmpty() ? message : Message(PALPATE_TEXT("%1; %2"), all, message);
    }
    return all;
}

} // namespace palpate::core

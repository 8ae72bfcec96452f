// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Message.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::test {

/// Returns the English texts of messages.
inline std::vector<std::string> english(const std::vector<core::Message>& messages)
{
    std::vector<std::string> lines;
    for (const core::Message& message : messages) {
        lines.push_back(message.english());
    }
    return lines;
}

/// Returns true if the English text of any message contains `words`.
inline bool mentions(const std::vector<core::Message>& messages, std::string_view words)
{
    return std::any_of(messages.begin(), messages.end(), [words](const core::Message& message) {
        return message.english().find(words) != std::string::npos;
    });
}

} // namespace palpate::test

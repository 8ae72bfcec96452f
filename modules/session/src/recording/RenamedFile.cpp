// SPDX-License-Identifier: BSD-3-Clause
#include "recording/RenamedFile.h"

#include <vector>

namespace palpate::session::internal {

core::Message renamed(const core::Message& message, const std::string& from, const std::string& to)
{
    std::vector<core::MessageArgument> arguments = message.arguments();
    for (core::MessageArgument& argument : arguments) {
        if (argument.message != nullptr) {
            argument = renamed(*argument.message, from, to);
            continue;
        }
        std::string& name = argument.english;
        for (auto at = name.find(from); at != std::string::npos; at = name.find(from, at + to.size())) {
            name.replace(at, from.size(), to);
        }
    }
    return core::Message::fromParts(message.text(), std::move(arguments));
}

} // namespace palpate::session::internal

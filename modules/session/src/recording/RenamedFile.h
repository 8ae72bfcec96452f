// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Message.h>

#include <string>

namespace palpate::session::internal {

/// Replaces a file name in all arguments of a message, for example that of a temporary file by the name from the user.
[[nodiscard]] core::Message renamed(const core::Message& message, const std::string& from, const std::string& to);

} // namespace palpate::session::internal

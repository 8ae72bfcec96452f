// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/device/PluginHost.h"

namespace palpate::device {

/// Loads a plugin and returns its root object, which exists until the program ends.
[[nodiscard]] core::Result<DevicePlugin*> loadPlugin(const std::filesystem::path& file);

/// Runs `command` with `file` as the last argument and waits for the process to end.
/// @return ok if the process answered as in answerProbe; otherwise its error message, a crash, or a timeout
[[nodiscard]] core::Status runProbe(const std::vector<std::string>& command, const std::filesystem::path& file,
                                    int timeout_ms);

} // namespace palpate::device

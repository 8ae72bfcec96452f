// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/device/PluginHost.h"

namespace palpate::device {

/// Loads the file's code and gives its root object, which lives until the program ends.
[[nodiscard]] core::Result<DevicePlugin*> loadPlugin(const std::filesystem::path& file);

/// Runs `command` with `file` appended and waits for its end.
/// @return ok when it answered as answerProbe does; else what it said was wrong, that it crashed, or that it hung
[[nodiscard]] core::Status runProbe(const std::vector<std::string>& command, const std::filesystem::path& file,
                                    int timeout_ms);

} // namespace palpate::device

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Message.h>
#include <palpate/core/Status.h>
#include <palpate/servo/SelfTestResult.h>

#include <filesystem>
#include <string>
#include <vector>

namespace palpate::study {

/// Page of a device's self-test with its plots: self-contained HTML.
[[nodiscard]] PALPATE_EXPORT std::string selfTestHtml(const servo::SelfTestResult& result);
/// The same as JSON: one object, quantities with the unit in the name, null where nothing was measured.
[[nodiscard]] PALPATE_EXPORT std::string selfTestJson(const servo::SelfTestResult& result);
/// Lines of text for a terminal or a dialog: one quantity each.
[[nodiscard]] PALPATE_EXPORT std::vector<core::Message> selfTestLines(const servo::SelfTestResult& result);
/// @return paths of the files written by writeSelfTest: `selftest.json` and `selftest.html`
[[nodiscard]] PALPATE_EXPORT std::vector<std::filesystem::path> selfTestFiles(const std::filesystem::path& folder);
/// Writes both files to a folder, which is made if missing. Files are replaced atomically.
[[nodiscard]] PALPATE_EXPORT core::Status writeSelfTest(const std::filesystem::path& folder,
                                                        const servo::SelfTestResult& result);
/// Command that predicts the held stiffness for this device, rate and delay; empty for a device that the predictions do
/// not know: "palpate stability --device omega --rate 1000 --delay 2".
[[nodiscard]] PALPATE_EXPORT std::string predictionCommand(const servo::SelfTestResult& result);

} // namespace palpate::study

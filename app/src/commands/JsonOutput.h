// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shared/Console.h"

#include <palpate/core/AtomicFile.h>
#include <palpate/core/Status.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace palpate::app {

/// JSON output of a command: a file, or stdout, which then contains only JSON.
class JsonOutput
{
  public:
    /// Checks the output and creates the file. @param path  "-": stdout; empty: none
    core::Status open(const std::filesystem::path& path, const std::vector<std::filesystem::path>& inputs)
    {
        m_isPiped = path == "-";
        if (path.empty() || m_isPiped) {
            return {};
        }
        if (core::Status status = checkOutputs(inputs, {path}); !status.isOk()) {
            return status;
        }
        auto file = core::AtomicFile::create(path);
        if (file.isOk()) {
            m_file = std::move(file).value();
        }
        return file.status();
    }
    [[nodiscard]] bool isPiped() const noexcept { return m_isPiped; }
    core::Status write(const std::string& json)
    {
        if (m_isPiped) {
            printJson(json);
        }
        if (!m_file) {
            return {};
        }
        m_file->write(json);
        return m_file->finish();
    }

  private:
    bool m_isPiped = false;
    std::optional<core::AtomicFile> m_file;
};

} // namespace palpate::app

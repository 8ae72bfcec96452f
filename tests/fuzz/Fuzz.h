// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::fuzz {

/// A function under fuzzing.
struct Target
{
    std::string_view name;
    std::size_t mutations; ///< per seed, in the CTest run
    /// Returns the inputs to start from, including all earlier findings.
    std::vector<std::string> (*seeds)();
    /// Processes one input, which must end in a value that meets its guarantees or an error of one line.
    void (*tryInput)(std::string_view bytes);
};

/// Returns the targets of this program.
std::span<const Target* const> targets();

/// Returns the target with that name; otherwise prints the available names and exits.
const Target& target(std::string_view name);

/// Aborts the program, as a finding, unless `isTrue`.
void require(bool isTrue, const char* what);

/// Requires an error message of one line that starts with the input's name.
void requireOneLine(const core::Status& status, std::string_view name);

/// A file of this process in memory-backed storage that holds the newest input, for readers that need a file name.
class InputFile
{
  public:
    explicit InputFile(const char* name);
    ~InputFile();
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const noexcept { return m_path; }
    void set(std::string_view bytes) const;

  private:
    std::filesystem::path m_folder;
    std::filesystem::path m_path;
};

} // namespace palpate::fuzz

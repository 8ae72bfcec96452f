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

/// What inputs are made for.
struct Target
{
    std::string_view name;
    std::size_t mutations; ///< of each seed, where CTest tries it
    /// Inputs to start from. What was once found to go wrong is among them and stays.
    std::vector<std::string> (*seeds)();
    /// Feeds one input. Whatever it is, it must end here: with a value that keeps its promises, or with an error of one
    /// line.
    void (*tryInput)(std::string_view bytes);
};

/// Those of this program.
std::span<const Target* const> targets();

/// Its target of that name; without one the program says which there are and ends.
const Target& target(std::string_view name);

/// Ends the program, as a finding, unless `isTrue`.
void require(bool isTrue, const char* what);

/// A refusal is one line that begins with the input's name.
void requireOneLine(const core::Status& status, std::string_view name);

/// A file of this process in memory-backed storage, for what can only be read by name; it holds the newest input.
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

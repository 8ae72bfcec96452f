// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace palpate::session {

/// Writes a file that appears under its name only when it is whole: a temporary file beside it, then a rename. What was
/// there before stays until then; destroyed without `finish`, it leaves nothing.
class AtomicFile
{
  public:
    /// Opens the temporary file.
    /// @return Unreadable with one line that names `path` when it could not be written in the end
    [[nodiscard]] static core::Result<AtomicFile> create(const std::filesystem::path& path);

    AtomicFile(AtomicFile&& other) noexcept;
    AtomicFile& operator=(AtomicFile&& other) noexcept;
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;
    ~AtomicFile();

    /// Appends; an error is kept and reported by `finish`.
    void write(std::string_view text);
    /// Syncs and renames. Once.
    [[nodiscard]] core::Status finish();

  private:
    AtomicFile() = default;
    void discard() noexcept;
    void flush();

    std::filesystem::path m_path;
    std::filesystem::path m_temporary;
    int m_file = -1;
    int m_error = 0; ///< first errno
    std::string m_buffer;
};

} // namespace palpate::session

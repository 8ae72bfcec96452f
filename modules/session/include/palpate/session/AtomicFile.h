// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <filesystem>
#include <memory>
#include <string_view>

class QFileDevice;

namespace palpate::session {

/// Writes a file that appears under its name only when it is whole, as QSaveFile does. What was there before stays
/// until then; destroyed without `finish`, it leaves nothing. A pipe, a terminal or another device is written straight
/// to.
class AtomicFile
{
  public:
    /// @return Unreadable with one line that names `path` when it could not be written in the end
    [[nodiscard]] static core::Result<AtomicFile> create(const std::filesystem::path& path);

    AtomicFile(AtomicFile&& other) noexcept;
    AtomicFile& operator=(AtomicFile&& other) noexcept;
    ~AtomicFile();

    /// Appends; an error is kept and reported by `finish`.
    void write(std::string_view text);
    /// Brings it to the disk and under its name. Once.
    [[nodiscard]] core::Status finish();

  private:
    AtomicFile(std::filesystem::path path, std::unique_ptr<QFileDevice> file);

    std::filesystem::path m_path;
    std::unique_ptr<QFileDevice> m_file;
};

/// Writes all of an AtomicFile at once.
[[nodiscard]] core::Status writeAtomically(const std::filesystem::path& path, std::string_view text);

} // namespace palpate::session

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "guard/OpenFile.h"

#include <span>
#include <string>
#include <string_view>

namespace palpate::meshio::internal {

/// A private copy of a file's bytes in memory, which VTK can open by a name. The bytes that were checked are the bytes
/// that are read: no other process can change or cut them in between. The file's own path may have any characters.
class FileImage
{
  public:
    /// Copies the file at `path`.
    [[nodiscard]] static core::Result<FileImage> load(const std::filesystem::path& path);
    /// Copies a file from the current position of its descriptor. @param file  name for error messages
    [[nodiscard]] static core::Result<FileImage> load(const OpenFile& source, std::string_view file);
    /// Copies `bytes`. @param file  name for error messages
    [[nodiscard]] static core::Result<FileImage> copy(std::string_view bytes, std::string_view file);

    /// Makes an image of zeros. @param file  name for error messages
    [[nodiscard]] static core::Result<FileImage> allocate(std::size_t size, std::string_view file);

    FileImage(FileImage&& other) noexcept;
    FileImage& operator=(FileImage&& other) noexcept;
    FileImage(const FileImage&) = delete;
    FileImage& operator=(const FileImage&) = delete;
    ~FileImage();

    [[nodiscard]] std::string_view bytes() const noexcept { return {m_data, m_size}; }
    [[nodiscard]] std::span<char> writable() noexcept { return {m_data, m_size}; }
    /// @return a path under which this process can open the image during the lifetime of this object.
    [[nodiscard]] std::string openPath() const;

  private:
    FileImage() = default;

    int m_descriptor = -1;
    char* m_data = nullptr;
    std::size_t m_size = 0;
};

} // namespace palpate::meshio::internal

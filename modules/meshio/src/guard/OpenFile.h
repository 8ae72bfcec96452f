// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <cstddef>
#include <filesystem>
#include <string_view>
#include <unistd.h>
#include <utility>

namespace palpate::meshio::internal {

/// Owns a file descriptor.
class Descriptor
{
  public:
    explicit Descriptor(int value = -1) noexcept
        : m_value(value)
    {
    }
    Descriptor(Descriptor&& other) noexcept
        : m_value(std::exchange(other.m_value, -1))
    {
    }
    Descriptor& operator=(Descriptor&& other) noexcept
    {
        std::swap(m_value, other.m_value);
        return *this;
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor()
    {
        if (m_value >= 0) {
            ::close(m_value);
        }
    }
    [[nodiscard]] int value() const noexcept { return m_value; }

  private:
    int m_value;
};

/// A regular file, open for reading from the start.
struct OpenFile
{
    Descriptor descriptor;
    std::size_t size = 0; ///< [bytes]
};

/// Opens `path`; anything but a regular file (folder, pipe) is an error.
[[nodiscard]] core::Result<OpenFile> openFile(const std::filesystem::path& path);
/// Same for an open descriptor. @param file  name for error messages
[[nodiscard]] core::Result<OpenFile> openFile(Descriptor descriptor, std::string_view file);

/// @return an error with the reason from errno
/// @param found  text with the place %1 for the reason
[[nodiscard]] core::Status systemFault(std::string_view file, core::MessageText<core::Message> found);

} // namespace palpate::meshio::internal

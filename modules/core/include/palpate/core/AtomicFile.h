// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Export.h"
#include "palpate/core/Scratch.h"
#include "palpate/core/Status.h"

#include <filesystem>
#include <memory>
#include <string_view>

namespace palpate::core {

/// Writes a file atomically: the complete content appears under its name only after it is on the disk.
///
///     auto file = AtomicFile::create("ticks.csv");
///     if (file.isOk()) {
///         file.value().write("tick,x\n");
///         const Status status = file.value().finish();
///     }
///
/// The content is written to a `Scratch` in the same folder. Until `finish` succeeds, and after any error, an existing
/// file of that name is unchanged. A new file gets permissions according to the umask; a replaced file keeps its
/// permissions. A symbolic link is followed and its target replaced. Pipes, terminals, other devices and descriptors of
/// this process (/dev/stdout) are written to directly.
/// @par Thread One thread at a time.
class PALPATE_EXPORT AtomicFile
{
  public:
    /// Permitted state of the target name.
    enum class Onto
    {
        Anything, ///< existing file, device, or nothing
        File,     ///< existing regular file or nothing
        Nothing   ///< must not exist, neither now nor at `finish`
    };

    /// @return an error that names `path`: NoSpace for a full disk or a size limit, NotFound for a missing folder,
    /// otherwise Unreadable. `finish` returns the same errors.
    [[nodiscard]] static Result<AtomicFile> create(const std::filesystem::path& path, Onto onto = Onto::Anything);

    AtomicFile(AtomicFile&& other) noexcept;
    AtomicFile& operator=(AtomicFile&& other) noexcept;
    ~AtomicFile(); ///< discards the content unless `finish` was called

    /// Appends. The first error is stored and returned by `finish`.
    void write(std::string_view bytes);
    /// Flushes the content to the disk, then renames the file to its final name. Call once.
    [[nodiscard]] Status finish();

  private:
    struct Private;
    explicit AtomicFile(std::unique_ptr<Private> d);
    std::unique_ptr<Private> m_d;
};

/// Writes a complete file atomically.
[[nodiscard]] PALPATE_EXPORT Status writeAtomically(const std::filesystem::path& path, std::string_view bytes,
                                                    AtomicFile::Onto onto = AtomicFile::Onto::Anything);

/// @return `path` for number 1, otherwise with the number before the extension: "2026-11-21 05.12.33 (2).png".
[[nodiscard]] PALPATE_EXPORT std::filesystem::path numbered(const std::filesystem::path& path, int number);

/// Writes a new file under the first free numbered name. Safe against other programs that choose a name at the same
/// time.
/// @return path of the file
[[nodiscard]] PALPATE_EXPORT Result<std::filesystem::path> writeNew(const std::filesystem::path& path,
                                                                    std::string_view bytes);

} // namespace palpate::core

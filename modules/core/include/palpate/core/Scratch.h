// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Export.h"
#include "palpate/core/Status.h"

#include <filesystem>
#include <memory>
#include <string>

namespace palpate::core {

/// Temporary file or folder next to an output file, with a unique name (".palpate-" and 16 hexadecimal digits). Created
/// exclusively (links are never followed) and removed by the destructor, or by the signal handler if a signal ends the
/// process, see `removeScratchOnSignals`. Leftovers after SIGKILL or a power loss are removed at the next creation in
/// the same folder: an unlocked scratch file is known to be unused.
/// @par Thread One thread at a time.
class PALPATE_EXPORT Scratch
{
  public:
    enum class Kind
    {
        File,
        Folder ///< private to the user (mode 0700); may contain files, but no folders
    };

    /// @param output  final file; the folder must exist
    /// @param mode    permissions of a file, before the umask
    /// @return an error that names `output`, see `cannotWrite`
    [[nodiscard]] static Result<std::unique_ptr<Scratch>> create(const std::filesystem::path& output, Kind kind,
                                                                 unsigned mode = 0600);
    ~Scratch();
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    /// Descriptor of the file (read and write), or of the folder.
    [[nodiscard]] int descriptor() const noexcept;
    /// Descriptor of the parent folder, for the `*at` system calls.
    [[nodiscard]] int folder() const noexcept;
    /// Name in the parent folder.
    [[nodiscard]] const char* name() const noexcept;
    [[nodiscard]] std::filesystem::path path() const;

  private:
    struct Private;
    explicit Scratch(std::unique_ptr<Private> d);
    std::unique_ptr<Private> m_d;
};

/// Treatment of an existing file at the target name of a rename.
enum class ExistingFile
{
    Replace, ///< replace an existing file or link
    Refuse   ///< fail if a file exists
};

/// Renames a file atomically within one file system.
/// @param fromFolder, toFolder  descriptors of the folders
/// @return 0 or the error number; EEXIST if `old` is Refuse and a file exists
[[nodiscard]] PALPATE_EXPORT int renameWithoutRace(int fromFolder, const char* from, int toFolder, const char* to,
                                                   ExistingFile old) noexcept;

/// Flushes the names in a folder to the disk. Errors of file systems without this feature are ignored.
PALPATE_EXPORT void syncFolder(int folder) noexcept;

/// Installs handlers for all signals that terminate the process: they remove the files of `Scratch` and then let the
/// signal terminate the process as before. Exceeding the file size limit (SIGXFSZ) becomes a write error instead of a
/// signal. Signals ignored by the parent process stay ignored. Call once, at program start.
PALPATE_EXPORT void removeScratchOnSignals();

/// Error for a file that cannot be written: one line with path, reason and remedy.
/// @param error  errno value. Results in NoSpace for a full disk, a quota or a size limit, in NotFound for a missing
/// folder, otherwise in Unreadable.
[[nodiscard]] PALPATE_EXPORT Status cannotWrite(const std::filesystem::path& path, int error);

} // namespace palpate::core

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Status.h"

#include <filesystem>
#include <memory>
#include <string>

namespace palpate::core {

/// A temporary file or folder beside an output, under a name of its own (".palpate-" and 16 hexadecimal digits). It is
/// created exclusively (links are never followed), and removed with this object. A signal that ends the process removes
/// it as well, see `removeScratchOnSignals`. What SIGKILL or a power loss leaves is removed when the next one is
/// created in the same folder: its lock tells that nobody uses it.
/// @par Thread One at a time.
class Scratch
{
  public:
    enum class Kind
    {
        File,
        Folder ///< for this user alone (mode 0700); may hold files, but no folders
    };

    /// @param output  the file that it is for; its folder must exist
    /// @param mode    permissions of a file, before the umask
    /// @return an error that names `output`, see `cannotWrite`
    [[nodiscard]] static Result<std::unique_ptr<Scratch>> create(const std::filesystem::path& output, Kind kind,
                                                                 unsigned mode = 0600);
    ~Scratch();
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    /// Descriptor of the file, open for reading and writing, or of the folder.
    [[nodiscard]] int descriptor() const noexcept;
    /// Descriptor of the folder that it is in, for the functions that end in `at`.
    [[nodiscard]] int folder() const noexcept;
    /// Its name in that folder.
    [[nodiscard]] const char* name() const noexcept;
    [[nodiscard]] std::filesystem::path path() const;

  private:
    struct Private;
    explicit Scratch(std::unique_ptr<Private> d);
    std::unique_ptr<Private> m_d;
};

/// What may have the name that a file is given.
enum class OldFile
{
    Replace, ///< a file or a link there is replaced
    Refuse   ///< there must be none
};

/// Renames a file within one file system, in one step.
/// @param fromFolder, toFolder  descriptors of folders
/// @return 0 or the error number; EEXIST when there is a file that is to be refused
[[nodiscard]] int giveName(int fromFolder, const char* from, int toFolder, const char* to, OldFile old) noexcept;

/// Waits until the disk has the names in a folder; file systems that cannot do it are taken as they are.
void syncFolder(int folder) noexcept;

/// Lets each signal that would end this process remove what `Scratch` made first, then end it as before. A write beyond
/// the limit of a file's size (SIGXFSZ) becomes an error instead of a signal. Signals that the parent process ignores
/// stay ignored. Call it once, at the start of a program.
void removeScratchOnSignals();

/// The error of a file that cannot be written: one line with its path, the reason and what to do.
/// @param error  number of the system's error. NoSpace for a full disk, a quota and a limit of size, NotFound for a
///               missing folder, else Unreadable
[[nodiscard]] Status cannotWrite(const std::filesystem::path& path, int error);

} // namespace palpate::core

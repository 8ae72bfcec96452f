// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/Scratch.h"
#include "palpate/core/Status.h"

#include <filesystem>
#include <memory>
#include <string_view>

namespace palpate::core {

/// Writes a file that appears under its name only when all of it is on the disk:
///
///     auto file = AtomicFile::create("ticks.csv");
///     if (file.isOk()) {
///         file.value().write("tick,x\n");
///         const Status status = file.value().finish();
///     }
///
/// It is written beside its name as a `Scratch`. Until `finish` succeeds, and after any error, an older file of that
/// name is as it was. A new file gets the permissions that the umask leaves, a replaced one keeps those it had; of a
/// symbolic link the target is written. A pipe, terminal or other device, and a descriptor of this process
/// (/dev/stdout), is written straight to.
/// @par Thread One at a time.
class AtomicFile
{
  public:
    /// What may have the name.
    enum class Onto
    {
        Anything, ///< a file, a device, or nothing
        File,     ///< a file or nothing
        Nothing   ///< nothing: also when it is finished
    };

    /// @return an error that names `path`: NoSpace on a full disk or at a limit, NotFound when its folder does not
    ///         exist, else Unreadable; so has `finish`
    [[nodiscard]] static Result<AtomicFile> create(const std::filesystem::path& path, Onto onto = Onto::Anything);

    AtomicFile(AtomicFile&& other) noexcept;
    AtomicFile& operator=(AtomicFile&& other) noexcept;
    ~AtomicFile(); ///< without `finish` before: nothing was written

    /// Appends. The first error is kept and returned by `finish`.
    void write(std::string_view bytes);
    /// Waits until the disk has it, then gives it its name. Once.
    [[nodiscard]] Status finish();

  private:
    struct Private;
    explicit AtomicFile(std::unique_ptr<Private> d);
    std::unique_ptr<Private> m_d;
};

/// Writes all of an AtomicFile at once.
[[nodiscard]] Status writeAtomically(const std::filesystem::path& path, std::string_view bytes,
                                     AtomicFile::Onto onto = AtomicFile::Onto::Anything);

/// @return `path` for 1, else with the number before its extension: "2026-11-21 05.12.33 (2).png".
[[nodiscard]] std::filesystem::path numbered(const std::filesystem::path& path, int number);

/// Writes a new file under the first numbered name that is free; another program may be looking for one at the same
/// time.
/// @return its path
[[nodiscard]] Result<std::filesystem::path> writeNew(const std::filesystem::path& path, std::string_view bytes);

} // namespace palpate::core

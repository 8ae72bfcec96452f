// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Scratch.h>
#include <palpate/core/Status.h>

#include <filesystem>
#include <memory>
#include <string>

#include <sys/stat.h>

namespace palpate::session::internal {

/// Output file of a recording, locked against other writers. The file is created in a scratch folder, so that the final
/// name never refers to a file without a schema. A new file is then moved to its name, which must be unused. A file
/// that replaces an older one is moved when complete. Removes only files that were created here.
class RecordingPlace
{
  public:
    /// Creates an empty file with mode 0644 before the umask, or the mode of the replaced file.
    /// @param path  Refuse: must not exist. Replace: may be missing, a symbolic link, or a file that no other program
    ///              is recording into. There must be no adjacent file that SQLite would treat as part of the database
    ///              (-journal, -wal, -shm).
    [[nodiscard]] static core::Result<std::unique_ptr<RecordingPlace>> claim(const std::filesystem::path& path,
                                                                             core::ExistingFile old);
    ~RecordingPlace();
    RecordingPlace(const RecordingPlace&) = delete;
    RecordingPlace& operator=(const RecordingPlace&) = delete;

    /// Current path of the file.
    [[nodiscard]] std::filesystem::path file() const;
    /// Moves a new file to its name once the schema exists. A replacing file is not moved yet.
    core::Status settle();
    /// Moves a replacing file to its name. Call when complete and closed by SQLite. If another program has written a
    /// file of that name, both are kept: the new file gets a numbered name that the error contains.
    core::Status complete();
    /// Removes the file and its journal, unless another file has taken the name. SQLite must have closed the file.
    void discard();

  private:
    explicit RecordingPlace(std::filesystem::path path);
    core::Status open(core::ExistingFile old);
    core::Status lockOld();
    [[nodiscard]] core::Status checkBeside() const;
    [[nodiscard]] bool isAt(const std::string& name, const struct stat& file) const;
    [[nodiscard]] core::Status cannot(const core::Message& why) const;

    const std::filesystem::path m_path;
    const std::string m_name; ///< file name in the folder
    int m_folder = -1;
    int m_file = -1; ///< holds the lock; closed after SQLite's descriptor, because closing any descriptor drops all
                     ///< POSIX locks of the process on that file
    int m_old = -1;  ///< file to be replaced, locked
    bool m_isOldThere = false;
    struct stat m_oldIs
    {
    };
    std::unique_ptr<core::Scratch> m_scratch; ///< until the file has its final name
};

} // namespace palpate::session::internal

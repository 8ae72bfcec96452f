// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Scratch.h>
#include <palpate/core/Status.h>

#include <filesystem>
#include <memory>
#include <string>

#include <sys/stat.h>

namespace palpate::session::internal {

/// The file of a recording that is written, held against other writers by a lock. It is made in a scratch folder, so
/// that no name ever stands for a file without its schema. A new one then takes its name, which nothing may have; one
/// that replaces an older file takes it when it is complete. Only a file that was made here is ever removed.
class RecordingPlace
{
  public:
    /// Makes an empty file, mode 0644 before the umask or as the replaced one has.
    /// @param path  Refuse: there must be nothing. Replace: nothing, a symbolic link or a file; another program must
    /// not
    ///              be recording into it. Beside it there must be no file that SQLite would take for a part of it
    ///              (-journal, -wal, -shm).
    [[nodiscard]] static core::Result<std::unique_ptr<RecordingPlace>> claim(const std::filesystem::path& path,
                                                                             core::OldFile old);
    ~RecordingPlace();
    RecordingPlace(const RecordingPlace&) = delete;
    RecordingPlace& operator=(const RecordingPlace&) = delete;

    /// Where the file is now.
    [[nodiscard]] std::filesystem::path file() const;
    /// With the schema in it, a new file takes its name. One that replaces another stays where it is.
    core::Status settle();
    /// Complete and closed by SQLite: a replacing one takes its name. Where another program wrote a file of that name
    /// meanwhile, both stay: the new one gets a numbered name, which the error says.
    core::Status complete();
    /// Removes the file, if the name still stands for it, and its journal. SQLite must have closed it.
    void discard();

  private:
    explicit RecordingPlace(std::filesystem::path path);
    core::Status open(core::OldFile old);
    core::Status lockOld();
    [[nodiscard]] core::Status checkBeside() const;
    [[nodiscard]] bool isAt(const std::string& name, const struct stat& file) const;
    [[nodiscard]] core::Status cannot(const std::string& why) const;

    const std::filesystem::path m_path;
    const std::string m_name; ///< in the folder
    int m_folder = -1;
    int m_file = -1; ///< holds the lock; closed after SQLite's, which would lose its own locks by that
    int m_old = -1;  ///< the file that is replaced, locked
    bool m_isOldThere = false;
    struct stat m_oldIs
    {
    };
    std::unique_ptr<core::Scratch> m_scratch; ///< until the file has its name
};

} // namespace palpate::session::internal

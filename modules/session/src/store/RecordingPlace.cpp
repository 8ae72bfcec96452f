// SPDX-License-Identifier: BSD-3-Clause
#include "store/RecordingPlace.h"

#include <palpate/core/AtomicFile.h>

#include <array>
#include <cerrno>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace palpate::session::internal {

using core::ExistingFile;
using core::Status;
using core::StatusCode;

namespace {

constexpr const char* kMade = "recording"; // name in the scratch folder
constexpr std::array kSideFiles{"-journal", "-wal", "-shm"};

/// Locks a byte far beyond SQLite's lock bytes. flock is unsuitable: over NFS it locks the whole file, including
/// SQLite's bytes.
/// @return false if another program holds the lock
bool lock(int file) noexcept
{
    struct flock range
    {
    };
    range.l_type = F_WRLCK;
    range.l_whence = SEEK_SET;
    range.l_start = off_t{1} << 62;
    range.l_len = 1;
    return ::fcntl(file, F_OFD_SETLK, &range) == 0 || (errno != EAGAIN && errno != EACCES);
}

core::Message nameIsTaken()
{
    return core::Message(PALPATE_TEXT("there is a file of this name; choose another name"));
}

} // namespace

RecordingPlace::RecordingPlace(std::filesystem::path path)
    : m_path(std::move(path))
    , m_name(m_path.filename().string())
{
}

RecordingPlace::~RecordingPlace()
{
    m_scratch.reset();
    for (const int one : {m_file, m_old, m_folder}) {
        if (one >= 0) {
            (void)::close(one);
        }
    }
}

Status RecordingPlace::cannot(const core::Message& why) const
{
    return {StatusCode::Unreadable, PALPATE_TEXT("%1: cannot be written: %2"), m_path, why};
}

/// Returns true if a name in the folder refers to this file.
bool RecordingPlace::isAt(const std::string& name, const struct stat& file) const
{
    struct stat there
    {
    };
    return ::fstatat(m_folder, name.c_str(), &there, AT_SYMLINK_NOFOLLOW) == 0 && there.st_dev == file.st_dev &&
           there.st_ino == file.st_ino;
}

core::Result<std::unique_ptr<RecordingPlace>> RecordingPlace::claim(const std::filesystem::path& path, ExistingFile old)
{
    std::unique_ptr<RecordingPlace> place(new RecordingPlace(path));
    if (Status status = place->open(old); !status.isOk()) {
        return status;
    }
    return place;
}

Status RecordingPlace::checkBeside() const
{
    for (const char* suffix : kSideFiles) {
        struct stat is
        {
        };
        if (const std::string side = m_name + suffix;
            ::fstatat(m_folder, side.c_str(), &is, AT_SYMLINK_NOFOLLOW) == 0) {
            return cannot(core::Message(
                PALPATE_TEXT("the file %1 would be taken for a part of it; move that away or choose another name"),
                side));
        }
    }
    return {};
}

/// Opens and locks the file to be replaced.
Status RecordingPlace::lockOld()
{
    if (S_ISLNK(m_oldIs.st_mode)) {
        return {}; // replaces the link, not its target
    }
    if (!S_ISREG(m_oldIs.st_mode)) {
        return cannot(core::Message(PALPATE_TEXT("not a file")));
    }
    m_old = ::openat(m_folder, m_name.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (m_old < 0) {
        return core::cannotWrite(m_path, errno);
    }
    return lock(m_old)
               ? Status()
               : cannot(core::Message(PALPATE_TEXT("another program is recording into it; choose another name")));
}

Status RecordingPlace::open(ExistingFile old)
{
    const std::filesystem::path folder = m_path.has_parent_path() ? m_path.parent_path() : ".";
    m_folder = ::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
    if (m_folder < 0) {
        return core::cannotWrite(m_path, errno);
    }
    m_isOldThere = ::fstatat(m_folder, m_name.c_str(), &m_oldIs, AT_SYMLINK_NOFOLLOW) == 0;
    if (m_isOldThere && old == ExistingFile::Refuse) {
        return cannot(S_ISREG(m_oldIs.st_mode) ? nameIsTaken() : core::Message(PALPATE_TEXT("not a file")));
    }
    if (m_isOldThere) {
        if (Status status = lockOld(); !status.isOk()) {
            return status;
        }
    }
    if (Status status = checkBeside(); !status.isOk()) {
        return status;
    }
    auto scratch = core::Scratch::create(m_path, core::Scratch::Kind::Folder);
    if (!scratch.isOk()) {
        return scratch.status();
    }
    m_scratch = std::move(scratch).value();
    m_file = ::openat(m_scratch->descriptor(), kMade, O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0644);
    if (m_file < 0 || (m_old >= 0 && ::fchmod(m_file, m_oldIs.st_mode & 07777) != 0)) {
        return core::cannotWrite(m_path, errno);
    }
    (void)lock(m_file); // cannot fail: the file is not visible to others yet
    return {};
}

std::filesystem::path RecordingPlace::file() const
{
    return m_scratch != nullptr ? m_scratch->path() / kMade : m_path;
}

Status RecordingPlace::settle()
{
    if (Status status = checkBeside(); !status.isOk()) {
        return status;
    }
    const int error =
        core::renameWithoutRace(m_scratch->descriptor(), kMade, m_folder, m_name.c_str(), ExistingFile::Refuse);
    if (error != 0) {
        return error == EEXIST ? cannot(nameIsTaken()) : core::cannotWrite(m_path, error);
    }
    m_scratch.reset();
    return {};
}

Status RecordingPlace::complete()
{
    if (m_scratch == nullptr) {
        core::syncFolder(m_folder);
        return {};
    }
    if (::fsync(m_file) != 0) {
        return core::cannotWrite(m_path, errno);
    }
    if (Status status = checkBeside(); !status.isOk()) {
        return status;
    }
    const bool isAsBefore = m_isOldThere && isAt(m_name, m_oldIs);
    int error = core::renameWithoutRace(m_scratch->descriptor(), kMade, m_folder, m_name.c_str(),
                                        isAsBefore ? ExistingFile::Replace : ExistingFile::Refuse);
    std::string kept;
    for (int number = 2; error == EEXIST; ++number) {
        kept = core::numbered(m_name, number).string();
        error = core::renameWithoutRace(m_scratch->descriptor(), kMade, m_folder, kept.c_str(), ExistingFile::Refuse);
    }
    if (error != 0) {
        return core::cannotWrite(m_path, error);
    }
    m_scratch.reset();
    core::syncFolder(m_folder);
    return kept.empty() ? Status()
                        : cannot(core::Message(
                              PALPATE_TEXT("another program wrote a file of this name meanwhile; kept as %1"), kept));
}

void RecordingPlace::discard()
{
    struct stat own
    {
    };
    if (m_scratch == nullptr && ::fstat(m_file, &own) == 0 && isAt(m_name, own)) {
        (void)::unlinkat(m_folder, m_name.c_str(), 0);
        (void)::unlinkat(m_folder, (m_name + kSideFiles.front()).c_str(), 0); // did not exist before the file
    }
    m_scratch.reset();
}

} // namespace palpate::session::internal

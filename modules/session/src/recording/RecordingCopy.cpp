// SPDX-License-Identifier: BSD-3-Clause
#include "recording/RecordingCopy.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

namespace palpate::session::internal {

using core::Status;
using core::StatusCode;

namespace {

constexpr std::size_t kHeader_bytes = 100;
using Header = std::array<unsigned char, kHeader_bytes>;

/// Input file, closed at the end.
struct Input
{
    /// @param follow  O_NOFOLLOW, or 0 for a path given by the user, which may be a link
    Input(const std::string& path, int follow)
        : file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | follow))
    {
        isRegular = file >= 0 && ::fstat(file, &is) == 0 && S_ISREG(is.st_mode);
    }
    ~Input()
    {
        if (file >= 0) {
            (void)::close(file);
        }
    }
    Input(const Input&) = delete;
    Input& operator=(const Input&) = delete;

    const int file;
    bool isRegular = false;
    struct stat is
    {
    };
    off_t size = 0; ///< number of bytes to copy
};

Status cannotRead(const std::filesystem::path& path, const core::Message& reason)
{
    return {StatusCode::Unreadable, PALPATE_TEXT("%1: cannot be read: %2"), path, reason};
}

std::uint32_t bigEndian(const unsigned char* at)
{
    return (std::uint32_t{at[0]} << 24) | (std::uint32_t{at[1]} << 16) | (std::uint32_t{at[2]} << 8) | at[3];
}

Header headerOf(const Input& input)
{
    Header header{};
    if (input.isRegular && ::pread(input.file, header.data(), header.size(), 0) < 0) {
        header = {};
    }
    return header;
}

/// Returns the size used by SQLite; the whole file if the header does not contain the page count.
off_t usedSize(const Input& database, const Input& journal)
{
    const Header header = headerOf(database);
    const std::uint32_t stated = (std::uint32_t{header[16]} << 8) | header[17];
    const std::uint32_t page = stated == 1 ? 65536 : stated;
    const bool isDatabase = std::memcmp(header.data(), "SQLite format 3", 16) == 0 && page >= 512 &&
                            (page & (page - 1)) == 0 && bigEndian(&header[24]) == bigEndian(&header[92]);
    std::uint32_t pages = bigEndian(&header[28]);
    if (!isDatabase || pages == 0) {
        return database.is.st_size;
    }
    constexpr std::array<unsigned char, 8> kMagic{0xd9, 0xd5, 0x05, 0xf9, 0x20, 0xa1, 0x63, 0xd7};
    if (const Header before = headerOf(journal); std::memcmp(before.data(), kMagic.data(), kMagic.size()) == 0) {
        pages = std::max(pages, bigEndian(&before[16])); // page count before the transaction to roll back
    }
    return std::min(database.is.st_size, static_cast<off_t>(pages) * static_cast<off_t>(page));
}

/// Calls `take(begin, end)` for each data range of a sparse file until `take` returns false.
template<class Take>
void forEachData(const Input& input, Take take)
{
    for (off_t at = 0; at < input.size;) {
        off_t begin = ::lseek(input.file, at, SEEK_DATA);
        if (begin < 0 && errno == ENXIO) {
            return; // hole up to the end
        }
        off_t end = begin < 0 ? input.size : ::lseek(input.file, begin, SEEK_HOLE);
        begin = begin < 0 ? at : begin; // file system without sparse files
        end = std::min(end < 0 ? input.size : end, input.size);
        if (begin >= end || !take(begin, end)) {
            return;
        }
        at = end;
    }
}

std::uint64_t dataSize(const Input& input)
{
    std::uint64_t size = 0;
    forEachData(input, [&size](off_t begin, off_t end) {
        size += static_cast<std::uint64_t>(end - begin);
        return true;
    });
    return size;
}

/// @return 0 or the error number
int writeAll(int to, std::string_view bytes, off_t at)
{
    while (!bytes.empty()) {
        const ssize_t written = ::pwrite(to, bytes.data(), bytes.size(), at);
        if (written < 0 && errno != EINTR) {
            return errno;
        }
        const auto count = static_cast<std::size_t>(std::max<ssize_t>(written, 0));
        bytes.remove_prefix(count);
        at += static_cast<off_t>(count);
    }
    return 0;
}

/// @return 0 or the error number of a write; `readError` receives that of a read
int copy(const Input& input, int folder, const std::string& name, int& readError)
{
    const int to = ::openat(folder, name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
    if (to < 0) {
        return errno;
    }
    std::vector<char> buffer(std::size_t{1} << 20);
    int error = ::ftruncate(to, input.size) == 0 ? 0 : errno;
    forEachData(input, [&](off_t begin, off_t end) {
        while (begin < end && error == 0 && readError == 0) {
            const auto wanted = std::min(buffer.size(), static_cast<std::size_t>(end - begin));
            const ssize_t read = ::pread(input.file, buffer.data(), wanted, begin);
            if (read == 0) {
                break; // truncated in the meantime
            }
            if (read > 0) {
                error = writeAll(to, {buffer.data(), static_cast<std::size_t>(read)}, begin);
                begin += static_cast<off_t>(read);
            } else if (errno != EINTR) {
                readError = errno;
            }
        }
        return error == 0 && readError == 0;
    });
    (void)::close(to);
    return error;
}

} // namespace

Status copyRecording(const std::filesystem::path& from, const core::Scratch& to, const std::string& name,
                     const std::filesystem::path& output)
{
    Input database(from.string(), 0);
    if (!database.isRegular) {
        return cannotRead(from,
                          database.file < 0 ? core::systemError(errno) : core::Message(PALPATE_TEXT("not a file")));
    }
    Input journal(from.string() + "-journal", O_NOFOLLOW); // derived path, not named by the user: do not follow links
    database.size = usedSize(database, journal);
    journal.size = journal.isRegular ? journal.is.st_size : 0;
    const std::uint64_t needed = dataSize(database) + dataSize(journal);
    struct statvfs disk
    {
    };
    if (::fstatvfs(to.descriptor(), &disk) == 0 && needed / disk.f_frsize >= disk.f_bavail) {
        return core::cannotWrite(output, ENOSPC);
    }
    int readError = 0;
    int error = copy(database, to.descriptor(), name, readError);
    if (error == 0 && readError == 0 && journal.isRegular) {
        error = copy(journal, to.descriptor(), name + "-journal", readError);
    }
    return readError != 0 ? cannotRead(from, core::systemError(readError))
           : error != 0   ? core::cannotWrite(output, error)
                          : Status();
}

} // namespace palpate::session::internal

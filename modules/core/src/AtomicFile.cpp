// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/core/AtomicFile.h"

#include <cerrno>
#include <charconv>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace palpate::core {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBuffer_bytes = 65536;
constexpr unsigned kNewFile = 0666; // before the umask
constexpr unsigned kPermissions = 07777;

fs::path folderOf(const fs::path& path)
{
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// @return descriptor number if the path denotes a descriptor of this process: 1 for /proc/self/fd/1.
std::optional<int> descriptorNamed(const fs::path& path)
{
    std::error_code error;
    const std::string name = path.filename().string();
    int number = -1;
    const auto read = std::from_chars(name.data(), name.data() + name.size(), number);
    const bool isNumber = read.ec == std::errc() && read.ptr == name.data() + name.size();
    return isNumber && fs::equivalent(folderOf(path), "/proc/self/fd", error) ? std::optional(number) : std::nullopt;
}

/// Resolves symbolic links; the final target need not exist. @return 0 or the error number
int followLinks(fs::path& path)
{
    constexpr int kMost = 40; // limit of Linux
    for (int i = 0; i < kMost; ++i) {
        std::error_code error;
        const fs::path to = descriptorNamed(path) ? fs::path() : fs::read_symlink(path, error);
        if (to.empty()) {
            return 0;
        }
        path = folderOf(path) / to; // equals `to` if absolute
    }
    return ELOOP;
}

} // namespace

struct AtomicFile::Private
{
    Private() = default;
    Private(const Private&) = delete;
    Private& operator=(const Private&) = delete;
    ~Private()
    {
        if (device >= 0) {
            (void)::close(device);
        }
    }

    Status open(Onto onto);
    Status openDevice(int opened);
    Status openFile(const fs::path& at, std::optional<unsigned> permissions);
    void flush();

    fs::path path;                    ///< as given by the caller
    std::string name;                 ///< final name in the folder of the scratch file
    std::unique_ptr<Scratch> scratch; ///< only for regular files
    int device = -1;                  ///< descriptor for direct output
    ExistingFile old = ExistingFile::Replace;
    std::string buffer;
    int error = 0; ///< first error
};

Status AtomicFile::Private::open(Onto onto)
{
    fs::path at = path;
    if (onto == Onto::Nothing) {
        old = ExistingFile::Refuse;
    } else if (const int failed = followLinks(at); failed != 0) {
        return cannotWrite(path, failed);
    }
    if (const auto number = descriptorNamed(at); number && onto == Onto::Anything) {
        return openDevice(::fcntl(*number, F_DUPFD_CLOEXEC, 0));
    }
    if (!at.has_filename()) {
        return cannotWrite(path, at.empty() ? ENOENT : EISDIR);
    }
    struct stat is
    {
    };
    if (::lstat(at.c_str(), &is) != 0) {
        return errno == ENOENT ? openFile(at, std::nullopt) : cannotWrite(path, errno);
    }
    if (onto == Onto::Nothing) {
        return cannotWrite(path, EEXIST);
    }
    if (S_ISREG(is.st_mode)) {
        return ::faccessat(AT_FDCWD, at.c_str(), W_OK, AT_EACCESS) == 0 ? openFile(at, is.st_mode & kPermissions)
                                                                        : cannotWrite(path, errno);
    }
    if (S_ISDIR(is.st_mode) || onto == Onto::File) {
        return cannotWrite(path, S_ISDIR(is.st_mode) ? EISDIR : ENOTSUP);
    }
    return openDevice(::open(at.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
}

Status AtomicFile::Private::openDevice(int opened)
{
    device = opened;
    return device >= 0 ? Status() : cannotWrite(path, errno);
}

/// Creates a scratch file next to the target. @param permissions  those of the existing file, if any
Status AtomicFile::Private::openFile(const fs::path& at, std::optional<unsigned> permissions)
{
    // The content must not be readable by others during writing if the final file is not.
    auto made = Scratch::create(at, Scratch::Kind::File, permissions ? 0600 : kNewFile);
    if (!made.isOk()) {
        return made.status();
    }
    scratch = std::move(made).value();
    name = at.filename().string();
    return !permissions || ::fchmod(scratch->descriptor(), *permissions) == 0 ? Status() : cannotWrite(path, errno);
}

void AtomicFile::Private::flush()
{
    const int to = scratch ? scratch->descriptor() : device;
    for (std::string_view left = buffer; error == 0 && !left.empty();) {
        const ssize_t written = ::write(to, left.data(), left.size());
        if (written >= 0) {
            left.remove_prefix(static_cast<std::size_t>(written));
        } else if (errno != EINTR) {
            error = errno;
        }
    }
    buffer.clear();
}

AtomicFile::AtomicFile(std::unique_ptr<Private> d)
    : m_d(std::move(d))
{
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept = default;
AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept = default;
AtomicFile::~AtomicFile() = default;

Result<AtomicFile> AtomicFile::create(const fs::path& path, Onto onto)
{
    auto d = std::make_unique<Private>();
    d->path = path;
    if (Status status = d->open(onto); !status.isOk()) {
        return status;
    }
    return AtomicFile(std::move(d));
}

void AtomicFile::write(std::string_view bytes)
{
    m_d->buffer.append(bytes);
    if (m_d->buffer.size() >= kBuffer_bytes) {
        m_d->flush();
    }
}

Status AtomicFile::finish()
{
    Private& d = *m_d;
    d.flush();
    if (d.error == 0 && d.scratch != nullptr) {
        if (::fsync(d.scratch->descriptor()) != 0 &&
            errno != EINVAL) { // EINVAL: the file system does not support fsync
            d.error = errno;
        } else {
            d.error =
                renameWithoutRace(d.scratch->folder(), d.scratch->name(), d.scratch->folder(), d.name.c_str(), d.old);
        }
        if (d.error == 0) {
            syncFolder(d.scratch->folder());
        }
    }
    d.scratch.reset();
    return d.error == 0 ? Status() : cannotWrite(d.path, d.error);
}

Status writeAtomically(const fs::path& path, std::string_view bytes, AtomicFile::Onto onto)
{
    auto file = AtomicFile::create(path, onto);
    if (!file.isOk()) {
        return file.status();
    }
    file.value().write(bytes);
    return file.value().finish();
}

fs::path numbered(const fs::path& path, int number)
{
    if (number < 2) {
        return path;
    }
    fs::path name = path.stem();
    name += " (" + std::to_string(number) + ")";
    name += path.extension();
    return path.parent_path() / name;
}

Result<fs::path> writeNew(const fs::path& path, std::string_view bytes)
{
    constexpr int kMost = 1000;
    Status status;
    for (int number = 1; number <= kMost; ++number) {
        const fs::path free = numbered(path, number);
        status = writeAtomically(free, bytes, AtomicFile::Onto::Nothing);
        std::error_code error;
        if (status.isOk()) {
            return free;
        }
        if (!fs::exists(fs::symlink_status(free, error))) {
            break; // the error has a cause other than the name
        }
    }
    return status;
}

} // namespace palpate::core

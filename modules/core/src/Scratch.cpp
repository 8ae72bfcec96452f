// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/core/Scratch.h"

#include <array>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string_view>
#include <utility>

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

namespace palpate::core {

namespace {

constexpr std::string_view kPrefix = ".palpate-";
constexpr std::size_t kDigits = 16;
using Name = std::array<char, kPrefix.size() + kDigits + 1>;

/// Scratch entry of this process for the signal handler. `owner` is 0 for a free slot and -1 while being filled.
struct Slot
{
    std::atomic<pid_t> owner{0};
    int folder = -1;
    Name name{};
};
static_assert(std::atomic<pid_t>::is_always_lock_free, "used in a signal handler");

std::array<Slot, 64> slots; // further entries are removed at the next creation of a scratch, not by the handler

Slot* takeSlot(int folder, const Name& name) noexcept
{
    for (Slot& slot : slots) {
        pid_t free = 0;
        if (slot.owner.compare_exchange_strong(free, -1)) {
            slot.folder = folder;
            slot.name = name;
            slot.owner.store(::getpid());
            return &slot;
        }
    }
    return nullptr;
}

/// Removes a file, or a folder with its files. Async-signal-safe.
void removeEntry(int folder, const char* name) noexcept
{
    if (::unlinkat(folder, name, 0) == 0 || (errno != EISDIR && errno != EPERM)) {
        return;
    }
    const int inside = ::openat(folder, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (inside < 0) {
        return;
    }
    alignas(dirent64) std::array<char, 4096> buffer;
    for (bool isAnyRemoved = true; isAnyRemoved;) { // deletions may make the listing skip entries
        isAnyRemoved = false;
        (void)::lseek(inside, 0, SEEK_SET);
        for (ssize_t size = 0; (size = ::getdents64(inside, buffer.data(), buffer.size())) > 0;) {
            for (ssize_t at = 0; at < size;) {
                const auto* const entry = reinterpret_cast<const dirent64*>(buffer.data() + at);
                at += entry->d_reclen;
                isAnyRemoved = ::unlinkat(inside, entry->d_name, 0) == 0 || isAnyRemoved;
            }
        }
    }
    (void)::close(inside);
    (void)::unlinkat(folder, name, AT_REMOVEDIR);
}

bool isScratchName(std::string_view name)
{
    return name.size() == kPrefix.size() + kDigits && name.starts_with(kPrefix) &&
           name.find_first_not_of("0123456789abcdef", kPrefix.size()) == std::string_view::npos;
}

/// Removes leftovers of killed programs from a folder: entries with a scratch name that belong to this user and are not
/// locked.
void removeLeftovers(int folder)
{
    const int again = ::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR* const list = again < 0 ? nullptr : ::fdopendir(again);
    if (list == nullptr) {
        return; // folder with write but without read permission
    }
    while (const dirent* entry = ::readdir(list)) {
        if (!isScratchName(entry->d_name)) {
            continue;
        }
        const int file = ::openat(folder, entry->d_name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
        struct stat is
        {
        };
        if (file >= 0 && ::fstat(file, &is) == 0 && (S_ISREG(is.st_mode) || S_ISDIR(is.st_mode)) &&
            is.st_uid == ::geteuid() && ::flock(file, LOCK_EX | LOCK_NB) == 0) {
            removeEntry(folder, entry->d_name);
        }
        if (file >= 0) {
            (void)::close(file);
        }
    }
    (void)::closedir(list);
}

/// Locks the entry to mark it as in use. @return false if another program removed the entry before the lock
bool isHeld(int file, int folder, const char* name)
{
    while (::flock(file, LOCK_EX) != 0) {
        if (errno == EINTR) {
            continue;
        }
        return true; // a file system without locks: other programs cannot lock and remove the entry either
    }
    struct stat opened
    {
    };
    struct stat named
    {
    };
    return ::fstat(file, &opened) == 0 && ::fstatat(folder, name, &named, AT_SYMLINK_NOFOLLOW) == 0 &&
           opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

constexpr std::array kEnding{SIGHUP,  SIGINT,  SIGQUIT, SIGILL,  SIGTRAP, SIGABRT, SIGBUS,    SIGFPE,  SIGUSR1, SIGSEGV,
                             SIGUSR2, SIGPIPE, SIGALRM, SIGTERM, SIGXCPU, SIGPOLL, SIGVTALRM, SIGPROF, SIGSYS};

extern "C" void removeScratchAndEnd(int signal)
{
    const pid_t self = ::getpid(); // a child process inherits its parent's slots
    for (const Slot& slot : slots) {
        if (slot.owner.load() == self) {
            removeEntry(slot.folder, slot.name.data());
        }
    }
    (void)std::signal(signal, SIG_DFL);
    (void)::raise(signal); // delivered when the handler returns
}

} // namespace

struct Scratch::Private
{
    Private() = default;
    Private(const Private&) = delete;
    Private& operator=(const Private&) = delete;
    ~Private()
    {
        if (descriptor >= 0) {
            removeEntry(folder, name.data());
            (void)::close(descriptor);
        }
        if (slot != nullptr) {
            slot->owner.store(0);
        }
        if (folder >= 0) {
            (void)::close(folder);
        }
    }

    int make(Kind kind, unsigned mode)
    {
        if (kind == Kind::Folder && ::mkdirat(folder, name.data(), 0700) != 0) {
            return -1;
        }
        return kind == Kind::Folder
                   ? ::openat(folder, name.data(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC)
                   : ::openat(folder, name.data(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
    }

    std::filesystem::path place;
    int folder = -1;
    int descriptor = -1;
    Name name{};
    Slot* slot = nullptr;
};

Scratch::Scratch(std::unique_ptr<Private> d)
    : m_d(std::move(d))
{
}

Scratch::~Scratch() = default;

Result<std::unique_ptr<Scratch>> Scratch::create(const std::filesystem::path& output, Kind kind, unsigned mode)
{
    auto d = std::make_unique<Private>();
    d->place = output.has_parent_path() ? output.parent_path() : ".";
    d->folder = ::open(d->place.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC);
    if (d->folder < 0) {
        return cannotWrite(output, errno);
    }
    removeLeftovers(d->folder);
    for (;;) {
        std::uint64_t random = 0;
        if (::getrandom(&random, sizeof random, 0) != sizeof random) {
            return cannotWrite(output, errno);
        }
        (void)std::snprintf(d->name.data(), d->name.size(), "%s%016llx", kPrefix.data(),
                            static_cast<unsigned long long>(random));
        d->slot = takeSlot(d->folder, d->name); // before creation, so that a signal in between is handled
        d->descriptor = d->make(kind, mode);
        const int error = errno;
        if (d->descriptor >= 0 && isHeld(d->descriptor, d->folder, d->name.data())) {
            return std::unique_ptr<Scratch>(new Scratch(std::move(d)));
        }
        if (d->slot != nullptr) {
            std::exchange(d->slot, nullptr)->owner.store(0);
        }
        if (d->descriptor < 0 && error != EEXIST) {
            return cannotWrite(output, error);
        }
        if (d->descriptor >= 0) {
            (void)::close(std::exchange(d->descriptor, -1));
        }
    }
}

int Scratch::descriptor() const noexcept
{
    return m_d->descriptor;
}

int Scratch::folder() const noexcept
{
    return m_d->folder;
}

const char* Scratch::name() const noexcept
{
    return m_d->name.data();
}

std::filesystem::path Scratch::path() const
{
    return m_d->place / m_d->name.data();
}

int renameWithoutRace(int fromFolder, const char* from, int toFolder, const char* to, ExistingFile old) noexcept
{
    if (old == ExistingFile::Replace) {
        return ::renameat(fromFolder, from, toFolder, to) == 0 ? 0 : errno;
    }
    if (::renameat2(fromFolder, from, toFolder, to, RENAME_NOREPLACE) == 0) {
        return 0;
    }
    if (errno != EINVAL && errno != ENOSYS) {
        return errno;
    }
    // Fallback for file systems without RENAME_NOREPLACE: reserve the name with an empty file first.
    const int claim = ::openat(toFolder, to, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
    if (claim < 0) {
        return errno;
    }
    (void)::close(claim);
    return ::renameat(fromFolder, from, toFolder, to) == 0 ? 0 : errno;
}

void syncFolder(int folder) noexcept
{
    if (const int again = ::openat(folder, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC); again >= 0) {
        (void)::fsync(again);
        (void)::close(again);
    }
}

void removeScratchOnSignals()
{
    struct sigaction action
    {
    };
    struct sigaction before
    {
    };
    action.sa_handler = SIG_IGN;
    (void)::sigaction(SIGXFSZ, &action, nullptr);
    action.sa_handler = removeScratchAndEnd;
    for (const int signal : kEnding) {
        if (::sigaction(signal, nullptr, &before) == 0 && (before.sa_flags & SA_SIGINFO) == 0 &&
            before.sa_handler == SIG_DFL) {
            (void)::sigaction(signal, &action, nullptr);
        }
    }
}

Status cannotWrite(const std::filesystem::path& path, int error)
{
    const bool isFull = error == ENOSPC || error == EDQUOT || error == EFBIG;
    return {isFull            ? StatusCode::NoSpace
            : error == ENOENT ? StatusCode::NotFound
                              : StatusCode::Unreadable,
            PALPATE_TEXT("%1: cannot be written: %2; choose another folder"), path, systemError(error)};
}

} // namespace palpate::core

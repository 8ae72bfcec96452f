// SPDX-License-Identifier: BSD-3-Clause
#include "FaultyDisk.h"

#include <sqlite3.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <new>
#include <thread>

namespace palpate::test {

namespace {

using Kind = FaultyDisk::Operation::Kind;

FaultyDisk* theDisk = nullptr;
sqlite3_vfs* theOrdinary = nullptr;

/// A file of this VFS; the file of the default VFS follows in the same memory.
struct File
{
    sqlite3_file head;
    std::string* name;
    sqlite3_file* real() { return reinterpret_cast<sqlite3_file*>(this + 1); }
};

File& of(sqlite3_file* file)
{
    return *reinterpret_cast<File*>(file);
}

sqlite3_file* real(sqlite3_file* file)
{
    return of(file).real();
}

int closeFile(sqlite3_file* file)
{
    delete of(file).name;
    return real(file)->pMethods->xClose(real(file));
}

int readFile(sqlite3_file* file, void* bytes, int size, sqlite3_int64 offset)
{
    return real(file)->pMethods->xRead(real(file), bytes, size, offset);
}

int writeFile(sqlite3_file* file, const void* bytes, int size, sqlite3_int64 offset)
{
    const int code = theDisk->ask(Kind::Write, *of(file).name, offset, bytes, size);
    return code != 0 ? code : real(file)->pMethods->xWrite(real(file), bytes, size, offset);
}

int truncateFile(sqlite3_file* file, sqlite3_int64 size)
{
    const int code = theDisk->ask(Kind::Truncate, *of(file).name, size, nullptr, 0);
    return code != 0 ? code : real(file)->pMethods->xTruncate(real(file), size);
}

int syncFile(sqlite3_file* file, int)
{
    // No real sync is needed: only simulated power losses occur.
    return theDisk->ask(Kind::Sync, *of(file).name, 0, nullptr, 0);
}

int sizeOfFile(sqlite3_file* file, sqlite3_int64* size)
{
    return real(file)->pMethods->xFileSize(real(file), size);
}

int lockFile(sqlite3_file* file, int level)
{
    return real(file)->pMethods->xLock(real(file), level);
}

int unlockFile(sqlite3_file* file, int level)
{
    return real(file)->pMethods->xUnlock(real(file), level);
}

int checkLock(sqlite3_file* file, int* out)
{
    return real(file)->pMethods->xCheckReservedLock(real(file), out);
}

int controlFile(sqlite3_file* file, int operation, void* argument)
{
    return real(file)->pMethods->xFileControl(real(file), operation, argument);
}

int sectorSize(sqlite3_file* file)
{
    return real(file)->pMethods->xSectorSize(real(file));
}

int characteristics(sqlite3_file* file)
{
    return real(file)->pMethods->xDeviceCharacteristics(real(file));
}

const sqlite3_io_methods kMethods = [] {
    sqlite3_io_methods methods{};
    methods.iVersion = 1;
    methods.xClose = closeFile;
    methods.xRead = readFile;
    methods.xWrite = writeFile;
    methods.xTruncate = truncateFile;
    methods.xSync = syncFile;
    methods.xFileSize = sizeOfFile;
    methods.xLock = lockFile;
    methods.xUnlock = unlockFile;
    methods.xCheckReservedLock = checkLock;
    methods.xFileControl = controlFile;
    methods.xSectorSize = sectorSize;
    methods.xDeviceCharacteristics = characteristics;
    return methods;
}();

std::string nameOf(const char* path)
{
    return path == nullptr ? std::string() : std::filesystem::path(path).filename().string();
}

int openFile(sqlite3_vfs*, const char* path, sqlite3_file* out, int flags, int* outFlags)
{
    File& file = of(out);
    file.head.pMethods = nullptr;
    std::error_code error;
    if ((flags & SQLITE_OPEN_CREATE) != 0 && path != nullptr && !std::filesystem::exists(path, error)) {
        if (const int failed = theDisk->ask(Kind::Create, nameOf(path), 0, nullptr, 0); failed != 0) {
            errno = failed == SQLITE_FULL ? ENOSPC : EIO;
            return SQLITE_CANTOPEN;
        }
    }
    const int code = theOrdinary->xOpen(theOrdinary, path, file.real(), flags, outFlags);
    if (code == SQLITE_OK) {
        file.name = new std::string(nameOf(path));
        file.head.pMethods = &kMethods;
    }
    return code;
}

int deleteFile(sqlite3_vfs*, const char* path, int syncFolder)
{
    const int code = theDisk->ask(Kind::Delete, nameOf(path), 0, nullptr, 0);
    return code != 0 ? code : theOrdinary->xDelete(theOrdinary, path, syncFolder);
}

sqlite3_vfs theLayer; // a copy of the default VFS with two functions replaced

/// Writes bytes into the content of a file.
void put(std::string& content, std::int64_t offset, const std::string& bytes)
{
    const auto end = static_cast<std::size_t>(offset) + bytes.size();
    content.resize(std::max(content.size(), end), '\0');
    content.replace(static_cast<std::size_t>(offset), bytes.size(), bytes);
}

} // namespace

FaultyDisk::FaultyDisk()
{
    theDisk = this;
    theOrdinary = sqlite3_vfs_find(nullptr);
    theLayer = *theOrdinary;
    theLayer.zName = "faulty disk";
    theLayer.szOsFile = static_cast<int>(sizeof(File)) + theOrdinary->szOsFile;
    theLayer.xOpen = openFile;
    theLayer.xDelete = deleteFile;
    sqlite3_vfs_register(&theLayer, 1);
}

FaultyDisk::~FaultyDisk()
{
    sqlite3_vfs_unregister(&theLayer);
    sqlite3_vfs_register(theOrdinary, 1);
    theDisk = nullptr;
}

void FaultyDisk::loseErrno()
{
    theLayer.xGetLastError = [](sqlite3_vfs*, int, char*) { return 0; };
}

void FaultyDisk::mark(std::int64_t number)
{
    if (m_isLogging) {
        m_log.push_back({Operation::Mark, {}, number, {}});
    }
}

std::vector<FaultyDisk::Operation> FaultyDisk::takeLog()
{
    m_isLogging = false;
    return std::move(m_log);
}

void FaultyDisk::failAt(std::int64_t k, bool isLasting, int code)
{
    m_operations = 0;
    m_isLasting = isLasting;
    m_code = code;
    m_failAt = k;
}

void FaultyDisk::hold()
{
    const std::lock_guard lock(m_mutex);
    m_isHeld = true;
}

void FaultyDisk::release()
{
    const std::lock_guard lock(m_mutex);
    m_isHeld = false;
    m_released.notify_all();
}

int FaultyDisk::ask(Operation::Kind kind, const std::string& file, std::int64_t offset, const void* bytes, int size)
{
    {
        std::unique_lock lock(m_mutex);
        m_released.wait(lock, [this] { return !m_isHeld; });
    }
    if (kind == Kind::Write) {
        std::this_thread::sleep_for(std::chrono::milliseconds(m_delay_ms));
    }
    const std::int64_t number = m_operations++;
    const std::int64_t failAt = m_failAt;
    if (failAt >= 0 && (m_isLasting ? number >= failAt : number == failAt)) {
        return m_code;
    }
    if (m_isLogging) {
        m_log.push_back({kind, file, offset,
                         bytes == nullptr
                             ? std::string()
                             : std::string(static_cast<const char*>(bytes), static_cast<std::size_t>(size))});
    }
    return 0;
}

namespace {

/// The history of a name from creation to deletion, with the order of creations and deletions.
struct Incarnation
{
    std::string synced;
    std::vector<FaultyDisk::Operation> pending; // writes and truncations
    bool isDeleted = false;
};
struct Name
{
    std::vector<Incarnation> lives;
    std::size_t onDisk = 0; // persistent directory entries: creations and deletions in order
    [[nodiscard]] std::size_t entries() const
    {
        return 2 * lives.size() - (lives.empty() || lives.back().isDeleted ? 0 : 1);
    }
};

void redo(std::string& content, const FaultyDisk::Operation& operation)
{
    if (operation.kind == Kind::Write) {
        put(content, operation.offset, operation.bytes);
    } else {
        content.resize(static_cast<std::size_t>(operation.offset), '\0');
    }
}

} // namespace

DiskState afterPowerLoss(const DiskState& before, const std::vector<FaultyDisk::Operation>& log, std::size_t end,
                         std::uint32_t seed)
{
    constexpr std::uint32_t kNothing = 0;
    constexpr std::uint32_t kEverything = 1;
    constexpr std::size_t kSector = 512;
    std::map<std::string, Name> names;
    for (const auto& [name, bytes] : before) {
        names[name].lives.push_back({bytes, {}, false});
        names[name].onDisk = 1;
    }
    for (std::size_t i = 0; i < end; ++i) {
        const FaultyDisk::Operation& operation = log[i];
        if (operation.kind == Kind::Mark) {
            continue;
        }
        Name& name = names[operation.file];
        if (operation.kind == Kind::Create) {
            name.lives.emplace_back();
        } else if (operation.kind == Kind::Delete) {
            name.lives.back().isDeleted = true;
        } else if (operation.kind == Kind::Sync) {
            Incarnation& file = name.lives.back();
            for (const auto& one : file.pending) {
                redo(file.synced, one);
            }
            file.pending.clear();
            if (operation.file.ends_with("-journal")) { // SQLite also syncs the folder of a new journal
                for (auto& [any, one] : names) {
                    one.onDisk = one.entries();
                }
            }
        } else {
            name.lives.back().pending.push_back(operation);
        }
    }
    std::uint32_t state = seed * 2654435761u + static_cast<std::uint32_t>(end);
    const auto toss = [&state] {
        state = state * 1664525u + 1013904223u;
        return state >> 16;
    };
    DiskState out;
    for (auto& [text, name] : names) {
        std::size_t entries = seed == kEverything ? name.entries() : name.onDisk;
        if (seed > kEverything) {
            entries += toss() % (name.entries() - name.onDisk + 1);
        }
        if (entries % 2 == 0) {
            continue; // missing or deleted
        }
        Incarnation& file = name.lives[entries / 2];
        for (FaultyDisk::Operation operation : file.pending) {
            const bool isKept = seed == kEverything || (seed != kNothing && toss() % 2 == 0);
            if (!isKept) {
                continue;
            }
            if (operation.kind == Kind::Write && seed != kEverything && toss() % 2 == 0) {
                operation.bytes.resize(std::min(operation.bytes.size(), kSector * (toss() % 8)));
            }
            redo(file.synced, operation);
        }
        out[text] = std::move(file.synced);
    }
    return out;
}

} // namespace palpate::test

// SPDX-License-Identifier: BSD-3-Clause
#include "database/ReadOnlyVfs.h"

#include "database/Database.h"

#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstring>
#include <new>
#include <string_view>
#include <unordered_map>

namespace palpate::session::internal {

namespace {

constexpr sqlite3_int64 kSector = 512; // SQLite writes whole pages, which are at least this large
/// Limit for rolled-back pages in memory. A transaction of the recorder changes a few pages of 4 kB per quarter of a
/// second.
constexpr std::size_t kMostSectors = (std::size_t{256} << 20U) / std::size_t{kSector};

/// Overlay of written sectors over the file.
class WrittenSectors
{
  public:
    [[nodiscard]] bool isEmpty() const noexcept { return !m_isActive; }
    [[nodiscard]] sqlite3_int64 size() const noexcept { return m_size; }

    /// Activates the overlay and sets the initial file size.
    void begin(sqlite3_int64 fileSize)
    {
        if (!m_isActive) {
            m_isActive = true;
            m_size = m_fileEnd = fileSize;
        }
    }

    int write(const char* bytes, int size, sqlite3_int64 offset)
    {
        const sqlite3_int64 sectors = size / kSector;
        if (offset % kSector != 0 || size % kSector != 0 ||
            m_sectors.size() + static_cast<std::size_t>(sectors) > kMostSectors) {
            return SQLITE_IOERR_WRITE;
        }
        for (sqlite3_int64 i = 0; i < sectors; ++i) {
            std::memcpy(m_sectors[offset / kSector + i].data(), bytes + i * kSector, kSector);
        }
        m_size = std::max(m_size, offset + size);
        return SQLITE_OK;
    }

    void truncate(sqlite3_int64 size)
    {
        m_size = size;
        m_fileEnd = std::min(m_fileEnd, size);
        std::erase_if(m_sectors, [size](const auto& sector) { return sector.first * kSector >= size; });
    }

    /// Reads the file up to its logical end, then applies the overlay.
    int read(sqlite3_file* file, char* out, int size, sqlite3_int64 offset) const
    {
        std::memset(out, 0, static_cast<std::size_t>(size));
        const sqlite3_int64 inFile = std::clamp<sqlite3_int64>(m_fileEnd - offset, 0, size);
        if (inFile > 0) {
            const int code = file->pMethods->xRead(file, out, static_cast<int>(inFile), offset);
            if (code != SQLITE_OK && code != SQLITE_IOERR_SHORT_READ) {
                return code;
            }
        }
        for (sqlite3_int64 sector = offset / kSector; sector * kSector < offset + size; ++sector) {
            if (const auto found = m_sectors.find(sector); found != m_sectors.end()) {
                const sqlite3_int64 from = std::max(offset, sector * kSector);
                const sqlite3_int64 to = std::min(offset + size, (sector + 1) * kSector);
                std::memcpy(out + (from - offset), found->second.data() + (from - sector * kSector),
                            static_cast<std::size_t>(to - from));
            }
        }
        return offset + size <= m_size ? SQLITE_OK : SQLITE_IOERR_SHORT_READ;
    }

  private:
    bool m_isActive = false;
    sqlite3_int64 m_size = 0;
    sqlite3_int64 m_fileEnd = 0; ///< file content beyond was truncated
    std::unordered_map<sqlite3_int64, std::array<char, kSector>> m_sectors;
};

} // namespace

struct ReadOnlyVfs::Private
{
    sqlite3_vfs layer{};
    sqlite3_vfs* below = nullptr;
    std::string name;
    std::string path; ///< of the database
    core::Message refusal;
    bool isJournalGone = false; ///< rolled back by SQLite
    WrittenSectors written;

    [[nodiscard]] std::string journal() const { return path + "-journal"; }
    void refuseToOpen(const char* file)
    {
        const core::Message what = file == nullptr ? core::Message(PALPATE_TEXT("a temporary file"))
                                                   : core::Message::untranslated(oneLine(file));
        refusal =
            core::Message(PALPATE_TEXT("it asks to open %1, expected nothing but the recording and its journal"), what);
    }
    void refuseToDelete(const char* file)
    {
        refusal = core::Message(
            PALPATE_TEXT("it asks to delete %1, expected nothing but the recording and its journal"), oneLine(file));
    }
};

namespace {

/// File object for SQLite, followed in memory by the object of the underlying VFS.
struct LayeredFile
{
    sqlite3_file head;
    ReadOnlyVfs::Private* owner;
    bool isDatabase;
    sqlite3_file* below() { return reinterpret_cast<sqlite3_file*>(this + 1); }
};
static_assert(sizeof(LayeredFile) % alignof(std::max_align_t) == 0 || sizeof(LayeredFile) % alignof(void*) == 0);

LayeredFile& layered(sqlite3_file* file)
{
    return *reinterpret_cast<LayeredFile*>(file);
}

sqlite3_file* belowOf(sqlite3_file* file)
{
    return layered(file).below();
}

bool isOverlaid(sqlite3_file* file)
{
    return layered(file).isDatabase && !layered(file).owner->written.isEmpty();
}

/// Activates the overlay. From now on, the underlying file must not change.
int beginWriting(sqlite3_file* file)
{
    sqlite3_int64 size = 0;
    const int code = belowOf(file)->pMethods->xFileSize(belowOf(file), &size);
    if (code == SQLITE_OK) {
        layered(file).owner->written.begin(size);
    }
    return code;
}

int closeLayered(sqlite3_file* file)
{
    return belowOf(file)->pMethods->xClose(belowOf(file));
}

int readLayered(sqlite3_file* file, void* out, int size, sqlite3_int64 offset)
{
    return isOverlaid(file) ? layered(file).owner->written.read(belowOf(file), static_cast<char*>(out), size, offset)
                            : belowOf(file)->pMethods->xRead(belowOf(file), out, size, offset);
}

int writeLayered(sqlite3_file* file, const void* bytes, int size, sqlite3_int64 offset)
{
    if (!layered(file).isDatabase) {
        return SQLITE_IOERR_WRITE;
    }
    int code = beginWriting(file);
    if (code == SQLITE_OK) {
        code = layered(file).owner->written.write(static_cast<const char*>(bytes), size, offset);
    }
    if (code == SQLITE_IOERR_WRITE) {
        layered(file).owner->refusal =
            core::Message(PALPATE_TEXT("its journal holds more than a recorder changes at a time"));
    }
    return code;
}

int truncateLayered(sqlite3_file* file, sqlite3_int64 size)
{
    if (!layered(file).isDatabase) {
        return SQLITE_IOERR_TRUNCATE;
    }
    const int code = beginWriting(file);
    if (code == SQLITE_OK) {
        layered(file).owner->written.truncate(size);
    }
    return code;
}

int syncLayered(sqlite3_file*, int)
{
    return SQLITE_OK;
}

int sizeOfLayered(sqlite3_file* file, sqlite3_int64* size)
{
    if (isOverlaid(file)) {
        *size = layered(file).owner->written.size();
        return SQLITE_OK;
    }
    return belowOf(file)->pMethods->xFileSize(belowOf(file), size);
}

/// Takes at most a shared lock. To other processes, this connection is a reader, although SQLite believes that it
/// writes.
int lockLayered(sqlite3_file* file, int level)
{
    return belowOf(file)->pMethods->xLock(belowOf(file), std::min(level, SQLITE_LOCK_SHARED));
}

int unlockLayered(sqlite3_file* file, int level)
{
    return isOverlaid(file) ? SQLITE_OK : belowOf(file)->pMethods->xUnlock(belowOf(file), level);
}

int checkLayeredLock(sqlite3_file* file, int* out)
{
    return belowOf(file)->pMethods->xCheckReservedLock(belowOf(file), out);
}

int controlLayered(sqlite3_file* file, int operation, void* argument)
{
    return operation == SQLITE_FCNTL_LAST_ERRNO
               ? belowOf(file)->pMethods->xFileControl(belowOf(file), operation, argument)
               : SQLITE_NOTFOUND;
}

int layeredSectorSize(sqlite3_file* file)
{
    return belowOf(file)->pMethods->xSectorSize(belowOf(file));
}

int layeredCharacteristics(sqlite3_file*)
{
    return 0;
}

/// Version 1 of the methods: no shared memory, which a write-ahead log would need, and no memory mapping.
const sqlite3_io_methods kLayeredMethods = [] {
    sqlite3_io_methods methods{};
    methods.iVersion = 1;
    methods.xClose = closeLayered;
    methods.xRead = readLayered;
    methods.xWrite = writeLayered;
    methods.xTruncate = truncateLayered;
    methods.xSync = syncLayered;
    methods.xFileSize = sizeOfLayered;
    methods.xLock = lockLayered;
    methods.xUnlock = unlockLayered;
    methods.xCheckReservedLock = checkLayeredLock;
    methods.xFileControl = controlLayered;
    methods.xSectorSize = layeredSectorSize;
    methods.xDeviceCharacteristics = layeredCharacteristics;
    return methods;
}();

ReadOnlyVfs::Private& ownerOf(sqlite3_vfs* layer)
{
    return *static_cast<ReadOnlyVfs::Private*>(layer->pAppData);
}

int openLayered(sqlite3_vfs* layer, const char* path, sqlite3_file* out, int flags, int* outFlags)
{
    ReadOnlyVfs::Private& d = ownerOf(layer);
    LayeredFile& file = layered(out);
    file.head.pMethods = nullptr;
    const bool isDatabase = (flags & SQLITE_OPEN_MAIN_DB) != 0 && path != nullptr;
    const bool isJournal = (flags & SQLITE_OPEN_MAIN_JOURNAL) != 0 && path != nullptr && path == d.journal();
    if (!isJournal && !(isDatabase && (d.path.empty() || path == d.path))) {
        d.refuseToOpen(path);
        return SQLITE_CANTOPEN;
    }
    if (isJournal && d.isJournalGone) {
        return SQLITE_CANTOPEN;
    }
    if (isDatabase) {
        d.path = path;
    }
    const int kind = flags & (SQLITE_OPEN_MAIN_DB | SQLITE_OPEN_MAIN_JOURNAL);
    const int code = d.below->xOpen(d.below, path, file.below(), kind | SQLITE_OPEN_READONLY, nullptr);
    if (code == SQLITE_OK) {
        file.owner = &d;
        file.isDatabase = isDatabase;
        file.head.pMethods = &kLayeredMethods;
        if (outFlags != nullptr) {
            *outFlags = flags; // reported as writable, because SQLite rolls back journals only for writable files
        }
    }
    return code;
}

int deleteLayered(sqlite3_vfs* layer, const char* path, int)
{
    ReadOnlyVfs::Private& d = ownerOf(layer);
    if (path != d.journal()) {
        d.refuseToDelete(path);
        return SQLITE_IOERR_DELETE;
    }
    d.isJournalGone = true;
    return SQLITE_OK;
}

int accessLayered(sqlite3_vfs* layer, const char* path, int flags, int* out)
{
    ReadOnlyVfs::Private& d = ownerOf(layer);
    *out = 0;
    if (path == d.journal() && !d.isJournalGone) {
        return d.below->xAccess(d.below, path, flags, out);
    }
    return SQLITE_OK; // all other files appear to be missing
}

int fullPathLayered(sqlite3_vfs* layer, const char* path, int size, char* out)
{
    ReadOnlyVfs::Private& d = ownerOf(layer);
    return d.below->xFullPathname(d.below, path, size, out);
}

} // namespace

ReadOnlyVfs::ReadOnlyVfs()
    : m_d(std::make_unique<Private>())
{
    static std::atomic<unsigned> count{0};
    m_d->below = sqlite3_vfs_find(nullptr);
    m_d->name = "palpate read-only " + std::to_string(count++);
    m_d->layer = *m_d->below;
    m_d->layer.iVersion = std::min(m_d->below->iVersion, 2); // excludes the replacement of system calls
    m_d->layer.zName = m_d->name.c_str();
    m_d->layer.pAppData = m_d.get();
    m_d->layer.szOsFile = static_cast<int>(sizeof(LayeredFile)) + m_d->below->szOsFile;
    m_d->layer.xOpen = openLayered;
    m_d->layer.xDelete = deleteLayered;
    m_d->layer.xAccess = accessLayered;
    m_d->layer.xFullPathname = fullPathLayered;
    m_d->layer.xDlOpen = nullptr;
    sqlite3_vfs_register(&m_d->layer, 0);
}

ReadOnlyVfs::~ReadOnlyVfs()
{
    sqlite3_vfs_unregister(&m_d->layer);
}

const char* ReadOnlyVfs::name() const noexcept
{
    return m_d->name.c_str();
}

const core::Message& ReadOnlyVfs::refusal() const noexcept
{
    return m_d->refusal;
}

} // namespace palpate::session::internal

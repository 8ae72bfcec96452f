// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/MotionFile.h"
#include "palpate/session/Recording.h"

#include <palpate/core/Export.h>
#include <palpate/core/Status.h>
#include <palpate/servo/TickRecord.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::session {

/// Reason why a recording ends.
enum class RecordingEnd : std::uint8_t
{
    Closed,     ///< closed by the recording program
    DiskFull,   ///< disk full: later ticks are missing
    DiskFailed, ///< another write error
    CutOff      ///< not closed, after a crash or when the disk could not even store the reason
};

/// Size and completeness of a recording.
struct RecordingExtent
{
    std::int64_t firstTick = 0;
    std::int64_t lastTick = -1; ///< < firstTick: no ticks
    std::int64_t ticks = 0;     ///< number of rows
    std::int64_t dropped = 0;   ///< ticks missing between first and last
    double duration_s = 0.0;
    bool isComplete = false; ///< closed by the writer without missing data
    RecordingEnd end = RecordingEnd::CutOff;
    std::optional<std::int64_t> late; ///< periods skipped by the servo; empty if unknown
};

/// Describes the end of a recording in one clause, such as "complete" or "ended at 8.7 s because the disk was full;
/// what was felt after is not in it".
[[nodiscard]] PALPATE_EXPORT core::Message endingText(const RecordingExtent& extent);

/// Reads a recording from an untrusted source. Opens quickly and never loads the whole file: rows are streamed, and
/// each block of ticks (a quarter of a second) is verified against the checksum before use. Never writes to the file or
/// its folder.
/// @par Thread One thread at a time. Several readers may be open on one file.
class PALPATE_EXPORT RecordingReader
{
  public:
    /// Opens a recording. After a crash, the last incomplete transaction is rolled back in memory.
    /// @return a one-line error if the file is missing, not a recording, damaged or of a newer version; BadFormat if
    ///         tables or numbers cannot have been written by Palpate
    [[nodiscard]] static core::Result<std::unique_ptr<RecordingReader>> open(const std::filesystem::path& path);
    ~RecordingReader();
    RecordingReader(const RecordingReader&) = delete;
    RecordingReader& operator=(const RecordingReader&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const noexcept;
    [[nodiscard]] const RecordingInfo& info() const noexcept;
    [[nodiscard]] const RecordingExtent& extent() const noexcept;
    [[nodiscard]] const std::vector<SceneRecord>& scenes() const noexcept;    ///< by generation, ascending
    [[nodiscard]] const std::vector<RecordingEvent>& events() const noexcept; ///< by tick, ascending
    /// Returns the scene of a generation, or null if the recording does not describe that generation.
    [[nodiscard]] const SceneRecord* scene(std::uint32_t generation) const noexcept;
    /// Returns the name of a structure from the scene generation and the index, empty if unknown. Valid for the
    /// lifetime of the reader.
    [[nodiscard]] std::string_view structureName(std::uint32_t generation, std::uint32_t number) const noexcept;
    /// Returns the name of the structure in contact, empty in free space.
    [[nodiscard]] std::string structureName(const servo::TickRecord& tick) const;

    /// Passes the ticks first … last in order to `sink` until `sink` returns false. `time_ns` counts from the first
    /// tick. Blocks with a failed checksum are skipped and listed by `faults`. All numbers are finite. Recordings
    /// before version 3 contain neither layers nor normals. For these, a tick has a single contact with the total
    /// force, and the direction of the spring as normal.
    core::Status forEach(std::int64_t first, std::int64_t last,
                         const std::function<bool(const servo::TickRecord&)>& sink) const;
    /// Returns the part of the recording before a tick, 0 to 1.
    [[nodiscard]] double shareBefore(std::int64_t tick) const noexcept;
    /// Returns the latest intact tick at or before `tick`; nothing before the first tick or after a read error.
    [[nodiscard]] std::optional<servo::TickRecord> at(std::int64_t tick) const;
    /// Returns one line for each damaged part found so far ("ticks 250 to 499: found other bits than were written
    /// (checksum)"). Opening checks metadata, scenes, events and the last block; every requested block of ticks is
    /// checked when read.
    [[nodiscard]] std::vector<core::Message> faults() const;

    /// Reads the path of the HIP with one sample per tick with a hand present. Needs 24 bytes of memory per tick.
    [[nodiscard]] core::Result<Motion> motion() const;
    /// Returns the hashes of the embedded surfaces.
    [[nodiscard]] std::vector<std::string> embeddedHashes() const;
    /// Reads an embedded surface. @param sha256  geometryHash as in StructureSource::sha256
    [[nodiscard]] core::Result<geometry::RepairedMesh> embedded(const std::string& sha256) const;
    /// Verifies all checksums and the database.
    /// @param progress  progress callback (0 to 1). Return false to cancel. May be empty
    /// @return Mismatch with the first damaged part, such as a range of ticks; Cancelled
    [[nodiscard]] core::Status verify(const std::function<bool(double)>& progress = {}) const;

  private:
    struct Private;
    explicit RecordingReader(std::unique_ptr<Private> d);
    std::unique_ptr<Private> m_d;
};

/// Returns true if the file starts like a SQLite database, which distinguishes a recording from a CSV file.
[[nodiscard]] PALPATE_EXPORT bool isRecordingFile(const std::filesystem::path& path);
/// Returns true for a file to open as a recording: by its content, or by the extension ".palpate" in any case. The
/// first bytes of a damaged recording may be lost; `RecordingReader::open` then names the recovery.
[[nodiscard]] PALPATE_EXPORT bool isRecordingByNameOrContent(const std::filesystem::path& path);

} // namespace palpate::session

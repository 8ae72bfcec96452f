// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/MotionFile.h"
#include "palpate/session/Recording.h"

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

/// Why a recording ends where it does.
enum class RecordingEnd : std::uint8_t
{
    Closed,     ///< ended by the program that recorded it
    DiskFull,   ///< the disk was full: what was felt after is not in it
    DiskFailed, ///< the disk could not be written for another reason
    CutOff      ///< it was not closed: a crash, or a disk that took not even the reason
};

/// How much a recording holds.
struct RecordingExtent
{
    std::int64_t firstTick = 0;
    std::int64_t lastTick = -1; ///< < firstTick: no tick
    std::int64_t ticks = 0;     ///< rows
    std::int64_t dropped = 0;   ///< ticks missing between first and last
    double duration_s = 0.0;
    bool isComplete = false; ///< closed by its writer when all was in it
    RecordingEnd end = RecordingEnd::CutOff;
    std::optional<std::int64_t> late; ///< periods that the servo left out meanwhile; nothing: it is not said
};

/// How a recording ended, as one clause: "complete", "ended at 8.7 s because the disk was full; what was felt after is
/// not in it".
[[nodiscard]] std::string endingText(const RecordingExtent& extent);

/// Reads a recording, which anyone may have made. Opens fast and never holds the whole file: rows are streamed, each
/// block of ticks (a quarter of a second) once it has been held against its checksum. Nothing is written, to the file
/// or beside it.
/// @par Thread One at a time; several readers may be open on one file.
class RecordingReader
{
  public:
    /// @return one line for a file that is missing, not a recording, damaged, or of a newer version; BadFormat for one
    ///         whose tables or numbers are none of Palpate's. Of a recording that was cut off by a crash the last
    ///         transaction is rolled back, in memory.
    [[nodiscard]] static core::Result<std::unique_ptr<RecordingReader>> open(const std::filesystem::path& path);
    ~RecordingReader();
    RecordingReader(const RecordingReader&) = delete;
    RecordingReader& operator=(const RecordingReader&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const noexcept;
    [[nodiscard]] const RecordingInfo& info() const noexcept;
    [[nodiscard]] const RecordingExtent& extent() const noexcept;
    [[nodiscard]] const std::vector<SceneRecord>& scenes() const noexcept;    ///< by generation, ascending
    [[nodiscard]] const std::vector<RecordingEvent>& events() const noexcept; ///< by tick
    /// @return the scene of a generation, null when it was not described.
    [[nodiscard]] const SceneRecord* scene(std::uint32_t generation) const noexcept;
    /// @return name of a structure by its number in the scene of a generation, empty when it was not described; valid
    /// as long as the reader.
    [[nodiscard]] std::string_view structureName(std::uint32_t generation, std::uint32_t number) const noexcept;
    /// @return name of the structure that a tick touches, empty in free space.
    [[nodiscard]] std::string structureName(const servo::TickRecord& tick) const;

    /// Gives the ticks first … last in order, until `sink` returns false. `time_ns` counts from the first tick. Blocks
    /// that are not as they were written are left out; `faults` names them. All numbers are finite.
    /// Recordings before version 3 held no layers and no normal: what comes is one contact with all of the force, and
    /// the direction of the spring.
    core::Status forEach(std::int64_t first, std::int64_t last,
                         const std::function<bool(const servo::TickRecord&)>& sink) const;
    /// @return the newest tick at or before `tick` that is as it was written, nothing before the first one or when the
    ///         file cannot be read.
    [[nodiscard]] std::optional<servo::TickRecord> at(std::int64_t tick) const;
    /// @return what is not as it was written in what was read so far, a line each ("ticks 250 to 499: found other bits
    ///         than were written (checksum)"): after opening metadata, scenes, events and the last block, later also
    ///         each block of ticks that was asked for.
    [[nodiscard]] std::vector<std::string> faults() const;

    /// Reads the path of the HIP, one sample a tick at which there was a hand: 24 bytes a tick in memory.
    [[nodiscard]] core::Result<Motion> motion() const;
    /// @return hashes of the surfaces that the recording holds itself.
    [[nodiscard]] std::vector<std::string> embeddedHashes() const;
    /// Gives a surface that the recording holds itself. @param sha256  its geometryHash, as a scene's source says it
    [[nodiscard]] core::Result<geometry::RepairedMesh> embedded(const std::string& sha256) const;
    /// Checks every checksum and the database. @return Mismatch naming the first part that is not as written, such as
    ///         a range of ticks
    [[nodiscard]] core::Status verify() const;

  private:
    struct Private;
    explicit RecordingReader(std::unique_ptr<Private> d);
    std::unique_ptr<Private> m_d;
};

/// @return true when the file starts as a SQLite database: a recording rather than a CSV.
[[nodiscard]] bool isRecordingFile(const std::filesystem::path& path);

} // namespace palpate::session

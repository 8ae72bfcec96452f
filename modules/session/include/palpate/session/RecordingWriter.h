// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/Recording.h"

#include <palpate/core/Export.h>
#include <palpate/core/Scratch.h>
#include <palpate/core/Status.h>
#include <palpate/servo/TickRecord.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace palpate::session {

/// Writes a recording (`*.palpate`); the format is documented in docs/recording.md. The file is a valid
/// prefix of the recording at any time: it contains only complete transactions, each with a quarter of a second of
/// ticks and their checksum.
/// @par Thread One thread at a time, never the servo thread: writing blocks on the disk.
class PALPATE_EXPORT RecordingWriter
{
  public:
    /// When to wait for the disk.
    enum class Sync
    {
        EachCommit, ///< after each commit: committed data survives a power loss; for real-time recording
        AtEnd,      ///< only in `finish`: survives a killed process, not a power loss; for fast writing
    };

    /// Source of the events.
    enum class Events
    {
        Derived, ///< scene changes and clutch events are derived from the ticks, in addition to added events
        AsGiven, ///< only added events: for copies
    };
    enum class Ending
    {
        Complete, ///< the session ended here
        CutOff,   ///< the session continued, but the rest is missing
    };

    /// Creates the file with the schema and `info` and locks the file against other writers. There must be no adjacent
    /// file that SQLite would treat as part of the database (-journal, -wal, -shm).
    /// @param old  Refuse: fails if the name exists; the file has its final name immediately. Replace: writes a
    ///             temporary file that `finish` renames, so that an older file stays unchanged until then. A file that
    ///             another program is recording into is never replaced.
    /// @return a one-line error with the file name if the file cannot be written
    [[nodiscard]] static core::Result<std::unique_ptr<RecordingWriter>>
    create(const std::filesystem::path& path, const RecordingInfo& info, Sync sync = Sync::EachCommit,
           Events events = Events::Derived, core::ExistingFile old = core::ExistingFile::Refuse);
    ~RecordingWriter(); ///< commits the remaining data
    RecordingWriter(const RecordingWriter&) = delete;
    RecordingWriter& operator=(const RecordingWriter&) = delete;

    /// Adds a tick. Tick numbers must ascend. Commits after each quarter of a second of ticks.
    /// @return the disk error. The tick is kept and written with the next successful commit, for up to one minute of
    ///         ticks. Later ticks are dropped and counted, and the next stored tick carries `kDroppedBefore`.
    core::Status append(const servo::TickRecord& tick);
    /// Describes a scene generation. Call once per generation, before or after the first tick. Also stores the surfaces
    /// to embed.
    core::Status addScene(const SceneRecord& scene);
    core::Status addEvent(const RecordingEvent& event);
    /// Commits the transaction, so that all data added so far survives a crash. @return the disk error; no data is lost
    core::Status commit();
    /// Commits, waits for the disk and closes the file. Can be repeated after an error. Nothing may be added after
    /// success.
    core::Status finish(Ending ending = Ending::Complete);
    /// Removes the file instead, unless another file has taken the name.
    void discard();
    /// Closes a recording when the disk accepts no more data. Releases the reserved space, then stores the uncommitted
    /// data and an event with the reason. If the space is too small for both, only the events are stored and the ticks
    /// are lost. Call at most once; nothing may be added afterwards.
    /// @param why  event with the reason; its tick is set to the last stored tick
    /// @return the disk error if not even the events could be stored
    core::Status abandon(RecordingEvent why);

    [[nodiscard]] std::int64_t ticksWritten() const noexcept;  ///< committed or pending
    [[nodiscard]] std::uint64_t ticksDropped() const noexcept; ///< lost because the disk accepted no data for too long
    /// Time stamp of the newest committed tick [ns], on the clock of the ticks; empty before the first commit.
    [[nodiscard]] std::optional<std::int64_t> newestStored_ns() const noexcept;

  private:
    struct Private;
    explicit RecordingWriter(std::unique_ptr<Private> d);
    std::unique_ptr<Private> m_d;
};

} // namespace palpate::session

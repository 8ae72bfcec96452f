// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/Recording.h"

#include <palpate/core/Scratch.h>
#include <palpate/core/Status.h>
#include <palpate/servo/TickRecord.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace palpate::session {

/// Writes a recording (`*.palpate`), as resources/docs/recording.md says. At every moment the file is a clean prefix:
/// only whole transactions, each of a quarter of a second of ticks with its checksum.
/// @par Thread One at a time, never the servo thread: it waits for the disk.
class RecordingWriter
{
  public:
    /// What a commit waits for.
    enum class Sync
    {
        EachCommit, ///< the disk: what was committed survives a power loss; for recording in real time
        AtEnd,      ///< nothing until `finish`: survives a killed program only; for writing as fast as possible
    };

    /// Where events come from.
    enum class Events
    {
        Derived, ///< change of scene and clutch are told from the ticks, beside those that are added
        AsGiven, ///< only those that are added: for a copy
    };
    enum class Ending
    {
        Complete, ///< the session ended here
        CutOff,   ///< it went on, but this is all there is
    };

    /// Makes the file with its schema and `info`, and holds a lock on it: no two writers have one file. Beside it there
    /// must be no file that SQLite would take for a part of it (-journal, -wal, -shm).
    /// @param old  Refuse: there must be nothing of this name, and the file has it from now on. Replace: written
    /// beside;
    ///             `finish` gives it the name, until then an older file stays as it is. A file that another program is
    ///             recording into is refused.
    /// @return one line that names the file when it cannot be written
    [[nodiscard]] static core::Result<std::unique_ptr<RecordingWriter>>
    create(const std::filesystem::path& path, const RecordingInfo& info, Sync sync = Sync::EachCommit,
           Events events = Events::Derived, core::OldFile old = core::OldFile::Refuse);
    ~RecordingWriter(); ///< commits what is left
    RecordingWriter(const RecordingWriter&) = delete;
    RecordingWriter& operator=(const RecordingWriter&) = delete;

    /// Adds a tick; ticks ascend. Commits each quarter of a second of ticks.
    /// @return the disk's error. The tick is kept and written by the next commit that succeeds, up to a minute of
    ///         ticks; after that it is lost and counted, and the next one carries `kDroppedBefore`.
    core::Status append(const servo::TickRecord& tick);
    /// Describes a scene generation, once; before or after its first tick. Surfaces to be embedded go in with it.
    core::Status addScene(const SceneRecord& scene);
    core::Status addEvent(const RecordingEvent& event);
    /// Ends the transaction: what was added until now survives a crash. @return the disk's error; nothing is lost by it
    core::Status commit();
    /// Commits, waits for the disk and closes the file. After an error it may be tried again; after it nothing may be
    /// added.
    core::Status finish(Ending ending = Ending::Complete);
    /// Removes the file instead, where it is still the one that was made.
    void discard();
    /// Ends a recording that the disk takes no more of: gives up the room that was kept for this, then stores what is
    /// not yet committed and an event that says why it ends; where there is no room for all of that, events alone, and
    /// the ticks are lost. Once; nothing may be added after it.
    /// @param why  its tick becomes that of the last tick that is stored
    /// @return the disk's error when not even the events could be stored
    core::Status abandon(RecordingEvent why);

    [[nodiscard]] std::int64_t ticksWritten() const noexcept;  ///< committed or about to be
    [[nodiscard]] std::uint64_t ticksDropped() const noexcept; ///< lost because the disk took nothing for too long
    /// Time of the newest tick that is committed, as ticks have it; nothing before the first. [ns]
    [[nodiscard]] std::optional<std::int64_t> newestStored_ns() const noexcept;

  private:
    struct Private;
    explicit RecordingWriter(std::unique_ptr<Private> d);
    std::unique_ptr<Private> m_d;
};

} // namespace palpate::session

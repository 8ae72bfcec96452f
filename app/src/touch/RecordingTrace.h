// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QLockFile>

#include <filesystem>
#include <memory>
#include <optional>

namespace palpate::app {

/// Note on disk of the recording that runs. A regular end deletes it, so that a note without a running program belongs
/// to a recording that a crash cut off.
/// @par Thread GUI thread only.
class RecordingTrace
{
  public:
    RecordingTrace() = default;
    ~RecordingTrace() { end(); }
    RecordingTrace(const RecordingTrace&) = delete;
    RecordingTrace& operator=(const RecordingTrace&) = delete;

    /// Notes a recording that has begun. Without a writable folder there is no note.
    void begin(const std::filesystem::path& recording);
    /// Deletes the note.
    void end();

    /// A recording that was cut off.
    struct Left
    {
        std::filesystem::path note, recording;
    };
    /// Finds the newest recording that was cut off and still exists. Notes of others are deleted.
    [[nodiscard]] static std::optional<Left> findLeft();
    /// Deletes a note, so that the recording is not found again.
    static void discard(const Left& left);

  private:
    std::filesystem::path m_note;
    std::unique_ptr<QLockFile> m_lock; ///< held while the recording runs
};

} // namespace palpate::app

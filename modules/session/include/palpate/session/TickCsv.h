// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/AtomicFile.h"
#include "palpate/session/Recording.h"
#include "palpate/session/StructureNames.h"

#include <palpate/servo/TickRecord.h>

#include <filesystem>
#include <span>
#include <string>

namespace palpate::session {

/// Writes ticks as CSV, the columns of session/src/TickColumns.h; with 17 significant digits, which give the same
/// doubles back. Atomic as core::AtomicFile is.
class TickCsv
{
  public:
    /// What the rows tell.
    enum class Rows
    {
        Ticks,  ///< what was computed
        Device, ///< and the force that a device was given
        Session ///< with time, sent force, depth and events; cells of a tick without a hand are empty
    };
    [[nodiscard]] static core::Result<TickCsv> create(const std::filesystem::path& path, Rows rows = Rows::Ticks);
    /// @param tick    of Rows::Session: `time_ns` counts from the recording's first tick
    /// @param events  of this tick, for Rows::Session
    void write(const servo::TickRecord& tick, const StructureNames& names, std::span<const RecordingEvent> events = {});
    [[nodiscard]] core::Status finish();

  private:
    TickCsv(core::AtomicFile file, Rows rows);

    core::AtomicFile m_file;
    Rows m_rows = Rows::Ticks;
    std::string m_line;
};

} // namespace palpate::session

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/core/AtomicFile.h"
#include "palpate/session/Recording.h"
#include "palpate/session/StructureNames.h"

#include <palpate/core/Export.h>
#include <palpate/haptics/TickResult.h>
#include <palpate/servo/TickRecord.h>

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace palpate::session {

/// Returns the text of the column `layers`: `name=force_N=depth_mm` for each structure in contact, see
/// docs/recording.md.
[[nodiscard]] PALPATE_EXPORT std::string layersText(const haptics::TickResult& felt, const StructureNames& names);

/// Returns the text of the column `events`: `kind` or `kind=subject` for each event.
[[nodiscard]] PALPATE_EXPORT std::string eventsText(std::span<const RecordingEvent> events);

/// Writes ticks as CSV with the columns of docs/recording.md, "As CSV". Numbers have 17 significant digits and read
/// back bit-exactly. Atomic like core::AtomicFile.
class PALPATE_EXPORT TickCsv
{
  public:
    /// Content of the rows.
    enum class Rows
    {
        Ticks,  ///< computed values
        Device, ///< computed values and the force sent to a device
        Session ///< with time, sent force, depth and events; cells are empty without a hand
    };
    /// @param columns  names of the columns to write, in their order; empty: all columns of `rows`
    /// @return BadCommandLine for an unknown name or one that is given twice
    [[nodiscard]] static core::Result<TickCsv> create(const std::filesystem::path& path, Rows rows = Rows::Ticks,
                                                      std::span<const std::string> columns = {});
    /// @param tick  for Rows::Session, `time_ns` counts from the first tick of the recording
    /// @param events  events of this tick, for Rows::Session
    void write(const servo::TickRecord& tick, const StructureNames& names, std::span<const RecordingEvent> events = {});
    [[nodiscard]] core::Status finish();

  private:
    TickCsv(core::AtomicFile file, Rows rows);

    void endCells(std::size_t count);
    void writeChosen();

    core::AtomicFile m_file;
    Rows m_rows = Rows::Ticks;
    std::vector<std::size_t> m_chosen; ///< indices of the cells to write; empty: all
    std::vector<std::size_t> m_ends;   ///< end of each cell in `m_line`, only if cells are chosen
    std::string m_line;
};

} // namespace palpate::session

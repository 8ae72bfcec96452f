// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "RecordingTables.h"

#include <palpate/servo/TickRecord.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace palpate::session::internal {

/// @return "ticks 250 to 499"
[[nodiscard]] std::string tickRange(std::int64_t first, std::int64_t last);

/// A recording's lines of checksums, each held against what it covers: those of metadata, scenes and events at once,
/// those of ticks when their block is read.
/// @par Thread One at a time.
class CheckedLines
{
  public:
    /// Ticks that one line covers.
    struct Block
    {
        std::vector<servo::TickRecord> ticks; ///< ascending; empty unless it is as written
        bool isRight = false;
    };

    /// What of the rest is as written, and what no line covers.
    struct Covered
    {
        std::set<std::uint32_t> scenes, uncheckedScenes; ///< generations
        std::set<std::int64_t> events, uncheckedEvents;  ///< ids
    };

    /// @param tables  must outlive this, as must the others
    CheckedLines(const RecordingTables& tables, const MetaTable& meta, const std::vector<SceneRecord>& scenes,
                 const Events& events);

    /// Reads the lines and checks all but ticks. Once, when the rest is read. @return an error of the database
    core::Status read();

    /// Lines of ticks that make sense: ascending ranges apart from each other.
    [[nodiscard]] const std::vector<Check>& blocks() const noexcept { return m_blocks; }
    /// Reads a block and holds it against its checksum. The newest one is kept, so that the same again costs nothing.
    /// @param number  in `blocks()`
    /// @par Cost 4.4 µs a tick, of which SHA-256, checks of type and range and the copy take 3; a seek to another block
    /// 1 ms.
    [[nodiscard]] std::shared_ptr<const Block> block(std::size_t number) const;
    [[nodiscard]] const Covered& covered() const noexcept { return m_covered; }

    /// What is not as it was written, one line each, as far as it was looked at; each once.
    [[nodiscard]] const std::vector<std::string>& faults() const noexcept { return m_faults; }

  private:
    /// Rows that a line covers, as bytes.
    struct Content
    {
        std::string bytes;
        std::int64_t rows = 0;
    };

    using EventsById = std::vector<const Events::value_type*>;

    void takeLine(std::size_t line);
    void takeTicks(std::size_t line);
    void findUnchecked();
    void findUncheckedTicks();
    /// Compares what a line covers with it. @param wrong  what is wrong at first sight, or nothing
    bool judge(std::size_t line, const std::string& name, const std::string& bytes, std::string wrong) const;
    [[nodiscard]] const SceneRecord* sceneOf(std::int64_t generation) const;
    /// @return the first event of this id or a later one
    [[nodiscard]] EventsById::const_iterator firstEvent(std::int64_t id) const;
    [[nodiscard]] std::string hashBefore(std::size_t line) const;
    [[nodiscard]] std::string expectedHash(std::size_t line, const std::string& bytes, int depth) const;
    [[nodiscard]] Content contentOf(std::size_t line) const;
    void note(const std::string& fault) const;

    const RecordingTables& m_tables;
    const MetaTable& m_meta;
    const std::vector<SceneRecord>& m_scenes;
    const Events& m_events;
    std::string m_metaHash;
    EventsById m_eventsById;
    std::vector<Check> m_lines;             ///< all, as they are
    std::vector<Check> m_blocks;            ///< see blocks()
    std::vector<std::size_t> m_lineOfBlock; ///< in `m_lines`
    std::set<std::uint32_t> m_seenScenes;   ///< by a line, right or wrong
    std::int64_t m_seenEvent = 0;           ///< id of the last event that a line covers, right or wrong
    int m_overlaps = 0;
    Covered m_covered;
    mutable std::vector<std::string> m_faults;
    mutable std::set<std::string, std::less<>> m_known; ///< the same
    mutable std::size_t m_newest = 0;
    mutable std::shared_ptr<const Block> m_newestBlock;
};

} // namespace palpate::session::internal

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "store/RecordingTables.h"

#include <palpate/servo/TickRecord.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace palpate::session::internal {

/// Formats a range: "ticks 250 to 499".
[[nodiscard]] core::Message tickRange(std::int64_t first, std::int64_t last);

/// Returns true for the fault of a part whose checksum is missing, so that the part may be intact.
[[nodiscard]] bool isUnchecked(const core::Message& fault);

/// Rows of a recording's table `checks`, each compared with the data covered by its checksum. Metadata, scenes and
/// events are verified immediately, blocks of ticks when read.
/// @par Thread One thread at a time.
class CheckedLines
{
  public:
    /// Ticks covered by one row.
    struct Block
    {
        std::vector<servo::TickRecord> ticks; ///< ascending; empty if the checksum failed
        bool isIntact = false;
    };

    /// Verification result for scenes and events.
    struct Covered
    {
        std::set<std::uint32_t> scenes, uncheckedScenes; ///< generations with a valid checksum, and without any
        std::set<std::int64_t> events, uncheckedEvents;  ///< ids of events with a valid checksum, and without any
    };

    /// @param tables  all arguments must outlive this object
    CheckedLines(const RecordingTables& tables, const MetaTable& meta, const std::vector<SceneRecord>& scenes,
                 const Events& events);

    /// Reads the rows and verifies all data except ticks. Call once, after reading the other tables. @return database
    /// error
    core::Status read();

    /// Valid rows for ticks: ascending ranges without overlap.
    [[nodiscard]] const std::vector<Check>& blocks() const noexcept { return m_blocks; }
    /// Reads a block and verifies its checksum. Caches the most recent block. A block that is read again with the same
    /// bits (by a 64-bit hash) is not verified by SHA-256 again.
    /// @param number  index in `blocks()`
    /// @par Cost 4.4 µs per tick, including 3 µs for SHA-256, type and range checks and copying; 1 ms for a seek to a
    ///           different block.
    [[nodiscard]] std::shared_ptr<const Block> block(std::size_t number) const;
    /// Hashes by which the blocks that were found intact are known, for `know` of another reader of the same file.
    [[nodiscard]] const std::vector<std::size_t>& known() const noexcept { return m_intact; }
    void know(std::vector<std::size_t> intact) const { m_intact = std::move(intact); }
    [[nodiscard]] const Covered& covered() const noexcept { return m_covered; }

    /// Damage found so far, one line each, without duplicates.
    [[nodiscard]] const std::vector<core::Message>& faults() const noexcept { return m_faults; }

  private:
    /// Serialized rows covered by a checksum.
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
    /// Compares data with its checksum. @param wrong  fault that is already known; empty: none
    bool judge(std::size_t line, const core::Message& name, const std::string& bytes, core::Message wrong) const;
    [[nodiscard]] const SceneRecord* sceneOf(std::int64_t generation) const;
    /// @return the first event with this id or a later one
    [[nodiscard]] EventsById::const_iterator firstEvent(std::int64_t id) const;
    [[nodiscard]] std::string hashBefore(std::size_t line) const;
    [[nodiscard]] std::string expectedHash(std::size_t line, const std::string& bytes, int depth) const;
    [[nodiscard]] Content contentOf(std::size_t line) const;
    void note(const core::Message& fault) const;

    const RecordingTables& m_tables;
    const MetaTable& m_meta;
    const std::vector<SceneRecord>& m_scenes;
    const Events& m_events;
    std::string m_metaHash;
    EventsById m_eventsById;
    std::vector<Check> m_lines;             ///< all rows, unfiltered
    std::vector<Check> m_blocks;            ///< see blocks()
    std::vector<std::size_t> m_lineOfBlock; ///< index in `m_lines`
    std::set<std::uint32_t> m_seenScenes;   ///< covered by a row, valid or not
    std::int64_t m_seenEvent = 0;           ///< last event id covered by a row, valid or not
    int m_overlaps = 0;
    Covered m_covered;
    mutable std::vector<core::Message> m_faults;
    mutable std::set<std::string, std::less<>> m_known; ///< English texts of m_faults, for lookup
    mutable std::vector<std::size_t> m_intact; ///< hash of the content of each intact block, by line; 0: not verified
    mutable std::size_t m_contentSize = 0;     ///< of the last block that was read [bytes]
    mutable std::size_t m_newest = 0;
    mutable std::shared_ptr<const Block> m_newestBlock;
};

} // namespace palpate::session::internal

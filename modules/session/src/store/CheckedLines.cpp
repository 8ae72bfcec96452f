// SPDX-License-Identifier: BSD-3-Clause
#include "store/CheckedLines.h"

#include "database/Bounds.h"
#include "tables/Packing.h"
#include "tables/Schema.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

namespace palpate::session::internal {

using core::Status;

namespace {

/// A damaged hash in one row must not invalidate the next row. The expected hash is therefore also computed from the
/// content of up to this many earlier rows instead of their stored hashes.
constexpr int kLinesBack = 4;

/// Returns the error in the range or row count of a check for ticks; empty if valid.
core::Message wrongRange(const Check& check)
{
    if (check.first < 0 || check.last < check.first || check.last > kMaxTick) {
        return {PALPATE_TEXT("found %1, expected an ascending range from 0 to 2^53"),
                tickRange(check.first, check.last)};
    }
    if (check.rows < 1 || check.rows > kMaxTicksPerCheck || check.rows > check.last - check.first + 1) {
        return {PALPATE_TEXT("%1: found a checksum of %2 rows, expected at least one and at most one a tick"),
                tickRange(check.first, check.last), check.rows};
    }
    return {};
}

core::Message otherCount(std::int64_t found, std::int64_t expected)
{
    return found == expected ? core::Message()
                             : core::Message(PALPATE_TEXT("found %1 rows, expected %2"), found, expected);
}

constexpr core::MessageText<core::Message> kUncheckedRows = PALPATE_TEXT("%1: found rows without a checksum");
constexpr core::MessageText<core::Message> kUnchecked = PALPATE_TEXT("%1: found without a checksum");

core::Message uncheckedRows(std::int64_t first, std::int64_t last)
{
    return {kUncheckedRows, tickRange(first, last)};
}

core::Message unchecked(const core::Message& name)
{
    return {kUnchecked, name};
}

core::Message sceneName(std::int64_t generation)
{
    return {PALPATE_TEXT("scene %1"), generation};
}

} // namespace

bool isUnchecked(const core::Message& fault)
{
    return fault.text() == kUnchecked.text() || fault.text() == kUncheckedRows.text();
}

core::Message tickRange(std::int64_t first, std::int64_t last)
{
    return {PALPATE_TEXT("ticks %1 to %2"), first, last};
}

CheckedLines::CheckedLines(const RecordingTables& tables, const MetaTable& meta, const std::vector<SceneRecord>& scenes,
                           const Events& events)
    : m_tables(tables)
    , m_meta(meta)
    , m_scenes(scenes)
    , m_events(events)
{
}

void CheckedLines::note(const core::Message& fault) const
{
    if (m_known.insert(fault.english()).second) {
        m_faults.push_back(fault);
    }
}

Status CheckedLines::read()
{
    m_metaHash = metaHash(hashedPairs(m_meta));
    const Status status = m_tables.readChecks(m_lines);
    for (const auto& event : m_events) {
        m_eventsById.push_back(&event);
    }
    std::stable_sort(m_eventsById.begin(), m_eventsById.end(),
                     [](const auto* a, const auto* b) { return a->first < b->first; });
    const bool isOld = m_tables.version() < 2;
    bool hasMeta = isOld; // covered by the first check for ticks
    std::int64_t expectedId = 1;
    for (std::size_t i = 0; i < m_lines.size(); ++i) {
        const Check& check = m_lines[i];
        if (!isOld && check.id != std::exchange(expectedId, check.id + 1)) {
            note({PALPATE_TEXT("checks: found line %1, expected %2: a part of the recording was taken out"), check.id,
                  expectedId - 1});
        }
        hasMeta = hasMeta || check.kind == kMetaCheck;
        takeLine(i);
    }
    if (!hasMeta) {
        note(unchecked(core::Message(PALPATE_TEXT("metadata"))));
    }
    findUnchecked();
    findUncheckedTicks();
    return status;
}

void CheckedLines::takeLine(std::size_t line)
{
    const Check& check = m_lines[line];
    if (check.kind == kTicksCheck) {
        takeTicks(line);
        return;
    }
    if (check.kind == kMetaCheck) {
        (void)judge(line, core::Message(PALPATE_TEXT("metadata")), contentOf(line).bytes, {});
        return;
    }
    const bool isScene = check.kind == kSceneCheck;
    if (!isScene && check.kind != kEventsCheck) {
        note({PALPATE_TEXT("checks: found a line of kind \"%1\", expected one of this version"), oneLine(check.kind)});
        return;
    }
    const core::Message name =
        isScene ? sceneName(check.first) : core::Message(PALPATE_TEXT("events %1 to %2"), check.first, check.last);
    const bool isAgain =
        isScene ? !m_seenScenes.insert(static_cast<std::uint32_t>(check.first)).second : check.first <= m_seenEvent;
    if (isAgain) {
        note({PALPATE_TEXT("%1: found a second checksum, expected one"), name});
        return;
    }
    const Content content = contentOf(line);
    const bool isIntact = judge(line, name, content.bytes, otherCount(content.rows, check.rows));
    if (isScene && isIntact && sceneOf(check.first) != nullptr) {
        m_covered.scenes.insert(static_cast<std::uint32_t>(check.first));
    }
    if (!isScene) {
        m_seenEvent = std::max(m_seenEvent, check.last);
        for (auto event = firstEvent(check.first);
             isIntact && event != m_eventsById.end() && (*event)->first <= check.last; ++event) {
            m_covered.events.insert((*event)->first);
        }
    }
}

/// Adds a check for ticks unless its range is invalid. Of two overlapping ranges, the intact one is kept.
void CheckedLines::takeTicks(std::size_t line)
{
    constexpr int kMaxOverlaps = 100; // each overlap reads a block; only a malicious file has many
    const Check& check = m_lines[line];
    if (const core::Message wrong = wrongRange(check); !wrong.isEmpty()) {
        note({PALPATE_TEXT("checks: %1"), wrong});
        return;
    }
    while (!m_blocks.empty() && check.first <= m_blocks.back().last) {
        if (++m_overlaps > kMaxOverlaps || block(m_blocks.size() - 1)->isIntact) {
            note({PALPATE_TEXT("checks: %1: found behind %2, expected ascending ranges"),
                  tickRange(check.first, check.last), tickRange(m_blocks.back().first, m_blocks.back().last)});
            return;
        }
        m_blocks.pop_back();
        m_lineOfBlock.pop_back();
        m_newestBlock.reset();
    }
    m_blocks.push_back(check);
    m_lineOfBlock.push_back(line);
}

void CheckedLines::findUnchecked()
{
    const bool isOld = m_tables.version() < 2; // checks for ticks only
    for (const SceneRecord& scene : m_scenes) {
        if (isOld) {
            m_covered.scenes.insert(scene.generation);
        } else if (!m_seenScenes.contains(scene.generation)) {
            m_covered.uncheckedScenes.insert(scene.generation);
            note(unchecked(sceneName(scene.generation)));
        }
    }
    for (const auto* event : m_eventsById) {
        const std::int64_t id = event->first;
        if (isOld) {
            m_covered.events.insert(id);
        } else if (id < 1 || id > m_seenEvent) {
            m_covered.uncheckedEvents.insert(id);
            note(unchecked(core::Message(PALPATE_TEXT("event %1"), id)));
        }
    }
}

/// Searches before the first and after the last block. Rows between blocks are found when reading the blocks.
void CheckedLines::findUncheckedTicks()
{
    const auto numbers = m_tables.tickNumbers();
    if (!numbers) {
        return;
    }
    const std::int64_t next = m_blocks.empty() ? 0 : m_blocks.back().last + 1;
    if (numbers->first < 0) {
        note({PALPATE_TEXT("tick %1: found a row without a checksum, expected ticks from 0"), numbers->first});
    }
    if (numbers->second >= next) {
        note(uncheckedRows(next, numbers->second));
    }
}

std::string CheckedLines::hashBefore(std::size_t line) const
{
    return line > 0 ? m_lines[line - 1].hash : m_tables.version() < 2 ? m_metaHash : std::string();
}

const SceneRecord* CheckedLines::sceneOf(std::int64_t generation) const
{
    const auto found = std::lower_bound(m_scenes.begin(), m_scenes.end(), generation,
                                        [](const SceneRecord& scene, std::int64_t g) { return scene.generation < g; });
    return found == m_scenes.end() || found->generation != generation ? nullptr : &*found;
}

CheckedLines::EventsById::const_iterator CheckedLines::firstEvent(std::int64_t id) const
{
    return std::lower_bound(m_eventsById.begin(), m_eventsById.end(), id,
                            [](const auto* event, std::int64_t least) { return event->first < least; });
}

/// Ticks that are not in an accepted block give empty content, so that no row is covered twice.
CheckedLines::Content CheckedLines::contentOf(std::size_t line) const
{
    const Check& check = m_lines[line];
    Content content;
    if (check.kind == kMetaCheck) {
        content.bytes = m_metaHash;
    } else if (check.kind == kSceneCheck) {
        if (const SceneRecord* scene = sceneOf(check.first)) {
            packScene(content.bytes, *scene, m_tables.version());
            content.rows = static_cast<std::int64_t>(scene->structures.size());
        }
    } else if (check.kind == kEventsCheck) {
        for (auto event = firstEvent(check.first); event != m_eventsById.end() && (*event)->first <= check.last;
             ++event, ++content.rows) {
            packEvent(content.bytes, (*event)->first, (*event)->second);
        }
    } else if (std::binary_search(m_lineOfBlock.begin(), m_lineOfBlock.end(), line)) {
        (void)m_tables.readTicks(check.first, check.last, [&](const servo::TickRecord& tick) {
            packTick(content.bytes, tick, m_tables.version());
            return ++content.rows < check.rows;
        });
    }
    return content;
}

/// Returns the expected hash of a row. Uses the stored hash of the previous row if this gives a match, else the
/// recomputed hash.
std::string CheckedLines::expectedHash(std::size_t line, const std::string& bytes, int depth) const
{
    std::string stored = sha256(hashBefore(line) + bytes);
    if (stored == m_lines[line].hash || depth == 0 || line == 0) {
        return stored;
    }
    return sha256(expectedHash(line - 1, contentOf(line - 1).bytes, depth - 1) + bytes);
}

bool CheckedLines::judge(std::size_t line, const core::Message& name, const std::string& bytes,
                         core::Message wrong) const
{
    const bool coversMeta = m_tables.version() < 2 && line == 0;
    if (!wrong.isEmpty()) {
        note({PALPATE_TEXT("%1: %2"), name, wrong});
        return false;
    }
    if (expectedHash(line, bytes, kLinesBack) != m_lines[line].hash) {
        note({PALPATE_TEXT("%1: found other bits than were written (checksum)"),
              coversMeta ? core::Message(PALPATE_TEXT("metadata or %1"), name) : name});
        return false;
    }
    return true;
}

std::shared_ptr<const CheckedLines::Block> CheckedLines::block(std::size_t number) const
{
    if (m_newestBlock != nullptr && m_newest == number) {
        return m_newestBlock;
    }
    const Check& check = m_blocks[number];
    auto out = std::make_shared<Block>();
    constexpr std::int64_t kUsualRows = 1024; // a row count of the file is not trusted beyond
    out->ticks.reserve(static_cast<std::size_t>(std::clamp<std::int64_t>(check.rows, 0, kUsualRows)));
    std::string content;
    content.reserve(m_contentSize);
    core::Message wrong;
    std::optional<std::pair<std::int64_t, std::int64_t>> strays; // preceding rows without a check
    const std::int64_t after = number > 0 ? m_blocks[number - 1].last + 1 : 0;
    const Status status = m_tables.readTicks(after, check.last, [&](const servo::TickRecord& tick) {
        if (tick.tick < check.first) {
            strays = std::pair(strays ? strays->first : tick.tick, tick.tick);
            return true;
        }
        packTick(content, tick, m_tables.version());
        out->ticks.push_back(tick);
        const SceneRecord* const scene = sceneOf(tick.scene);
        out->ticks.back().felt.fingertip_mm = scene != nullptr ? scene->fingertip_mm : 0.0;
        return static_cast<std::int64_t>(out->ticks.size()) <= check.rows;
    });
    if (!status.isOk()) {
        wrong = status.text();
    } else {
        wrong = otherCount(static_cast<std::int64_t>(out->ticks.size()), check.rows);
    }
    if (wrong.isEmpty() && (out->ticks.front().tick != check.first || out->ticks.back().tick != check.last)) {
        wrong =
            core::Message(PALPATE_TEXT("found %1 there"), tickRange(out->ticks.front().tick, out->ticks.back().tick));
    }
    m_contentSize = content.size();
    const std::size_t line = m_lineOfBlock[number], hash = std::hash<std::string>()(content);
    m_intact.resize(m_lines.size(), 0);
    const bool isKnown = wrong.isEmpty() && hash != 0 && m_intact[line] == hash;
    out->isIntact = isKnown || judge(line, tickRange(check.first, check.last), content, std::move(wrong));
    m_intact[line] = out->isIntact ? hash : 0;
    if (strays) {
        note(uncheckedRows(strays->first, strays->second));
    }
    if (!out->isIntact) {
        out->ticks.clear();
    }
    m_newest = number;
    m_newestBlock = out;
    return out;
}

} // namespace palpate::session::internal

// SPDX-License-Identifier: BSD-3-Clause
#include "RecordingSurvey.h"

#include "MapRows.h"
#include "Packing.h"
#include "Schema.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace palpate::session::internal {

using core::Status;

namespace {

constexpr const char* kOtherBits = ": found other bits than were written (checksum)";

class Surveyor
{
  public:
    Surveyor(const RecordingTables& tables, const MetaTable& meta)
        : m_tables(tables)
        , m_meta(meta)
    {
    }

    Survey run()
    {
        const auto note = [this](const Status& status) {
            if (!status.isOk()) {
                m_result.faults.push_back(status.message());
            }
        };
        std::vector<Check> checks;
        std::vector<SceneRecord> scenes;
        std::vector<std::pair<std::int64_t, RecordingEvent>> events;
        note(m_tables.readChecks(checks));
        note(m_tables.readScenes(scenes));
        note(m_tables.readEvents(events));
        for (SceneRecord& scene : scenes) {
            for (const StructureRecord& structure : scene.structures) {
                if (mapsText(structure.tissueMaps) != structure.maps) {
                    m_result.faults.push_back("structure \"" + structure.name +
                                              "\": a map of its tissue is not there, or damaged");
                }
            }
            const auto generation = scene.generation;
            m_scenes.emplace(generation, std::move(scene));
        }
        for (auto& [id, event] : events) {
            m_events.emplace(id, std::move(event));
        }
        const bool isOld = m_tables.version() < 2;
        if (isOld) {
            m_stored = m_computed = metaHash(hashedPairs(m_meta)); // its first block covers the metadata too
        }
        std::int64_t expectedId = 1;
        for (const Check& check : checks) {
            if (!isOld && check.id != std::exchange(expectedId, check.id + 1)) {
                m_result.faults.push_back("checks: found line " + std::to_string(check.id) + ", expected " +
                                          std::to_string(expectedId - 1) + ": a part of the recording was taken out");
            }
            take(check);
        }
        findUnchecked(isOld);
        for (const std::string& hash : m_tables.embeddedHashes()) {
            const auto read = m_tables.readEmbedded(hash);
            if (read.isOk()) {
                m_result.embedded.push_back(hash);
            }
            note(read.status());
        }
        return std::move(m_result);
    }

  private:
    /// Compares one line with what it covers. A line whose own hash was hit must not make the next one a fault: that
    /// one follows on the hash as it is stored or on the hash as it is computed.
    void take(const Check& check)
    {
        std::string content;
        std::string name;
        const std::string wrong = gather(check, content, name);
        const std::string computed = sha256(m_computed + content);
        const bool isSame = computed == check.hash || sha256(m_stored + content) == check.hash;
        const bool isFirstOld = m_tables.version() < 2 && m_nextTick == kLowest;
        m_stored = check.hash;
        m_computed = isSame ? check.hash : computed;
        if (check.kind == kTicksCheck) {
            m_nextTick = check.last < std::numeric_limits<std::int64_t>::max() ? check.last + 1 : check.last;
        }
        if (!wrong.empty()) {
            m_result.faults.push_back(name + ": " + wrong);
        } else if (!isSame) {
            m_result.faults.push_back((isFirstOld ? "metadata or " : "") + name + kOtherBits);
        } else if (check.kind == kTicksCheck) {
            m_result.blocks.push_back(check);
        } else if (check.kind == kSceneCheck) {
            m_result.scenes.insert(static_cast<std::uint32_t>(check.first));
        } else if (check.kind == kEventsCheck) {
            for (std::int64_t id = check.first; id <= check.last; ++id) {
                m_result.events.insert(id);
            }
        }
    }

    /// Collects what a line covers and how it is called. @return what is wrong with it at first sight, or nothing
    std::string gather(const Check& check, std::string& content, std::string& name)
    {
        std::int64_t rows = 0;
        Status status;
        if (check.kind == kTicksCheck) {
            name = tickRange(check.first, check.last);
            // From the end of the block before: no tick may lie between two blocks.
            status = m_tables.readTicks(m_nextTick, check.last, [&](const servo::TickRecord& tick) {
                packTick(content, tick, m_tables.version());
                ++rows;
                return true;
            });
        } else if (check.kind == kSceneCheck) {
            name = "scene " + std::to_string(check.first);
            const auto found = m_scenes.find(static_cast<std::uint32_t>(check.first));
            if (found != m_scenes.end()) {
                packScene(content, found->second, m_tables.version());
                rows = static_cast<std::int64_t>(found->second.structures.size());
                m_checkedScenes.insert(found->first);
            }
        } else if (check.kind == kEventsCheck) {
            name = "events " + std::to_string(check.first) + " to " + std::to_string(check.last);
            for (auto event = m_events.lower_bound(check.first); event != m_events.end() && event->first <= check.last;
                 ++event) {
                packEvent(content, event->first, event->second);
                m_checkedEvents.insert(event->first);
                ++rows;
            }
        } else if (check.kind == kMetaCheck) {
            name = "metadata";
            content = metaHash(hashedPairs(m_meta));
            rows = check.rows; // the hash tells
        } else {
            name = "checks";
            return "found a line of kind \"" + oneLine(check.kind) + "\", expected one of this version";
        }
        if (!status.isOk()) {
            return status.message();
        }
        return rows == check.rows ? std::string()
                                  : "found " + std::to_string(rows) + " rows, expected " + std::to_string(check.rows);
    }

    /// Names rows that no line of `checks` covers.
    void findUnchecked(bool isOld)
    {
        const auto after = m_tables.tickAt(std::numeric_limits<std::int64_t>::max());
        if (after && after->tick >= m_nextTick) {
            m_result.faults.push_back(tickRange(std::max<std::int64_t>(m_nextTick, 0), after->tick) +
                                      ": found rows without a checksum");
        }
        for (const auto& [generation, scene] : m_scenes) {
            if (isOld) {
                m_result.scenes.insert(generation);
            } else if (!m_checkedScenes.contains(generation)) {
                m_result.uncheckedScenes.insert(generation);
                m_result.faults.push_back("scene " + std::to_string(generation) + ": found without a checksum");
            }
        }
        for (const auto& [id, event] : m_events) {
            if (isOld) {
                m_result.events.insert(id);
            } else if (!m_checkedEvents.contains(id)) {
                m_result.uncheckedEvents.insert(id);
                m_result.faults.push_back("event " + std::to_string(id) + ": found without a checksum");
            }
        }
    }

    static constexpr std::int64_t kLowest = std::numeric_limits<std::int64_t>::min();

    const RecordingTables& m_tables;
    const MetaTable& m_meta;
    std::map<std::uint32_t, SceneRecord> m_scenes;
    std::map<std::int64_t, RecordingEvent> m_events;
    std::set<std::uint32_t> m_checkedScenes;
    std::set<std::int64_t> m_checkedEvents;
    std::string m_stored;   ///< hash of the line before, as the table says it
    std::string m_computed; ///< the same from what it covers
    std::int64_t m_nextTick = kLowest;
    Survey m_result;
};

} // namespace

std::string tickRange(std::int64_t first, std::int64_t last)
{
    return "ticks " + std::to_string(first) + " to " + std::to_string(last);
}

Survey survey(const RecordingTables& tables, const MetaTable& meta)
{
    return Surveyor(tables, meta).run();
}

} // namespace palpate::session::internal

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/Recovery.h"

#include "database/Bounds.h"
#include "database/JournalCheck.h"
#include "palpate/session/RecordingReader.h"
#include "palpate/session/RecordingWriter.h"
#include "recording/RecordingCopy.h"
#include "recording/RecordingSurvey.h"
#include "recording/RenamedFile.h"
#include "recording/StoredPath.h"
#include "store/CheckedLines.h"
#include "store/PageSalvage.h"
#include "store/SchemaCheck.h"
#include "tables/Schema.h"

#include <palpate/core/Scratch.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace palpate::session {

using core::Status;
using core::StatusCode;
using internal::Database;

namespace {

namespace fs = std::filesystem;

constexpr const char* kSource = "source"; // name in the scratch folder

/// Returns true for a database that is shorter than its header states.
/// @par Source https://www.sqlite.org/fileformat2.html, section 1.3: page size at 16, number of pages at 28
bool isShorterThanStated(const fs::path& path)
{
    constexpr std::size_t kPageSize = 16, kPages = 28;
    std::array<unsigned char, 32> head{};
    std::ifstream file(path, std::ios::binary);
    if (!isRecordingFile(path) || !file.read(reinterpret_cast<char*>(head.data()), head.size())) {
        return false;
    }
    const auto number = [&head](std::size_t at, std::size_t bytes) {
        std::uint64_t value = 0;
        for (std::size_t i = 0; i < bytes; ++i) {
            value = (value << 8U) | head[at + i];
        }
        return value;
    };
    const std::uint64_t page = number(kPageSize, 2) == 1 ? 65536 : number(kPageSize, 2);
    std::error_code error;
    const auto size = fs::file_size(path, error);
    return !error && size < page * number(kPages, 4);
}

/// Readable database with its verification result.
struct Source
{
    explicit Source(Database opened)
        : database(std::move(opened))
        , tables(database)
    {
    }
    Source(const Source&) = delete;
    Source& operator=(const Source&) = delete;

    Status read()
    {
        internal::Statement head = database.prepare("SELECT count(*) FROM sqlite_master");
        if (head.step() != internal::Statement::Step::Row) {
            return {StatusCode::BadFormat, PALPATE_TEXT("its first page is damaged")};
        }
        head.reset();
        if (Status status = tables.readVersion(); !status.isOk()) {
            return status;
        }
        if (Status status = internal::checkSchema(database, tables.version()); !status.isOk()) {
            return status;
        }
        if (Status status = tables.readMeta(meta); !status.isOk()) {
            faults.push_back(status.text());
        }
        survey = internal::survey(tables, meta);
        faults.insert(faults.end(), survey.faults.begin(), survey.faults.end());
        return {};
    }
    /// Returns the amount of intact data.
    std::int64_t worth() const
    {
        auto rows = static_cast<std::int64_t>(survey.covered.scenes.size() + survey.covered.events.size() +
                                              survey.embedded.size());
        for (const internal::Check& block : survey.blocks) {
            rows += block.rows;
        }
        return rows;
    }

    Database database;
    internal::RecordingTables tables;
    internal::MetaTable meta;
    internal::Survey survey;
    std::vector<core::Message> faults;
};

class Rescue
{
  public:
    Rescue(const fs::path& from, const fs::path& to)
        : m_from(from)
        , m_to(to)
    {
    }

    core::Result<Recovery> run()
    {
        for (const auto step :
             {&Rescue::copySource, &Rescue::chooseSource, &Rescue::makeCopy, &Rescue::copyTicks, &Rescue::finish}) {
            if (Status status = (this->*step)(); !status.isOk()) {
                return status;
            }
        }
        return std::move(m_result);
    }

  private:
    void lose(core::Message line)
    {
        // SQLite messages contain the name of the temporary copy.
        for (const fs::path& work : {source(), pages()}) {
            line = internal::renamed(line, work.string(), m_from.filename().string());
        }
        m_result.losses.push_back(std::move(line));
    }

    /// Copies the recording, because SQLite writes when rolling back a journal and the original must stay unchanged.
    Status copySource()
    {
        if (Status status = internal::checkJournal(m_from); !status.isOk()) {
            return status;
        }
        std::error_code error;
        if (!fs::exists(m_from, error)) {
            return {StatusCode::NotFound, PALPATE_TEXT("%1: no such file, expected a recording"), m_from};
        }
        if (fs::equivalent(m_from, m_to, error)) {
            return {StatusCode::BadCommandLine, PALPATE_TEXT("%1: is the recording itself, expected another name"),
                    m_to};
        }
        if (const auto kind = fs::status(m_to, error); fs::exists(kind) && !fs::is_regular_file(kind)) {
            // Would be replaced by the copy.
            return {StatusCode::Unreadable, PALPATE_TEXT("%1: cannot be written: not a file"), m_to};
        }
        auto scratch = core::Scratch::create(m_to, core::Scratch::Kind::Folder);
        if (!scratch.isOk()) {
            return scratch.status();
        }
        m_scratch = std::move(scratch).value();
        return internal::copyRecording(m_from, *m_scratch, kSource, m_to);
    }

    /// Opens the database. If damaged, also salvages rows from its pages, and continues with the source that contains
    /// more data.
    Status chooseSource()
    {
        Status direct(StatusCode::BadFormat, PALPATE_TEXT("found no SQLite database, expected a recording"));
        if (isRecordingFile(m_from)) {
            direct = open(source(), m_chosen);
        }
        if (direct.code() == StatusCode::Mismatch) {
            return direct.at(m_from); // pages of a newer version have a different meaning
        }
        if (!direct.isOk() || !m_chosen->faults.empty()) {
            const auto salvage = internal::salvagePages(source(), pages());
            std::unique_ptr<Source> found;
            if (salvage.isOk() && salvage.value().ticks > 0 && open(pages(), found).isOk() &&
                (!direct.isOk() || found->worth() > m_chosen->worth())) {
                const core::Message why = direct.isOk() ? m_chosen->faults.front() : direct.text();
                m_chosen = std::move(found);
                lose(core::Message(PALPATE_TEXT("%1: %2 rows were gathered from the file's %3 pages one by one"), why,
                                   salvage.value().rows, salvage.value().pages));
                m_isSalvaged = true;
                direct = {};
            }
        }
        if (!direct.isOk()) {
            return {direct.code(), PALPATE_TEXT("%1: %2: nothing can be recovered"), m_from, direct.text()};
        }
        for (const core::Message& fault : m_chosen->faults) {
            if (!internal::isUnchecked(fault)) { // listed with what is kept
                lose(fault);
            } else if (fault.english().starts_with("metadata")) {
                m_unverified.push_back({PALPATE_TEXT("metadata")});
            }
        }
        readInfo();
        return {};
    }

    static Status open(const fs::path& path, std::unique_ptr<Source>& out)
    {
        auto opened = Database::open(path, Database::Mode::Read);
        if (!opened.isOk()) {
            return opened.status();
        }
        out = std::make_unique<Source>(std::move(opened).value());
        return out->read();
    }

    /// Reads all valid values; the others get the defaults of a new recording.
    void readInfo()
    {
        readMeta();
        m_info.tickVersion = std::min(m_info.tickVersion, m_chosen->tables.version());
    }

    void readMeta()
    {
        if (auto whole = internal::fromMeta(m_chosen->meta); whole.isOk()) {
            m_info = std::move(whole).value();
            return;
        }
        internal::MetaTable good = internal::toMeta(RecordingInfo{});
        std::string lost;
        bool hasStart = false;
        for (auto& [key, value] : good) {
            const auto found = m_chosen->meta.find(key);
            const std::string before = value;
            if (found != m_chosen->meta.end()) {
                value = found->second;
            }
            const bool isTaken = found != m_chosen->meta.end() && internal::fromMeta(good).isOk();
            if (!isTaken) {
                value = before;
                lost += (lost.empty() ? "" : ", ") + key;
            }
            hasStart = hasStart || (isTaken && key == "start");
        }
        lose(core::Message(PALPATE_TEXT("metadata: %1 cannot be read; set to their defaults"), lost));
        m_info = internal::fromMeta(good).value();
        if (!hasStart) {
            // Marks the state before the first tick as unknown for replays. A reader accepts no number below -1.
            m_info.firstTick = std::max<std::int64_t>(m_info.firstTick - 1, -1);
        }
    }

    Status makeCopy()
    {
        m_info.scene = internal::movedPath(m_info.scene, m_from, m_to);
        auto made = RecordingWriter::create(m_to, m_info, RecordingWriter::Sync::AtEnd,
                                            RecordingWriter::Events::AsGiven, core::ExistingFile::Replace);
        if (!made.isOk()) {
            return made.status();
        }
        m_writer = std::move(made).value();
        std::vector<SceneRecord> scenes;
        (void)m_chosen->tables.readScenes(scenes); // errors are already reported
        for (SceneRecord& scene : scenes) {
            if (m_chosen->survey.covered.uncheckedScenes.contains(scene.generation)) {
                m_unverified.push_back({PALPATE_TEXT("scene %1"), scene.generation});
            } else if (!m_chosen->survey.covered.scenes.contains(scene.generation)) {
                lose(core::Message(PALPATE_TEXT("scene %1: left out"), scene.generation));
                continue;
            }
            for (StructureRecord& structure : scene.structures) {
                structure.source.mesh = internal::movedPath(structure.source.mesh, m_from, m_to);
                const std::string& hash = structure.source.sha256;
                if (std::binary_search(m_chosen->survey.embedded.begin(), m_chosen->survey.embedded.end(), hash)) {
                    if (auto surface = m_chosen->tables.readEmbedded(hash); surface.isOk()) {
                        structure.source.embed =
                            std::make_shared<const geometry::RepairedMesh>(std::move(surface).value());
                    }
                }
            }
            if (Status status = m_writer->addScene(scene); !status.isOk()) {
                return status;
            }
        }
        copyEvents();
        return m_writer->commit();
    }

    void copyEvents()
    {
        internal::Events events;
        (void)m_chosen->tables.readEvents(events);
        std::int64_t unverified = 0;
        for (const auto& [id, event] : events) {
            const bool isUnverified = m_chosen->survey.covered.uncheckedEvents.contains(id);
            if (isUnverified || m_chosen->survey.covered.events.contains(id)) {
                unverified += isUnverified ? 1 : 0;
                (void)m_writer->addEvent(event);
                if (event.kind == "timing" || event.kind == "ended") {
                    m_endEvent = event.tick;
                }
            }
        }
        if (unverified > 0) {
            m_unverified.push_back({PALPATE_TEXT("events: %1"), core::Count(unverified)});
        }
    }

    /// Copies the readable part of a range. @return the status of writing
    Status copyRange(std::int64_t first, std::int64_t last, std::int64_t& copied)
    {
        Status written, read;
        for (std::int64_t next = first; next <= last && written.isOk();) {
            std::int64_t wrongTick = internal::kMaxTick;
            read = m_chosen->tables.readTicks(
                next, last,
                [&](const servo::TickRecord& tick) {
                    m_firstTime_ns = m_firstTime_ns.value_or(tick.time_ns);
                    if (tick.time_ns < *m_firstTime_ns) {
                        lose(core::Message(PALPATE_TEXT("tick %1: found a time before the first tick's: left out"),
                                           tick.tick));
                        return true;
                    }
                    written = m_writer->append(tick);
                    copied += written.isOk() ? 1 : 0;
                    m_last = tick.tick;
                    return written.isOk();
                },
                &wrongTick);
            if (!read.isOk()) {
                lose(read.at(internal::tickRange(next, last)).text());
            }
            next = wrongTick < last ? wrongTick + 1 : last + 1; // continue after an invalid row
        }
        return written;
    }

    Status copyTicks()
    {
        std::vector<internal::Check> checks;
        (void)m_chosen->tables.readChecks(checks);
        std::erase_if(checks, [](const internal::Check& check) { return check.kind != internal::kTicksCheck; });
        std::int64_t next = 0;
        const auto copyUnchecked = [&](std::int64_t last) {
            const std::int64_t before = m_result.ticks;
            const Status status = last < next ? Status() : copyRange(next, last, m_result.ticks);
            if (m_result.ticks > before) {
                m_unverified.push_back(
                    {PALPATE_TEXT("ticks up to %1: %2"), m_last, core::Count(m_result.ticks - before)});
            }
            return status;
        };
        for (const internal::Check& check : checks) {
            if (check.first < next || check.last < check.first || check.last > internal::kMaxTick) {
                continue; // check out of order: its ticks are already copied, with or without a checksum
            }
            if (Status status = copyUnchecked(check.first - 1); !status.isOk()) {
                return status;
            }
            const bool isGood = std::any_of(m_chosen->survey.blocks.begin(), m_chosen->survey.blocks.end(),
                                            [&](const internal::Check& good) { return good.id == check.id; });
            if (isGood) {
                if (Status status = copyRange(check.first, check.last, m_result.ticks); !status.isOk()) {
                    return status;
                }
            } else {
                lose(core::Message(PALPATE_TEXT("%1: left out"), internal::tickRange(check.first, check.last)));
            }
            next = check.last + 1;
        }
        return copyUnchecked(internal::kMaxTick);
    }

    Status finish()
    {
        if (!m_unverified.empty()) {
            lose(core::Message(PALPATE_TEXT("kept, but not verified, because the checksums are lost: %1"),
                               core::joined(m_unverified)));
        }
        const bool isClosed = m_chosen->meta.contains(internal::kComplete);
        const bool isComplete = isClosed && isEndKnown();
        if (!isClosed) {
            lose(core::Message(PALPATE_TEXT("the end: the recording was not closed; nothing is known after tick %1"),
                               m_last));
        } else if (!isComplete) {
            lose(core::Message(PALPATE_TEXT("the end may be missing: the recording was closed, but the file is damaged "
                                            "or cut off; nothing is known after tick %1"),
                               m_last));
        }
        QJsonArray missing;
        for (const core::Message& loss : m_result.losses) {
            missing.append(QString::fromStdString(loss.english()));
        }
        const QJsonObject json{{"from", QString::fromStdString(m_from.filename().string())}, {"missing", missing}};
        if (!missing.isEmpty()) {
            (void)m_writer->addEvent({std::max<std::int64_t>(m_last, 0), "recovered",
                                      QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString()});
        }
        return m_writer->finish(isComplete ? RecordingWriter::Ending::Complete : RecordingWriter::Ending::CutOff);
    }

    /// The mark of a closed recording lies near the beginning of the file and survives a loss of its end.
    bool isEndKnown() const
    {
        if (isShorterThanStated(m_from)) {
            return false;
        }
        return !m_isSalvaged || (m_endEvent && *m_endEvent <= m_last + 1); // the last event follows the last tick
    }

    fs::path source() const { return m_scratch->path() / kSource; }
    fs::path pages() const { return m_scratch->path() / "pages"; }

    const fs::path m_from;
    const fs::path m_to;
    std::unique_ptr<core::Scratch> m_scratch; ///< contains the copy of the recording and the salvaged rows
    std::unique_ptr<Source> m_chosen;
    RecordingInfo m_info;
    std::unique_ptr<RecordingWriter> m_writer;
    bool m_isSalvaged = false;                  ///< gathered from the pages
    std::vector<core::Message> m_unverified;    ///< parts in the copy whose checksums are lost
    std::optional<std::int64_t> m_endEvent;     ///< tick of the event that ends a recording
    std::int64_t m_last = -1;                   ///< last tick in the copy
    std::optional<std::int64_t> m_firstTime_ns; ///< of the first tick in the copy
    Recovery m_result;
};

} // namespace

core::Result<Recovery> recoverRecording(const std::filesystem::path& from, const std::filesystem::path& to)
{
    return Rescue(from, to).run();
}

} // namespace palpate::session

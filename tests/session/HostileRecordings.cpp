// SPDX-License-Identifier: BSD-3-Clause
#include "HostileRecordings.h"

#include "../support/Shapes.h"
#include "Sessions.h"
#include "store/RecordingTables.h"
#include "store/SchemaCheck.h"
#include "tables/Packing.h"

#include <palpate/session/GeometryHash.h>
#include <palpate/session/RecordingWriter.h>

#include <sqlite3.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <optional>

namespace palpate::test {

using namespace session::internal;

namespace {

constexpr std::string_view kMagic{"\xd9\xd5\x05\xf9\x20\xa1\x63\xd7", 8};

std::string bigEndian(std::uint32_t value)
{
    std::string out;
    for (int shift = 24; shift >= 0; shift -= 8) {
        out += static_cast<char>((value >> static_cast<unsigned>(shift)) & 0xffU);
    }
    return out;
}

template<class T>
void copyBlob(const std::string& bytes, std::vector<T>& out)
{
    out.resize(bytes.size() / sizeof(T));
    if (!out.empty()) {
        std::memcpy(static_cast<void*>(out.data()), bytes.data(), out.size() * sizeof(T));
    }
}

} // namespace

bool rehash(const std::filesystem::path& recording)
{
    auto opened = Database::open(recording, Database::Mode::ReadWrite);
    if (!opened.isOk()) {
        return false;
    }
    Database& database = opened.value();
    RecordingTables tables(database);
    MetaTable meta;
    std::vector<session::SceneRecord> scenes;
    Events events;
    std::vector<Check> checks;
    if (!tables.readVersion().isOk() || !checkSchema(database, tables.version()).isOk()) {
        return false; // a view in place of a table might never end
    }
    (void)tables.readMeta(meta);
    (void)tables.readScenes(scenes);
    (void)tables.readEvents(events);
    (void)tables.readChecks(checks);
    std::sort(events.begin(), events.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    (void)database.execute("BEGIN");
    Statement update = database.prepare("UPDATE checks SET rows = ?, sha256 = ? WHERE id = ?");
    std::string hash;
    bool isDone = update.isPrepared();
    for (const Check& check : checks) {
        std::string content;
        std::int64_t rows = 0;
        if (check.kind == "meta") {
            content = metaHash(hashedPairs(meta));
            rows = check.rows;
        } else if (check.kind == "scene") {
            for (const session::SceneRecord& scene : scenes) {
                if (scene.generation == check.first) {
                    packScene(content, scene, tables.version());
                    rows = static_cast<std::int64_t>(scene.structures.size());
                }
            }
        } else if (check.kind == "events") {
            for (const auto& [id, event] : events) {
                if (id >= check.first && id <= check.last) {
                    packEvent(content, id, event);
                    ++rows;
                }
            }
        } else {
            (void)tables.readTicks(check.first, check.last, [&](const servo::TickRecord& tick) {
                packTick(content, tick, tables.version());
                return ++rows < 100'000;
            });
        }
        hash = sha256(hash + content);
        update.bind(0, rows);
        update.bindBlob(1, hash);
        update.bind(2, check.id);
        isDone = update.step() == Statement::Step::Done && isDone;
    }
    return database.execute("COMMIT").isOk() && isDone;
}

bool rehashSurfaces(const std::filesystem::path& recording)
{
    auto opened = Database::open(recording, Database::Mode::ReadWrite);
    if (!opened.isOk()) {
        return false;
    }
    Database& database = opened.value();
    RecordingTables tables(database);
    if (!tables.readVersion().isOk() || !checkSchema(database, tables.version()).isOk()) {
        return false;
    }
    struct Row
    {
        std::string before, after, all;
    };
    std::vector<Row> found;
    {
        Statement row = database.prepare("SELECT sha256, vertices, triangles, two_sided, source FROM embedded");
        while (row.step() == Statement::Step::Row) {
            geometry::RepairedMesh surface;
            copyBlob(row.bytes(1), surface.mesh.vertices);
            copyBlob(row.bytes(2), surface.mesh.triangles);
            copyBlob(row.bytes(3), surface.twoSided);
            copyBlob(row.bytes(4), surface.source);
            found.push_back({row.bytes(0), session::geometryHash(surface.mesh), embeddedHash(surface)});
        }
    }
    bool isDone = true;
    for (const Row& row : found) {
        for (const char* sql : {"UPDATE embedded SET sha256 = ?1, all_sha256 = ?3 WHERE sha256 = ?2",
                                "UPDATE meshes SET sha256 = ?1 WHERE sha256 = ?2 AND ?3 IS NOT NULL"}) {
            Statement update = database.prepare(sql);
            update.bind(0, std::string_view(row.after));
            update.bind(1, std::string_view(row.before));
            update.bindBlob(2, row.all);
            isDone = update.step() == Statement::Step::Done && isDone;
        }
    }
    return isDone;
}

std::string superJournal(const std::filesystem::path& recording, const std::string& name)
{
    constexpr std::uint32_t kSector = 512, kPage = 4096;
    std::error_code error;
    const auto pages = static_cast<std::uint32_t>(std::filesystem::file_size(recording, error) / kPage);
    std::string out(kMagic);
    for (const std::uint32_t number : {0U, 0U, pages, kSector, kPage}) {
        out += bigEndian(number);
    }
    out.resize(kSector, '\0');
    std::uint32_t sum = 0;
    for (const char c : name) {
        sum += static_cast<std::uint32_t>(static_cast<signed char>(c));
    }
    return out + bigEndian(0x40000000U / kPage + 1) + name + bigEndian(static_cast<std::uint32_t>(name.size())) +
           bigEndian(sum) + std::string(kMagic);
}

bool writeRichRecording(const std::filesystem::path& recording, int ticks)
{
    const geometry::RepairedMesh box =
        geometry::repair(test::box(core::Vec3(-20, -20, -20), core::Vec3(20, 20, 20), 4));
    std::vector<session::SceneRecord> scenes = palpationScenes();
    for (session::SceneRecord& scene : scenes) {
        session::StructureRecord& structure = scene.structures.front();
        structure.source.sha256 = session::geometryHash(box.mesh);
        structure.source.embed = std::make_shared<const geometry::RepairedMesh>(box);
    }
    session::RecordingInfo info;
    info.device.id = "test";
    info.firstGeneration = 1;
    auto writer = session::RecordingWriter::create(recording, info, session::RecordingWriter::Sync::AtEnd);
    if (!writer.isOk()) {
        return false;
    }
    bool isDone = true;
    for (const session::SceneRecord& scene : scenes) {
        isDone = writer.value()->addScene(scene).isOk() && isDone;
    }
    for (const servo::TickRecord& tick : palpationTicks(ticks)) {
        isDone = writer.value()->append(tick).isOk() && isDone;
    }
    isDone = writer.value()->addEvent({5, "note", R"({"text": "harder here"})"}).isOk() && isDone;
    isDone = writer.value()
                 ->addEvent({9, "finding", R"({"id": "a", "name": "Finding 1", "position": [1, 2, 20], "size_mm": 4})"})
                 .isOk() &&
             isDone;
    return writer.value()->finish().isOk() && isDone;
}

} // namespace palpate::test

// SPDX-License-Identifier: BSD-3-Clause
#include "../support/Shapes.h"
#include "Sessions.h"
#include "TestRunner.h"
#include "database/LawText.h"

#include <palpate/haptics/ForceTable.h>
#include <palpate/servo/ServoCore.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/session/RecordingWriter.h>
#include <palpate/session/Recovery.h>

#include <QFile>
#include <QTemporaryDir>

#include <cmath>
#include <limits>
#include <set>

#include <sqlite3.h>

using namespace palpate;
using core::Vec3;
using session::RecordingReader;

/// Presses through a soft block onto hard ones and checks the recorded data of each layer.
class RecordedLayers : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    std::filesystem::path path(const char* name) const { return m_folder.filePath(name).toStdString(); }

    static haptics::HapticStructure block(const char* name, const Vec3& low, const Vec3& high, double stiffness,
                                          std::uint32_t layer)
    {
        return {name, test::indexed(test::box(low, high)), {stiffness, 0.001}, layer, {}, {}};
    }

    /// A block, a lump 4 mm below the block's top, and a bare lump of the inner layer beside the block.
    static std::shared_ptr<const haptics::HapticScene> scene()
    {
        static const auto kScene = std::make_shared<const haptics::HapticScene>(
            std::vector{block("block", Vec3(-20, -20, -20), Vec3(20, 20, 0), 0.4, 0),
                        block("lump", Vec3(-5, -5, -15), Vec3(5, 5, -4), 1.5, 1),
                        block("bare", Vec3(22, -5, -15), Vec3(32, 5, 0), 1.0, 1)});
        return kScene;
    }

    static session::SurfacesByHash surfaces()
    {
        session::SurfacesByHash out;
        for (const auto& structure : scene()->structures()) {
            out[structure.name] = structure.surface;
        }
        return out;
    }

    static session::SceneRecord described(const haptics::HapticScene& felt)
    {
        std::vector<session::StructureSource> sources;
        for (const auto& structure : felt.structures()) {
            sources.emplace_back().sha256 = structure.name;
        }
        return session::describeScene(1, felt, sources);
    }
    static session::SceneRecord described() { return described(*scene()); }

    /// The scene with stiffness and damping maps on the outer block.
    static std::shared_ptr<const haptics::HapticScene> mapped()
    {
        std::vector<haptics::HapticStructure> structures = scene()->structures();
        const auto& block = *structures[0].surface;
        std::vector<std::array<float, 3>> stiffness(block.triangleCount());
        for (std::size_t i = 0; i < stiffness.size(); ++i) {
            stiffness[i] = {1.0F + 0.1F * static_cast<float>(i), 1.5F, 0.7F};
        }
        structures[0].maps.stiffness = {std::make_shared<const std::vector<std::array<float, 3>>>(stiffness), 1.25};
        structures[0].maps.damping =
            haptics::TissueMap::atTriangles(block, std::vector<float>(stiffness.size(), 0.002F));
        return std::make_shared<const haptics::HapticScene>(structures);
    }

    /// Presses over the lump and beside it, then on the bare lump.
    /// @param from  first tick of the result
    /// @param start  receives the state before that tick; may be null
    static std::vector<servo::TickRecord> pressing(const haptics::HapticScene& felt, int from,
                                                   haptics::PalpatorState* start)
    {
        device::DeviceInfo info;
        info.maxForce_N = 20.0;
        servo::ServoCore core(servo::GateLimits::forDevice(info), 1000.0);
        core.borrowScene(&felt, 1);
        std::vector<servo::TickRecord> ticks;
        for (int i = 0; i < 1500; ++i) {
            if (i == from && start != nullptr) {
                *start = core.palpatorState();
            }
            device::DeviceState state;
            state.time_ns = std::int64_t{i} * 1'000'000;
            state.isPresent = true;
            state.p_D = Vec3(-15.0 + 0.03 * i, 0.5 * std::sin(0.01 * i), 2.0 - 4.0 * (1.0 - std::cos(0.02 * i)));
            const servo::TickRecord tick = core.tick(state, state.time_ns);
            if (i >= from) {
                ticks.push_back(tick);
                ticks.back().solve_ns = 100;
            }
        }
        return ticks;
    }
    static std::vector<servo::TickRecord> pressing() { return pressing(*scene(), 0, nullptr); }

    bool write(const char* name, const std::vector<servo::TickRecord>& ticks, const session::SceneRecord& scene,
               session::RecordingInfo info = {}) const
    {
        info.firstGeneration = 1;
        auto writer = session::RecordingWriter::create(path(name), info);
        bool isOk = writer.isOk() && writer.value()->addScene(scene).isOk();
        for (const servo::TickRecord& tick : ticks) {
            isOk = isOk && writer.value()->append(tick).isOk();
        }
        return isOk && writer.value()->finish().isOk();
    }

    static std::vector<servo::TickRecord> all(const RecordingReader& reader)
    {
        std::vector<servo::TickRecord> ticks;
        (void)reader.forEach(0, std::numeric_limits<std::int64_t>::max(), [&](const auto& tick) {
            ticks.push_back(tick);
            return true;
        });
        return ticks;
    }

    /// Counts the ticks whose `layers` value has this many bytes; 0 bytes: NULL.
    int countLayers(const char* name, int bytes) const
    {
        sqlite3* database = nullptr;
        sqlite3_stmt* row = nullptr;
        sqlite3_open(path(name).c_str(), &database);
        const std::string sql =
            "SELECT count(*) FROM ticks WHERE coalesce(length(layers), 0) = " + std::to_string(bytes);
        sqlite3_prepare_v2(database, sql.c_str(), -1, &row, nullptr);
        const int count = sqlite3_step(row) == SQLITE_ROW ? sqlite3_column_int(row, 0) : -1;
        sqlite3_finalize(row);
        sqlite3_close(database);
        return count;
    }

  private Q_SLOTS:
    void everyLayerComesBack()
    {
        auto ticks = pressing();
        std::array<int, 3> touching{};
        std::set<std::uint32_t> firstLayers;
        for (std::size_t i = 0; i < ticks.size(); ++i) {
            servo::TickRecord& tick = ticks[i];
            ++touching.at(tick.felt.contactCount);
            if (tick.felt.contactCount == 0) {
                continue;
            }
            firstLayers.insert(tick.felt.contacts[0].layer);
            // States that the engine does not produce: a normal that differs from the spring's, and friction with and
            // without the flag.
            if (i % 3 == 0) {
                tick.felt.n_W = tick.felt.contacts[0].n_W = Vec3(0.6, -0.0, 0.8);
            }
            tick.felt.contacts[0].friction = static_cast<haptics::Friction>(i % 3);
            if (i % 5 != 0) {
                if (i % 3 != 0) {
                    tick.flags |= i % 3 == 1 ? servo::kHolds : servo::kSlides;
                }
            }
            if (tick.felt.contactCount > 1) {
                tick.felt.contacts[1].friction = static_cast<haptics::Friction>(i / 3 % 3);
            }
        }
        QVERIFY(touching[0] > 50 && touching[1] > 100 && touching[2] > 50);
        QCOMPARE(firstLayers.size(), std::size_t{2});
        QVERIFY(write("a.palpate", ticks, described()));
        const auto reader = RecordingReader::open(path("a.palpate"));
        QVERIFY2(reader.isOk(), reader.status().message().c_str());
        const auto read = all(*reader.value());
        QCOMPARE(read.size(), ticks.size());
        for (std::size_t i = 0; i < ticks.size(); ++i) {
            QVERIFY2(test::isSameTick(read[i], ticks[i]), std::to_string(i).c_str());
            for (std::size_t k = 0; k < ticks[i].felt.contactCount; ++k) {
                QCOMPARE(read[i].felt.contacts[k].depth_mm, ticks[i].felt.contacts[k].depth_mm);
            }
        }
        QVERIFY2(reader.value()->verify().isOk(), reader.value()->verify().message().c_str());
    }

    void oneLayerCostsNothing()
    {
        const auto ticks = pressing();
        QVERIFY(write("b.palpate", ticks, described()));
        int two = 0;
        int bare = 0;
        for (const auto& tick : ticks) {
            two += tick.felt.contactCount == 2 ? 1 : 0;
            bare += tick.felt.contactCount == 1 && tick.felt.contacts[0].layer == 1 ? 1 : 0;
        }
        QCOMPARE(countLayers("b.palpate", 2 * 88), two);
        QCOMPARE(countLayers("b.palpate", 88), bare);
        QCOMPARE(countLayers("b.palpate", 0), int(ticks.size()) - two - bare);
    }

    void computedAgainLayerByLayer()
    {
        auto ticks = pressing();
        QVERIFY(write("c.palpate", ticks, described()));
        const auto same = session::resimulate(*RecordingReader::open(path("c.palpate")).value(), surfaces());
        QVERIFY2(same.isOk() && same.value().isSame(), same.isOk() ? same.value().difference.english().c_str() : "");

        const auto two =
            std::find_if(ticks.begin(), ticks.end(), [](const auto& t) { return t.felt.contactCount == 2; });
        two->felt.contacts[1].p_WG.x() += 1e-3;
        QVERIFY(write("d.palpate", ticks, described()));
        const auto other = session::resimulate(*RecordingReader::open(path("d.palpate")).value(), surfaces());
        QCOMPARE(other.value().differing, std::int64_t{1});
        QCOMPARE(*other.value().firstDifference, two->tick);
        QVERIFY(!other.value().isWithinRounding());
        QVERIFY2(other.value().difference.english().find("layers") != std::string::npos,
                 other.value().difference.english().c_str());
    }

    /// With friction the normal differs from the spring's, and the sliding state at the start affects the following
    /// ticks.
    void frictionIsKeptAndFeltAgain()
    {
        std::vector<haptics::HapticStructure> structures = scene()->structures();
        structures[0].tissue.friction_static = 1.5;
        structures[0].tissue.friction_dynamic = 0.8;
        const haptics::HapticScene rough(structures);
        session::SceneRecord record = described();
        record.structures[0].tissue = structures[0].tissue;
        session::RecordingInfo info;
        int from = 300;
        std::vector<servo::TickRecord> ticks;
        do { // starts while sliding
            ticks = pressing(rough, from++, &info.start);
        } while (info.start.layers[0].slides == 0 && from < 1400);
        QVERIFY(info.start.layers[0].slides == 1 && ticks.front().felt.contactCount > 0);
        info.firstTick = ticks.front().tick;
        int leaning = 0;
        unsigned seen = 0;
        for (const servo::TickRecord& tick : ticks) {
            const core::Vec3 spring = tick.felt.p_WG - tick.p_WH;
            leaning += tick.felt.structure == 0 && (spring.normalized() - tick.felt.n_W).norm() > 0.05 ? 1 : 0;
            seen |= tick.flags;
        }
        QVERIFY2(leaning > 100, std::to_string(leaning).c_str());
        QVERIFY((seen & servo::kSlides) != 0 && (seen & servo::kHolds) != 0);
        QVERIFY(write("r.palpate", ticks, record, info));
        const auto reader = RecordingReader::open(path("r.palpate"));
        QCOMPARE(reader.value()->info().start.layers[0].slides, std::uint8_t{1});
        auto read = all(*reader.value());
        for (std::size_t i = 0; i < ticks.size(); ++i) {
            read[i].time_ns += ticks.front().time_ns; // relative to the first
            QVERIFY2(test::isSameTick(read[i], ticks[i]), std::to_string(i).c_str());
        }
        const auto again = session::resimulate(*reader.value(), surfaces());
        QVERIFY2(again.isOk() && again.value().isSame(),
                 again.isOk() ? again.value().difference.english().c_str() : "");
        // The byte matters: starting with a static contact gives another trajectory.
        info.start.layers[0].slides = 0;
        QVERIFY(write("s.palpate", ticks, record, info));
        const auto other = session::resimulate(*RecordingReader::open(path("s.palpate")).value(), surfaces());
        QVERIFY(!other.value().isSame());
    }

    void aChangedLayerIsFound()
    {
        QVERIFY(write("e.palpate", pressing(), described()));
        for (const char* sql : {"UPDATE ticks SET layers = NULL WHERE tick = (SELECT min(tick) FROM ticks WHERE "
                                "length(layers) = 176)",
                                "UPDATE ticks SET layers = zeroblob(88) WHERE tick = (SELECT max(tick) FROM ticks "
                                "WHERE length(layers) = 176)",
                                "UPDATE ticks SET layers = x'00' WHERE length(layers) = 88",
                                "UPDATE ticks SET normal_x = 1.0 WHERE tick = 700"}) {
            QFile::remove(m_folder.filePath("f.palpate"));
            QVERIFY(QFile::copy(m_folder.filePath("e.palpate"), m_folder.filePath("f.palpate")));
            QVERIFY(test::runSql(path("f.palpate"), sql));
            const auto status = RecordingReader::open(path("f.palpate")).value()->verify();
            QVERIFY2(status.message().find("f.palpate: ticks ") != std::string::npos, status.message().c_str());
        }
    }

    void recoveryKeepsLayersAndTissue()
    {
        const auto ticks = pressing();
        session::SceneRecord scene = described(*mapped());
        scene.structures[0].tissue.friction_static = 0.3;
        scene.structures[0].tissue.law.kind = core::LawKind::Hertz;
        scene.structures[0].tissue.law.numbers = {12.5, 8.0};
        scene.structures[0].lawTable = std::string("\0table\xff", 7);
        QVERIFY(write("g.palpate", ticks, scene));
        QFile file(m_folder.filePath("g.palpate"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QByteArray bytes = file.readAll();
        for (int page = 0; page < 2; ++page) { // first intact, then without the first page: row by row
            QFile hurt(m_folder.filePath("h.palpate"));
            QVERIFY(hurt.open(QIODevice::WriteOnly));
            hurt.write(bytes);
            hurt.close();
            const auto result = session::recoverRecording(path("h.palpate"), path("i.palpate"));
            QVERIFY2(result.isOk(), result.status().message().c_str());
            QCOMPARE(result.value().ticks, std::int64_t(ticks.size()));
            const auto copy = RecordingReader::open(path("i.palpate"));
            QVERIFY2(copy.isOk() && copy.value()->verify().isOk(), copy.status().message().c_str());
            const auto read = all(*copy.value());
            for (std::size_t i = 0; i < ticks.size(); ++i) {
                QVERIFY2(test::isSameTick(read[i], ticks[i]), std::to_string(i).c_str());
            }
            const session::StructureRecord& was = scene.structures[0];
            const session::StructureRecord& is = copy.value()->scenes().at(0).structures.at(0);
            QVERIFY(is.tissue == was.tissue);
            QCOMPARE(is.lawTable, was.lawTable);
            QCOMPARE(is.maps, was.maps);
            QVERIFY(*is.tissueMaps.stiffness.corners == *was.tissueMaps.stiffness.corners);
            bytes.replace(0, 4096, QByteArray(4096, 'x'));
        }
        for (const char* sql : {"UPDATE structures SET law = NULL", "UPDATE structures SET law_table = NULL",
                                "UPDATE structures SET maps = ''", "UPDATE structures SET friction_static = 0.1"}) {
            QFile::remove(m_folder.filePath("j.palpate"));
            QVERIFY(QFile::copy(m_folder.filePath("i.palpate"), m_folder.filePath("j.palpate")));
            QVERIFY(test::runSql(path("j.palpate"), sql));
            const auto status = RecordingReader::open(path("j.palpate")).value()->verify();
            QVERIFY2(status.message().find("scene 1: found other bits") != std::string::npos, sql);
        }
    }

    void mapsAreFeltAgain()
    {
        const auto felt = mapped();
        const session::SceneRecord record = described(*felt);
        session::SceneRecord plain = described();
        const auto ticks = pressing(*felt, 0, nullptr);
        QVERIFY(write("m.palpate", ticks, record));
        const auto reader = RecordingReader::open(path("m.palpate"));
        QVERIFY2(reader.value()->verify().isOk(), reader.value()->verify().message().c_str());
        const auto again = session::resimulate(*reader.value(), surfaces());
        QVERIFY2(again.isOk() && again.value().isSame(),
                 again.isOk() ? again.value().difference.english().c_str() : "");
        // The map matters: the simulation without it gives another result.
        QVERIFY(write("n.palpate", ticks, plain));
        QVERIFY(!session::resimulate(*RecordingReader::open(path("n.palpate")).value(), surfaces()).value().isSame());

        for (const char* sql : {"DELETE FROM maps", "UPDATE maps SET corners = zeroblob(length(corners))",
                                "UPDATE maps SET corners = x'0011'"}) {
            QFile::remove(m_folder.filePath("o.palpate"));
            QVERIFY(QFile::copy(m_folder.filePath("m.palpate"), m_folder.filePath("o.palpate")));
            QVERIFY(test::runSql(path("o.palpate"), sql));
            const auto hurt = RecordingReader::open(path("o.palpate"));
            QVERIFY2(hurt.value()->verify().message().find(
                         "a map of its tissue or its motion is not there, or damaged") != std::string::npos,
                     sql);
            const auto refused = session::resimulate(*hurt.value(), surfaces());
            QVERIFY(!refused.isOk());
            QVERIFY2(refused.status().message().find("structure \"block\" of the recording: a map of its tissue") !=
                         std::string::npos,
                     refused.status().message().c_str());
        }
        // A scene with a different surface.
        session::SurfacesByHash others = surfaces();
        others["block"] = others["lump"] = test::indexed(test::box(Vec3(-20, -20, -20), Vec3(20, 20, 0), 2));
        const auto other = session::resimulate(*reader.value(), others);
        QVERIFY2(!other.isOk() && other.status().message().find("triangles, expected") != std::string::npos,
                 other.status().message().c_str());
    }

    /// Resimulation uses the table in the recording, regardless of how this build samples the parameters of the force
    /// law.
    void aLawIsFeltAgainByItsTable()
    {
        core::Tissue hertz{0.4, 0.001};
        hertz.law.kind = core::LawKind::Hertz;
        hertz.law.numbers = {30.0, 8.0};
        std::vector<haptics::HapticStructure> structures = scene()->structures();
        structures[0].tissue = hertz;
        const haptics::HapticScene felt(structures);
        QVERIFY(felt.structures()[0].law != nullptr);
        std::vector<session::StructureSource> sources(structures.size());
        for (std::size_t i = 0; i < sources.size(); ++i) {
            sources[i].sha256 = structures[i].name;
        }
        session::SceneRecord record = session::describeScene(1, felt, sources);
        QVERIFY(record.structures[1].lawTable.empty());
        const auto again = session::rebuildScene(record, surfaces());
        QVERIFY2(again.isOk(), again.status().message().c_str());
        QVERIFY(*again.value()->structures()[0].law == *felt.structures()[0].law);

        const auto other = haptics::ForceTable::fromKnots({{0, 0, 0, 1}, {1, 1, 1, 2}});
        const std::vector<std::byte> bytes = other.value()->bytes();
        record.structures[0].lawTable.assign(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        QVERIFY(*session::rebuildScene(record, surfaces()).value()->structures()[0].law == *other.value());

        record.structures[0].lawTable += 'x';
        const auto bad = session::rebuildScene(record, surfaces());
        QVERIFY2(bad.status().message().starts_with("structure \"block\" of the recording: law_table: "),
                 bad.status().message().c_str());
    }

    /// A measured click: a recording must restore any force law that a scene may contain.
    void aLawThatFallsComesBack()
    {
        core::ForceLaw law;
        law.kind = core::LawKind::Points;
        law.points = {{0.0, 0.0}, {1.0, 2.0}, {1.5, 1.2}, {4.0, 3.0}};
        QVERIFY(core::check(law).isOk());
        const auto back = session::internal::parseLaw(session::internal::lawText(law));
        QVERIFY(back.has_value() && *back == law);
    }

    void lawsComeBackAsTheyWere()
    {
        for (const core::LawKind kind : core::kLawKinds) {
            core::ForceLaw law;
            law.kind = kind;
            for (std::size_t i = 0; i < core::lawParameters(kind).size(); ++i) {
                law.numbers[i] = core::lawParameters(kind)[i].usual / 3.0 + core::lawParameters(kind)[i].least;
            }
            if (kind == core::LawKind::Points) {
                law.points = {{0.0, 0.0}, {0.1, 1.0 / 3.0}, {2.0, 7.0}};
            }
            const std::string text = session::internal::lawText(law);
            QCOMPARE(text.empty(), kind == core::LawKind::Linear);
            const auto back = session::internal::parseLaw(text);
            QVERIFY2(back.has_value() && *back == law, text.c_str());
        }
    }

    void aBadLawIsRefusedByName_data()
    {
        QTest::addColumn<QString>("law");
        QTest::newRow("no JSON") << "hertz";
        QTest::newRow("unknown") << R"({"kind":"rubber"})";
        QTest::newRow("number missing") << R"({"kind":"hertz","young_kPa":3})";
        QTest::newRow("negative") << R"({"kind":"hertz","young_kPa":-3,"radius_mm":8})";
        QTest::newRow("too large") << R"({"kind":"hertz","young_kPa":3,"radius_mm":1e300})";
        QTest::newRow("no number") << R"({"kind":"hertz","young_kPa":"soft","radius_mm":8})";
        QTest::newRow("points fall") << R"({"kind":"points","points":[[0,0],[2,1],[1,2]]})";
        QTest::newRow("no origin") << R"({"kind":"points","points":[[1,1],[2,2]]})";
        QTest::newRow("no pairs") << R"({"kind":"points","points":[[0,0],[1]]})";
    }
    void aBadLawIsRefusedByName()
    {
        QFETCH(QString, law);
        std::filesystem::remove(path("k.palpate")); // from the previous row
        QVERIFY(write("k.palpate", {}, described()));
        QVERIFY(test::runSql(path("k.palpate"),
                             "UPDATE structures SET law = '" + law.toStdString() + "' WHERE number = 1"));
        const auto reader = RecordingReader::open(path("k.palpate"));
        QVERIFY(!reader.isOk());
        const std::string expected = path("k.palpate").string() + ": scene 1, structure \"lump\": found the law ";
        QVERIFY2(reader.status().message().starts_with(expected), reader.status().message().c_str());
        QVERIFY(session::recoverRecording(path("k.palpate"), path("l.palpate")).isOk());
    }
};

PALPATE_TEST(RecordedLayers)
#include "tst_RecordedLayers.moc"

// SPDX-License-Identifier: BSD-3-Clause
// The wire code against bytes that are written without it: every type, and everything that a peer can get wrong.
#include "TestRunner.h"
#include "WireBytes.h"

#include <palpate/igtl/Messages.h>
#include <palpate/igtl/Surface.h>
#include <palpate/igtl/Wire.h>

#include <cmath>
#include <limits>

using namespace palpate;
using namespace palpate::test;
using igtl::MessageReader;
using Step = MessageReader::Step;
using ByteVector = std::vector<std::uint8_t>;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

ByteVector joinedBytes(const std::vector<ByteVector>& parts)
{
    WireBytes all;
    for (const ByteVector& part : parts) {
        all.raw(part);
    }
    return all.bytes();
}

/// Names of all complete messages, each followed by the size of the content: "a/48 b/12".
QString readAll(const ByteVector& bytes, std::size_t chunk, bool takesSurfaces = true)
{
    MessageReader reader(takesSurfaces);
    QStringList names;
    for (std::size_t at = 0; at < bytes.size(); at += chunk) {
        reader.add(igtl::ByteView(bytes).subspan(at, std::min(chunk, bytes.size() - at)));
        for (Step step = reader.next(); step != Step::NeedsMore; step = reader.next()) {
            switch (step) {
            case Step::Complete:
                names << QString::fromStdString(reader.message().header.name) + QLatin1Char('/') +
                             QString::number(reader.message().content.size());
                break;
            case Step::Skipped:
                names << QStringLiteral("skipped");
                break;
            case Step::Refused:
                names << QStringLiteral("refused");
                break;
            default:
                names << QStringLiteral("lost");
                return names.join(QLatin1Char(' '));
            }
        }
    }
    return names.join(QLatin1Char(' '));
}

ByteVector polyCounts(std::initializer_list<std::uint64_t> counts)
{
    WireBytes content;
    for (const std::uint64_t count : counts) {
        content.u32(count);
    }
    return content.bytes();
}

QString messageOf(const core::Status& status)
{
    return QString::fromStdString(status.message());
}

} // namespace

class IgtlWire : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void computesTheChecksumOfEcma182()
    {
        const std::string digits = "123456789";
        const ByteVector bytes(digits.begin(), digits.end());
        QCOMPARE(igtl::crc64(bytes), 0x6C40DF5F0B497347U); // check value of CRC-64/ECMA-182
        QCOMPARE(slowCrc64(bytes), 0x6C40DF5F0B497347U);
    }

    void writesWhatItReads_data()
    {
        QTest::addColumn<unsigned>("version");
        QTest::newRow("header 1") << 1U;
        QTest::newRow("header 2") << 2U;
    }

    void writesWhatItReads()
    {
        QFETCH(const unsigned, version);
        const ByteVector content{1, 2, 3};
        const igtl::Bytes written = igtl::encodeMessage("STATUS", "name of more than twenty bytes", content, 5,
                                                        static_cast<std::uint16_t>(version));
        ByteVector expected =
            wireMessage("STATUS", "name of more than tw", content, {.version = version, .timestamp = 5});
        if (version == 2) { // but for the number of the message
            QCOMPARE(written.size(), expected.size());
        } else {
            QCOMPARE(written, expected);
        }
        QCOMPARE(readAll(written, written.size()), QStringLiteral("name of more than tw/3"));
    }

    void framesTheStream_data()
    {
        QTest::addColumn<ByteVector>("bytes");
        QTest::addColumn<QString>("expected");
        const ByteVector one = transformAt("a", 1, 2, 3);
        const ByteVector two = transformAt("b", 1, 2, 3, {.version = 2});
        const auto of = [](Framing framing, const char* type = "TRANSFORM") {
            return wireMessage(type, "x", ByteVector(48, 1), framing);
        };
        QTest::newRow("one") << one << "a/48";
        QTest::newRow("two in one packet") << joinedBytes({one, two}) << "a/48 b/48";
        QTest::newRow("metadata") << transformAt("m", 1, 2, 3, {.version = 2, .metadata = 8}) << "m/48";
        QTest::newRow("name without a zero")
            << transformAt("12345678901234567890", 1, 2, 3) << "12345678901234567890/48";
        QTest::newRow("longer extended header")
            << wireMessage("STATUS", "e", ByteVector(40), {.version = 2, .extended = 20}) << "e/32";
        QTest::newRow("empty body") << wireMessage("GET_STATUS", "g", {}) << "g/0";
        QTest::newRow("empty body of header 2") << joinedBytes({wireMessage("GET_STATUS", "g", {}), one}) << "g/0 a/48";
        QTest::newRow("wrong checksum") << joinedBytes({of({.isChecksumWrong = true}), one}) << "refused a/48";
        QTest::newRow("unknown type") << joinedBytes({wireMessage("IMAGE", "i", ByteVector(100000)), one})
                                      << "skipped a/48";
        QTest::newRow("unknown type, empty") << joinedBytes({wireMessage("VIDEO", "i", {}), one}) << "skipped a/48";
        QTest::newRow("type of twelve bytes")
            << joinedBytes({wireMessage("ABCDEFGHIJKL", "i", {1}), one}) << "skipped a/48";
        QTest::newRow("body of 2^31") << of({.size = std::int64_t{1} << 31}) << "lost";
        QTest::newRow("unknown body of 2^31") << of({.size = std::int64_t{1} << 31}, "IMAGE") << "lost";
        QTest::newRow("surface of 2^31") << of({.size = std::int64_t{1} << 31}, "POLYDATA") << "lost";
        ByteVector most = one;
        std::fill(most.begin() + 42, most.begin() + 50, std::uint8_t{255});
        QTest::newRow("body of 2^64-1") << most << "lost";
        // The checksum is over what the size states.
        QTest::newRow("size shorter than the content") << joinedBytes({of({.size = 40}), one}) << "refused lost";
        QTest::newRow("size longer than the content") << joinedBytes({of({.size = 60}), one, one}) << "refused lost";
        QTest::newRow("header 3") << of({.version = 3}) << "lost";
        QTest::newRow("header 0") << of({.version = 0}) << "lost";
        QTest::newRow("another protocol") << ByteVector(200, 'G') << "lost";
        QTest::newRow("extended header too short")
            << joinedBytes({of({.version = 2, .extended = 11}), one}) << "refused a/48";
        QTest::newRow("extended header too long")
            << joinedBytes({of({.version = 2, .extended = 999}), one}) << "refused a/48";
        ByteVector metadata = WireBytes().u16(12).u16(65535).u32(4294967295U).u32(0).bytes();
        ByteVector hostile = wireMessage("STATUS", "x", metadata);
        hostile[1] = 2;
        QTest::newRow("metadata beyond the body") << joinedBytes({hostile, one}) << "refused a/48";
        ByteVector tiny = wireMessage("STATUS", "x", {1, 2, 3});
        tiny[1] = 2;
        QTest::newRow("body shorter than its extended header") << joinedBytes({tiny, one}) << "refused a/48";
    }

    void framesTheStream()
    {
        QFETCH(const ByteVector, bytes);
        QFETCH(const QString, expected);
        QCOMPARE(readAll(bytes, bytes.size()), expected);
        QCOMPARE(readAll(bytes, 1), expected);
        QCOMPARE(readAll(bytes, 59), expected);
    }

    void storesNothingOfWhatItSkips()
    {
        MessageReader reader(false);
        for (const char* type : {"IMAGE", "POLYDATA"}) {
            const ByteVector header = wireMessage(type, "x", {}, {.size = 100'000'000});
            reader.add(header);
            QCOMPARE(reader.next(), Step::Skipped);
            const ByteVector chunk(1'000'000);
            for (int i = 0; i < 100; ++i) {
                QCOMPARE(reader.next(), Step::NeedsMore);
                reader.add(chunk);
                QCOMPARE(reader.stored_bytes(), std::size_t{0});
            }
        }
        reader.add(transformAt("a", 1, 2, 3));
        QCOMPARE(reader.next(), Step::Complete);
    }

    void decodesTransforms()
    {
        // A quarter turn about z: x goes to y.
        const ByteVector content = WireBytes().f32({0, 1, 0, -1, 0, 0, 0, 0, 1, 10, 20, 30}).bytes();
        const auto transform = igtl::decodeTransform(content);
        QVERIFY(transform.isOk());
        QCOMPARE(igtl::encodeTransform(transform.value()), content);
        const auto pose = igtl::poseOf(transform.value());
        QVERIFY(pose.has_value());
        QVERIFY((pose->q * core::Vec3::UnitX() - core::Vec3::UnitY()).norm() < 1e-6);
        const igtl::Pose lps = igtl::toggleRas(*pose);
        QCOMPARE(lps.p_mm, core::Vec3(-10, -20, 30));
        QVERIFY((lps.q * core::Vec3::UnitX() - core::Vec3::UnitY()).norm() < 1e-6); // x and y are both negated
        const igtl::Pose tilted{core::Vec3(1, 2, 3), core::Quaternion(Eigen::AngleAxisd(0.3, core::Vec3::UnitX()))};
        const Eigen::Matrix3d F = core::Vec3(-1, -1, 1).asDiagonal();
        QVERIFY((igtl::toggleRas(tilted).q.toRotationMatrix() - F * tilted.q.toRotationMatrix() * F).norm() < 1e-12);
    }

    void refusesMatricesThatAreNoPose_data()
    {
        QTest::addColumn<ByteVector>("content");
        const auto row = [](const char* name, std::initializer_list<double> numbers) {
            QTest::newRow(name) << WireBytes().f32(numbers).bytes();
        };
        row("singular", {1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0});
        row("zero", {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
        row("scaled by 2 %", {1.02, 0, 0, 0, 1.02, 0, 0, 0, 1.02, 0, 0, 0});
        row("metres", {0.001, 0, 0, 0, 0.001, 0, 0, 0, 0.001, 0, 0, 0});
        row("mirrored", {-1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
        row("sheared", {1, 0, 0, 0.1, 1, 0, 0, 0, 1, 0, 0, 0});
        row("NaN in the rotation", {kNaN, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
        row("NaN in the position", {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, kNaN, 0});
        row("infinite", {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, HUGE_VAL, 0});
        row("out of reach", {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 2e6, 0});
    }

    void refusesMatricesThatAreNoPose()
    {
        QFETCH(const ByteVector, content);
        const auto transform = igtl::decodeTransform(content);
        QVERIFY(transform.isOk());
        QVERIFY(!igtl::poseOf(transform.value()));
    }

    void decodesPositions()
    {
        const ByteVector content = WireBytes().f32({1, 2, 3, 0, 0, 0.6, 0.8}).bytes();
        const auto pose = igtl::decodePosition(content);
        QVERIFY2(pose.isOk(), pose.status().message().c_str());
        QCOMPARE(pose.value().p_mm, core::Vec3(1, 2, 3));
        QVERIFY(std::abs(pose.value().q.z() - 0.6) < 1e-6);
        QVERIFY(std::abs(pose.value().q.w() - 0.8) < 1e-6);
        QCOMPARE(igtl::encodePosition(pose.value()), content);
        QVERIFY(igtl::decodePosition(WireBytes().f32({1, 2, 3}).bytes()).isOk());
        QVERIFY(!igtl::decodePosition(WireBytes().f32({1, 2, 3, 0, 0, 0, 0}).bytes()).isOk());
        QVERIFY(!igtl::decodePosition(WireBytes().f32({1, kNaN, 3, 0, 0, 0, 1}).bytes()).isOk());
        QVERIFY(!igtl::decodePosition(WireBytes().f32({1, 2, 3, 0, 0, kNaN, 1}).bytes()).isOk());
        QVERIFY(!igtl::decodePosition(ByteVector(27)).isOk());
    }

    void decodesTheOtherTypes()
    {
        const std::vector<igtl::TrackedTool> tools{{"Stylus", 2, {}}, {"12345678901234567890", 3, {}}};
        const auto read = igtl::decodeTrackingData(igtl::encodeTrackingData(tools));
        QVERIFY(read.isOk());
        QCOMPARE(read.value().size(), std::size_t{2});
        QCOMPARE(read.value()[1].name, tools[1].name);
        QCOMPARE(igtl::encodeTrackingData(tools), WireBytes()
                                                      .text("Stylus", 20)
                                                      .u8(2)
                                                      .u8(0)
                                                      .f32({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0})
                                                      .text("12345678901234567890", 20)
                                                      .u8(3)
                                                      .u8(0)
                                                      .f32({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0})
                                                      .bytes());

        const ByteVector status = WireBytes().u16(16).u64(9).text("absent", 20).text("no tool", 8).bytes();
        const auto state = igtl::decodeStatus(status);
        QVERIFY(state.isOk());
        QCOMPARE(state.value().code, std::uint16_t{16});
        QCOMPARE(state.value().text, std::string("no tool"));
        QCOMPARE(igtl::encodeStatus(state.value()), status);

        const ByteVector text = WireBytes().u16(3).u16(5).text("lump!", 5).bytes();
        QCOMPARE(igtl::decodeString(text).value(), std::string("lump!"));
        QCOMPARE(igtl::encodeString("lump!"), text);
        QCOMPARE(igtl::encodeString(std::string(70000, 'x')).size(), std::size_t{65539});

        const ByteVector sensor = WireBytes().u8(2).u8(0).u64(7).f64(1.5).f64(-2.0).bytes();
        const auto reading = igtl::decodeSensor(sensor);
        QVERIFY(reading.isOk());
        QCOMPARE(reading.value().values, (std::vector<double>{1.5, -2.0}));
        QCOMPARE(igtl::encodeSensor(reading.value()), sensor);

        const ByteVector request = WireBytes().u32(50).text("CAMERA", 32).bytes();
        QCOMPARE(igtl::decodeTrackingRequest(request).value().interval_ms, 50U);
        QCOMPARE(igtl::encodeTrackingRequest({50, "CAMERA"}), request);
        QVERIFY(igtl::decodeTrackingRequest(WireBytes().u32(50).bytes()).isOk());
        QVERIFY(!igtl::decodeTrackingRequest({}).isOk());
    }

    void namesQueries()
    {
        QCOMPARE(igtl::queryOf("GET_TRANS")->type, std::string("TRANSFORM"));
        QCOMPARE(igtl::queryOf("GET_TRANSFOR")->type, std::string("TRANSFORM"));
        QCOMPARE(igtl::queryOf("STT_TDATA")->kind, igtl::QueryKind::Start);
        QCOMPARE(igtl::queryOf("STP_TDATA")->kind, igtl::QueryKind::Stop);
        QCOMPARE(igtl::queryOf("RTS_TDATA")->kind, igtl::QueryKind::Answer);
        QVERIFY(!igtl::queryOf("TRANSFORM"));
    }

    void refusesCountsBeyondTheContent_data()
    {
        QTest::addColumn<QString>("type");
        QTest::addColumn<ByteVector>("content");
        QTest::newRow("TRANSFORM") << "TRANSFORM" << ByteVector(47);
        QTest::newRow("TRANSFORM, longer") << "TRANSFORM" << ByteVector(52);
        QTest::newRow("TDATA") << "TDATA" << ByteVector(71);
        QTest::newRow("STATUS") << "STATUS" << ByteVector(29);
        QTest::newRow("STRING, empty") << "STRING" << ByteVector();
        QTest::newRow("STRING") << "STRING" << WireBytes().u16(3).u16(65535).text("x", 1).bytes();
        QTest::newRow("SENSOR, empty") << "SENSOR" << ByteVector(9);
        QTest::newRow("SENSOR") << "SENSOR" << WireBytes().u8(255).u8(0).u64(0).f64(1).bytes();
        QTest::newRow("POLYDATA, empty") << "POLYDATA" << ByteVector(39);
        QTest::newRow("POLYDATA, points") << "POLYDATA" << polyCounts({4294967295U, 0, 0, 0, 0, 0, 0, 0, 0, 0});
        QTest::newRow("POLYDATA, cells") << "POLYDATA" << polyCounts({0, 0, 0, 0, 0, 4294967295U, 0, 0, 0, 0});
        QTest::newRow("POLYDATA, size") << "POLYDATA" << polyCounts({0, 0, 0, 0, 0, 1, 4294967295U, 0, 0, 0});
        QTest::newRow("POLYDATA, all") << "POLYDATA"
                                       << polyCounts({4294967295U, 4294967295U, 4294967295U, 4294967295U, 4294967295U,
                                                      4294967295U, 4294967295U, 4294967295U, 4294967295U, 4294967295U});
        const auto cells = [](std::initializer_list<std::uint64_t> words, unsigned count, bool isStrip) {
            WireBytes content;
            const unsigned size = static_cast<unsigned>(words.size() * 4);
            content.raw(isStrip ? polyCounts({3, 0, 0, 0, 0, 0, 0, count, size, 0})
                                : polyCounts({3, 0, 0, 0, 0, count, size, 0, 0, 0}));
            content.f32({0, 0, 0, 1, 0, 0, 0, 1, 0});
            for (const std::uint64_t word : words) {
                content.u32(word);
            }
            return content.bytes();
        };
        QTest::newRow("POLYDATA, corners") << "POLYDATA" << cells({4294967295U, 0, 1, 2}, 1, false);
        QTest::newRow("POLYDATA, index") << "POLYDATA" << cells({3, 0, 1, 3}, 1, false);
        QTest::newRow("POLYDATA, largest index") << "POLYDATA" << cells({3, 0, 1, 4294967295U}, 1, false);
        QTest::newRow("POLYDATA, index of a strip") << "POLYDATA" << cells({3, 0, 1, 3}, 1, true);
        QTest::newRow("POLYDATA, fewer cells than bytes") << "POLYDATA" << cells({3, 0, 1, 2, 3, 0, 1, 2}, 1, false);
        QTest::newRow("POLYDATA, more cells than bytes") << "POLYDATA" << cells({3, 0, 1, 2}, 2, false);
        QTest::newRow("POLYDATA, no triangle") << "POLYDATA" << cells({2, 0, 1}, 1, false);
        QTest::newRow("POLYDATA, no cell") << "POLYDATA" << cells({}, 0, false);
        ByteVector point = cells({3, 0, 1, 2}, 1, false);
        point[40] = 0x7f;
        point[41] = 0xc0; // NaN
        QTest::newRow("POLYDATA, NaN") << "POLYDATA" << point;
    }

    void refusesCountsBeyondTheContent()
    {
        QFETCH(const QString, type);
        QFETCH(const ByteVector, content);
        core::Status status;
        if (type == QLatin1String("TRANSFORM")) {
            status = igtl::decodeTransform(content).status();
        } else if (type == QLatin1String("TDATA")) {
            status = igtl::decodeTrackingData(content).status();
        } else if (type == QLatin1String("STATUS")) {
            status = igtl::decodeStatus(content).status();
        } else if (type == QLatin1String("STRING")) {
            status = igtl::decodeString(content).status();
        } else if (type == QLatin1String("SENSOR")) {
            status = igtl::decodeSensor(content).status();
        } else {
            status = igtl::decodeSurface(content).status();
        }
        QVERIFY(!status.isOk());
        QVERIFY2(messageOf(status).startsWith(type), qPrintable(messageOf(status)));
    }

    void decodesSurfaces()
    {
        const auto surface = igtl::decodeSurface(tetrahedron());
        QVERIFY2(surface.isOk(), surface.status().message().c_str());
        QCOMPARE(surface.value().points.size(), std::size_t{4});
        QCOMPARE(surface.value().triangles.size(), std::size_t{4});
        QCOMPARE(igtl::encodeSurface(surface.value()), tetrahedron());

        // A vertex and a line, a quadrangle, a strip of three triangles, an attribute.
        WireBytes content;
        content.raw(polyCounts({5, 1, 8, 1, 12, 1, 20, 1, 24, 1}));
        content.f32({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 2, 0});
        content.u32(1).u32(0).u32(2).u32(0).u32(1);
        content.u32(4).u32(0).u32(1).u32(2).u32(3);
        content.u32(5).u32(0).u32(1).u32(3).u32(2).u32(4);
        content.u16(1).u32(5).text("a", 2).f32({1, 2, 3, 4, 5});
        const auto mixed = igtl::decodeSurface(content.bytes());
        QVERIFY2(mixed.isOk(), mixed.status().message().c_str());
        QCOMPARE(mixed.value().vertices, 1U);
        QCOMPARE(mixed.value().lines, 1U);
        const std::vector<std::array<std::uint32_t, 3>> expected{{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {3, 1, 2}, {3, 2, 4}};
        QCOMPARE(mixed.value().triangles, expected);
    }
};

PALPATE_TEST(IgtlWire)
#include "tst_IgtlWire.moc"

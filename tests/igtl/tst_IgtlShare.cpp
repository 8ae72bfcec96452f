// SPDX-License-Identifier: BSD-3-Clause
// The server against peers that write bytes themselves: the messages that they get; none of them delays another.
#include "TestRunner.h"
#include "WireBytes.h"
#include "WirePeer.h"

#include <palpate/core/Clock.h>
#include <palpate/igtl/ShareServer.h>

#include <atomic>
#include <cmath>
#include <mutex>
#include <thread>

using namespace palpate;
using namespace palpate::test;

class IgtlShare : public QObject
{
    Q_OBJECT

  private:
    std::unique_ptr<igtl::ShareServer> m_server;
    std::uint16_t m_port = 0;
    std::thread m_toucher;
    std::atomic<bool> m_isOver{false};
    std::mutex m_mutex;
    std::vector<igtl::ReceivedSurface> m_surfaces;

    void begin(double rate_Hz = 200.0)
    {
        m_server = std::make_unique<igtl::ShareServer>();
        const core::Status status =
            m_server->start({.port = 0, .rate_Hz = rate_Hz, .takesSurfaces = true}, [this](igtl::ReceivedSurface one) {
                const std::scoped_lock lock(m_mutex);
                m_surfaces.push_back(std::move(one));
            });
        QVERIFY2(status.isOk(), status.message().c_str());
        m_port = m_server->report().port;
        QVERIFY(m_port != 0);
    }

    /// Touches 500 times a second from another thread, as the window does at its rate.
    void touch()
    {
        m_toucher = std::thread([this] {
            while (!m_isOver) {
                m_server->setTouch({{1, 2, 3}, {4, 5, 6}, {0.1, 0.2, 0.3}, true});
                core::sleepUntil_ns(core::monotonicNow_ns() + 2'000'000);
            }
        });
    }

    std::size_t surfaces()
    {
        const std::scoped_lock lock(m_mutex);
        return m_surfaces.size();
    }

  private Q_SLOTS:
    void cleanup()
    {
        m_isOver = true;
        if (m_toucher.joinable()) {
            m_toucher.join();
        }
        m_isOver = false;
        m_server.reset();
        m_surfaces.clear();
    }

    void sendsTheTouchInRas()
    {
        begin();
        touch();
        WirePeer peer;
        QVERIFY(peer.connect(m_port));
        std::map<std::string, WireText> seen;
        while (seen.size() < 3) {
            const WireText message = peer.read("TRANSFORM");
            QVERIFY(!message.type.empty());
            QVERIFY(message.isChecksumRight);
            QVERIFY(message.name.size() <= 20);
            QCOMPARE(message.content.size(), std::size_t{48});
            QVERIFY(message.timestamp >> 32 > 1'700'000'000U); // seconds since 1970
            QCOMPARE(message.f32(0), 1.0);
            seen[message.name] = message;
        }
        QCOMPARE(seen["PalpateHand"].f32(36), -1.0);
        QCOMPARE(seen["PalpateHand"].f32(40), -2.0);
        QCOMPARE(seen["PalpateHand"].f32(44), 3.0);
        QCOMPARE(seen["PalpateGodObject"].f32(36), -4.0);
        QVERIFY(std::abs(seen["PalpateForce"].f32(36) + 0.1) < 1e-6);
        QVERIFY(std::abs(seen["PalpateForce"].f32(44) - 0.3) < 1e-6);
    }

    void sendsNothingWithoutAHand()
    {
        begin();
        WirePeer peer;
        QVERIFY(peer.connect(m_port));
        m_server->setTouch({{1, 2, 3}, {4, 5, 6}, {0, 0, 0}, false});
        QCOMPARE(peer.read({}, 100).type, std::string());
        m_server->setTouch({{1, 2, 3}, {4, 5, 6}, {0, 0, 0}, true});
        for (int i = 0; i < 3; ++i) {
            QCOMPARE(peer.read().type, std::string("TRANSFORM"));
        }
        QCOMPARE(peer.read({}, 100).type, std::string()); // each touch once
    }

    void sendsTextsToEachPeer()
    {
        begin();
        m_server->setText("PalpateFindings", "lump");
        WirePeer first, second;
        QVERIFY(first.connect(m_port));
        QCOMPARE(first.read("STRING").content, WireBytes().u16(3).u16(4).text("lump", 4).bytes());
        m_server->setText("PalpateFindings", "lump 2");
        QCOMPARE(first.read("STRING").content, WireBytes().u16(3).u16(6).text("lump 2", 6).bytes());
        QVERIFY(second.connect(m_port));
        const WireText text = second.read("STRING");
        QCOMPARE(text.name, std::string("PalpateFindings"));
        QCOMPARE(text.content, WireBytes().u16(3).u16(6).text("lump 2", 6).bytes());
        QCOMPARE(first.read({}, 50).type, std::string()); // once
        QVERIFY(first.write(wireMessage("GET_STRING", "", {})));
        QCOMPARE(first.read("STRING").content.size(), std::size_t{10});
    }

    /// In any order, twice, with either header.
    void answersQueries()
    {
        begin();
        touch();
        WirePeer peer;
        QVERIFY(peer.connect(m_port));
        QVERIFY(peer.write(wireMessage("RTS_TDATA", "", {0}))); // unasked
        QVERIFY(peer.write(wireMessage("STP_TDATA", "", {})));  // nothing to stop
        QCOMPARE(peer.read("RTS_TDATA").content, std::vector<std::uint8_t>{0});
        const auto start = WireBytes().u32(5).text("", 32).bytes();
        for (const unsigned version : {1U, 2U}) {
            QVERIFY(peer.write(wireMessage("STT_TDATA", "", start, {.version = version})));
            QCOMPARE(peer.read("RTS_TDATA").content, std::vector<std::uint8_t>{0});
        }
        const WireText tools = peer.read("TDATA");
        QCOMPARE(tools.content.size(), std::size_t{140});
        QCOMPARE(tools.f32(22 + 36), -1.0);
        QVERIFY(peer.write(wireMessage("STP_TDATA", "", {})));
        QVERIFY(peer.write(wireMessage("STP_TRANS", "", {})));
        QCOMPARE(peer.read("RTS_TDATA").content, std::vector<std::uint8_t>{0});
        QCOMPARE(peer.read("RTS_TRANS").content, std::vector<std::uint8_t>{0});
        QCOMPARE(peer.read({}, 100).type, std::string());
        QVERIFY(peer.write(wireMessage("GET_TRANS", "", {})));
        QCOMPARE(peer.read().type, std::string("TRANSFORM"));
        QVERIFY(peer.write(wireMessage("GET_STATUS", "", {})));
        QCOMPARE(peer.read("STATUS").content[1], std::uint8_t{1});
        QVERIFY(peer.write(wireMessage("STT_TRANSFOR", "", {})));
        QCOMPARE(peer.read("RTS_TRANS").content, std::vector<std::uint8_t>{0});
        QCOMPARE(peer.read().type, std::string("TRANSFORM"));
        QVERIFY(peer.write(wireMessage("STT_IMAGE", "", {}))); // not offered
        QCOMPARE(peer.read("RTS_IMAGE").content, std::vector<std::uint8_t>{1});
        QVERIFY(peer.write(wireMessage("STT_TDATA", "", {1}))); // no interval
        QCOMPARE(peer.read("RTS_TDATA").content, std::vector<std::uint8_t>{1});
    }

    void receivesSurfaces()
    {
        begin();
        WirePeer first, second;
        QVERIFY(first.connect(m_port));
        QVERIFY(second.connect(m_port));
        QVERIFY(first.write(wireMessage("POLYDATA", "liver", tetrahedron()), 7));
        QVERIFY(second.write(wireMessage("POLYDATA", "liver", tetrahedron(), {.version = 2}))); // two of one name
        PALPATE_TRY_COMPARE(surfaces(), std::size_t{2});
        QCOMPARE(m_surfaces[0].name, std::string("liver"));
        QCOMPARE(m_surfaces[1].surface.triangles.size(), std::size_t{4});
        QVERIFY(first.write(wireMessage("POLYDATA", "bad", {1, 2, 3})));
        PALPATE_TRY_COMPARE(m_server->report().refused, std::uint64_t{1});
        QVERIFY(QString::fromStdString(m_server->report().problem).contains(QLatin1String("\"bad\": POLYDATA")));
        QVERIFY(first.write(wireMessage("POLYDATA", "kidney", tetrahedron())));
        PALPATE_TRY_COMPARE(surfaces(), std::size_t{3});
    }

    void closesWithASenderOfNonsense()
    {
        begin();
        WirePeer bad, good;
        QVERIFY(bad.connect(m_port));
        QVERIFY(good.connect(m_port));
        PALPATE_TRY_COMPARE(m_server->report().peers.size(), std::size_t{2});
        QVERIFY(bad.write(wireMessage("POLYDATA", "x", {}, {.size = std::int64_t{1} << 31})));
        QVERIFY(bad.isClosedByOther(10000));
        PALPATE_TRY_COMPARE(m_server->report().peers.size(), std::size_t{1});
        QVERIFY2(m_server->report().problem.find("2,147,483,648") != std::string::npos,
                 m_server->report().problem.c_str());
        touch();
        QCOMPARE(good.read().type, std::string("TRANSFORM"));
    }

    /// Peers that never read fill their buffers; the others get every transform, and the window is not delayed.
    void isNotDelayedByAPeerThatNeverReads()
    {
        begin(1000.0);
        WirePeer silent, good;
        QVERIFY(silent.connect(m_port));
        QVERIFY(good.connect(m_port));
        PALPATE_TRY_COMPARE(m_server->report().peers.size(), std::size_t{2});
        const std::string text(60000, 'x');
        std::int64_t slowest_ns = 0;
        for (int i = 0; i < 400; ++i) {
            const std::int64_t before_ns = core::monotonicNow_ns();
            m_server->setText("PalpateFindings", text + std::to_string(i));
            m_server->setTouch({{1, 2, 3}, {4, 5, 6}, {0, 0, 0}, true});
            slowest_ns = std::max(slowest_ns, core::monotonicNow_ns() - before_ns);
            QVERIFY(!good.read("STRING").type.empty());
        }
        QVERIFY(m_server->report().dropped > 0);
        QVERIFY2(slowest_ns < 500'000'000, qPrintable(QString::number(slowest_ns)));
        // Once it reads again, it gets the newest text.
        std::string last;
        while (!last.ends_with("x399")) {
            const WireText message = silent.read("STRING");
            QVERIFY(!message.type.empty());
            last.assign(message.content.begin(), message.content.end());
        }
        const std::int64_t before_ns = core::monotonicNow_ns();
        m_server->stop();
        QVERIFY(core::monotonicNow_ns() - before_ns < 2'000'000'000);
    }

    void goesOnWhenPeersDieAndReturn()
    {
        begin();
        touch();
        for (int i = 0; i < 20; ++i) {
            WirePeer peer;
            QVERIFY(peer.connect(m_port));
            QVERIFY(peer.write(wireMessage("POLYDATA", "cut", {}, {.size = 1000}))); // and dies within it
            QCOMPARE(peer.read("TRANSFORM").type, std::string("TRANSFORM"));
        }
        PALPATE_TRY_COMPARE(m_server->report().peers.size(), std::size_t{0});
        QCOMPARE(m_server->report().refused, std::uint64_t{0});
    }

    void limitsTheNumberOfPeers()
    {
        begin();
        std::vector<std::unique_ptr<WirePeer>> peers;
        for (std::size_t i = 0; i < igtl::ShareServer::kMaxPeers; ++i) {
            peers.push_back(std::make_unique<WirePeer>());
            QVERIFY(peers.back()->connect(m_port));
        }
        PALPATE_TRY_COMPARE(m_server->report().peers.size(), igtl::ShareServer::kMaxPeers);
        WirePeer another;
        QVERIFY(another.connect(m_port));
        QVERIFY(another.isClosedByOther(10000));
        QCOMPARE(m_server->report().peers.size(), igtl::ShareServer::kMaxPeers);
    }

    void refusesAPortInUse()
    {
        begin();
        igtl::ShareServer second;
        const core::Status status = second.start({.port = m_port});
        QVERIFY(!status.isOk());
        QVERIFY2(status.message().find(std::to_string(m_port)) != std::string::npos, status.message().c_str());
        QCOMPARE(second.start({.address = "localhost"}).code(), core::StatusCode::BadCommandLine);
        QVERIFY(!second.isRunning());
        m_server->stop();
        QVERIFY(second.start({.port = m_port}).isOk()); // at once
    }
};

PALPATE_TEST(IgtlShare)
#include "tst_IgtlShare.moc"

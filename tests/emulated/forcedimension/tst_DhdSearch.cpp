// SPDX-License-Identifier: BSD-3-Clause
// The maker's library found in an unpacked SDK, and ticks of the real-time thread counted. In real time.
#include "EmulatedArm.h"
#include "EmulatedDhd.h"
#include "RealtimeGuard.h"
#include "TestRunner.h"

#include <filesystem>
#include <fstream>

using namespace palpate;
using namespace palpate::test;

class DhdSearch : public QObject
{
    Q_OBJECT

  private:
    std::unique_ptr<EmulatedDhd> m_bench;
    std::unique_ptr<device::PluginHost> m_host;

  private Q_SLOTS:
    void initTestCase()
    {
        m_bench = std::make_unique<EmulatedDhd>();
        m_host = shippingPlugins();
    }

    /// The SDK contains only the long name, and users forget the link.
    void longNameInAnSdkIsFound()
    {
        m_bench->removeSettings();
        const std::filesystem::path folder = m_bench->folder() + "/sdk-3.14/lib/release/lin-x86_64-gcc";
        std::filesystem::create_directories(folder);
        std::ofstream(folder / "libdhd.so.3.9.0") << "older, and broken\n";
        std::filesystem::copy_file(PALPATE_DHD_WHOLE "/libdhd.so.3", folder / "libdhd.so.3.14.0");
        setenv("FDSDK", (m_bench->folder() + "/sdk-3.14").c_str(), 1);
        const auto made = m_host->make("forcedimension");
        QVERIFY2(made.isOk(), made.status().message().c_str());
        QCOMPARE(m_host->find("forcedimension").value().at(0).name, std::string("emulated omega"));
    }

    void ticksNeitherAllocateNorLock()
    {
        if (!RealtimeGuard::isAvailable()) {
            QSKIP("not counted under this sanitizer");
        }
        const auto device = m_bench->make(*m_host);
        QVERIFY(device != nullptr);
        QVERIFY(device->start().isOk());
        std::uint64_t calls = 0;
        for (int i = 0; i < 300; ++i) {
            pass(0.001);
            const RealtimeGuard guard;
            const device::DeviceState state = device->read(core::monotonicNow_ns());
            device->write(state.p_D * 0.01);
            calls += guard.all();
        }
        QCOMPARE(calls, std::uint64_t{0});
        QVERIFY(device->report().states > 100);
        device->stop();
        QVERIFY(!m_bench->violation().startsWith(QLatin1String("driven with")));
    }
};

PALPATE_TEST(DhdSearch)
#include "tst_DhdSearch.moc"

// SPDX-License-Identifier: BSD-3-Clause
// Ticks of the real-time thread and callbacks of the library, counted, and the locale of the user. In real time.
#include "EmulatedArm.h"
#include "EmulatedHd.h"
#include "RealtimeGuard.h"
#include "TestRunner.h"

#include <QProcess>

#include <atomic>
#include <clocale>
#include <dlfcn.h>
#include <optional>

using namespace palpate;
using namespace palpate::test;

namespace {

std::atomic<std::uint64_t> callbacks{0};
std::atomic<std::uint64_t> calls{0}; // of a callback, outside of the library

/// Counts from the begin of a callback or the return of the library to the end of the callback or the next call of the
/// library.
void countCallback(int what)
{
    thread_local std::optional<RealtimeGuard> guard;
    if (what == 1 || what == 4) {
        callbacks += what == 1 ? 1 : 0;
        guard.emplace();
    } else if (guard.has_value()) {
        calls += guard->all();
        guard.reset();
    }
}

} // namespace

class HdRealtime : public QObject
{
    Q_OBJECT

  private:
    std::unique_ptr<EmulatedHd> m_bench;
    std::unique_ptr<device::PluginHost> m_host;

  private Q_SLOTS:
    void initTestCase()
    {
        m_bench = std::make_unique<EmulatedHd>();
        m_host = shippingPlugins();
    }
    void init() { m_bench->renew(); }
    void cleanup() { QVERIFY(!m_bench->violation().contains(QLatin1String("misuse"))); }

    /// The library reads numbers with the C library: with a decimal comma, joint angles would stay zero.
    void decimalCommaDoesNotMatter()
    {
        const std::string folder = m_bench->folder();
        QProcess::execute(QStringLiteral("localedef"),
                          {QStringLiteral("-c"), QStringLiteral("-i"), QStringLiteral("de_DE"), QStringLiteral("-f"),
                           QStringLiteral("UTF-8"), QString::fromStdString(folder + "/de_DE.UTF-8")});
        setenv("LOCPATH", folder.c_str(), 1);
        if (std::setlocale(LC_ALL, "de_DE.UTF-8") == nullptr) {
            QSKIP("this machine cannot make a German locale");
        }
        m_bench->with([](standin::HdBench& b) { b.devices[0].p = b.devices[0].to = {0.010, 0.020, 0.030}; });
        const auto device = m_bench->make(*m_host);
        const core::Status started = device->start();
        QVERIFY2(started.isOk(), started.message().c_str());
        pass(0.02);
        const core::Vec3 p_mm = device->read(core::monotonicNow_ns()).p_D;
        device->stop();
        const bool isComma = std::localeconv()->decimal_point[0] == ','; // the user's locale is left alone
        std::setlocale(LC_ALL, "C");
        unsetenv("LOCPATH");
        QVERIFY2((p_mm - core::Vec3(10, 20, 30)).norm() < 1e-6, qPrintable(QString::number(p_mm.norm())));
        QVERIFY(isComma);
    }

    void ticksAndCallbacksNeitherAllocateNorLock()
    {
        if (!RealtimeGuard::isAvailable()) {
            QSKIP("not counted under this sanitizer");
        }
        const auto device = m_bench->make(*m_host);
        QVERIFY(device != nullptr);
        QVERIFY(device->start().isOk());
        pass(0.05); // the first callbacks
        void* const library = dlopen(PALPATE_HD_WHOLE "/libHD.so.3.4", RTLD_NOW | RTLD_NOLOAD);
        QVERIFY(library != nullptr);
        const auto setHook = reinterpret_cast<void (*)(void (*)(int))>(dlsym(library, "standin_setHook"));
        QVERIFY(setHook != nullptr);
        setHook(countCallback);
        std::uint64_t inTicks = 0;
        for (int i = 0; i < 300; ++i) {
            pass(0.001);
            const RealtimeGuard guard;
            const device::DeviceState state = device->read(core::monotonicNow_ns());
            device->write(state.p_D * 0.01);
            inTicks += guard.all();
        }
        // Also while things go wrong.
        m_bench->with([](standin::HdBench& b) {
            b.devices[0].faults.failing = 0.2;
            b.devices[0].faults.frameError = 0x0203;
            b.devices[0].calibration = 0x5001;
        });
        pass(0.1);
        setHook(nullptr);
        QCOMPARE(inTicks, std::uint64_t{0});
        QCOMPARE(calls.load(), std::uint64_t{0});
        QVERIFY2(callbacks > 150, qPrintable(QString::number(callbacks)));
        device->stop();
    }
};

PALPATE_TEST(HdRealtime)
#include "tst_HdRealtime.moc"

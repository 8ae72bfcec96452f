// SPDX-License-Identifier: BSD-3-Clause
// The maker's library missing, unusable, of another version: words instead of crashes, and silence where nobody asked.
// In this order, because a library that was loaded stays.
#include "EmulatedArm.h"
#include "EmulatedDhd.h"
#include "TestRunner.h"

#include <fstream>

using namespace palpate;
using namespace palpate::test;

class DhdLibrary : public QObject
{
    Q_OBJECT

  private:
    std::unique_ptr<EmulatedDhd> m_bench;
    std::unique_ptr<device::PluginHost> m_host;

    void expectRefusal(core::StatusCode code, const char* word)
    {
        const auto made = m_host->make("forcedimension");
        QVERIFY(!made.isOk());
        QCOMPARE(made.status().code(), code);
        const std::string& message = made.status().message();
        QVERIFY2(message.find(word) != std::string::npos, message.c_str());
        const auto found = m_host->find("forcedimension");
        QVERIFY(found.isOk());
        QCOMPARE(found.value().size(), std::size_t{1});
        QCOMPARE(found.value()[0].problem, message);
    }

  private Q_SLOTS:
    void initTestCase()
    {
        m_bench = std::make_unique<EmulatedDhd>();
        m_host = shippingPlugins();
    }

    void missingLibraryIsNamedOnlyWhenAskedFor()
    {
        m_bench->removeSettings();
        const auto found = m_host->find("forcedimension");
        QVERIFY(found.isOk() && found.value().empty());
        const auto made = m_host->make("forcedimension");
        QCOMPARE(made.status().code(), core::StatusCode::NotFound);
        for (const char* word : {"libdhd.so.3 was not found", "install the Force Dimension SDK", "\"library\""}) {
            QVERIFY2(made.status().message().find(word) != std::string::npos, made.status().message().c_str());
        }
    }

    void wrongPathIsNamed()
    {
        m_bench->configure("", "/nowhere/libdhd.so.3");
        expectRefusal(core::StatusCode::NotFound, "/nowhere/libdhd.so.3");
        m_bench->configure("", "libdhd.so.3");
        expectRefusal(core::StatusCode::BadCommandLine, "relative path");
        const std::string text = m_bench->folder() + "/text.so";
        std::ofstream(text) << "not a library\n";
        m_bench->configure("", text);
        expectRefusal(core::StatusCode::Unreadable, "text.so");
    }

    void wrongSettingsAreNamed()
    {
        m_bench->configure(R"(, "serial": 70000)");
        expectRefusal(core::StatusCode::OutOfRange, "serial");
        m_bench->configure(R"(, "max_force_N": "much")");
        expectRefusal(core::StatusCode::OutOfRange, "max_force_N");
    }

    void libraryWithoutHalfOfItsFunctionsIsRefused()
    {
        m_bench->configure("", PALPATE_DHD_HALF "/libdhd.so.3");
        expectRefusal(core::StatusCode::Mismatch, "dhdOpenSerial");
    }

    void anotherVersionIsRefused()
    {
        m_bench->configure();
        m_bench->with([](standin::DhdBench& b) { b.sdkMajor = 4; });
        expectRefusal(core::StatusCode::Mismatch, "version 4.14, expected version 3");
        m_bench->with([](standin::DhdBench& b) { b.sdkMajor = 3; });
    }
};

PALPATE_TEST(DhdLibrary)
#include "tst_DhdLibrary.moc"

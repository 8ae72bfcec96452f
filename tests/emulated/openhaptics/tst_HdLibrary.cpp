// SPDX-License-Identifier: BSD-3-Clause
// The maker's library missing, unusable, of another version: words instead of crashes, and silence where nobody asked.
// In this order, because a library that was loaded stays.
#include "EmulatedArm.h"
#include "EmulatedHd.h"
#include "TestRunner.h"

#include <dlfcn.h>
#include <fstream>

using namespace palpate;
using namespace palpate::test;

class HdLibrary : public QObject
{
    Q_OBJECT

  private:
    std::unique_ptr<EmulatedHd> m_bench;
    std::unique_ptr<device::PluginHost> m_host;

    void expectRefusal(core::StatusCode code, const char* word)
    {
        const auto made = m_host->make("openhaptics");
        QVERIFY(!made.isOk());
        QCOMPARE(made.status().code(), code);
        const std::string& message = made.status().message();
        QVERIFY2(message.find(word) != std::string::npos, message.c_str());
        const auto found = m_host->find("openhaptics");
        QVERIFY(found.isOk());
        QCOMPARE(found.value().size(), std::size_t{1});
        QCOMPARE(found.value()[0].problem, message);
    }

  private Q_SLOTS:
    void initTestCase()
    {
        m_bench = std::make_unique<EmulatedHd>();
        m_host = shippingPlugins();
    }

    void missingLibraryIsNamedOnlyWhenAskedFor()
    {
        m_bench->removeSettings();
        const auto found = m_host->find("openhaptics");
        QVERIFY(found.isOk() && found.value().empty());
        const auto made = m_host->make("openhaptics");
        QCOMPARE(made.status().code(), core::StatusCode::NotFound);
        for (const char* word : {"libHD.so.3.4 was not found", "install OpenHaptics", "\"library\"", "see the page"}) {
            QVERIFY2(made.status().message().find(word) != std::string::npos, made.status().message().c_str());
        }
    }

    void unusableLibraryIsRefused_data()
    {
        QTest::addColumn<QString>("library");
        QTest::addColumn<int>("code");
        QTest::addColumn<QByteArray>("word");
        const QString text = QString::fromStdString(m_bench->folder() + "/text.so");
        std::ofstream(text.toStdString()) << "not a library\n";
        const auto row = [](const char* name, const QString& library, core::StatusCode code, const char* word) {
            QTest::newRow(name) << library << static_cast<int>(code) << QByteArray(word);
        };
        row("missing", QStringLiteral("/nowhere/libHD.so.3.4"), core::StatusCode::NotFound, "/nowhere/libHD.so.3.4");
        row("relative", QStringLiteral("libHD.so.3.4"), core::StatusCode::BadCommandLine, "relative path");
        row("no library", text, core::StatusCode::Unreadable, "text.so");
        row("lacks functions", QStringLiteral(PALPATE_HD_HALF "/libHD.so.3.4"), core::StatusCode::Mismatch,
            "lacks 5 of the needed functions, the first is hdIsEnabled");
    }

    void unusableLibraryIsRefused()
    {
        QFETCH(const QString, library);
        QFETCH(const int, code);
        QFETCH(const QByteArray, word);
        m_bench->configure("", library.toStdString());
        expectRefusal(static_cast<core::StatusCode>(code), word.constData());
    }

    void wrongSettingsAreNamed()
    {
        m_bench->configure(R"(, "device": 7)");
        expectRefusal(core::StatusCode::BadFormat, "device");
        m_bench->configure(R"(, "max_force_N": "much")");
        expectRefusal(core::StatusCode::OutOfRange, "max_force_N");
    }

    /// The version is known when a device is open.
    void anotherVersionIsRefused()
    {
        m_bench->configure();
        m_bench->with([](standin::HdBench& b) { b.version = {"4.0.1"}; });
        const core::Status status = m_bench->make(*m_host)->start();
        QCOMPARE(status.code(), core::StatusCode::Mismatch);
        QVERIFY2(status.message().find("version 4.0.1, expected version 3") != std::string::npos,
                 status.message().c_str());
        QCOMPARE(m_host->find("openhaptics").value().at(0).problem, status.message());
        for (const char* version : {"", "3.4.0", "3", "unknown"}) {
            m_bench->with([version](standin::HdBench& b) {
                b.version = {};
                std::copy_n(version, std::char_traits<char>::length(version), b.version.begin());
            });
            const auto device = m_bench->make(*m_host);
            QVERIFY2(device->start().isOk(), version);
            device->stop();
        }
        QCOMPARE(m_bench->violation(), QString());
    }

    void withoutConfigurationTheDefaultIsTried()
    {
        m_bench->configureDevices({});
        QVERIFY(m_host->find("openhaptics").value().empty()); // the library cannot list devices
        const auto device = m_bench->make(*m_host);
        QVERIFY(device->start().isOk());
        device->stop();
    }

    /// Loaded, closed and loaded again in one process, the library fails.
    void libraryIsNeverUnloaded()
    {
        m_host.reset();
        void* const handle = dlopen(PALPATE_HD_WHOLE "/libHD.so.3.4", RTLD_NOW | RTLD_NOLOAD);
        QVERIFY(handle != nullptr);
        for (int i = 0; i < 3; ++i) {
            (void)dlclose(handle); // more often than it was opened
        }
        QVERIFY(dlopen(PALPATE_HD_WHOLE "/libHD.so.3.4", RTLD_NOW | RTLD_NOLOAD) != nullptr);
    }
};

PALPATE_TEST(HdLibrary)
#include "tst_HdLibrary.moc"

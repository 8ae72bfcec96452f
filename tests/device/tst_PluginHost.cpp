// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/device/PluginHost.h>

#include <QTemporaryDir>

#include <algorithm>
#include <fstream>

#include <sys/stat.h>
#include <unistd.h>

using namespace palpate;

class PluginHost : public QObject
{
    Q_OBJECT

  private:
    const std::filesystem::path m_found = PALPATE_WAYWARD_PLUGINS;

    device::PluginHost host(const std::vector<std::filesystem::path>& folders, int timeout_ms = 60'000) const
    {
        return device::PluginHost(folders, {PALPATE_TEST_PROBE}, timeout_ms);
    }

    static std::string problemOf(const device::PluginHost& host, const std::string& id)
    {
        for (const device::PluginEntry& entry : host.plugins()) {
            if (entry.info.id == id || entry.file.stem() == id) {
                return entry.status.message();
            }
        }
        return "not found";
    }

  private Q_SLOTS:
    void readsMetadataWithoutLoading()
    {
        const device::PluginHost all({m_found}); // no probe: nothing may be loaded here
        QCOMPARE(all.plugins().size(), std::size_t{9});
        QCOMPARE(problemOf(all, "crashing"), std::string());
        QCOMPARE(problemOf(all, "working"), std::string());
        const auto& plugins = all.plugins();
        const auto working =
            std::find_if(plugins.begin(), plugins.end(), [](const auto& e) { return e.info.id == "working"; });
        QCOMPARE(working->info.license, std::string("BSD-3-Clause"));
        QCOMPARE(working->info.apiVersion, device::kDeviceApiVersion);
        QCOMPARE(working->info.drives, std::string("nothing"));
    }

    /// A plugin built before a layout changed would be misread: whoever changes one raises the number, then this.
    void versionStandsForTheLayouts()
    {
        QCOMPARE(PALPATE_DEVICE_PLUGIN_IID, qPrintable(QStringLiteral("palpate.DevicePlugin/3")));
        QCOMPARE(device::kDeviceApiVersion, 3);
        if (sizeof(void*) != 8 || sizeof(std::string) != 32) {
            QSKIP("the sizes below are those of 64 bits and libstdc++");
        }
        QCOMPARE(sizeof(device::DeviceInfo), std::size_t{176});
        QCOMPARE(sizeof(device::DeviceState), std::size_t{80});
        QCOMPARE(sizeof(device::DeviceReport), std::size_t{104});
        QCOMPARE(sizeof(device::FoundDevice), std::size_t{96});
        QCOMPARE(sizeof(device::PluginServices), std::size_t{32});
        QCOMPARE(sizeof(core::Status), std::size_t{96});
    }

    void namesAndSkipsWhatCannotBeUsed()
    {
        QTemporaryDir folder;
        const std::filesystem::path path = folder.path().toStdString();
        std::ofstream(path / "text.so") << "not a library";
        std::filesystem::copy_file(m_found / "working.so", path / "again.so");
        std::filesystem::copy_file(m_found / "working.so", path / "cut.so");
        std::filesystem::resize_file(path / "cut.so", std::filesystem::file_size(path / "cut.so") / 3);
        std::ofstream(path / "notes.txt") << "no plugin's name";
        auto all = host({m_found, path, "/nowhere"});
        QCOMPARE(all.plugins().size(), std::size_t{12});
        for (const char* older : {"old", "copied"}) { // regardless of the metadata of the second
            QVERIFY(problemOf(all, older).find("built for device API 1, this program has 3; rebuild it against") !=
                    std::string::npos);
            QCOMPARE(all.make(older).status().message(), problemOf(all, older));
        }
        QVERIFY(problemOf(all, "unsure").find("found apiVersion 1 in its metadata, expected 3") != std::string::npos);
        QVERIFY(problemOf(all, "mouse").find("built-in") != std::string::npos);
        QVERIFY(problemOf(all, "text").find("not a Qt plugin") != std::string::npos);
        QVERIFY(!problemOf(all, "cut").empty());
        const std::string nobody = all.find("nobody").status().message();
        QVERIFY2(nobody.find("(the built-in devices mouse, simulated, playback are not plugins)") != std::string::npos,
                 nobody.c_str());
        for (const device::PluginEntry& entry : all.plugins()) {
            QVERIFY2(!entry.status.isOk() ||
                         nobody.find(entry.info.id, nobody.find("expected one of: ")) != std::string::npos,
                     nobody.c_str());
            if (entry.file.stem() == "again") {
                QVERIFY(entry.status.message().find("comes first") != std::string::npos);
            }
            if (!entry.status.isOk()) {
                QVERIFY(entry.status.message().find(entry.file.string()) == 0);
            }
        }
        QCOMPARE(all.find("old").status().code(), core::StatusCode::Mismatch);
        QCOMPARE(all.find("nobody").status().code(), core::StatusCode::NotFound);
    }

    void skipsPluginsThatOthersCanReplace_data()
    {
        QTest::addColumn<int>("file");
        QTest::addColumn<int>("folder");
        QTest::addColumn<bool>("isFit");
        QTest::newRow("sound") << 0644 << 0755 << true;
        QTest::newRow("file open to all") << 0666 << 0755 << false;
        QTest::newRow("file open to the group") << 0664 << 0755 << false;
        QTest::newRow("folder open to all") << 0644 << 0777 << false;
        QTest::newRow("sticky folder open to all") << 0644 << 01777 << false;
        QTest::newRow("folder open to the group") << 0644 << 0775 << false;
    }

    void skipsPluginsThatOthersCanReplace()
    {
        QFETCH(const int, file);
        QFETCH(const int, folder);
        QFETCH(const bool, isFit);
        QTemporaryDir temporary;
        const auto plugins = std::filesystem::path(temporary.path().toStdString()) / "plugins";
        std::filesystem::create_directory(plugins);
        std::filesystem::copy_file(m_found / "working.so", plugins / "working.so");
        QVERIFY(::chmod((plugins / "working.so").c_str(), static_cast<mode_t>(file)) == 0);
        QVERIFY(::chmod(plugins.c_str(), static_cast<mode_t>(folder)) == 0);
        auto all = host({plugins});
        QCOMPARE(all.plugins().size(), std::size_t{1});
        QCOMPARE(all.find("working").isOk(), isFit);
        const std::string problem = problemOf(all, "working");
        QVERIFY2(isFit == problem.empty(), problem.c_str());
        QVERIFY2(isFit || problem.find("others may write to " + plugins.string()) != std::string::npos,
                 problem.c_str());
        // A link into such a folder leads to the same file.
        const auto links = std::filesystem::path(temporary.path().toStdString()) / "links";
        std::filesystem::create_directory(links);
        std::filesystem::create_symlink(plugins / "working.so", links / "working.so");
        QCOMPARE(host({links}).find("working").isOk(), isFit);
    }

    void skipsPluginsOfOtherUsers()
    {
        QTemporaryDir temporary;
        const std::filesystem::path copy = temporary.path().toStdString() + "/working.so";
        std::filesystem::copy_file(m_found / "working.so", copy);
        if (::chown(copy.c_str(), 65534, 65534) != 0) {
            QSKIP("only root can give a file away");
        }
        auto all = host({copy.parent_path()});
        QVERIFY(!all.find("working").isOk());
        QVERIFY2(problemOf(all, "working").find("belongs to another user") != std::string::npos,
                 problemOf(all, "working").c_str());
    }

    /// The environment is often set by scripts; a relative folder would be looked for below the working folder.
    void looksOnlyInAbsoluteFolders()
    {
        const auto all = [] {
            std::vector<std::filesystem::path> folders = device::pluginFolders({}, "/program");
            const auto settings = device::deviceSettingsFolders();
            folders.insert(folders.end(), settings.begin(), settings.end());
            return folders;
        };
        const QByteArray home = qgetenv("HOME"), data = qgetenv("XDG_DATA_HOME"), config = qgetenv("XDG_CONFIG_HOME");
        qputenv("XDG_DATA_HOME", ".local/share");
        qputenv("XDG_CONFIG_HOME", ".config");
        qputenv("HOME", ".");
        const auto relative = all();
        qputenv("HOME", "/home/somebody");
        qputenv("XDG_DATA_HOME", "/data");
        qunsetenv("XDG_CONFIG_HOME");
        const auto absolute = all();
        home.isNull() ? qunsetenv("HOME") : qputenv("HOME", home);
        data.isNull() ? qunsetenv("XDG_DATA_HOME") : qputenv("XDG_DATA_HOME", data);
        config.isNull() ? qunsetenv("XDG_CONFIG_HOME") : qputenv("XDG_CONFIG_HOME", config);
        for (const std::filesystem::path& folder : relative) {
            QVERIFY2(folder.is_absolute(), folder.c_str());
        }
        QVERIFY(std::find(absolute.begin(), absolute.end(), "/data/Palpate/plugins") != absolute.end());
        QCOMPARE(absolute.size(), relative.size() + 3);
    }

    void survivesPluginsThatDoNot_data()
    {
        QTest::addColumn<QString>("id");
        QTest::addColumn<QString>("said");
        QTest::newRow("crashes") << "crashing"
                                 << "crashed";
        QTest::newRow("throws") << "throwing"
                                << "no bus today";
        QTest::newRow("ends the process as if all were well") << "leaving"
                                                              << "ended the process";
    }

    void survivesPluginsThatDoNot()
    {
        QFETCH(const QString, id);
        QFETCH(const QString, said);
        auto all = host({m_found});
        const auto found = all.find(id.toStdString());
        QVERIFY(!found.isOk());
        QVERIFY2(found.status().message().find(said.toStdString()) != std::string::npos,
                 found.status().message().c_str());
        QCOMPARE(problemOf(all, id.toStdString()), found.status().message());
        QVERIFY(!all.make(id.toStdString()).isOk());
        QCOMPARE(all.find("working").value().size(), std::size_t{1}); // and the others go on
    }

    void survivesOneThatHangs()
    {
        auto all = host({m_found}, 1000);
        const auto found = all.find("hanging");
        QVERIFY(!found.isOk());
        QVERIFY2(found.status().message().find("hung") != std::string::npos, found.status().message().c_str());
    }
};

PALPATE_TEST(PluginHost)
#include "tst_PluginHost.moc"

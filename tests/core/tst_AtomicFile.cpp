// SPDX-License-Identifier: BSD-3-Clause
#include "FileLimits.h"
#include "TestRunner.h"

#include <palpate/core/AtomicFile.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <csignal>
#include <string>
#include <thread>

#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace palpate;
using core::AtomicFile;
using core::StatusCode;

namespace {

/// @return the exit code of a child process that runs the function, or minus the signal that ended the child
template<class Work>
int inChild(Work work)
{
    const pid_t child = ::fork();
    if (child == 0) {
        ::_exit(work());
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

} // namespace

/// Output files contain the old content or all of the new content, and no temporary files remain.
class AtomicFileTest : public QObject
{
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;

    std::filesystem::path path(const char* name) const { return m_folder->filePath(name).toStdString(); }
    std::string content(const char* name) const
    {
        QFile file(m_folder->filePath(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll().toStdString() : std::string("nothing");
    }
    QStringList files() const
    {
        return QDir(m_folder->path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot);
    }
    static unsigned mode(const std::filesystem::path& file)
    {
        struct stat is
        {
        };
        return ::stat(file.c_str(), &is) == 0 ? is.st_mode & 07777 : 0;
    }

  private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void keepsTheOldFileAtAnyLimitOfSize()
    {
        const std::string fresh(150'000, 'n'); // larger than the buffer
        for (const bool isThere : {false, true}) {
            for (std::size_t limit = 0; limit <= fresh.size() + 3; limit += limit < 149'990 ? 1'777 : 1) {
                (void)::unlink(path("a").c_str());
                if (isThere) {
                    QVERIFY(core::writeAtomically(path("a"), "old").isOk());
                }
                core::Status status;
                {
                    const test::FileLimit full(limit);
                    status = core::writeAtomically(path("a"), fresh);
                }
                QCOMPARE(status.isOk(), limit >= fresh.size());
                if (status.isOk()) {
                    QVERIFY(content("a") == fresh);
                } else {
                    QCOMPARE(status.code(), StatusCode::NoSpace);
                    QVERIFY(status.message().find("cannot be written: File too large") != std::string::npos);
                    QCOMPARE(content("a"), std::string(isThere ? "old" : "nothing"));
                }
                QCOMPARE(files(), isThere || status.isOk() ? QStringList{"a"} : QStringList());
            }
        }
    }

    /// Content that fits into the buffer must not count as written.
    void keepsTheOldFileOnAFullDisk()
    {
        QVERIFY(QDir(m_folder->path()).mkdir("disk"));
        const std::filesystem::path disk = path("disk");
        const int code = inChild([&] {
            if (::unshare(CLONE_NEWNS) != 0 || ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
                ::mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=64k") != 0) {
                return 77;
            }
            if (!core::writeAtomically(disk / "a", "old").isOk()) {
                return 1;
            }
            const int fill = ::open((disk / "fill").c_str(), O_WRONLY | O_CREAT, 0600);
            const std::string block(4096, 'x');
            while (::write(fill, block.data(), block.size()) > 0) {
            }
            for (const std::size_t size : {10, 5'000, 70'000, 400'000}) {
                const core::Status status = core::writeAtomically(disk / "a", std::string(size, 'n'));
                if (status.isOk() || status.code() != StatusCode::NoSpace) {
                    return 2;
                }
                QFile file(QString::fromStdString((disk / "a").string()));
                if (!file.open(QIODevice::ReadOnly) || file.readAll() != "old") {
                    return 3;
                }
            }
            return 0;
        });
        if (code == 77) {
            QSKIP("no right to mount a small file system");
        }
        QCOMPARE(code, 0);
    }

    void keepsModesAndWritesThroughLinks()
    {
        const mode_t before = ::umask(027);
        QVERIFY(core::writeAtomically(path("a"), "1").isOk());
        (void)::umask(before);
        QCOMPARE(mode(path("a")), 0640u);
        QCOMPARE(::chmod(path("a").c_str(), 0604), 0);
        QVERIFY(QFile::link("a", m_folder->filePath("link")));
        QVERIFY(QFile::link("link", m_folder->filePath("link2")));
        QVERIFY(QFile::link("b", m_folder->filePath("dangling")));
        QVERIFY(core::writeAtomically(path("link2"), "2").isOk());
        QCOMPARE(content("a"), std::string("2"));
        QCOMPARE(mode(path("a")), 0604u);
        QVERIFY(core::writeAtomically(path("dangling"), "3").isOk());
        QCOMPARE(content("b"), std::string("3"));
        QVERIFY(std::filesystem::is_symlink(path("link2")) && std::filesystem::is_symlink(path("dangling")));
        QVERIFY(QFile::link("round", m_folder->filePath("round")));
        QVERIFY(!core::writeAtomically(path("round"), "4").isOk());
    }

    /// Only the name being written gets the new file; a hard link to the old file keeps the old content.
    void leavesASecondNameAlone()
    {
        QVERIFY(core::writeAtomically(path("a"), "old").isOk());
        QCOMPARE(::link(path("a").c_str(), path("b").c_str()), 0);
        QVERIFY(core::writeAtomically(path("a"), "new").isOk());
        QCOMPARE(content("b"), std::string("old"));
    }

    void writesStraightToPipesDevicesAndDescriptors()
    {
        QCOMPARE(::mkfifo(path("pipe").c_str(), 0600), 0);
        std::string got;
        std::thread reader([&] { got = content("pipe"); });
        QVERIFY(core::writeAtomically(path("pipe"), "through").isOk());
        reader.join();
        QCOMPARE(got, std::string("through"));
        QVERIFY(std::filesystem::is_fifo(path("pipe")));
        QVERIFY(core::writeAtomically("/dev/null", "gone").isOk());
        QCOMPARE(core::writeAtomically("/dev/full", "more").code(), StatusCode::NoSpace);
        QVERIFY(!core::writeAtomically(path("pipe"), "no", AtomicFile::Onto::File).isOk());
        const int file = ::open(path("out").c_str(), O_WRONLY | O_CREAT, 0600);
        QVERIFY(file >= 0);
        QCOMPARE(::write(file, "a", 1), ssize_t{1});
        QVERIFY(core::writeAtomically("/dev/fd/" + std::to_string(file), "b").isOk()); // like a shell redirection
        QCOMPARE(::write(file, "c", 1), ssize_t{1});
        (void)::close(file);
        QCOMPARE(content("out"), std::string("abc"));
    }

    void refusesWhatCannotBeAFile()
    {
        QCOMPARE(core::writeAtomically(path("none/a"), "x").code(), StatusCode::NotFound);
        QVERIFY(core::writeAtomically(m_folder->path().toStdString(), "x").message().find("Is a directory") !=
                std::string::npos);
        for (const std::string& name : {std::string(), m_folder->path().toStdString() + "/", std::string("/proc/a")}) {
            QVERIFY2(!core::writeAtomically(name, "x").isOk(), name.c_str());
        }
        QVERIFY(core::writeAtomically(path(std::string(255, 'x').c_str()), "long").isOk());
        QVERIFY(!core::writeAtomically(path(std::string(256, 'x').c_str()), "long").isOk());
        QVERIFY(core::writeAtomically(path("a\xff\xfe"), "not UTF-8").isOk());
        QCOMPARE(files().size(), 2);
    }

    void leavesNothingWithoutFinish()
    {
        {
            auto file = AtomicFile::create(path("a"));
            QVERIFY(file.isOk());
            file.value().write(std::string(200'000, 'x'));
            QCOMPARE(files().size(), 1); // a new file
        }
        QCOMPARE(files(), QStringList());
    }

    void newFilesGetAFreeName()
    {
        for (const char* name : {"a b.png", "a b (2).png", "a b (3).png"}) {
            QCOMPARE(core::writeNew(path("a b.png"), name).value(), path(name));
        }
        QCOMPARE(content("a b.png"), std::string("a b.png"));
        QVERIFY(!core::writeNew(path("none/a.png"), "x").isOk());
        auto late = AtomicFile::create(path("c"), AtomicFile::Onto::Nothing);
        QVERIFY(core::writeAtomically(path("c"), "first").isOk());
        late.value().write("second");
        QVERIFY(!late.value().finish().isOk());
        QCOMPARE(content("c"), std::string("first"));
        QVERIFY(QFile::link("nowhere", m_folder->filePath("d")));
        QVERIFY(!core::writeAtomically(path("d"), "x", AtomicFile::Onto::Nothing).isOk());
        QCOMPARE(files().size(), 5);
    }

    void signalsLeaveNothing_data()
    {
        QTest::addColumn<int>("signal");
        QTest::addColumn<bool>("isFolder");
        for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGABRT, SIGSEGV, SIGPIPE, SIGXCPU}) {
            for (const bool isFolder : {false, true}) {
                QTest::addRow("%d, %s", signal, isFolder ? "folder" : "file") << signal << isFolder;
            }
        }
    }
    void signalsLeaveNothing()
    {
        QFETCH(const int, signal);
        QFETCH(const bool, isFolder);
        QVERIFY(core::writeAtomically(path("a"), "old").isOk());
        const int ended = inChild([&] {
            (void)std::signal(signal, SIG_DFL); // Qt Test installs its own handler
            core::removeScratchOnSignals();
            auto file = AtomicFile::create(path("a"));
            file.value().write(std::string(200'000, 'n'));
            if (isFolder) {
                const auto folder = core::Scratch::create(path("a"), core::Scratch::Kind::Folder);
                for (const char* name : {"source", "source-journal"}) {
                    (void)core::writeAtomically(folder.value()->path() / name, "a patient's");
                }
                (void)::raise(signal);
            }
            (void)::raise(signal);
            return 0;
        });
        QCOMPARE(ended, -signal);
        QCOMPARE(files(), QStringList{"a"});
        QCOMPARE(content("a"), std::string("old"));
    }

    void ignoredSignalsStayIgnored()
    {
        QCOMPARE(inChild([] {
                     (void)std::signal(SIGHUP, SIG_IGN);
                     core::removeScratchOnSignals();
                     return ::raise(SIGHUP) + ::raise(SIGXFSZ);
                 }),
                 0);
    }

    /// Temporary files from a SIGKILL are removed on the next write in that folder; files in use and foreign files
    /// stay.
    void cleansUpAfterSigkill()
    {
        QCOMPARE(inChild([&] {
                     auto file = AtomicFile::create(path("a"));
                     file.value().write(std::string(200'000, 'n'));
                     const auto folder = core::Scratch::create(path("a"), core::Scratch::Kind::Folder);
                     (void)core::writeAtomically(folder.value()->path() / "source", "a patient's");
                     return ::raise(SIGKILL);
                 }),
                 -SIGKILL);
        QCOMPARE(files().size(), 2);
        const auto used = core::Scratch::create(path("b"), core::Scratch::Kind::Folder);
        QVERIFY(core::writeAtomically(used.value()->path() / "source", "kept").isOk());
        QCOMPARE(files().size(), 1);
        const QStringList others{".palpate-0123456789abcdeg", ".palpate-0123", ".palpate-0123456789abcdef.txt"};
        for (const QString& name : others) {
            QVERIFY(core::writeAtomically(path(qPrintable(name)), "theirs").isOk());
        }
        QVERIFY(QFile::link("b", m_folder->filePath(".palpate-0123456789abcdef")));
        QCOMPARE(inChild([&] { return core::writeAtomically(path("c"), "x").isOk() ? 0 : 1; }), 0);
        QCOMPARE(files().size(), 6);
        QVERIFY(QFile::exists(QString::fromStdString((used.value()->path() / "source").string())));
    }
};

PALPATE_TEST_NAMED("AtomicFile", AtomicFileTest)
#include "tst_AtomicFile.moc"

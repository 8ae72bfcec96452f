// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/servo/RealtimeSetup.h>

#include <cfenv>
#include <cstddef>
#include <fstream>
#include <limits>
#include <pthread.h>
#include <sched.h>
#include <string>
#include <sys/mman.h>
#include <thread>
#include <unistd.h>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

using palpate::servo::makeThreadRealtime;
using palpate::servo::RealtimeItem;
using palpate::servo::RealtimeReport;
using palpate::servo::RealtimeRequest;

namespace {

template<class Work>
void onAThread(Work work)
{
    std::thread(work).join();
}

const RealtimeItem* itemOf(const RealtimeReport& report, const std::string& name)
{
    for (const RealtimeItem& item : report.items) {
        if (item.name.english() == name) {
            return &item;
        }
    }
    return nullptr;
}

long lockedMemory_KiB()
{
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with("VmLck:")) {
            return std::stol(line.substr(6));
        }
    }
    return -1;
}

/// Sanitizers replace mlock and mlockall by functions that report success and do nothing.
bool canLockMemory()
{
    const auto size = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    void* const page = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    const bool isLocked = page != MAP_FAILED && mlock(page, size) == 0 && lockedMemory_KiB() > 0;
    if (page != MAP_FAILED) {
        munmap(page, size);
    }
    return isLocked;
}

bool locksFutureMappings()
{
    const long before_KiB = lockedMemory_KiB();
    const std::size_t size = 1U << 20U;
    void* block = mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    const bool isLocked = lockedMemory_KiB() > before_KiB;
    munmap(block, size);
    return isLocked;
}

} // namespace

class RealtimeSetup : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void saysOfEachItemWhatItGotOrWhyNot()
    {
        RealtimeReport report;
        onAThread([&] {
            report = makeThreadRealtime({.lockMemory = true});
            palpate::servo::releaseRealtime(report);
        });
        for (const char* name :
             {"real-time priority", "locked memory", "timer slack", "thread name", "floating point"}) {
            const RealtimeItem* item = itemOf(report, name);
            QVERIFY2(item != nullptr, name);
            QVERIFY2(!item->message.isEmpty(), name);
            QVERIFY2(!item->isGranted || item->remedy.empty(), name);
            qInfo("%s: %s, %s", name, item->isGranted ? "granted" : "refused", item->message.english().c_str());
        }
        for (const char* name : {"real-time priority", "locked memory"}) {
            const RealtimeItem* item = itemOf(report, name);
            QVERIFY2(item->isGranted || item->remedy.find("sudo") != std::string::npos, name);
        }
        QCOMPARE(report.isRealtime,
                 itemOf(report, "real-time priority")->isGranted && itemOf(report, "locked memory")->isGranted);
    }

    void saysThatTheThreadIsWhatItReports()
    {
        int policy = -1;
        char name[16] = {};
        RealtimeReport report;
        onAThread([&] {
            report = makeThreadRealtime({});
            sched_param parameter{};
            pthread_getschedparam(pthread_self(), &policy, &parameter);
            pthread_getname_np(pthread_self(), name, sizeof(name));
            palpate::servo::releaseRealtime(report);
        });
        QCOMPARE(policy == SCHED_FIFO, itemOf(report, "real-time priority")->isGranted);
        QCOMPARE(std::string(name), std::string("palpate-servo"));
    }

    void asksForNoPermissionUnlessTold()
    {
        RealtimeReport report;
        int policy = -1;
        onAThread([&] {
            RealtimeRequest request;
            request.askPriority = false;
            report = makeThreadRealtime(request);
            sched_param parameter{};
            pthread_getschedparam(pthread_self(), &policy, &parameter);
        });
        QVERIFY(!report.isRealtime);
        QCOMPARE(policy, SCHED_OTHER);
        QCOMPARE(itemOf(report, "real-time priority")->message.english(), std::string("not asked for"));
    }

    void locksNoMemoryUnlessTold()
    {
        RealtimeReport report;
        onAThread([&] { report = makeThreadRealtime({}); });
        QCOMPARE(itemOf(report, "locked memory")->message.english(), std::string("not asked for"));
        QCOMPARE(lockedMemory_KiB(), 0L);
        QCOMPARE(report.isRealtime, itemOf(report, "real-time priority")->isGranted);
    }

    void unlocksWhatItHasLocked()
    {
        if (!canLockMemory()) {
            QSKIP("memory cannot be locked here");
        }
        RealtimeReport report;
        onAThread([&] { report = makeThreadRealtime({.lockMemory = true}); });
        if (!itemOf(report, "locked memory")->isGranted) {
            QSKIP("memory may not be locked here");
        }
        QVERIFY(lockedMemory_KiB() > 0);
        palpate::servo::releaseRealtime(report);
        QCOMPARE(lockedMemory_KiB(), 0L);
    }

    void aPageThatTheProgramHasLockedStaysLocked()
    {
        if (!canLockMemory()) {
            QSKIP("memory cannot be locked here");
        }
        const auto size = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
        void* page = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        QVERIFY(page != MAP_FAILED && mlock(page, size) == 0);
        RealtimeReport report;
        onAThread([&] { report = makeThreadRealtime({.lockMemory = true}); });
        palpate::servo::releaseRealtime(report);
        QVERIFY(lockedMemory_KiB() > 0);
        QVERIFY(!locksFutureMappings());
        munlockall();
        munmap(page, size);
    }

    void aLockOfTheProgramsWholeMemoryStays()
    {
        if (!canLockMemory() || mlockall(MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT) != 0) {
            QSKIP("memory may not be locked here");
        }
        RealtimeReport report;
        onAThread([&] { report = makeThreadRealtime({.lockMemory = true}); });
        palpate::servo::releaseRealtime(report);
        const bool isLocked = lockedMemory_KiB() > 0 && locksFutureMappings();
        munlockall();
        QVERIFY(isLocked);
        QVERIFY(itemOf(report, "locked memory")->isGranted);
        QCOMPARE(itemOf(report, "locked memory")->message.english(),
                 std::string("the program has locked its memory itself"));
    }

    void namesACpuThatIsNotThere()
    {
        RealtimeReport report;
        onAThread([&] {
            RealtimeRequest request;
            request.askPriority = false;
            request.cpu = 100'000;
            report = makeThreadRealtime(request);
        });
        const RealtimeItem* item = itemOf(report, "own CPU");
        QVERIFY(item != nullptr && !item->isGranted);
        QVERIFY(item->message.english().find("CPU 100000") != std::string::npos);
    }

    void aCpuIsGivenWhenItIsAllowed()
    {
        const std::vector<int> allowed = palpate::servo::allowedCpus();
        QVERIFY(!allowed.empty());
        QVERIFY(palpate::servo::checkCpu(-1).isOk());
        QVERIFY(palpate::servo::checkCpu(allowed.back()).isOk());
        std::vector<int> got;
        onAThread([&] {
            RealtimeRequest request;
            request.askPriority = false;
            request.cpu = allowed.back();
            const RealtimeReport report = makeThreadRealtime(request);
            QVERIFY(itemOf(report, "own CPU")->isGranted);
            got = palpate::servo::allowedCpus();
        });
        QCOMPARE(got, std::vector<int>{allowed.back()});
    }

    void aCpuThatIsNotThereIsRefusedInWords()
    {
        for (const int cpu : {100'000, -2}) {
            const palpate::core::Status status = palpate::servo::checkCpu(cpu);
            QCOMPARE(status.code(), palpate::core::StatusCode::BadCommandLine);
            const std::string start = "CPU " + std::to_string(cpu) + ": this machine has no such CPU, expected one of ";
            QVERIFY2(status.message().find(start) == 0, status.message().c_str());
        }
    }

    /// As set by `taskset -c`.
    void aCpuThatIsNotAllowedIsRefusedInWords()
    {
        const std::vector<int> allowed = palpate::servo::allowedCpus();
        if (allowed.size() < 2) {
            QSKIP("one CPU is allowed here: none is left to be forbidden");
        }
        onAThread([&] {
            RealtimeRequest request;
            request.askPriority = false;
            request.cpu = allowed[0];
            static_cast<void>(makeThreadRealtime(request));
            const palpate::core::Status status = palpate::servo::checkCpu(allowed[1]);
            QCOMPARE(status.code(), palpate::core::StatusCode::BadCommandLine);
            QCOMPARE(status.message(), "CPU " + std::to_string(allowed[1]) +
                                           ": the program may not run on it (see taskset -p, or the container's "
                                           "settings), expected one of " +
                                           std::to_string(allowed[0]));
        });
    }

    void keepsDenormalsAndRoundsToNearestWhateverTheCreatorHad()
    {
        double half = 0.0;
        int rounding = -1;
        onAThread([&] {
#if defined(__SSE2__)
            _mm_setcsr(_mm_getcsr() | 0x8040); // FTZ and DAZ, as set by fast-math libraries
#endif
            std::fesetround(FE_UPWARD);
            RealtimeRequest request;
            request.askPriority = false;
            static_cast<void>(makeThreadRealtime(request));
            volatile double smallest = std::numeric_limits<double>::min();
            smallest = smallest / 2.0;
            half = smallest;
            rounding = std::fegetround();
        });
        QVERIFY(half > 0.0);
        QCOMPARE(rounding, FE_TONEAREST);
    }
};

PALPATE_TEST(RealtimeSetup)
#include "tst_RealtimeSetup.moc"

// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#ifdef PALPATE_TEST_GUI
#include <QApplication>
#else
#include <QCoreApplication>
#endif

#include <cstdio>
#include <cstdlib>
#include <map>

namespace palpate::test {

namespace {
using Factory = std::unique_ptr<QObject> (*)();

std::map<std::string, Factory>& registry()
{
    static std::map<std::string, Factory> tests;
    return tests;
}
} // namespace

bool registerTest(const char* name, Factory make)
{
    return registry().emplace(name, make).second;
}

std::optional<std::filesystem::path> sharedFolder(const std::string& sub)
{
    const char* named = std::getenv("PALPATE_SHARED");
    const std::filesystem::path folder = (named != nullptr ? named : PALPATE_SHARED_DIR) + ("/" + sub);
    return std::filesystem::is_directory(folder) ? std::optional(folder) : std::nullopt;
}

} // namespace palpate::test

/// Usage: tst_<module> CLASS [QtTest arguments]; without arguments runs all classes in turn.
int main(int argc, char** argv)
{
    using palpate::test::registry;
#ifdef PALPATE_TEST_GUI
    const QApplication application(argc, argv);
#else
    const QCoreApplication application(argc, argv);
#endif
    if (argc > 1 && argv[1][0] != '-') {
        const auto found = registry().find(argv[1]);
        if (found == registry().end()) {
            std::fprintf(stderr, "%s: no test class \"%s\"\n", argv[0], argv[1]);
            return 2;
        }
        argv[1] = argv[0];
        return QTest::qExec(found->second().get(), argc - 1, argv + 1);
    }
    int failed = 0;
    for (const auto& [name, make] : registry()) {
        failed += QTest::qExec(make().get(), argc, argv);
    }
    return failed == 0 ? 0 : 1;
}

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QtTest>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace palpate::test {

/// Registers a test class under its name; use PALPATE_TEST at the end of a tst_*.cpp.
bool registerTest(const char* name, std::unique_ptr<QObject> (*make)());

/// Longest time that a test waits for an event before it fails: far more than the event takes on a busy machine. [ms]
inline constexpr int kPatience_ms = 60000;

/// Returns the folder of real meshes or malformed files, if available; tests that need the folder skip otherwise with a
/// message. The folder is beside the checkout, or in PALPATE_SHARED.
/// @param sub  "anatomy" or "hostile"
std::optional<std::filesystem::path> sharedFolder(const std::string& sub);

} // namespace palpate::test

/// In a test slot: skips with a message if the shared folder `sub` is missing; otherwise `variable` is its path.
#define PALPATE_SHARED_OR_SKIP(variable, sub)                                                                          \
    const auto variable##Found = palpate::test::sharedFolder(sub);                                                     \
    if (!variable##Found) {                                                                                            \
        QSKIP("no shared/" sub " beside the checkout: nothing to test on");                                            \
    }                                                                                                                  \
    const std::filesystem::path variable = *variable##Found

// Qt's own do not compile in a test:
#undef QTRY_VERIFY
#undef QTRY_COMPARE

/// In a test slot: handles events until a condition holds or two values are equal; fails after `kPatience_ms`. Instead
/// of Qt's QTRY_VERIFY and QTRY_COMPARE, whose five seconds a busy machine exceeds, and which GCC 14 warns about in
/// Qt 6.8.
#define PALPATE_TRY_VERIFY2(condition, message)                                                                        \
    do {                                                                                                               \
        (void)QTest::qWaitFor([&] { return static_cast<bool>(condition); }, palpate::test::kPatience_ms);              \
        QVERIFY2(condition, message);                                                                                  \
    } while (false)
#define PALPATE_TRY_VERIFY(condition) PALPATE_TRY_VERIFY2(condition, #condition)
#define PALPATE_TRY_COMPARE(actual, expected)                                                                          \
    do {                                                                                                               \
        (void)QTest::qWaitFor([&] { return (actual) == (expected); }, palpate::test::kPatience_ms);                    \
        QCOMPARE(actual, expected);                                                                                    \
    } while (false)

#define PALPATE_TEST(Class) PALPATE_TEST_NAMED(#Class, Class)

/// For a class that cannot have the name of the tested class.
#define PALPATE_TEST_NAMED(name, Class)                                                                                \
    [[maybe_unused]] static const bool registered##Class =                                                             \
        palpate::test::registerTest(name, []() -> std::unique_ptr<QObject> { return std::make_unique<Class>(); });

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

#define PALPATE_TEST(Class) PALPATE_TEST_NAMED(#Class, Class)

/// For a class that cannot have the name of the tested class.
#define PALPATE_TEST_NAMED(name, Class)                                                                                \
    [[maybe_unused]] static const bool registered##Class =                                                             \
        palpate::test::registerTest(name, []() -> std::unique_ptr<QObject> { return std::make_unique<Class>(); });

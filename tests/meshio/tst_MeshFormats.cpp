// SPDX-License-Identifier: BSD-3-Clause
#include "Samples.h"
#include "TestRunner.h"

#include "formats/MeshFormat.h"

#include <palpate/meshio/MeshFormats.h>

#include <set>

using namespace palpate;
using meshio::internal::formatTable;
using meshio::internal::MeshFormat;

namespace {

std::string document(const std::string& path)
{
    return test::fileBytes(std::filesystem::path(PALPATE_SOURCE_DIR) / path);
}

/// Returns the text from `from` to `to`, inclusive.
std::string passage(const std::string& text, const std::string& from, const std::string& to)
{
    const std::size_t begin = text.find(from);
    return begin == std::string::npos ? std::string() : text.substr(begin, text.find(to, begin) + to.size() - begin);
}

} // namespace

/// Checks the table of formats against all other lists of formats.
class MeshFormats : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void everyFormatIsWhole()
    {
        std::set<std::string> names, extensions;
        for (const MeshFormat* format : formatTable()) {
            QVERIFY(format->looksLike != nullptr);
            QVERIFY((format->guard != nullptr && format->reader != nullptr) != (format->surfaces != nullptr));
            QVERIFY(names.insert(std::string(format->name)).second);
            for (const std::string_view extension : format->extensions) {
                QVERIFY(extension.starts_with('.') && extensions.insert(std::string(extension)).second);
                QVERIFY(meshio::hasMeshExtension("organs/Liver" + std::string(extension)));
                if (!format->isLabelMap) {
                    const std::string packed = std::string(extension) + ".gz";
                    QVERIFY(extensions.insert(packed).second && meshio::hasMeshExtension("Liver" + packed));
                }
            }
        }
        QVERIFY(meshio::hasMeshExtension("LIVER.STL"));
        QVERIFY(!meshio::hasMeshExtension("liver.gz") && !meshio::hasMeshExtension("liver.mha.gz"));
        QVERIFY(!meshio::hasMeshExtension("liver.txt") && !meshio::hasMeshExtension("stl"));
        const std::vector<std::string> offered = meshio::meshExtensions();
        QCOMPARE(std::set<std::string>(offered.begin(), offered.end()), extensions);
        QCOMPARE(offered.front(), std::string(".stl"));
        const std::string sentence = meshio::meshFormatNames("or");
        QVERIFY(sentence.starts_with("STL, ") && sentence.find(" or ") != std::string::npos);
        QVERIFY(sentence.find(", or") == std::string::npos && sentence.find(",  ") == std::string::npos);
    }

    void documentsNameEach()
    {
        const std::string readme = passage(document("README.md"), "Formats: ", ".");
        const std::string module = passage(document("modules/meshio/README.md"), "`readMesh` (", ")");
        for (const MeshFormat* format : formatTable()) {
            const std::string name(format->name);
            QVERIFY2(readme.find(name) != std::string::npos, ("README.md: Formats: no " + name).c_str());
            QVERIFY2(module.find(name) != std::string::npos,
                     ("modules/meshio/README.md: readMesh: no " + name).c_str());
        }
    }

    void eachIsFuzzed()
    {
        const std::string built = passage(document("tests/fuzz/CMakeLists.txt"), "palpate_fuzz(meshio", ")") + ' ';
        const std::string run = passage(document(".ci/run"), "targets=(", ")") + ' ';
        for (const MeshFormat* format : formatTable()) {
            // MNI's files share the extension of OBJ.
            const std::string target(format->extensions.empty() ? "mniobj" : format->extensions.front().substr(1));
            const std::string source = document("tests/fuzz/fuzz_" + target + ".cpp");
            QVERIFY2(source.find("tryMesh(bytes") != std::string::npos, ("tests/fuzz: no fuzz_" + target).c_str());
            const auto names = [](std::string text, const std::string& word) {
                std::ranges::replace_if(
                    text, [](char c) { return c == '(' || c == ')' || c == '\n'; }, ' ');
                return text.find(' ' + word + ' ') != std::string::npos;
            };
            QVERIFY2(names(built, target), ("tests/fuzz/CMakeLists.txt: no " + target).c_str());
            QVERIFY2(names(run, target), (".ci/run: fuzzers: no " + target).c_str());
        }
    }
};

PALPATE_TEST(MeshFormats)
#include "tst_MeshFormats.moc"

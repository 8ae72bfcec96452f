// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/session/MotionFile.h>

#include <QTemporaryDir>

#include <clocale>
#include <fstream>

using namespace palpate;

namespace {
std::string wrong(const char* text)
{
    const auto motion = session::parseMotion(text, "m.csv");
    return motion.isOk() ? "(read)" : motion.status().message();
}
} // namespace

class MotionFile : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void readsColumnsInAnyOrder()
    {
        const auto motion = session::parseMotion("note,z,x,time_s,y\na,3,1,0,2\nb,-3.5,1e1,0.00025,+2\n", "m.csv");
        QVERIFY2(motion.isOk(), motion.status().message().c_str());
        QCOMPARE(motion.value().p_WH.size(), std::size_t{2});
        QCOMPARE(motion.value().p_WH[0], core::Vec3(1, 2, 3));
        QCOMPARE(motion.value().p_WH[1], core::Vec3(10, 2, -3.5));
        QCOMPARE(motion.value().dt_s, 0.00025);
    }

    void takesMarksBlanksAndLineEndings()
    {
        const auto motion = session::parseMotion("\xef\xbb\xbfx, y ,z\r\n 1 ,2,3\r\n4,5,6\r\n\r\n\n", "m.csv");
        QVERIFY2(motion.isOk(), motion.status().message().c_str());
        QCOMPARE(motion.value().p_WH.size(), std::size_t{2});
        QCOMPARE(motion.value().dt_s, session::kNominalPeriod_s);
    }

    void takesQuotedFields()
    {
        const auto motion = session::parseMotion("\"x\",\"y\",\"z\"\n1,2,3\n\"4\", \"5\" ,\"6\"\n", "m.csv");
        QVERIFY2(motion.isOk(), motion.status().message().c_str());
        QCOMPARE(motion.value().p_WH.size(), std::size_t{2});
        QCOMPARE(motion.value().p_WH[1], core::Vec3(4, 5, 6));
    }

    void readsTheSameUnderADecimalComma()
    {
        if (std::setlocale(LC_NUMERIC, "de_DE.UTF-8") == nullptr) {
            QSKIP("no locale de_DE.UTF-8 on this machine");
        }
        const auto motion = session::parseMotion("x,y,z\n1.5,2.5,3.5\n", "m.csv");
        std::setlocale(LC_NUMERIC, "C");
        QVERIFY(motion.isOk());
        QCOMPARE(motion.value().p_WH[0], core::Vec3(1.5, 2.5, 3.5));
    }

    void namesThePlaceOfAnError_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("message");
        const auto row = [](const char* name, const char* text, const char* message) {
            QTest::newRow(name) << QByteArray(text) << QByteArray(message);
        };
        row("empty", "", "m.csv: line 1: found an empty line, expected a header with x, y and z");
        row("no rows", "x,y,z\n", "m.csv: line 1: found no rows after the header, expected one a servo tick");
        row("no z", "x,y\n1,2\n", "m.csv: line 1: found no column z in \"x,y\", expected a header with x, y and z");
        row("x twice", "x,y,z,x\n1,2,3,4\n", "m.csv: line 1, column x: found the column twice, expected it once");
        row("a word", "x,y,z\n1,2,3\n1,abc,3\n", "m.csv: line 3, column y: found \"abc\", expected a number");
        row("empty field", "x,y,z\n1,,3\n", "m.csv: line 2, column y: found \"\", expected a number");
        row("nan", "x,y,z\n1,2,nan\n", "m.csv: line 2, column z: found \"nan\", expected a finite number");
        row("inf", "x,y,z\n-inf,2,3\n", "m.csv: line 2, column x: found \"-inf\", expected a finite number");
        row("too large", "x,y,z\n1e300,2,3\n",
            "m.csv: line 2, column x: found \"1e300\", expected a coordinate within 10⁹ mm");
        row("field missing", "x,y,z\n1,2\n", "m.csv: line 2: found 2 fields, expected 3 as in the header");
        row("decimal commas", "x,y,z\n1,0,2,0,3,0\n", "m.csv: line 2: found 6 fields, expected 3 as in the header");
        row("empty line", "x,y,z\n1,2,3\n\n1,2,3\n", "m.csv: line 3: found 1 field, expected 3 as in the header");
        row("time back", "time_s,x,y,z\n1,1,2,3\n0,1,2,3\n",
            "m.csv: line 3, column time_s: found a time before the previous row's, expected ascending times");
        row("no time passes", "time_s,x,y,z\n1,1,2,3\n1,1,2,3\n",
            "m.csv: line 3, column time_s: found that no time passes, expected ascending times");
        row("times of no servo", "time_s,x,y,z\n0,1,2,3\n1e300,1,2,3\n",
            "m.csv: line 3, column time_s: found 10³⁰⁰ s between rows on average, expected 0.00001 to 1 s: one row a "
            "servo tick");
        row("steps of 10 s", "time_s,x,y,z\n0,1,2,3\n10,1,2,3\n20,1,2,3\n",
            "m.csv: line 4, column time_s: found 10 s between rows on average, expected 0.00001 to 1 s: one row a "
            "servo "
            "tick");
        row("blanks, then a row", "x,y,z\n1,2,3\n \n\t\n1,2,3\n",
            "m.csv: line 3: found 1 field, expected 3 as in the header");
        row("control characters", "x,y,z\n1,\x01\x02,3\n",
            "m.csv: line 2, column y: found \"\?\?\", expected a number");
    }

    void namesThePlaceOfAnError()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, message);
        QCOMPARE(QByteArray::fromStdString(wrong(text.constData())), message);
    }

    void namesAFileThatIsNotThere()
    {
        const auto motion = session::readMotion("no-such-folder/m.csv");
        QCOMPARE(motion.status().code(), core::StatusCode::NotFound);
        QVERIFY(motion.status().message().starts_with("no-such-folder/m.csv: "));
    }

    /// The file is read in blocks; a row may cross the border of two.
    void readsALongFileLikeItsText()
    {
        std::string text = "x,y,z\r\n";
        for (int i = 0; i < 20'000; ++i) {
            text += std::to_string(i) + ",-1.25," + std::to_string(0.001 * i) + "\r\n";
        }
        QTemporaryDir folder;
        const std::filesystem::path path = folder.path().toStdString() + "/m.csv";
        std::ofstream(path, std::ios::binary) << text;
        const auto fromFile = session::readMotion(path), fromText = session::parseMotion(text, "m.csv");
        QVERIFY2(fromFile.isOk() && fromText.isOk(), fromFile.status().message().c_str());
        QCOMPARE(fromFile.value().p_WH.size(), std::size_t{20'000});
        QVERIFY(fromFile.value().p_WH == fromText.value().p_WH);
    }

    void refusesEndlessAndUnreadableInputs()
    {
        const std::string zeros = session::readMotion("/dev/zero").status().message();
        QCOMPARE(zeros, std::string("/dev/zero: line 1: found more than 1,000,000 bytes without a line end, expected a "
                                    "CSV"));
        QVERIFY(!session::readMotion("/dev/urandom").isOk());
        const auto memory = session::readMotion("/proc/self/mem");
        QVERIFY2(memory.status().message().starts_with("/proc/self/mem: cannot be read: "),
                 memory.status().message().c_str());
        QVERIFY(session::readMotion("/").status().message().find("directory") != std::string::npos);
    }

    void survivesAnyBytes()
    {
        std::uint32_t seed = 1; // a separate generator: the same bytes everywhere
        const std::string valid = "x,y,z\n1,2,3\n4,5,6\n";
        for (int round = 0; round < 20000; ++round) {
            std::string text = valid;
            for (int change = 0; change < 3; ++change) {
                seed = seed * 1664525u + 1013904223u;
                text[(seed >> 8) % text.size()] = static_cast<char>(seed >> 24);
            }
            const auto motion = session::parseMotion(text, "m.csv");
            QVERIFY(motion.isOk() != (motion.status().message().find(": line ") != std::string::npos));
        }
    }
};

PALPATE_TEST(MotionFile)
#include "tst_MotionFile.moc"

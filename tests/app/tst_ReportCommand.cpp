// SPDX-License-Identifier: BSD-3-Clause
#include "../meshio/Samples.h"
#include "Program.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <QFile>
#include <QRegularExpression>
#include <QXmlStreamReader>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <functional>
#include <span>

#include <sys/resource.h>

using namespace palpate;
using core::Vec3;
using test::Outcome;

/// Tests `session report`: its numbers against the other commands, its exit codes and messages.
class ReportCommand : public QObject
{
    Q_OBJECT

    test::Folder m_folder;
    QByteArray m_html;
    QStringList m_texts;       ///< paragraphs
    QList<QStringList> m_rows; ///< cells of all tables

    Outcome run(const QStringList& arguments, const std::function<void()>& prepare = {}) const
    {
        return test::runProgram(QString::fromStdString(m_folder.path("").string()), arguments, prepare);
    }
    QByteArray read(const char* name) const
    {
        QFile file(QString::fromStdString(m_folder.path(name).string()));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    void write(const char* name, const geometry::TriangleMesh& mesh) const
    {
        const meshio::MeshStructure one{std::filesystem::path(name).stem().string(), mesh, std::nullopt};
        QVERIFY(meshio::writeMesh(m_folder.path(name), std::span(&one, 1)).isOk());
    }

    void parse()
    {
        QXmlStreamReader xml(m_html);
        while (!xml.atEnd()) {
            if (xml.readNext() != QXmlStreamReader::StartElement) {
                continue;
            }
            if (xml.name() == u"tr") {
                m_rows << QStringList();
            } else if (xml.name() == u"th" || xml.name() == u"td") {
                m_rows.back() << xml.readElementText(QXmlStreamReader::IncludeChildElements);
            } else if (xml.name() == u"p") {
                m_texts << xml.readElementText(QXmlStreamReader::IncludeChildElements);
            }
        }
        QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
    }

    /// Returns the rows that begin with these cells.
    QList<QStringList> rowsOf(const QStringList& first) const
    {
        QList<QStringList> found;
        for (const QStringList& row : m_rows) {
            if (row.mid(0, first.size()) == first) {
                found << row;
            }
        }
        return found;
    }

    /// Verifies that a row begins with the first `keys` cells and contains the others.
    void hasRow(const QStringList& cells, int keys = 1) const
    {
        for (const QStringList& row : rowsOf(cells.mid(0, keys))) {
            bool hasAll = true;
            for (const QString& cell : cells.mid(keys)) {
                hasAll = hasAll && row.contains(cell);
            }
            if (hasAll) {
                return;
            }
        }
        QFAIL(qPrintable("no row with " + cells.join(" | ")));
    }

    static QStringList captures(const QByteArray& line, const char* pattern)
    {
        const auto match = QRegularExpression(QRegularExpression::anchoredPattern(pattern)).match(line);
        return match.capturedTexts().mid(1);
    }

  private Q_SLOTS:
    void initTestCase()
    {
        write("liver.stl", test::sphere(24, 60.0));
        write("tumour.stl", test::moved(test::sphere(8, 8.0), Vec3(0, 0, 46)));
        write("vessel.stl", test::box(Vec3(-40, -3, 20), Vec3(40, 3, 26), 2));
        m_folder.write("s.palpate.json", R"({"version": 1, "structures": [
            {"mesh": "liver.stl", "name": "liver", "stiffness_N_per_mm": 0.2},
            {"mesh": "tumour.stl", "name": "tumour", "stiffness_N_per_mm": 0.6, "palpable": false, "inside": "liver",
             "young_ratio": 4},
            {"mesh": "vessel.stl", "name": "vessel", "palpable": false}]})");
        QByteArray motion = "x,y,z\n";
        for (int i = 0; i < 2500; ++i) {
            motion += QByteArray::number(8.0 * std::sin(0.003 * i)) + ',' + QByteArray::number(0.001 * i) + ',' +
                      QByteArray::number(61.0 - 9.0 * std::abs(std::sin(0.0025 * i))) + '\n';
        }
        m_folder.write("m.csv", motion.toStdString());
        QCOMPARE(run({"replay", "s.palpate.json", "--motion", "m.csv", "--record", "r.palpate"}).exitCode, 0);
        const Outcome outcome =
            run({"session", "report", "r.palpate", "--out", "r.html", "--case", "17", "--examiner", "N. N."});
        QVERIFY2(outcome.exitCode == 3, outcome.error.constData()); // no display, so no pictures
        QVERIFY2(outcome.error.contains("This report has no pictures: found no display with OpenGL"),
                 outcome.error.constData());
        QCOMPARE(outcome.error.count("palpate: "), 1);
        QVERIFY(outcome.out.contains("r.html: report of r.palpate"));
        m_html = read("r.html");
        parse();
        hasRow({"Case", "17"});
        hasRow({"Examiner", "N. N."});
    }

    /// The values of `session measure`, text for text.
    void numbersAreThoseOfMeasure()
    {
        const Outcome outcome = run({"session", "measure", "r.palpate"});
        QCOMPARE(outcome.exitCode, 0);
        int checked = 0;
        for (const QByteArray& line : outcome.out.split('\n')) {
            if (line.startsWith("force in contact: ")) {
                hasRow({"Force in contact", line.mid(18)});
            } else if (line.startsWith("depth in contact: ")) {
                hasRow({"Depth in contact", line.mid(18)});
            } else if (line.startsWith("duration ")) {
                const QStringList v = captures(line, "duration (\\S+) s, contact (\\S+) s in (\\S+) contacts?");
                hasRow({"Duration", v[0] + " s"});
                hasRow({"In contact", v[1] + " s, contacts: " + v[2]});
            } else if (line.startsWith("path ")) {
                const QStringList v = captures(line, "path of the hand (\\S+) mm, on the surface (\\S+) mm");
                hasRow({"Path of the hand", v[0] + " mm"});
                hasRow({"Path on the surface", v[1] + " mm"});
            } else if (line.startsWith("search: ") || line.startsWith("press: ")) {
                QStringList v = captures(line, "(\\S+): (\\S+) s in (\\S+) phases, force mean (\\S+) N, peak (\\S+) N");
                v[0] = v[0] == "press" ? "pressing" : "searching";
                hasRow(v);
            } else if (line.startsWith("  liver: contact")) {
                hasRow(captures(line,
                                "  (liver): contact (\\S+) s, pressed (\\S+) times, force of its layer peak (\\S+) "
                                "N, mean (\\S+) N, 95th percentile (\\S+) N, peak depth (\\S+) mm"));
            } else if (line.startsWith("  liver: ")) {
                const QStringList v =
                    captures(line, "  (liver): (\\S+) % of (\\S+) cm² covered \\(within (\\S+) mm\\), "
                                   "longest dwell at a point (\\S+) s");
                hasRow({v[0], v[1], v[4]});
                hasRow({"liver", v[2] + " cm²"}); // area in the table of sizes
                hasRow({"Distance that counts as touched", v[3] + " mm"});
            } else if (line.startsWith("  tumour in liver: ")) {
                hasRow({"tumour", "liver", captures(line, ".* under the hand (.*)").value(0)}, 2);
            } else if (line.startsWith("    model of felt lumps")) {
                QStringList v = captures(line, ".* an estimate: (\\S+ %) predicted; pressed hard enough on (\\S+) % of "
                                               "the (\\S+) cm² where a trained hand can feel the lump");
                QCOMPARE(v.size(), 3);
                hasRow(QStringList{"tumour", "liver"} + v, 2);
            } else {
                continue;
            }
            ++checked;
        }
        QCOMPARE(checked, 10);
    }

    /// The values of `info --distances`, text for text.
    void numbersAreThoseOfInfo()
    {
        const Outcome outcome = run({"info", "--distances", "s.palpate.json"});
        QCOMPARE(outcome.exitCode, 0);
        int checked = 0;
        for (const QByteArray& line : outcome.out.split('\n')) {
            if (line.startsWith("  size: ")) {
                const QStringList v =
                    captures(line, "  size: (.+): volume (\\S+ ml) \\(a ball of (\\S+) mm\\), area (\\S+ cm²), extent "
                                   "(\\S+ × \\S+ × \\S+) mm");
                QVERIFY2(v.size() == 5, line.constData());
                hasRow(v);
            } else if (line.startsWith("  distance: ")) {
                const QStringList v = captures(line, "  distance: (.+) to (.+?): (\\S+) mm, (.+)");
                hasRow(v.mid(0, 3), 2);
                if (v[3].contains("lies inside")) {
                    hasRow({v[0], v[1], captures(v[3].toUtf8(), "(.*), from .*").value(0)}, 2);
                }
            } else if (line.startsWith("  margin: ")) {
                const QStringList v = captures(line, "  margin: (\\S+) to (\\S+): (.+) of its area");
                QStringList cells{v[0], v[1]};
                for (const QString& band : v[2].split(", ")) {
                    cells << band.section(": ", 1).chopped(2);
                }
                hasRow(cells, 2);
            } else {
                continue;
            }
            ++checked;
        }
        QCOMPARE(checked, 3 + 2 + 2);
    }

    /// The ratio and the verdicts of `felt`, text for text.
    void verdictsAreThoseOfFelt()
    {
        const Outcome outcome = run({"felt", "s.palpate.json"});
        QCOMPARE(outcome.exitCode, 0);
        int checked = 0;
        for (const QByteArray& line : outcome.out.split('\n')) {
            for (const char* pattern :
                 {"tumour \\((.+)\\), .*", " +\\d+ +[+-].*  (not by hand|by a trained hand|plainly)"}) {
                if (const QStringList v = captures(line, pattern); !v.isEmpty()) {
                    hasRow({"tumour", "liver", v[0]}, 2);
                    ++checked;
                }
            }
        }
        QVERIFY2(checked == 5, outcome.out.constData());
    }

    void writesPdf()
    {
        const Outcome outcome = run({"session", "report", "r.palpate", "--out", "r.pdf"});
        QCOMPARE(outcome.exitCode, 3);
        QVERIFY(read("r.pdf").startsWith("%PDF-1."));
    }

    void refusesBadCommandLines()
    {
        const Outcome other = run({"session", "report", "r.palpate", "--out", "r.docx"});
        QCOMPARE(other.exitCode, 2);
        QVERIFY2(other.error.contains("--out: found \"r.docx\", expected a name that ends in .pdf or .html"),
                 other.error.constData());
        QCOMPARE(run({"session", "report", "r.palpate"}).exitCode, 2);
        QCOMPARE(run({"session", "report", "nothing.palpate", "--out", "n.pdf"}).exitCode, 2);
        QCOMPARE(run({"session", "report", "r.palpate", "--out", "no/folder.pdf"}).exitCode, 2);
        QCOMPARE(run({"session", "report", "r.palpate", "--out", "n.pdf", "--scene", "no.stl"}).exitCode, 2);
        QVERIFY(read("n.pdf").isEmpty());
    }

    void fullDiskLeavesNothing()
    {
        m_folder.write("old.html", "old");
        for (const char* name : {"old.html", "new.pdf"}) {
            const Outcome outcome = run({"session", "report", "r.palpate", "--out", name}, [] {
                const rlimit limit{2000, 2000};
                (void)std::signal(SIGXFSZ, SIG_IGN);
                ::setrlimit(RLIMIT_FSIZE, &limit);
            });
            QCOMPARE(outcome.exitCode, 2);
            QVERIFY2(outcome.error.contains(name), outcome.error.constData());
        }
        QCOMPARE(read("old.html"), QByteArray("old"));
        QVERIFY(!std::filesystem::exists(m_folder.path("new.pdf")));
    }
};

PALPATE_TEST(ReportCommand)
#include "tst_ReportCommand.moc"

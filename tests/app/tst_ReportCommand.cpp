// SPDX-License-Identifier: BSD-3-Clause
#include "../meshio/Samples.h"
#include "Program.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QXmlStreamReader>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <functional>
#include <span>
#include <utility>

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

    /// The values of `session measure --json`, rounded.
    void numbersAreThoseOfMeasure()
    {
        QCOMPARE(run({"session", "measure", "r.palpate", "--json", "m.json"}).exitCode, 0);
        const QJsonObject all = QJsonDocument::fromJson(read("m.json")).object();
        QVERIFY(all.value("peak_force_N").toDouble() > 0.1);
        const auto mm = [](const QJsonObject& of, const char* key) {
            return QString::number(of.value(key).toDouble(), 'f', 1);
        };
        const auto s = mm; // one decimal, too
        const auto newton = [](const QJsonObject& of, const char* key) {
            const double force_N = QString::number(of.value(key).toDouble(), 'g', 2).toDouble(); // two digits
            const int exponent = force_N > 0.0 ? static_cast<int>(std::floor(std::log10(force_N))) : 1;
            return QString::number(force_N, 'f', std::clamp(1 - exponent, 0, 4));
        };
        hasRow({"Force in contact", QString("peak %1 N, mean %2 N, median %3 N, 95th percentile %4 N")
                                        .arg(newton(all, "peak_force_N"), newton(all, "mean_force_N"),
                                             newton(all, "median_force_N"), newton(all, "p95_force_N"))});
        hasRow({"Depth in contact",
                QString("peak %1 mm, mean %2 mm, 95th percentile %3 mm")
                    .arg(mm(all, "peak_depth_mm"), mm(all, "mean_depth_mm"), mm(all, "p95_depth_mm"))});
        hasRow({"Duration", s(all, "duration_s") + " s"});
        hasRow({"In contact",
                QString("%1 s, contacts: %2").arg(s(all, "contact_time_s")).arg(all.value("contacts").toInt())});
        hasRow({"Path of the hand", QString::number(all.value("path_length_mm").toDouble(), 'g', 3) + " mm"});
        hasRow({"Path on the surface", QString::number(all.value("contact_path_mm").toDouble(), 'g', 3) + " mm"});
        const QJsonObject phases = all.value("phases").toObject();
        for (const auto& [key, name] : {std::pair("search", "searching"), std::pair("press", "pressing")}) {
            const QJsonObject one = phases.value(key).toObject();
            hasRow({name, QString::number(one.value("phases").toInt()), s(one, "time_s"), newton(one, "mean_force_N"),
                    newton(one, "peak_force_N")});
        }
        const QJsonObject liver = all.value("structures").toObject().value("liver").toObject();
        hasRow({"liver", s(liver, "contact_time_s"),
                QString::number(liver.value("press").toObject().value("phases").toInt()), newton(liver, "mean_force_N"),
                newton(liver, "p95_force_N"), newton(liver, "peak_force_N"), mm(liver, "peak_depth_mm"),
                QString::number(100.0 * liver.value("coverage").toDouble(), 'g', 3), s(liver, "longest_dwell_s")});
        hasRow(
            {"Distance that counts as touched", QString::number(all.value("coverage_distance_mm").toDouble()) + " mm"});
        QCOMPARE(all.value("lumps").toArray().size(), 1);
        const QJsonObject lump = all.value("lumps").toArray()[0].toObject();
        const auto percent = [&lump](const char* key) {
            const double value = lump.value(key).toDouble();
            return std::abs(value) < 0.05 ? QString("0 %") // the rest is rounding
                                          : (value < 0.0 ? "" : "+") + QString::number(value, 'g', 3) + " %";
        };
        hasRow({"tumour", "liver", percent("greatest_change_percent"), percent("predicted_change_percent")}, 2);
    }

    /// The values of `info --distances --json`, rounded.
    void numbersAreThoseOfInfo()
    {
        const Outcome outcome = run({"info", "--distances", "--json", "s.palpate.json"});
        QCOMPARE(outcome.exitCode, 0);
        const QJsonDocument document = QJsonDocument::fromJson(outcome.out);
        const QJsonObject first = document.isArray() ? document.array()[0].toObject() : document.object();
        const QJsonObject table = first.value("distances").toObject();
        const auto mm = [](double value) { return QString::number(value, 'f', 1); };
        QCOMPARE(table.value("sizes").toArray().size(), 3);
        for (const QJsonValue& value : table.value("sizes").toArray()) {
            const QJsonObject size = value.toObject();
            const QJsonArray extent = size.value("extent_mm").toArray();
            hasRow({size.value("name").toString(),
                    QString::number(1e-3 * size.value("volume_mm3").toDouble(), 'g', 3) + " ml",
                    mm(size.value("ball_diameter_mm").toDouble()),
                    QString::number(1e-2 * size.value("area_mm2").toDouble(), 'g', 3) + " cm²",
                    QString("%1 × %2 × %3")
                        .arg(mm(extent[0].toDouble()), mm(extent[1].toDouble()), mm(extent[2].toDouble()))});
        }
        QCOMPARE(table.value("nearest").toArray().size(), 2);
        for (const QJsonValue& value : table.value("nearest").toArray()) {
            const QJsonObject pair = value.toObject();
            const QString inner = pair.value("first").toString(), outer = pair.value("second").toString();
            const bool isInside = pair.value("relation").toString() == "inside";
            hasRow({inner, outer, mm(pair.value("distance_mm").toDouble()),
                    isInside ? QString("%1 lies inside, %2 mm from the surface")
                                   .arg(inner, mm(pair.value("surface_mm").toDouble()))
                             : QString("apart")},
                   2);
        }
        QCOMPARE(table.value("margins").toArray().size(), 2);
        for (const QJsonValue& value : table.value("margins").toArray()) {
            const QJsonObject margin = value.toObject();
            QStringList cells{margin.value("lump").toString(), margin.value("structure").toString()};
            for (const QJsonValue& share : margin.value("area_shares").toArray()) {
                cells << QString::number(100.0 * share.toDouble(), 'g', 3);
            }
            hasRow(cells, 2);
        }
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

// SPDX-License-Identifier: BSD-3-Clause
#include "../support/FileLimits.h"
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/core/AtomicFile.h>
#include <palpate/session/Findings.h>
#include <palpate/session/RecordingWriter.h>
#include <palpate/study/HapticCopy.h>
#include <palpate/study/RecordedScene.h>
#include <palpate/study/Report.h>
#include <palpate/study/StructureSources.h>
#include <palpate/ui/ReportFile.h>
#include <palpate/ui/ReportViews.h>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QXmlStreamReader>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

using namespace palpate;
using core::Vec3;

namespace {

constexpr int kTicks = 1500;
const std::string kHostile = "liver <script>alert(\"1\")</script> & 100 %1";
const std::string kRightToLeft = "كتلة في الكبد";
const std::string kEmoji = "hard 🙂 spot\x01";

/// The text of a file format, and what a reader of the page is told beside it.
struct Parsed
{
    QStringList texts;       ///< of all elements, in order
    QList<QStringList> rows; ///< cells of each row of each table
    QStringList imageTexts;  ///< alternative texts
    QStringList problems;    ///< headings of cells without scope, pictures without text, scripts, external links
    int headings = 0;        ///< of sections
    QString language;
};

Parsed parsed(const QByteArray& html)
{
    Parsed out;
    QXmlStreamReader xml(html);
    QString cell;
    bool isCell = false;
    while (!xml.atEnd()) {
        const auto token = xml.readNext();
        const QString name = xml.name().toString();
        const QXmlStreamAttributes attributes = xml.attributes();
        if (token == QXmlStreamReader::StartElement) {
            if (name == "html") {
                out.language = attributes.value("lang").toString();
            } else if (name == "tr") {
                out.rows << QStringList();
            } else if (name == "th" || name == "td") {
                isCell = true;
                cell.clear();
                if (name == "th" && !attributes.hasAttribute("scope")) {
                    out.problems << "th without scope";
                }
            } else if (name == "img") {
                out.imageTexts << attributes.value("alt").toString();
                if (out.imageTexts.back().isEmpty() || !attributes.value("src").startsWith(u"data:")) {
                    out.problems << "img";
                }
            } else if (name == "h2") {
                ++out.headings;
            } else if (name == "script" || name == "link" || name == "a" || name == "iframe") {
                out.problems << name;
            }
        } else if (token == QXmlStreamReader::EndElement && isCell && (name == "th" || name == "td")) {
            out.rows.back() << cell;
            isCell = false;
        } else if (token == QXmlStreamReader::Characters) {
            out.texts << xml.text().toString();
            cell += xml.text();
        }
    }
    if (xml.hasError()) {
        out.problems << xml.errorString();
    }
    return out;
}

QStringList warnings(const study::Report& report)
{
    QStringList all;
    for (const study::ReportSection& section : report.sections) {
        for (const study::ReportBlock& block : section.blocks) {
            if (const auto* text = std::get_if<study::ReportText>(&block); text != nullptr && text->isWarning) {
                all << QString::fromStdString(text->text.english());
            }
        }
    }
    return all;
}

} // namespace

/// Tests the content of a report and both file formats, on recordings of an organ with a lump.
class Report : public QObject
{
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_folder;

    std::filesystem::path path(const char* name) const { return m_folder->filePath(name).toStdString(); }

    /// Writes a recording of a hand that presses the organ above the lump, and the meshes.
    /// @param findings  number of findings; the first two have names that are hard to print
    void record(int findings, session::RecordingWriter::Ending ending = session::RecordingWriter::Ending::Complete,
                int ticks = kTicks) const
    {
        const auto write = [&](const char* name, const geometry::TriangleMesh& mesh) {
            const meshio::MeshStructure one{"x", mesh, std::nullopt};
            QVERIFY(meshio::writeMesh(path(name), std::span(&one, 1)).isOk());
        };
        write("organ.stl", test::sphere(10, 60.0));
        write("lump.stl", test::moved(test::sphere(4, 8.0), Vec3(0, 0, 46)));
        meshio::SceneFile file;
        file.structures.resize(2);
        file.structures[0].name = kHostile;
        file.structures[0].mesh = path("organ.stl");
        file.structures[0].tissue.stiffness_N_per_mm = 0.2;
        file.structures[1].name = "lump 16 mm";
        file.structures[1].mesh = path("lump.stl");
        file.structures[1].tissue.stiffness_N_per_mm = 0.6;
        file.structures[1].palpable = false;
        file.structures[1].inside = kHostile;
        file.structures[1].young_ratio = 4.0;
        QVERIFY(meshio::writeScene(path("s.palpate.json"), file).isOk());
        const auto scene = study::openScene(path("s.palpate.json"));
        QVERIFY2(scene.isOk(), scene.status().message().c_str());
        const auto haptic = study::hapticScene(scene.value());
        session::Motion motion;
        for (int i = 0; i < ticks; ++i) {
            const double depth_mm = 8.0 * std::sin(M_PI * i / ticks);
            motion.p_WH.emplace_back(5.0 * std::sin(0.002 * i), 1e-3 * i, 60.5 - depth_mm);
        }
        std::filesystem::remove(path("r.palpate"));
        session::RecordingInfo info;
        study::setSceneSource(info, path("s.palpate.json"));
        auto writer = session::RecordingWriter::create(path("r.palpate"), info, session::RecordingWriter::Sync::AtEnd);
        QVERIFY(writer.isOk());
        QVERIFY(writer.value()->addScene(session::describeScene(1, *haptic, study::sourcesOf(scene.value()))).isOk());
        session::replay(*haptic, motion,
                        [&](const servo::TickRecord& tick) { return writer.value()->append(tick).isOk(); });
        for (int i = 0; i < findings; ++i) {
            core::Finding finding;
            finding.name = i == 0 ? kRightToLeft : i == 1 ? kEmoji : "Finding " + std::to_string(i + 1);
            finding.p_W = Vec3(0.1 * i, 0.0, 60.0);
            finding.structure = kHostile;
            finding.note = i == 0 ? "first line\nsecond <b>line</b>" : "";
            finding.id = std::to_string(i);
            finding.type = core::FindingType::Lump;
            finding.force_N = 1.25;
            finding.depth_mm = 4.5;
            QVERIFY(writer.value()
                        ->addEvent({i * ticks / (findings + 1), "finding", session::findingJson(finding)})
                        .isOk());
        }
        QVERIFY(writer.value()->finish(ending).isOk());
    }

    /// Writes a recording of a press on a liver beside a row of open surfaces with long names. The first crosses the
    /// liver, the others are 4 mm and more away from it and 3 mm apart.
    void recordMany(int others) const
    {
        const auto write = [&](const std::string& name, const geometry::TriangleMesh& mesh) {
            const meshio::MeshStructure one{"x", mesh, std::nullopt};
            QVERIFY(meshio::writeMesh(path((name + ".stl").c_str()), std::span(&one, 1)).isOk());
        };
        meshio::SceneFile file;
        const auto add = [&](const std::string& name, const geometry::TriangleMesh& mesh, bool isPalpable) {
            write(name, mesh);
            meshio::SceneStructure& one = file.structures.emplace_back();
            one.name = name;
            one.mesh = path((name + ".stl").c_str());
            one.palpable = isPalpable;
            one.tissue.stiffness_N_per_mm = isPalpable ? 0.6866667 : 0.5;
        };
        add("capsule_of_the_liver", test::sphere(10, 60.0), true);
        for (int i = 0; i < others; ++i) {
            geometry::TriangleMesh mesh = test::box(Vec3(-1, -1, -1), Vec3(1, 1, 1), 1);
            mesh.triangles.pop_back();
            add(manyName(i), test::moved(mesh, Vec3(60 + 5 * i, 0, 0)), false);
        }
        QVERIFY(meshio::writeScene(path("s.palpate.json"), file).isOk());
        const auto scene = study::openScene(path("s.palpate.json"));
        QVERIFY2(scene.isOk(), scene.status().message().c_str());
        const auto haptic = study::hapticScene(scene.value());
        session::Motion motion;
        for (int i = 0; i < 200; ++i) {
            motion.p_WH.emplace_back(0.0, 0.0, 60.5 - 8.0 * std::sin(M_PI * i / 200));
        }
        session::RecordingInfo info;
        study::setSceneSource(info, path("s.palpate.json"));
        auto writer = session::RecordingWriter::create(path("r.palpate"), info, session::RecordingWriter::Sync::AtEnd);
        QVERIFY(writer.isOk());
        QVERIFY(writer.value()->addScene(session::describeScene(1, *haptic, study::sourcesOf(scene.value()))).isOk());
        session::replay(*haptic, motion,
                        [&](const servo::TickRecord& tick) { return writer.value()->append(tick).isOk(); });
        QVERIFY(writer.value()->finish().isOk());
    }
    /// A name with a word that is too long for a column.
    static std::string manyName(int i) { return "vessel_" + std::to_string(i) + "_" + std::string(70, 'm'); }
    static std::string shownName(int i) { return "vessel " + std::to_string(i) + " " + std::string(70, 'm'); }
    static QStringList paragraphs(const study::Report& report)
    {
        QStringList all;
        for (const study::ReportSection& section : report.sections) {
            for (const study::ReportBlock& block : section.blocks) {
                if (const auto* text = std::get_if<study::ReportText>(&block)) {
                    all << QString::fromStdString(text->text.english());
                }
            }
        }
        return all;
    }

    study::ReportFacts facts(const study::ReportOptions& options = {}) const
    {
        auto facts = study::gatherReport(path("r.palpate"), options);
        if (!facts.isOk()) {
            qWarning("%s", facts.status().message().c_str());
            return {};
        }
        return std::move(facts).value();
    }

    /// Returns the text of each page, or nothing without poppler-utils.
    static QStringList pagesOf(const QByteArray& pdf)
    {
        QProcess process;
        process.start(QStandardPaths::findExecutable("pdftotext"), {"-layout", "-", "-"});
        process.write(pdf);
        process.closeWriteChannel();
        process.waitForFinished(60000);
        return QString::fromUtf8(process.readAllStandardOutput()).split(QLatin1Char('\f'), Qt::SkipEmptyParts);
    }

    static const study::ReportTable* tableWith(const study::Report& report, const char* heading)
    {
        for (const study::ReportSection& section : report.sections) {
            for (const study::ReportBlock& block : section.blocks) {
                const auto* table = std::get_if<study::ReportTable>(&block);
                if (table != nullptr && std::any_of(table->columns.begin(), table->columns.end(), [&](const auto& one) {
                        return one.heading.english() == heading;
                    })) {
                    return table;
                }
            }
        }
        return nullptr;
    }

  private Q_SLOTS:
    void init() { m_folder = std::make_unique<QTemporaryDir>(); }

    void statesWhatWasFelt()
    {
        record(2);
        const study::ReportFacts all = facts();
        const study::Report report = study::composeReport(all);
        QVERIFY2(warnings(report).isEmpty(), qPrintable(warnings(report).join('\n')));
        QVERIFY(all.verification.checksums.isOk());
        QVERIFY(all.verification.resimulated->isSame());
        QCOMPARE(report.views.size(), std::size_t{8}); // 2 of the scene, 2 of findings, 4 maps of touch
        QCOMPARE(report.places.size(), std::size_t{2});
        // The verdict names the ratio that it rests on.
        const study::ReportTable* lumps = tableWith(report, "Stiffness ratio");
        QVERIFY(lumps != nullptr);
        QCOMPARE(lumps->rows.size(), std::size_t{1});
        QCOMPARE(lumps->rows[0][2].english, std::string("4 times as stiff, as typed"));
        const buried::FeltSurface::Lump& lump = all.lumps[0].felt.lumps[0];
        for (std::size_t i = 0; i < lump.press.size(); ++i) {
            QCOMPARE(lumps->rows[0][3 + i].english, buried::verdictText(lump.press[i], lump.ratio));
        }
        const study::ReportTable* findings = tableWith(report, "Place (x y z) [mm]");
        QVERIFY(findings != nullptr);
        QCOMPARE(findings->rows[1][4].english, std::string("0.1 0.0 60.0"));
        QCOMPARE(findings->rows[1][6].english, std::string("1.2")); // of 1.25: two digits, halves to even
        QCOMPARE(findings->rows[1][8].english, std::string("0.5"));
    }

    /// Findings that were marked after the end of the recording are listed apart, numbered on and without measures.
    void findingsOutsideTheRecordingAreListedApart()
    {
        record(2);
        study::ReportOptions options;
        const study::ReportFacts inside = facts();
        options.findings.emplace();
        for (const session::FindingMeasures& one : inside.measures.findings) {
            options.findings->push_back(one.finding); // in the recording
        }
        core::Finding late;
        late.id = "late";
        late.name = "After the end";
        late.p_W = Vec3(0, 0, 60);
        late.hasPlace = true;
        late.force_N = 1.5;
        late.note = "soft";
        late.marked_utc = "2026-11-28T05:18:01Z";
        options.findings->push_back(late);
        core::Finding note; // without a place
        note.id = "note";
        note.hasPlace = false;
        options.findings->push_back(note);
        const study::ReportFacts all = facts(options);
        QCOMPARE(all.outside.size(), std::size_t{1});
        const study::Report report = study::composeReport(all);
        QCOMPARE(report.places.size(), std::size_t{3});
        const study::ReportTable* outside = tableWith(report, "Marked");
        QVERIFY(outside != nullptr);
        QCOMPARE(outside->rows.size(), std::size_t{1});
        QCOMPARE(outside->rows[0][0].english, std::string("3"));
        QCOMPARE(outside->rows[0][1].english, std::string("After the end"));
        QCOMPARE(outside->rows[0][6].english, std::string("1.5"));
        QCOMPARE(outside->rows[0][8].english, std::string("2026-11-28 05:18:01 UTC"));
        QCOMPARE(tableWith(report, "Marked at [s]")->rows.size(), std::size_t{2});
        QCOMPARE(tableWith(report, "Visits")->rows.size(), std::size_t{2});
        const study::ReportTable* notes = tableWith(report, "Written at [s]");
        QVERIFY(notes != nullptr);
        QCOMPARE(notes->rows.back()[0].english, std::string("3. After the end"));
        QVERIFY(tableWith(study::composeReport(inside), "Marked") == nullptr);
    }

    /// The legend has the covered area of the measures; few places lie beyond the end of the colours.
    void mapsAgreeWithTheMeasures()
    {
        record(1);
        const study::ReportFacts all = facts();
        const study::Report report = study::composeReport(all);
        QCOMPARE(report.maps.size(), std::size_t{2});
        const auto surface = std::find_if(all.measures.surfaces.begin(), all.measures.surfaces.end(),
                                          [](const session::SurfaceMeasures& one) { return one.surface != nullptr; });
        QVERIFY(surface != all.measures.surfaces.end());
        const auto rounded = [](double value, int digits) { return QString::number(value, 'g', digits); };
        const QString touched =
            QString("touched: %1 cm², %2 %")
                .arg(rounded(0.01 * surface->coveredArea_mm2, 3), rounded(100.0 * surface->coverage(), 3));
        for (const study::ReportMap& map : report.maps) {
            QCOMPARE(QString::fromStdString(map.legend.at(1).english()), touched);
            const std::vector<float> values = study::mapValues(*surface->surface, map.quantity);
            const auto count = [&](double above) {
                return std::count_if(values.begin(), values.end(), [above](float value) { return value > above; });
            };
            QVERIFY(count(0.0) > 10);
            QVERIFY(50 * count(map.end) <= count(0.0) + 50); // 2 %
            QVERIFY(count(0.39 * map.end) > 0);              // else a lower end of 1, 2 or 5 would do
        }
        QCOMPARE(report.maps[1].legend[0].english(), std::string("Largest force, N"));
        for (const study::ReportView& view : report.views) {
            QVERIFY(!view.map || view.from != study::ReportView::From::Finding);
        }
        QVERIFY(study::composeReport(all, core::Message(PALPATE_TEXT("none"))).maps.empty());
    }

    /// The curve keeps the peak however long the session is, in a fixed number of spans.
    void curveKeepsTheExtremes()
    {
        record(1, session::RecordingWriter::Ending::Complete, 5 * static_cast<int>(study::ForceCurve::kSpans));
        const study::ReportFacts all = facts();
        QCOMPARE(all.force.spans.size(), study::ForceCurve::kSpans);
        float most = 0.0F, least = 1e9F;
        int ranges = 0; // spans in which the force changes: nearly all
        for (const study::ForceCurve::Span& span : all.force.spans) {
            QVERIFY(span.isRecorded && span.least_N <= span.greatest_N);
            ranges += span.least_N < span.greatest_N ? 1 : 0;
            most = std::max(most, span.greatest_N);
            least = std::min(least, span.least_N);
        }
        QCOMPARE(most, static_cast<float>(all.measures.sums.contact.peakForce_N));
        QCOMPARE(least, 0.0F);
        QVERIFY2(ranges > 1000, qPrintable(QString::number(ranges)));
        QCOMPARE(all.force.marks.size(), std::size_t{1});
    }

    /// Of 300 pairs, a third of a page lists the nearest of the touched structure; equal statements are one sentence.
    void manyStructuresFillNoPages()
    {
        constexpr int kOthers = 24;
        recordMany(kOthers);
        const study::ReportFacts all = facts();
        QCOMPARE(all.distances->pairs.size(), std::size_t{25 * 24 / 2});
        const study::Report report = study::composeReport(all);
        const study::ReportTable* pairs = tableWith(report, "Distance [mm]");
        QVERIFY(pairs != nullptr);
        QCOMPARE(pairs->rows.size(), study::kReportedPairs);
        for (std::size_t i = 0; i < pairs->rows.size(); ++i) { // number 0 crosses
            QCOMPARE(pairs->rows[i][0].english, std::string("capsule of the liver"));
            QCOMPARE(pairs->rows[i][1].english, shownName(static_cast<int>(i) + 1));
        }
        const QStringList lines = paragraphs(report);
        const auto has = [&lines](const QString& text) { return lines.filter(text).size() == 1; };
        QVERIFY2(has("capsule of the liver crosses or touches (0 mm): vessel 0 m"), qPrintable(lines.join('\n')));
        QVERIFY2(has("Of 300 pairs of structures, 283 are left out."), qPrintable(lines.join('\n')));
        QVERIFY2(has("No volume, because the surface is open, for 24 structures: vessel 0 m"),
                 qPrintable(lines.join('\n')));
        QVERIFY2(has("Touched structures: capsule of the liver."), qPrintable(lines.join('\n')));
        QCOMPARE(lines.filter("no volume").size(), 0);
        QCOMPARE(tableWith(report, "Volume")->rows.size(), std::size_t{1}); // the touched one
        const study::ReportTable* tissue = tableWith(report, "Stiffness [N/mm]");
        QCOMPARE(tissue->rows.size(), std::size_t{2}); // equal tissues in one row, palpable ones first
        QCOMPARE(tissue->rows[0][0].english, std::string("capsule of the liver"));
        QCOMPARE(tissue->rows[0][1].english, std::string("0.687"));

        const QByteArray pdf = ui::reportPdf(report, {});
        if (!QStandardPaths::findExecutable("pdftotext").isEmpty()) {
            const QStringList pages = pagesOf(pdf);
            QVERIFY2(pages.size() <= 8, qPrintable(QString::number(pages.size())));
            const QString text = pages.join('\n');
            QVERIFY2(text.contains(QRegularExpression("\\bDistance\\b +Position\\b")), qPrintable(text));
            QVERIFY(!text.contains(QRegularExpression("\\bDistanc\\b|\\bPositio\\b")));
            QVERIFY(!text.contains("capsule_of_the_liver "));
        }
    }

    /// A structure beside a finding matters, although it was not touched.
    void neighboursOfFindingsAreListed()
    {
        recordMany(24);
        study::ReportOptions options;
        core::Finding finding;
        finding.id = "late";
        finding.p_W = Vec3(60 + 5 * 20, 4, 0); // 3 mm beside number 20; 19 and 21 are 5 mm away, 18 and 22 10 mm
        options.findings = {finding};
        const study::ReportFacts all = facts(options);
        QVERIFY(std::find(all.besideFindings.begin(), all.besideFindings.end(), 21) != all.besideFindings.end());
        QVERIFY(all.besideFindings.size() >= 3 && all.besideFindings.size() <= 5);
        const study::Report report = study::composeReport(all);
        const study::ReportTable* pairs = tableWith(report, "Distance [mm]");
        QCOMPARE(pairs->rows.size(), study::kReportedPairs);
        const auto isListed = std::any_of(pairs->rows.begin(), pairs->rows.end(), [](const auto& row) {
            return row[0].english == shownName(19) && row[1].english == shownName(20) && row[2].english == "3.0";
        });
        QVERIFY(isListed);
    }

    /// Tapes of the open scene, or else of the scene file.
    void tapesAreListed()
    {
        record(1);
        core::Tape tape;
        tape.name = "Tape 1";
        tape.to_W = Vec3(0.0, 0.0, 119.7311);
        tape.fromOn = "capsule_of_the_liver";
        tape.toOn = "Finding 1";
        study::ReportOptions options;
        options.tapes = {tape};
        const study::Report report = study::composeReport(facts(options));
        const study::ReportTable* tapes = tableWith(report, "Distance [mm]");
        QVERIFY(tapes != nullptr && tapes->rows.size() == 1); // before the least distances
        QCOMPARE(tapes->rows[0][0].english, std::string("Tape 1"));
        QCOMPARE(tapes->rows[0][1].english, std::string("119.7"));
        QCOMPARE(tapes->rows[0][2].english, std::string("capsule of the liver"));
        QCOMPARE(tapes->rows[0][5].english, std::string("0.0 0.0 119.7"));
        QCOMPARE(paragraphs(report).filter("measured with the tape: 1 (Tape 1 119.7 mm)").size(), 1);
        options.tapes->clear();
        QVERIFY(paragraphs(study::composeReport(facts(options))).filter("with the tape").isEmpty());

        auto file = meshio::readScene(path("s.palpate.json"));
        QVERIFY(file.isOk());
        file.value().tapes = {tape};
        QVERIFY(meshio::writeScene(path("s.palpate.json"), file.value()).isOk());
        options.tapes.reset();
        options.scene = path("s.palpate.json");
        QCOMPARE(facts(options).tapes.size(), std::size_t{1});
    }

    /// A mesh in metres, named anew, is read in the unit of the recording.
    void anotherPlaceOfTheSceneKeepsTheUnit()
    {
        geometry::TriangleMesh mesh = test::sphere(10, 60.0);
        for (Vec3& vertex : mesh.vertices) {
            vertex *= 1e-3;
        }
        const meshio::MeshStructure one{"x", mesh, std::nullopt};
        QVERIFY(meshio::writeMesh(path("metres.stl"), std::span(&one, 1)).isOk());
        meshio::ReadOptions inMetres;
        inMetres.unit_mm = 1000.0;
        const auto scene = study::openScene(path("metres.stl"), inMetres);
        QVERIFY(scene.isOk());
        const auto haptic = study::hapticScene(scene.value());
        session::Motion motion;
        for (int i = 0; i < 100; ++i) {
            motion.p_WH.emplace_back(0.0, 0.0, 60.5 - 0.05 * i);
        }
        auto writer = session::RecordingWriter::create(path("r.palpate"), {}, session::RecordingWriter::Sync::AtEnd);
        QVERIFY(writer.isOk());
        QVERIFY(writer.value()->addScene(session::describeScene(1, *haptic, study::sourcesOf(scene.value()))).isOk());
        session::replay(*haptic, motion,
                        [&](const servo::TickRecord& tick) { return writer.value()->append(tick).isOk(); });
        QVERIFY(writer.value()->finish().isOk());
        study::ReportOptions options;
        options.scene = path("metres.stl");
        const study::ReportFacts all = facts(options);
        QVERIFY(all.distances && all.verification.resimulated->isWithinRounding());
        QVERIFY(std::abs(all.distances->sizes[0].extent_mm.z() - 120.0) < 0.1); // a float of 0.06 m has 4e-6 mm
    }

    void missingMeshesAreNamed()
    {
        record(1);
        for (const char* name : {"organ.stl", "lump.stl", "s.palpate.json"}) {
            QVERIFY(std::filesystem::remove(path(name)));
        }
        const study::ReportFacts all = facts();
        QVERIFY(all.scene == nullptr && !all.distances);
        const study::Report report = study::composeReport(all);
        const QString lines = warnings(report).join('\n');
        QVERIFY2(lines.contains("scene is not available, so pictures, sizes, distances and lumps are missing"),
                 qPrintable(lines));
        QVERIFY(lines.contains("not computed again, so its forces are not verified"));
        QVERIFY(lines.contains("without coverage: liver <script>"));
        QVERIFY(report.views.empty());
        const QByteArray html = ui::reportHtml(report, {});
        QVERIFY(html.contains("Distances were not measured, because the scene is missing."));
        QVERIFY(ui::reportPdf(report, {}).startsWith("%PDF-1."));
    }

    /// The open scene replaces files that are gone, but only with the same surfaces.
    void openedSceneReplacesMissingFiles()
    {
        record(1);
        const auto opened = study::openScene(path("s.palpate.json"));
        QVERIFY(opened.isOk());
        for (const char* name : {"organ.stl", "lump.stl", "s.palpate.json"}) {
            QVERIFY(std::filesystem::remove(path(name)));
        }
        study::ReportOptions options;
        auto scene = std::make_shared<meshio::LoadedScene>(opened.value());
        options.opened = scene;
        QVERIFY(warnings(study::composeReport(facts(options))).isEmpty());
        scene->structures.erase(scene->structures.begin());
        QVERIFY(facts(options).scene == nullptr);
    }

    void interruptedRecordingIsNamed()
    {
        record(0, session::RecordingWriter::Ending::CutOff);
        const study::Report report = study::composeReport(facts());
        QVERIFY2(warnings(report).join('\n').contains("The recording was interrupted: ended at 1.5 s"),
                 qPrintable(warnings(report).join('\n')));
        const Parsed page = parsed(ui::reportHtml(report, {}));
        QVERIFY(page.texts.contains("No findings were marked."));
    }

    void damagedRecordingIsNamed()
    {
        record(0);
        QFile file(QString::fromStdString(path("r.palpate").string()));
        QVERIFY(file.open(QIODevice::ReadWrite));
        QByteArray bytes = file.readAll();
        const double stored = 1e-3 * 1234; // the HIP's y of tick 1234, big-endian as in SQLite
        QByteArray pattern(8, '\0');
        std::memcpy(pattern.data(), &stored, 8);
        std::reverse(pattern.begin(), pattern.end());
        const qsizetype at = bytes.indexOf(pattern);
        QVERIFY(at > 0);
        bytes[at + 7] = static_cast<char>(bytes[at + 7] ^ 1);
        QVERIFY(file.seek(0) && file.write(bytes) == bytes.size());
        file.close();
        const study::Report report = study::composeReport(facts());
        const QString lines = warnings(report).join('\n');
        QVERIFY2(lines.contains("The recording is damaged, or was changed after it was made. Damaged places: 1."),
                 qPrintable(lines));
        QVERIFY(lines.contains("Damaged, or changed after it was recorded: "));
    }

    void cancels()
    {
        record(0);
        const std::atomic<bool> isCancelled{true};
        study::ReportOptions options;
        options.isCancelled = &isCancelled;
        QCOMPARE(study::gatherReport(path("r.palpate"), options).status().code(), core::StatusCode::Cancelled);
    }

    void htmlIsReadAndEscaped()
    {
        record(2);
        study::ReportOptions options;
        options.caseText = "A & <b>B</b> \"C\"";
        options.examiner = kRightToLeft;
        const study::Report report = study::composeReport(facts(options));
        const QImage picture(40, 30, QImage::Format_RGB888);
        const QByteArray html = ui::reportHtml(report, std::vector<QImage>(report.views.size(), picture));
        const Parsed page = parsed(html);
        QVERIFY2(page.problems.isEmpty(), qPrintable(page.problems.join(", ")));
        QVERIFY(!html.contains("<script"));
        QVERIFY(!html.contains("http://") && !html.contains("https://"));
        QCOMPARE(page.language, QString("en"));
        QVERIFY(page.rows.contains(QStringList{"Case", "A & <b>B</b> \"C\""}));
        QVERIFY(page.rows.contains(QStringList{"Examiner", QString::fromStdString(kRightToLeft)}));
        QCOMPARE(page.imageTexts.size(), qsizetype(report.views.size()) + 1); // and the curve
        const QString all = page.texts.join(' ');
        QVERIFY(all.contains(QString::fromStdString(kHostile)));
        QVERIFY(all.contains("🙂 spot\\x01"));
        QVERIFY(all.contains("second <b>line</b>"));
        QCOMPARE(page.texts.count("Research, training and planning rehearsal. Not a medical device."), 2);
        QVERIFY(page.headings >= 9);
        for (const study::ReportSection& section : report.sections) {
            QVERIFY2(!section.blocks.empty(), section.heading.english().c_str());
        }
    }

    void pdfHasTheNoticeOnEveryPage()
    {
        record(500);
        const study::Report report = study::composeReport(facts());
        QCOMPARE(report.views.size(), 2 + 4 + study::kReportedPictures);
        const QImage picture(40, 30, QImage::Format_RGB888);
        const QByteArray pdf = ui::reportPdf(report, std::vector<QImage>(report.views.size(), picture));
        QVERIFY(pdf.startsWith("%PDF-1."));
        if (QStandardPaths::findExecutable("pdftotext").isEmpty()) {
            QSKIP("no pdftotext: the text of the PDF is not checked");
        }
        const QStringList pages = pagesOf(pdf);
        QVERIFY2(pages.size() > 10 && pages.size() < 60, qPrintable(QString::number(pages.size())));
        for (qsizetype i = 0; i < pages.size(); ++i) {
            QVERIFY2(pages[i].contains("Research, training and planning rehearsal. Not a medical device."),
                     qPrintable(pages[i]));
            QVERIFY2(pages[i].contains(QString("Page %1 of %2").arg(i + 1).arg(pages.size())), qPrintable(pages[i]));
        }
        const QString all = pages.join(' ');
        QVERIFY(all.contains("Pictures are shown of the first 24 of 500 findings."));
        QVERIFY(all.contains("Finding 500"));
        QCOMPARE(all.count(QRegularExpression("\\bNo\\. +Name +Type")) > 5, true); // on each page of the table
    }

    /// Pictures need OpenGL, here from an X server. Files go to the folder in PALPATE_TEST_PICTURES for visual
    /// inspection.
    void drawsFindings()
    {
        record(5);
        const study::ReportFacts all = facts();
        auto views = ui::ReportViews::create(all);
        if (!views.isOk()) {
            QCOMPARE(views.status().code(), core::StatusCode::Unsupported);
            QSKIP("no OpenGL: pictures are not drawn");
        }
        const study::Report report = study::composeReport(all);
        std::vector<QImage> pictures;
        for (std::size_t i = 0; i < report.views.size(); ++i) {
            pictures.push_back(views.value()->draw(report, i));
            QCOMPARE(3 * pictures.back().width(), 4 * pictures.back().height());
            QVERIFY(i == 0 || pictures[i] != pictures[i - 1]);
        }
        QCOMPARE(pictures.size(), std::size_t{11});
        if (const QString folder = qEnvironmentVariable("PALPATE_TEST_PICTURES"); !folder.isEmpty()) {
            for (const char* name : {"/report.pdf", "/report.html"}) {
                QVERIFY(ui::writeReport((folder + name).toStdString(), report, pictures).isOk());
            }
        }
    }

    void fullDiskLeavesTheOlderFile()
    {
        record(0);
        const study::Report report = study::composeReport(facts());
        QVERIFY(core::writeAtomically(path("old.pdf"), "old").isOk());
        {
            const test::FileLimit limit(4096);
            for (const char* name : {"old.pdf", "new.html"}) {
                QCOMPARE(ui::writeReport(path(name), report, {}).code(), core::StatusCode::NoSpace);
            }
        }
        QFile old(QString::fromStdString(path("old.pdf").string()));
        QVERIFY(old.open(QIODevice::ReadOnly));
        QCOMPARE(old.readAll(), QByteArray("old"));
        QVERIFY(!std::filesystem::exists(path("new.html")));
        QVERIFY(QDir(m_folder->path()).entryList({".palpate-*"}, QDir::AllEntries | QDir::Hidden).isEmpty());
        QCOMPARE(ui::writeReport(path("r.txt"), report, {}).code(), core::StatusCode::BadCommandLine);
    }
};

PALPATE_TEST(Report)
#include "tst_Report.moc"

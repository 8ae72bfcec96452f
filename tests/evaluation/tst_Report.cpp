// SPDX-License-Identifier: BSD-3-Clause
// Tests the evaluation on a small mesh: the measurements, and that the report files are complete and consistent.
#include "TestRunner.h"

#include <palpate/evaluation/Report.h>
#include <palpate/evaluation/Shapes.h>
#include <palpate/haptics/Palpator.h>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QXmlStreamReader>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>

using namespace palpate;
using namespace palpate::evaluation;

namespace {

constexpr double kLong_s = 1000.0; // nothing is skipped for lack of time, even on a busy machine

/// Counts the columns of a CSV line.
qsizetype columnsOf(const QByteArray& line)
{
    qsizetype columns = 1;
    bool isQuoted = false;
    for (const char c : line) {
        isQuoted = isQuoted != (c == '"');
        columns += c == ',' && !isQuoted ? 1 : 0;
    }
    return columns;
}

/// A soft cube around a stiffer ball in the layer below, 2 mm under the top, beside a third tissue.
meshio::LoadedScene layeredScene()
{
    const auto structure = [](const char* name, const geometry::TriangleMesh& mesh, double stiffness,
                              std::uint32_t layer) {
        meshio::LoadedStructure result;
        result.description.name = name;
        result.description.tissue.stiffness_N_per_mm = stiffness;
        result.description.layer = layer;
        result.surface = std::make_shared<geometry::RepairedMesh>(geometry::repair(mesh));
        return result;
    };
    meshio::LoadedScene scene;
    scene.structures.push_back(structure("soft", shapes::box({-20, -20, -20}, {20, 20, 20}, 2), 0.2, 0));
    scene.structures.push_back(structure("beside", shapes::box({30, -20, -20}, {50, 20, 20}, 2), 0.3, 0));
    scene.structures.push_back(structure("lump", shapes::box({-5, -5, 8}, {5, 5, 18}, 2), 0.6, 7));
    return scene;
}

/// A soft floor and a stiff wall in one layer that meet along x = z = 0.
meshio::LoadedScene floorAndWall(double lean_deg)
{
    geometry::TriangleMesh wall = shapes::box({-40, -30, -40}, {0, 30, 40});
    const Eigen::AngleAxisd lean(-lean_deg * std::numbers::pi / 180.0, Vec3::UnitY());
    for (Vec3& v : wall.vertices) {
        v = lean * v;
    }
    meshio::LoadedScene scene;
    for (const auto& [name, mesh, stiffness] :
         {std::tuple("floor", shapes::box({-60, -40, -30}, {60, 40, 0}), 0.2), std::tuple("wall", wall, 2.0)}) {
        meshio::LoadedStructure& one = scene.structures.emplace_back();
        one.description.name = name;
        one.description.tissue.stiffness_N_per_mm = stiffness;
        one.surface = std::make_shared<geometry::RepairedMesh>(geometry::repair(mesh));
    }
    return scene;
}

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class Report : public QObject
{
    Q_OBJECT

    std::shared_ptr<const Subject> m_subject;
    HandMotion m_motion;
    Evaluation m_evaluation;

    static EvaluateOptions quickOptions()
    {
        EvaluateOptions options;
        options.isQuick = true;
        options.seconds = kLong_s;
        options.withHardCases = options.withGeneratedMotions = false;
        return options;
    }

  private Q_SLOTS:
    void initTestCase()
    {
        m_subject = subjectOf("ball <& co>", shapes::bumpySphere(10, 60.0, 0.01));
        QVERIFY(m_subject != nullptr);
        m_motion = standardMotions(m_subject->layers[0].surface, 3, 400).front();
        m_motion.name = "slide";
        EvaluateOptions options = quickOptions();
        int calls = 0;
        double last = 0.0;
        bool isRising = true;
        options.progress = [&](double share, const std::string&) {
            isRising = isRising && share >= last && share <= 1.0;
            last = share;
            ++calls;
            return true;
        };
        m_evaluation = evaluate({m_subject}, {m_motion}, options);
        QVERIFY(calls > 5);
        QVERIFY(isRising);
        m_evaluation.hardCases.push_back(evaluation::run(hardCases().front()));
    }

    void everySolverAndKnobIsThere()
    {
        std::set<std::string> solvers, settings;
        for (const Trial& t : m_evaluation.trials) {
            solvers.insert(t.solver);
            settings.insert(t.setting);
            QVERIFY(t.ticks > 0);
            QVERIFY(t.time_us.p50 > 0.0 && t.time_us.p50 <= t.time_us.p999);
        }
        for (const char* name :
             {"exact", "Palpate", "paper (brute force)", "VTK static cell locator", "vector field, nearest"}) {
            QVERIFY2(solvers.count(name) == 1, name);
        }
        for (const char* name : {"one pass a tick", "force held at 500 Hz", "force held at 4000 Hz", "ball of 0.5 mm",
                                 "ball of 2 mm", "50 % of the triangles", "1 % of the triangles"}) {
            QVERIFY2(settings.count(name) == 1, name);
        }
        QVERIFY(!m_evaluation.sizes.empty());
        QCOMPARE(m_evaluation.tissues.size(), std::size_t(6)); // plain, friction, a law, a map, lumps, all
        for (const SizePoint& p : m_evaluation.tissues) {
            QVERIFY(p.ticks > 1000 && p.time_us.p50 > 0.0);
        }
        QCOMPARE(m_evaluation.advice.size(), std::size_t(1));
        QCOMPARE(m_evaluation.subjects[0].hash.size(), std::size_t(64));
    }

    Trial trialOf(Knob knob, double value, const std::string& solver = "Palpate") const
    {
        for (const Trial& t : m_evaluation.trials) {
            if (t.solver == solver && t.knob == knob && t.variationValue == value) {
                return t;
            }
        }
        return Trial{};
    }

    void errorsAreWhatTheSettingsCost()
    {
        const Trial product = trialOf(Knob::Solver, 0.0);
        QVERIFY(product.position_mm.count > 300);
        QVERIFY(product.position_mm.p99 <= 1e-6);
        QVERIFY(product.residual_mm.max <= 1e-6);
        QCOMPARE(product.popThroughs, std::size_t(0));
        for (const double radius : {0.5, 1.0, 2.0}) {
            const Trial ball = trialOf(Knob::Radius, radius);
            QVERIFY(ball.position_mm.count > 100);
            QVERIFY(ball.position_mm.p50 <= 1e-6 && ball.residual_mm.max <= 1e-6);
            QCOMPARE(ball.popThroughs, std::size_t(0));
        }
        QVERIFY(trialOf(Knob::Decimated, 0.5).position_mm.p50 < trialOf(Knob::Decimated, 0.05).position_mm.p50);
        // At 100 mm/s, a force held for 2 ms lags by 0.2 mm of hand motion.
        const double slow = trialOf(Knob::Rate, 500.0).position_mm.p50,
                     fast = trialOf(Knob::Rate, 4000.0).position_mm.p50;
        QVERIFY(slow > 4.0 * fast && slow < 12.0 * fast);
    }

    /// The same rule for all solvers: trials at one rate are compared over the same ticks, namely those in which either
    /// is in contact.
    void everyTickInContactCounts()
    {
        std::size_t exactTicks = 0;
        for (const Trial& t : m_evaluation.trials) {
            if (t.isReference) {
                exactTicks = t.ticks;
                QCOMPARE(t.ticks, t.wanted);
                continue;
            }
            QCOMPARE(t.ticks, t.wanted);
            QCOMPARE(t.ticks, exactTicks * static_cast<std::size_t>(t.rate_Hz) / 1000);
            QVERIFY2(t.position_mm.count == t.force_N.count && t.force_N.count == t.forcePercent.count,
                     t.solver.c_str());
            QVERIFY(t.elsewhere <= t.position_mm.count);
            QCOMPARE(t.elsewhere, t.elsewhere_mm.count);
            QCOMPARE(t.pathPosition_mm.values.size(), std::size_t(1));
            QVERIFY(std::abs(t.pathPosition_mm.median - t.position_mm.mean) <= 1e-12 + 1e-9 * t.position_mm.mean);
        }
        const Trial product = trialOf(Knob::Solver, 0.0);
        QCOMPARE(product.sameState.ticks, product.position_mm.count);
        const Trial paper = trialOf(Knob::Solver, 0.0, "paper (brute force)");
        QCOMPARE(paper.position_mm.count >= product.position_mm.count, true);
        QVERIFY(paper.elsewhere > 0); // the method needs two ticks for a convex edge
        // Deviations count in every tick: distant positions are included.
        QVERIFY(paper.position_mm.max >= paper.elsewhere_mm.max);
        QVERIFY(paper.elsewhere_mm.max >= paper.elsewhere_mm.p50 && paper.elsewhere_mm.p50 > 1e-3);
    }

    /// At 1 kHz the hand samples coincide with the solver's: the error is due to the solver and not to the rate.
    void solverAndRateErrorsAreApart()
    {
        const Trial solver = trialOf(Knob::Solver, 0.0), rate = trialOf(Knob::Rate, 1000.0);
        QVERIFY(solver.position_mm.p50 <= 1e-9);
        QVERIFY(rate.position_mm.p50 > 0.01);
        QVERIFY(rate.elsewhere_mm.max >= 0.0 && rate.elsewhere < rate.position_mm.count / 2);
    }

    void percentilesNeedTicks()
    {
        const auto tail = [](std::size_t count) {
            std::vector<double> values;
            for (std::size_t i = 1; i <= count; ++i) {
                values.push_back(static_cast<double>(i));
            }
            return tailOf(percentilesOf(values));
        };
        QCOMPARE(QString(tail(10000).name), QString("99.9 %"));
        QCOMPARE(tail(10000).value, 9990.0);
        QCOMPARE(QString(tail(9999).name), QString("99 %"));
        QCOMPARE(tail(1000).value, 990.0);
        QCOMPARE(QString(tail(999).name), QString("most"));
        QCOMPARE(tail(999).value, 999.0);
        QVERIFY(!reportHtml(m_evaluation).empty());
        for (const QJsonValue& t :
             QJsonDocument::fromJson(QByteArray::fromStdString(resultsJson(m_evaluation)))["trials"].toArray()) {
            const QJsonObject time = t["time_us"].toObject();
            QCOMPARE(time["p99_9"].isNull(), time["count"].toInt() < 10000);
        }
    }

    void pathsAreSpreadAndTheirNumberIsChosen()
    {
        const auto subject = subjectOf("ball", shapes::bumpySphere(6, 60.0, 0.01));
        EvaluateOptions options;
        options.withHardCases = false;
        options.isQuick = true;
        options.seconds = kLong_s;
        options.seed = 11;
        options.seeds = 4;
        const Evaluation e = evaluate({subject}, {}, options);
        QCOMPARE(e.subjects[0].paths, (std::vector<std::string>{"seed 11", "seed 12", "seed 13", "seed 14"}));
        for (const Trial& t : e.trials) {
            if (t.isReference) {
                continue;
            }
            QCOMPARE(t.pathPosition_mm.values.size(), std::size_t(4));
            QVERIFY(t.pathPosition_mm.low <= t.pathPosition_mm.medianLow);
            QVERIFY(t.pathPosition_mm.medianLow <= t.pathPosition_mm.median);
            QVERIFY(t.pathPosition_mm.median <= t.pathPosition_mm.medianHigh);
            QVERIFY(t.pathPosition_mm.medianHigh <= t.pathPosition_mm.high);
        }
        // Other seeds give other paths; the same seed gives the same path.
        options.seed = 14;
        options.seeds = 1;
        const Evaluation last = evaluate({subject}, {}, options);
        QCOMPARE(last.trials[1].pathPosition_mm.values[0], e.trials[1].pathPosition_mm.values[3]);
        QCOMPARE(last.trials[3].pathPosition_mm.values[0], e.trials[3].pathPosition_mm.values[3]);
        QVERIFY(e.trials[3].pathPosition_mm.values[0] != e.trials[3].pathPosition_mm.values[3]);
        QVERIFY(reportHtml(last).find("from a single path of the hand") != std::string::npos);
    }

    void thePapersOwnRowIsTheFirst()
    {
        QCOMPARE(m_evaluation.paperBody.size(), std::size_t(2));
        const Trial& paper = m_evaluation.paperBody[0];
        QCOMPARE(paper.triangles, std::size_t(616));
        QCOMPARE(paper.solver, std::string("paper (brute force)"));
        QCOMPARE(paper.ticks, paper.wanted);
        QVERIFY(paper.time_us.count > 1000 && paper.time_us.p50 < 1000.0);
        QCOMPARE(m_evaluation.paperBody[1].popThroughs, std::size_t(0));
        const std::string chart = chartSvg(m_evaluation);
        const std::size_t own = chart.find("paper, its 616 triangles"), next = chart.find("Palpate: ");
        QVERIFY(own != std::string::npos && next != std::string::npos && own < next);
    }

    void aSecondRunGivesTheSameErrors()
    {
        const Evaluation &a = m_evaluation, b = evaluate({m_subject}, {m_motion}, quickOptions());
        QCOMPARE(b.trials.size(), a.trials.size());
        for (std::size_t i = 0; i < a.trials.size(); ++i) {
            if (a.trials[i].ticks == a.trials[i].wanted && b.trials[i].ticks == b.trials[i].wanted) {
                QCOMPARE(a.trials[i].position_mm.max, b.trials[i].position_mm.max);
            }
        }
    }

    /// Each structure responds with its own stiffness, also in the reference for the errors.
    void unequalStructuresAnswerAsTheEngineDoes()
    {
        HandMotion motion{"into the wall", {}};
        for (int i = 0; i <= 800; ++i) {
            motion.p_WH.emplace_back(4.0 - 0.02 * i, 0.7, i < 60 ? 1.0 - 0.1 * i : -5.0);
        }
        std::vector<std::shared_ptr<const Subject>> subjects;
        for (const double lean_deg : {-50.0, 0.0, 40.0}) { // lean of the wall, away from the floor
            const QString name = QString("a wall that leans by %1 degrees").arg(lean_deg);
            subjects.push_back(subjectOf(name.toStdString(), floorAndWall(lean_deg)));
            const Subject& subject = *subjects.back();
            const SubjectLayer& layer = subject.layers[0];
            palpate::haptics::Palpator palpator;
            palpator.borrowScene(subject.scene.get());
            std::size_t shared = 0;
            double apart_N = 0.0;
            for (const Vec3& hip : motion.p_WH) {
                const auto tick = palpator.step(hip, 1e-3);
                const Vec3 spring = tick.p_WG - hip;
                if (tick.constraints > 0) {
                    apart_N = std::max(apart_N, (layer.springsAt(tick.p_WG, spring).force(spring) - tick.f_W).norm());
                    shared += tick.contactCount > 1 ? 1 : 0;
                }
            }
            QVERIFY2(shared > 100, qPrintable(name));
            QVERIFY2(apart_N < 1e-6, qPrintable(name + QString(": %1 N").arg(apart_N)));
            if (lean_deg == 0.0) {
                const Vec3 spring(0.09, 0.0, 5.0);
                const Vec3 both = layer.springsAt(Vec3(0, 0.7, 0), spring).force(spring);
                QVERIFY((both - Vec3(0.18, 0.0, 1.0)).norm() < 1e-9);
            }
        }
        const Evaluation e = evaluate(subjects, {motion}, quickOptions());
        std::size_t judged = 0;
        for (const Trial& t : e.trials) {
            if (t.solver == "Palpate" && t.knob == Knob::Solver) {
                QVERIFY2(t.force_N.max <= 1e-6,
                         qPrintable(QString("%1: %2 N").arg(QString::fromStdString(t.subject)).arg(t.force_N.max)));
                ++judged;
            }
        }
        QCOMPARE(judged, subjects.size());
    }

    void layersAreFeltTogether()
    {
        const auto subject = subjectOf("layers", layeredScene());
        QCOMPARE(subject->layers.size(), std::size_t(2));
        const Vec3 up = Vec3::UnitZ();
        QCOMPARE(subject->layers[0].springsAt(Vec3(3, 3, 20), up).force(up), Vec3(0.2 * up));
        QCOMPARE(subject->layers[0].springsAt(Vec3(40, 3, 20), up).force(up), Vec3(0.3 * up));
        QCOMPARE(subject->layers[1].springsAt(Vec3(0, 0, 18), up).force(up), Vec3(0.6 * up));
        HandMotion press{"press", {}};
        for (int i = 0; i <= 400; ++i) {
            // down to z = 14: 6 mm into the cube, 4 mm into the lump
            press.p_WH.emplace_back(1.0, 0.5, 22.0 - 0.02 * i);
        }
        const Evaluation e = evaluate({subject}, {press}, quickOptions());
        QCOMPARE(e.subjects[0].layers, std::size_t(2));
        QCOMPARE(e.subjects[0].structures.size(), std::size_t(3));
        const auto product = std::find_if(e.trials.begin(), e.trials.end(), [](const Trial& t) {
            return t.solver == "Palpate" && t.knob == Knob::Solver;
        });
        QVERIFY(product != e.trials.end());
        QCOMPARE(product->triangles, subject->triangleCount());
        QVERIFY(product->position_mm.max <= 1e-6 && product->force_N.max <= 1e-6);
        // A force held over 2 ms lags by 0.16 mm of both springs while the lump is touched.
        const auto slow =
            std::find_if(e.trials.begin(), e.trials.end(), [](const Trial& t) { return t.rate_Hz == 500.0; });
        QVERIFY(std::abs(slow->force_N.max - 0.16 * (0.2 + 0.6)) < 1e-6);
    }

    void timeIsKept()
    {
        const auto subject = subjectOf("ball", shapes::bumpySphere(6, 60.0, 0.01));
        EvaluateOptions options;
        options.isQuick = true;
        options.seeds = 5;
        options.seconds = 1e-3;
        const Evaluation e = evaluate({subject}, {}, options);
        QVERIFY(!e.isCancelled);
        QVERIFY(e.skippedItems.size() > 5); // nearly all trials, each with its name
        QVERIFY(reportHtml(e).find("Left out: ") != std::string::npos);
        QCOMPARE(e.trials.back().solver, std::string("Palpate")); // the requested trials are measured nevertheless
    }

    void cancellingEndsIt()
    {
        const auto subject = subjectOf("ball", shapes::bumpySphere(6, 60.0, 0.01));
        EvaluateOptions options;
        options.isQuick = true;
        options.progress = [](double, const std::string&) { return false; };
        const Evaluation e = evaluate({subject}, {}, options);
        QVERIFY(e.isCancelled);
        QVERIFY(e.trials.empty() && e.paperBody.empty());
        QVERIFY(reportHtml(e).find("Cancelled") != std::string::npos);
    }

    void filesAreWholeAndAgree()
    {
        QTemporaryDir folder;
        const QString out = folder.filePath("a/b");
        QVERIFY(writeReport(out.toStdString(), m_evaluation).isOk());
        QCOMPARE(QDir(out).entryList(QDir::Files),
                 (QStringList{"chart.svg", "hard_cases.csv", "report.html", "results.csv", "results.json"}));

        const QJsonObject json = QJsonDocument::fromJson(contentOf(out + "/results.json")).object();
        QCOMPARE(json["trials"].toArray().size(), qsizetype(m_evaluation.trials.size()));
        for (const char* key : {"machine", "seed", "subjects", "hard_cases", "cost_by_size", "elimination_operations",
                                "paper_body", "corner_force", "smooth_surfaces"}) {
            QVERIFY2(json.contains(key), key);
        }
        QVERIFY(!json["machine"].toObject()["build"].toString().isEmpty());

        const QList<QByteArray> lines = contentOf(out + "/results.csv").trimmed().split('\n');
        QCOMPARE(lines.size(), qsizetype(m_evaluation.trials.size() + m_evaluation.paperBody.size() +
                                         m_evaluation.sizes.size() + m_evaluation.tissues.size() + 1));
        for (const QByteArray& line : lines) {
            QCOMPARE(columnsOf(line), columnsOf(lines[0]));
        }
        QVERIFY(lines[0].endsWith("mesh_sha256,seed,cpu,compiler,build"));
        QVERIFY(lines[1].contains(m_evaluation.subjects[0].hash.c_str()));
        const QList<QByteArray> cases = contentOf(out + "/hard_cases.csv").trimmed().split('\n');
        QCOMPARE(cases.size(), qsizetype(m_evaluation.hardCases[0].figures.size() + 1));
        for (const QByteArray& line : cases) {
            QCOMPARE(columnsOf(line), columnsOf(cases[0]));
        }

        QXmlStreamReader chart(contentOf(out + "/chart.svg"));
        while (!chart.atEnd()) {
            chart.readNext();
        }
        QVERIFY2(!chart.hasError(), qPrintable(chart.errorString()));

        QByteArray html = contentOf(out + "/report.html");
        QVERIFY(html.startsWith("<!DOCTYPE html>"));
        QVERIFY(!html.contains("<script") && !html.contains("src=") && !html.contains("@import"));
        QVERIFY(!html.contains("nan") && !html.contains("inf "));
        QVERIFY(html.contains("ball &lt;&amp; co&gt;"));
        // Close the void elements of HTML for the XML reader; the rest must nest.
        html.replace("<meta charset='utf-8'>", "");
        html.replace("<meta name='viewport' content='width=device-width, initial-scale=1'>", "");
        html.replace("<br>", "<br/>");
        html.replace("<details open>", "<details open=''>");
        QXmlStreamReader xml(html);
        while (!xml.atEnd()) {
            xml.readNext();
        }
        QVERIFY2(!xml.hasError(), qPrintable(xml.errorString() + QString(" at %1").arg(xml.characterOffset())));
    }

    void aFolderThatCannotBeMadeIsSaid()
    {
        QTemporaryDir folder;
        QFile file(folder.filePath("taken"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.close();
        const core::Status status = writeReport(folder.filePath("taken/x").toStdString(), m_evaluation);
        QVERIFY(!status.isOk());
        QVERIFY(status.message().find("taken") != std::string::npos);
    }
};

PALPATE_TEST(Report)
#include "tst_Report.moc"

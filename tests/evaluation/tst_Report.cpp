// SPDX-License-Identifier: BSD-3-Clause
// The evaluation on a small mesh: what it measures, and that its files are whole and say the same.
#include "TestRunner.h"

#include <palpate/evaluation/Report.h>
#include <palpate/evaluation/Shapes.h>

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QXmlStreamReader>

#include <set>

using namespace palpate;
using namespace palpate::evaluation;

namespace {

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class Report : public QObject
{
    Q_OBJECT

    Evaluation m_evaluation;

  private slots:
    void initTestCase()
    {
        const auto subject = subjectOf("ball <& co>", shapes::bumpySphere(10, 60.0, 0.01));
        QVERIFY(subject != nullptr);
        const HandMotion motion = [&] {
            HandMotion m = standardMotions(subject->surface, 3, 400).front();
            m.name = "slide";
            return m;
        }();
        EvaluateOptions options;
        options.isQuick = true;
        options.withHardCases = false;
        int calls = 0;
        double last = 0.0;
        bool isRising = true;
        options.progress = [&](double share, const std::string&) {
            isRising = isRising && share >= last && share <= 1.0;
            last = share;
            ++calls;
            return true;
        };
        m_evaluation = evaluate({subject}, &motion, options);
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
        for (const char* name :
             {"one pass a tick", "500 Hz held", "4000 Hz held", "50 % of the triangles", "1 % of the triangles"}) {
            QVERIFY2(settings.count(name) == 1, name);
        }
        QVERIFY(!m_evaluation.sizes.empty());
        QCOMPARE(m_evaluation.advice.size(), std::size_t(1));
        QCOMPARE(m_evaluation.subjects[0].hash.size(), std::size_t(64));
    }

    void errorsAreWhatTheSettingsCost()
    {
        const auto find = [&](Knob knob, double value) {
            for (const Trial& t : m_evaluation.trials) {
                if (t.solver == "Palpate" && t.knob == knob && t.knobValue == value) {
                    return t;
                }
            }
            return Trial{};
        };
        const Trial product = find(Knob::Solver, 0.0);
        QVERIFY(product.position_mm.count > 300);
        QVERIFY(product.position_mm.p99 <= 1e-6);
        QVERIFY(product.residual_mm.max <= 1e-6);
        QCOMPARE(product.popThroughs, std::size_t(0));
        QVERIFY(find(Knob::Decimated, 0.5).position_mm.p50 < find(Knob::Decimated, 0.05).position_mm.p50);
        // 100 mm/s: a force that is held for 2 ms lags by 0.2 mm of the hand's way.
        const double slow = find(Knob::Rate, 500.0).position_mm.p50, fast = find(Knob::Rate, 4000.0).position_mm.p50;
        QVERIFY(slow > 4.0 * fast && slow < 12.0 * fast);
    }

    void aSecondRunGivesTheSameErrors()
    {
        const auto subject = subjectOf("ball", shapes::bumpySphere(6, 60.0, 0.01));
        EvaluateOptions options;
        options.withHardCases = false;
        options.isQuick = true;
        const HandMotion motion = standardMotions(subject->surface, 9, 150).front();
        const Evaluation a = evaluate({subject}, &motion, options), b = evaluate({subject}, &motion, options);
        for (std::size_t i = 0; i < a.trials.size(); ++i) {
            if (a.trials[i].ticks == a.trials[i].wanted && b.trials[i].ticks == b.trials[i].wanted) {
                QCOMPARE(a.trials[i].position_mm.max, b.trials[i].position_mm.max);
            }
        }
    }

    void cancellingEndsIt()
    {
        const auto subject = subjectOf("ball", shapes::bumpySphere(6, 60.0, 0.01));
        EvaluateOptions options;
        options.isQuick = true;
        options.progress = [](double, const std::string&) { return false; };
        const Evaluation e = evaluate({subject}, nullptr, options);
        QVERIFY(e.isCancelled);
        QVERIFY(e.trials.empty());
        QVERIFY(reportHtml(e).find("Cancelled") != std::string::npos);
    }

    void filesAreWholeAndAgree()
    {
        QTemporaryDir folder;
        const QString out = folder.filePath("a/b");
        QVERIFY(writeReport(out.toStdString(), m_evaluation).isOk());
        QCOMPARE(QDir(out).entryList(QDir::Files), (QStringList{"report.html", "results.csv", "results.json"}));

        const QJsonObject json = QJsonDocument::fromJson(contentOf(out + "/results.json")).object();
        QCOMPARE(json["trials"].toArray().size(), qsizetype(m_evaluation.trials.size()));
        for (const char* key :
             {"machine", "seed", "subjects", "hard_cases", "cost_by_size", "elimination_operations"}) {
            QVERIFY2(json.contains(key), key);
        }
        QVERIFY(!json["machine"].toObject()["build"].toString().isEmpty());

        const QList<QByteArray> lines = contentOf(out + "/results.csv").trimmed().split('\n');
        QCOMPARE(lines.size(), qsizetype(m_evaluation.trials.size() + 1));
        const auto columns = lines[0].count(',');
        for (qsizetype i = 1; i < lines.size(); ++i) {
            QCOMPARE(lines[i].count(','), columns + lines[i].count(", h") + lines[i].count("field, "));
        }

        QByteArray html = contentOf(out + "/report.html");
        QVERIFY(html.startsWith("<!DOCTYPE html>"));
        QVERIFY(!html.contains("<script") && !html.contains("src=") && !html.contains("@import"));
        QVERIFY(!html.contains("nan") && !html.contains("inf "));
        QVERIFY(html.contains("ball &lt;&amp; co&gt;"));
        // What HTML lets stand open is closed for an XML reader; the rest must nest.
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

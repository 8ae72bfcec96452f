// SPDX-License-Identifier: BSD-3-Clause
// Tests stiffness ratio and verdict of lumps: the window's model and the commands felt, replay and info agree to the
// last digit.
#include "TestRunner.h"
#include "shared/LumpLayout.h"

#include "../support/Shapes.h"

#include <palpate/meshio/LoadScene.h>
#include <palpate/study/FeltFile.h>
#include <palpate/study/HapticCopy.h>
#include <palpate/study/Layers.h>
#include <palpate/study/RecordedScene.h>
#include <palpate/ui/LumpMaps.h>
#include <palpate/ui/TissueByName.h>
#include <palpate/ui/TouchMode.h>
#include <palpate/view/SurfaceMesh.h>

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>

using namespace palpate;
using core::Vec3;

class LumpVerdicts : public QObject
{
    Q_OBJECT

    QTemporaryDir m_folder;

    void write(const QString& name, const QByteArray& bytes) const
    {
        QFile file(m_folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
    }
    static QByteArray obj(const geometry::TriangleMesh& mesh)
    {
        QByteArray text;
        for (const Vec3& v : mesh.vertices) {
            text += "v " + QByteArray::number(v.x(), 'g', 9) + ' ' + QByteArray::number(v.y(), 'g', 9) + ' ' +
                    QByteArray::number(v.z(), 'g', 9) + '\n';
        }
        for (const geometry::Triangle& t : mesh.triangles) {
            text += "f " + QByteArray::number(t[0] + 1) + ' ' + QByteArray::number(t[1] + 1) + ' ' +
                    QByteArray::number(t[2] + 1) + '\n';
        }
        return text;
    }
    /// Returns the JSON that a command writes to its last argument.
    QJsonDocument said(const QStringList& arguments) const
    {
        QProcess process;
        process.setWorkingDirectory(m_folder.path());
        process.start(QStringLiteral(PALPATE_EXECUTABLE), arguments);
        process.waitForFinished(120000);
        QFile file(m_folder.filePath(arguments.last()));
        return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()) : QJsonDocument();
    }

    /// Returns the verdicts as the window computes them on opening: tissue by name, layout of mesh files, then the maps
    /// for the table of lumps.
    QJsonArray ofWindow(const QString& scene) const
    {
        const std::filesystem::path path = m_folder.filePath(scene).toStdString();
        auto loaded = study::openScene(path);
        if (!loaded.isOk()) {
            return {};
        }
        std::vector<ui::StructureRow> rows;
        std::vector<study::LayeredSurface> surfaces;
        for (const meshio::LoadedStructure& one : loaded.value().structures) {
            ui::StructureRow& row = rows.emplace_back();
            row.loaded = one;
            row.picture = view::makeSurface(*one.surface);
            row.touch = study::indexed(*one.surface);
            surfaces.push_back({one.surface.get(), row.touch.get()});
        }
        const study::Layering layering = study::layering(surfaces);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (layering.structures[i].in) {
                rows[i].in = layering.structures[i].in;
            }
        }
        ui::StructureModel model;
        ui::LumpMaps maps(model);
        model.setRows(std::move(rows), loaded.value().scene.buried);
        if (!meshio::isSceneFile(path)) {
            model.editAll(ui::tissueByName(model, layering, 0), QStringLiteral("Tissue"));
            ui::feel(model, LumpLayout(model, layering, 0).ways(), QStringLiteral("Feel"));
        }
        maps.setWanted(true);
        if (!QTest::qWaitFor([&] { return maps.isUpToDate(); }, 60000)) {
            return {};
        }
        meshio::LoadedScene names;
        for (const study::OpenStructure& row : model.rows()) {
            names.structures.push_back(row.loaded);
        }
        std::vector<study::OrganPalpability> organs;
        for (const auto& organ : maps.organs()) {
            organs.push_back(organ->organ);
        }
        return QJsonDocument::fromJson(QJsonDocument(study::lumpsJson(names, organs)).toJson()).array();
    }

    /// Writes a folder of mesh files: an organ of 80 mm with a lump.
    void folder(const QString& name, const char* organ, const char* lump, double radius_mm, double cover_mm) const
    {
        QVERIFY(QDir(m_folder.path()).mkpath(name));
        write(name + QLatin1Char('/') + QLatin1String(organ) + QStringLiteral(".obj"), obj(test::sphere(16, 40.0)));
        const Vec3 place(0, 0, 40.0 - cover_mm - radius_mm);
        write(name + QLatin1Char('/') + QLatin1String(lump) + QStringLiteral(".obj"),
              obj(test::moved(test::sphere(6, radius_mm), place)));
    }

  private Q_SLOTS:
    void initTestCase()
    {
        write(QStringLiteral("motion.csv"), "x,y,z\n0,0,60\n0,0,59.9\n");
        write(QStringLiteral("organ.obj"), obj(test::sphere(16, 40.0)));
        write(QStringLiteral("lump.obj"), obj(test::moved(test::sphere(6, 8.0), Vec3(0, 0, 26))));
    }

    void allSayTheSame_data()
    {
        QTest::addColumn<QString>("scene");
        QTest::addColumn<double>("ratio"); ///< 0: unknown
        const auto named = [this](const char* organ, const char* lump, double radius_mm, double cover_mm,
                                  double ratio) {
            const QString name = QStringLiteral("%1-%2-%3").arg(organ, lump).arg(radius_mm);
            folder(name, organ, lump, radius_mm, cover_mm);
            QTest::newRow(qPrintable(name)) << name << ratio;
        };
        named("liver", "lump-20-mm", 10.0, 8.0, 4.4);
        named("liver", "tumour", 10.0, 4.0, 4.4);
        named("liver", "tumour_segment_IV", 5.0, 3.0, 4.4);
        named("liver", "metastasis", 7.5, 6.0, 4.4);
        named("liver", "hepatocellular_carcinoma", 12.0, 10.0, 4.4);
        named("liver", "haemangioma", 10.0, 3.0, 1.2);
        named("liver", "fibrotic_area", 12.0, 2.0, 2.6);
        named("liver", "cyst", 10.0, 4.0, 0.001);
        named("kidney", "kidney_cyst_left", 8.0, 2.0, 0.001);
        named("prostate", "cancer", 8.0, 3.0, 2.1);
        named("breast", "mass", 6.0, 5.0, 4.5);
        named("thyroid", "nodule", 6.0, 3.0, 9.6);
        named("pancreas", "tumor", 8.0, 4.0, 1.9);
        named("liver", "thing", 8.0, 4.0, 0.0);
        named("part", "tumour", 8.0, 4.0, 0.0);
        named("kidney", "tumour", 8.0, 4.0, 0.0);
        const auto file = [this](const char* name, const QByteArray& organ, const QByteArray& lump,
                                 const QByteArray& more, double ratio) {
            write(QLatin1String(name), R"({"version": 1, "structures": [{"mesh": "organ.obj", "name": "liver")" +
                                           organ + R"(}, {"mesh": "lump.obj", "name": "tumour")" + lump + "}]" + more +
                                           "}");
            QTest::newRow(name) << QString(QLatin1String(name)) << ratio;
        };
        file("tissues.palpate.json", R"(, "stiffness_N_per_mm": 0.2)", R"(, "stiffness_N_per_mm": 0.6)", {}, 0.6 / 0.2);
        file("moduli.palpate.json", R"(, "young_kPa": 7)", R"(, "young_kPa": 25)", {}, 25.0 / 7.0);
        file("typed.palpate.json", {}, R"(, "inside": "liver", "young_ratio": 3.3)", R"(, "buried": "felt")", 3.3);
        file("names.palpate.json", R"(, "felt_contact_radius_mm": 8)", R"(, "inside": "liver")",
             R"(, "buried": "felt")", 4.4);
    }
    void allSayTheSame()
    {
        QFETCH(QString, scene);
        QFETCH(double, ratio);
        const QJsonArray felt =
            said({QStringLiteral("felt"), scene, QStringLiteral("--json"), QStringLiteral("f.json")})
                .object()["lumps"]
                .toArray();
        QCOMPARE(felt.size(), 1);
        const QJsonObject lump = felt[0].toObject();
        const bool isKnown = ratio > 0.0;
        QCOMPARE(lump["young_ratio"].isDouble(), isKnown);
        QCOMPARE(lump["young_ratio"].toDouble(), ratio);
        for (const QJsonValue& press : lump["press"].toArray()) {
            QCOMPARE(press.toObject()["verdict"].isString(), isKnown);
        }
        const QJsonArray replayed =
            said({QStringLiteral("replay"), scene, QStringLiteral("--motion"), QStringLiteral("motion.csv"),
                  QStringLiteral("--json"), QStringLiteral("r.json")})
                .object()["lumps"]
                .toArray();
        QCOMPARE(replayed, felt);
        QProcess info;
        info.setWorkingDirectory(m_folder.path());
        info.start(QStringLiteral(PALPATE_EXECUTABLE), {QStringLiteral("info"), QStringLiteral("--json"), scene});
        QVERIFY(info.waitForFinished(120000));
        const QJsonDocument report = QJsonDocument::fromJson(info.readAllStandardOutput());
        QCOMPARE(report.array()[0].toObject()["lumps"].toArray(), felt);
        QCOMPARE(ofWindow(scene), felt);
    }
};

PALPATE_TEST(LumpVerdicts)
#include "tst_LumpVerdicts.moc"

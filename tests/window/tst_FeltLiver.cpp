// SPDX-License-Identifier: BSD-3-Clause
#include "Desk.h"
#include "TestRunner.h"

#include "../support/Shapes.h"

#include <palpate/meshio/MeshFile.h>
#include <palpate/study/FeltFile.h>
#include <palpate/study/RecordedScene.h>
#include <palpate/ui/FeltOverlay.h>
#include <palpate/ui/FeltPanel.h>
#include <palpate/ui/LumpMaps.h>
#include <palpate/ui/MessageBar.h>
#include <palpate/ui/VtkViewport.h>

#include <cmath>
#include <map>

using namespace palpate;
using core::Vec3;

/// Tests a whole liver from a reference library (30,000 triangles, vessels and ducts) with a lump of 24 mm below its
/// front, in the window and with the functions of the command.
class FeltLiver : public QObject
{
    Q_OBJECT

    static constexpr double kRadius_mm = 12.0, kCover_mm = 6.0;
    std::unique_ptr<test::Desk> m_desk;
    std::vector<std::filesystem::path> m_files; ///< in metres
    std::filesystem::path m_openCapsule, m_capsule, m_lump;

    static std::filesystem::path library()
    {
        return std::filesystem::path(PALPATE_SHARED_DIR) / "anatomy/vh_f_liver_scene";
    }
    ui::LumpMaps& lumps() { return *m_desk->window().findChild<ui::LumpMaps*>(); }

    /// Closes the rim at the missing caudate lobe with a fan around its centre.
    static geometry::TriangleMesh closed(geometry::TriangleMesh mesh)
    {
        std::map<std::uint32_t, std::uint32_t> rim; // in the direction of the missing triangles
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        for (const geometry::Triangle& t : mesh.triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                ++edges[{t[k], t[(k + 1) % 3]}];
            }
        }
        Vec3 middle = Vec3::Zero();
        for (const auto& [edge, count] : edges) {
            if (edges.count({edge.second, edge.first}) == 0) {
                rim[edge.second] = edge.first;
                middle += mesh.vertices[edge.first];
            }
        }
        const auto last = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.push_back(middle / static_cast<double>(rim.size()));
        for (const auto& [from, to] : rim) {
            mesh.triangles.push_back({from, to, last});
        }
        return mesh;
    }

    /// Returns the point of the liver's front nearest to the middle of the right lobe, and the outward normal there.
    static std::pair<Vec3, Vec3> front(const geometry::TriangleMesh& mesh)
    {
        const Vec3 about(-50.0, 360.0, 0.0);
        std::pair<Vec3, Vec3> best{Vec3::Zero(), Vec3::UnitZ()};
        double least = 1e9;
        for (const geometry::Triangle& t : mesh.triangles) {
            const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
            const Vec3 n = (b - a).cross(c - a).normalized(), p = (a + b + c) / 3.0;
            const double away = (p - about).head<2>().norm();
            if (n.z() > 0.8 && away < least) {
                least = away;
                best = {p, n};
            }
        }
        return best;
    }

    void open(const std::filesystem::path& capsule)
    {
        QVERIFY(m_desk->show());
        std::vector<std::filesystem::path> files = m_files;
        files.push_back(capsule);
        files.push_back(m_lump);
        QSignalSpy ready(&m_desk->window(), &MainWindow::ready);
        meshio::ReadOptions inMetres;
        inMetres.unit_mm = 1000.0;
        m_desk->window().open(files, inMetres);
        PALPATE_TRY_COMPARE(ready.count(), 1);
    }

    QString newestMessage() { return test::newest(m_desk->window().findChild<ui::MessageBar*>()->text()); }

    void keep(const char* name)
    {
        if (const QByteArray to = qgetenv("PALPATE_FELT_PICTURES"); !to.isEmpty()) {
            QTest::qWait(900);
            QVERIFY(m_desk->picture().save(QString::fromLocal8Bit(to + "/" + QByteArray(name) + ".png")));
        }
    }

  private Q_SLOTS:
    void initTestCase()
    {
        if (!test::Desk::hasDisplay()) {
            QSKIP(test::Desk::kNoDisplay);
        }
        if (!std::filesystem::exists(library())) {
            QSKIP("the reference anatomy is not there");
        }
        m_desk = std::make_unique<test::Desk>();
        m_openCapsule = library() / "capsule_of_the_liver.stl";
        for (const auto& file : std::filesystem::directory_iterator(library())) {
            if (file.path() != m_openCapsule) {
                m_files.push_back(file.path());
            }
        }
        std::sort(m_files.begin(), m_files.end());
        meshio::ReadOptions metres;
        metres.unit_mm = 1000.0;
        const auto scene = study::openScene(m_openCapsule, metres);
        QVERIFY(scene.isOk());
        const geometry::TriangleMesh capsule = closed(scene.value().structures.front().surface->mesh);
        const auto [p, n] = front(capsule);
        const auto inMetres = [](const geometry::TriangleMesh& mesh) {
            return test::transformed(mesh, [](const Vec3& v) { return Vec3(1e-3 * v); });
        };
        QVERIFY(QDir(QString::fromStdString(m_desk->folder().string())).mkpath("closed"));
        m_capsule = m_desk->writeStl("closed/capsule_of_the_liver.stl", inMetres(capsule));
        m_lump = m_desk->writeStl(
            "closed/tumour.stl", inMetres(test::moved(test::sphere(12, kRadius_mm), p - (kRadius_mm + kCover_mm) * n)));
    }
    void cleanupTestCase() { m_desk.reset(); }

    /// In the library the capsule is open at the missing caudate lobe: no lump is transmitted, and the message about
    /// the lump comes first.
    void anOpenCapsuleIsSaid()
    {
        open(m_openCapsule);
        QVERIFY2(
            newestMessage().startsWith(QStringLiteral(
                "tumour cannot be felt through capsule of the liver yet: the surface of capsule of the liver has ")),
            qPrintable(newestMessage()));
        meshio::ReadOptions metres;
        metres.unit_mm = 1000.0;
        auto scene = study::openScene(m_openCapsule, metres);
        auto lump = study::openScene(m_lump, metres);
        QVERIFY(scene.isOk() && lump.isOk());
        scene.value().structures.push_back(lump.value().structures.front());
        const core::Status why = study::organsWithLumps(scene.value()).status();
        QVERIFY2(why.message().find("tumour seems to lie in capsule_of_the_liver, whose surface is open") !=
                     std::string::npos,
                 why.message().c_str());
    }

    void theLumpIsFeltThroughTheClosedOne()
    {
        open(m_capsule);
        QVERIFY2(newestMessage().startsWith(QStringLiteral("tumour lies in capsule of the liver and is felt through "
                                                           "it, 4.4 (1 … 5.2) times as stiff (published")),
                 qPrintable(newestMessage()));
        PALPATE_TRY_VERIFY(lumps().isHandUpToDate());
        keep("liver-opened");
        m_desk->window().viewport().setFocus();
        m_desk->pressKeyOf("felt");
        PALPATE_TRY_VERIFY(lumps().isUpToDate());
        QCOMPARE(lumps().organs().size(), std::size_t(1));
        const buried::FeltSurface& felt = lumps().organs()[0]->organ.felt;
        QVERIFY(std::abs(felt.lumps[0].minCover_mm - kCover_mm) < 1.0);
        QVERIFY(felt.lumps[0].press[1].best.has_value());
        QVERIFY(felt.lumps[0].press[1].felt.estimate > 1.2);
        auto& overlay = *m_desk->window().findChild<ui::FeltOverlay*>();
        QVERIFY(overlay.showBestPlace(0, 0));
        keep("liver-lightly");
        overlay.setPress(2);
        QVERIFY(overlay.showBestPlace(0, 0));
        keep("liver-pressed");
    }
};

PALPATE_TEST(FeltLiver)
#include "tst_FeltLiver.moc"

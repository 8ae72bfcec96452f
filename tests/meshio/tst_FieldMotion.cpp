// SPDX-License-Identifier: BSD-3-Clause
// Motions by displacement fields of a registration.
#include "FieldFiles.h"
#include "Shapes.h"
#include "TestRunner.h"
#include "read/FieldFile.h"

#include <palpate/meshio/LoadScene.h>

#include <cmath>
#include <cstring>

using namespace palpate;
using core::Vec3;
using geometry::SurfaceMotion;
using meshio::internal::FieldGrid;
using meshio::internal::readFieldHere;

namespace {

constexpr double kLattice_mm = 10.0; // cells
constexpr double kWave_per_mm = 0.04, kWave_mm = 4.0, kLift_mm = 10.0;

/// The known field: it depends on z only.
Vec3 wave(const Vec3& p)
{
    const double s = kWave_mm * std::sin(kWave_per_mm * p.z());
    return {0.6 * s, 0.0, kLift_mm + 0.8 * s};
}

/// Largest root mean square of the error over the vertices, where a fit is compared with the spline whose control
/// points take the field's values at their places. Its error is h²/8 times the second derivative [Schoenberg's
/// operator: the mean of (place - x)² is h²/4]. The harmonic part weighs 0.01 of the mean of the squared weights, of
/// which the sum is at most (19/32)³ for each vertex, times the squared differences of neighbours, at most h times the
/// slope. The trilinear field adds a voxel's h²/8.
double boundOfFit_mm()
{
    const double slope = kWave_mm * kWave_per_mm, bend = slope * kWave_per_mm, voxel_mm = 3.0;
    const double spline_mm = kLattice_mm * kLattice_mm / 8.0 * bend;
    const double harmonic_mm2 = 0.01 * std::pow(19.0 / 32.0, 3) * std::pow(kLattice_mm * slope, 2);
    return std::sqrt(spline_mm * spline_mm + harmonic_mm2) + voxel_mm * voxel_mm / 8.0 * bend;
}

test::FieldSample fieldOf(std::function<Vec3(const Vec3&)> u)
{
    test::FieldSample field;
    field.u = std::move(u);
    return field;
}

std::string motionOf(const std::string& files, const std::string& more = "")
{
    return R"(, "motion": {"kind": "field", "files": [)" + files + "]" + more + "}";
}

} // namespace

class FieldMotion : public QObject
{
    Q_OBJECT

    const test::Folder m_folder;
    const std::vector<Vec3> m_vertices = test::sphere(8, 40.0).vertices;

    [[nodiscard]] core::Result<meshio::LoadedScene> loaded(const std::string& fields) const
    {
        return meshio::loadScene(
            m_folder.write("s.palpate.json",
                           R"({"version": 1, "structures": [{"mesh": "liver.vtp", "name": "liver")" + fields + "}]}"));
    }
    [[nodiscard]] std::shared_ptr<const SurfaceMotion> motion(const std::string& fields) const
    {
        const auto opened = loaded(fields);
        return opened.isOk() ? opened.value().structures[0].motion
                             : (qWarning("%s", opened.status().message().c_str()), nullptr);
    }

  private Q_SLOTS:
    void initTestCase()
    {
        meshio::MeshStructure one;
        one.name = "liver";
        one.mesh = test::sphere(8, 40.0);
        QVERIFY(meshio::writeMesh(m_folder.path("liver.vtp"), std::span(&one, 1)).isOk());
        for (const test::FieldFile& file : test::fieldFiles(fieldOf(wave))) {
            m_folder.write(file.name, file.bytes);
        }
        m_folder.write("half.nrrd", test::fieldNrrd(fieldOf([](const Vec3& p) { return Vec3(0.5 * wave(p)); })));
        m_folder.write("inverse.nrrd", test::fieldNrrd(fieldOf([](const Vec3& p) { return Vec3(-wave(p)); })));
    }

    void everyFormatGivesTheSameNumbers()
    {
        Eigen::Matrix3d A;
        A << 0.1, 0.02, -0.03, 0.04, -0.05, 0.06, 0.07, 0.08, 0.09;
        const Vec3 b(1, -2, 3);
        const auto files = test::fieldFiles(fieldOf([&](const Vec3& p) { return Vec3(A * p + b); }));
        const test::Folder folder;
        const FieldGrid first =
            readFieldHere(folder.write("first.nrrd", files[0].bytes), core::FileFrame::Untagged, {}).value();
        for (const test::FieldFile& file : files) {
            const auto read = readFieldHere(folder.write(file.name, file.bytes), core::FileFrame::Untagged, {});
            QVERIFY2(read.isOk(), read.status().message().c_str());
            const FieldGrid& field = read.value();
            QVERIFY2(field.size == first.size && field.values == first.values, file.name.c_str());
            QVERIFY2(field.toVoxel.matrix() == first.toVoxel.matrix(), file.name.c_str());
            for (const Vec3& p : m_vertices) {
                QVERIFY((field.at(p) - A * p - b).norm() < 1e-5); // trilinear, and of floats
                QVERIFY(field.covers(p) && !field.covers(3.0 * p));
            }
        }
        // A measurement frame leads from the components to the space; without a space the structure's axes hold.
        const std::string turned =
            test::fieldNrrd(fieldOf([&](const Vec3& p) {
                                const Vec3 u = A * p + b;
                                return Vec3(u.y(), u.z(), u.x());
                            }),
                            false, "raw", "vector", "measurement frame: (0,1,0) (0,0,1) (1,0,0)\n");
        QVERIFY(readFieldHere(folder.write("turned.nrrd", turned), core::FileFrame::Untagged, {}).value().values ==
                first.values);
        std::string untagged = files[2].bytes;
        const std::string space = "space: right-anterior-superior\n";
        untagged.erase(untagged.find(space), space.size());
        QVERIFY(readFieldHere(folder.write("untagged.nrrd", untagged), core::FileFrame::Ras, {}).value().values ==
                first.values);
    }

    void aKnownFieldIsFollowedWithinTheBoundOfTheLattice()
    {
        const auto found = motion(motionOf("\"u.nrrd\""));
        QVERIFY(found != nullptr);
        QCOMPARE(found->period_s(), 4.0);
        QVERIFY(found->strain() > 0.1 && found->strain() < 0.3);
        const SurfaceMotion::Moment full = found->at(2.0), half = found->at(1.0), rest = found->at(4.0);
        double squares = 0.0;
        for (const Vec3& p : m_vertices) {
            squares += (found->toWorld(full, p) - p - wave(p)).squaredNorm();
            const Vec3 u = found->toWorld(full, p) - p;
            QVERIFY((found->toWorld(half, p) - p - 0.25 * u).norm() < 1e-5); // sin^4
            QVERIFY((found->toWorld(rest, p) - p).norm() < 1e-9);
        }
        const double error_mm = std::sqrt(squares / double(m_vertices.size()));
        QVERIFY2(error_mm <= boundOfFit_mm(),
                 qPrintable(QString("%1 mm, bound %2 mm").arg(error_mm).arg(boundOfFit_mm())));
        QVERIFY(boundOfFit_mm() < 0.02 * kLift_mm);
    }

    void everyFormatGivesTheSameMotion()
    {
        const auto first = motion(motionOf("\"u.nrrd\""));
        for (const test::FieldFile& file : test::fieldFiles(fieldOf(wave))) {
            const auto found = motion(motionOf("\"" + file.name + "\""));
            QVERIFY2(found != nullptr && *found == *first && found->bytes() == first->bytes(), file.name.c_str());
        }
        // As a recording keeps it.
        const auto again = SurfaceMotion::fromBytes(first->bytes()).value();
        for (int i = 0; i < 1000; ++i) {
            const double t = 0.013 * i;
            const Vec3 p = m_vertices[static_cast<std::size_t>(i) % m_vertices.size()];
            const Vec3 a = first->toRest(first->at(t), p, p).X, b = again->toRest(again->at(t), p, p).X;
            QVERIFY(std::memcmp(a.data(), b.data(), sizeof a) == 0);
            QVERIFY((first->toWorld(first->at(t), a) - p).norm() <= SurfaceMotion::kInverse_mm);
        }
    }

    void theOtherDirectionIsInverted()
    {
        const auto found = motion(motionOf("\"inverse.nrrd\"", R"(, "direction": "moved_to_rest")"));
        QVERIFY(found != nullptr);
        const SurfaceMotion::Moment full = found->at(2.0);
        // The inverse has the slope s / (1 - s) and its change; both enter the bound.
        const double s = kWave_mm * kWave_per_mm, bound_mm = boundOfFit_mm() / std::pow(1.0 - s, 3);
        double squares = 0.0;
        for (const Vec3& p : m_vertices) {
            const Vec3 y = found->toWorld(full, p);
            squares += (y - wave(y) - p).squaredNorm();
        }
        const double error_mm = std::sqrt(squares / double(m_vertices.size()));
        QVERIFY2(error_mm <= (1.0 + s) * bound_mm, qPrintable(QString("%1 of %2").arg(error_mm).arg(bound_mm)));
        const auto forward = motion(motionOf("\"inverse.nrrd\""));
        QVERIFY((forward->toWorld(forward->at(2.0), Vec3::Zero()) - Vec3(0, 0, -kLift_mm)).norm() < 1.0);
    }

    void severalFieldsAreTheStepsAfterTheRestShape()
    {
        const auto found = motion(motionOf(R"("half.nrrd", "u.mha", "half.nrrd")", R"(, "period_s": 8)"));
        QVERIFY(found != nullptr);
        const auto u = [&](double t) { return Vec3(found->toWorld(found->at(t), Vec3::Zero())); };
        QVERIFY(u(0.0).norm() < 1e-9 && u(8.0).norm() < 1e-9);
        QVERIFY((u(2.0) - 0.5 * u(4.0)).norm() < 1e-9 && (u(6.0) - u(2.0)).norm() < 1e-9);
        QVERIFY((u(4.0) - wave(Vec3::Zero())).norm() < 0.5);
    }

    void theSceneIsWrittenAndReadAgain()
    {
        const auto opened = loaded(motionOf("\"inverse.nrrd\"", R"(, "direction": "moved_to_rest", "exponent": 2,
            "lattice_mm": 12, "period_s": 5, "source": "ANTs")"));
        QVERIFY2(opened.isOk(), opened.status().message().c_str());
        QCOMPARE(meshio::unknownFields(opened.value().scene), std::vector<std::string>{"structures[0].motion.source"});
        QVERIFY(meshio::writeScene(m_folder.path("t.palpate.json"), opened.value().scene).isOk());
        const auto again = meshio::loadScene(m_folder.path("t.palpate.json"));
        QVERIFY2(again.isOk(), again.status().message().c_str());
        const auto &a = opened.value().structures[0], &b = again.value().structures[0];
        QVERIFY(a.description.motion == b.description.motion);
        QVERIFY(*a.motion == *b.motion);
        QVERIFY(b.description.motion->direction == meshio::FieldDirection::MovedToRest);
        bool isStated = false;
        for (const core::Message& line : again.value().warnings) {
            isStated = isStated || line.english().starts_with("liver: moves by up to ");
        }
        QVERIFY(isStated);
    }

    void structuresWithOneFieldShareTheMotion()
    {
        const std::string field = motionOf("\"u.nrrd\"");
        const auto opened = meshio::loadScene(
            m_folder.write("two.palpate.json", R"({"version": 1, "structures": [{"mesh": "liver.vtp", "name": "a")" +
                                                   field + R"(}, {"mesh": "liver.vtp", "name": "b")" + field + "}]}"));
        QVERIFY2(opened.isOk(), opened.status().message().c_str());
        QVERIFY(opened.value().structures[0].motion == opened.value().structures[1].motion);
    }

    void badFieldsAreRefused_data();
    void badFieldsAreRefused()
    {
        QFETCH(QString, fields);
        QFETCH(QString, name);
        QFETCH(QByteArray, bytes);
        QFETCH(QString, said);
        if (!name.isEmpty()) {
            m_folder.write(name.toStdString(), bytes.toStdString());
        }
        const auto opened = loaded(fields.toStdString());
        QVERIFY(!opened.isOk());
        QVERIFY2(QString::fromStdString(opened.status().message()).contains(said), opened.status().message().c_str());
        QVERIFY(opened.status().message().starts_with("s.palpate.json"));
    }
};

void FieldMotion::badFieldsAreRefused_data()
{
    QTest::addColumn<QString>("fields");
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("said");
    const auto row = [](const char* what, const std::string& fields, const char* said, const char* name = "",
                        const std::string& bytes = "") {
        QTest::newRow(what) << QString::fromStdString(fields) << QString(name) << QByteArray::fromStdString(bytes)
                            << QString(said);
    };
    const auto file = [&row](const char* what, const char* name, const std::string& bytes, const char* said) {
        row(what, motionOf("\"" + std::string(name) + "\""), said, name, bytes);
    };
    const auto changed = [](std::string text, const std::string& from, const std::string& to) {
        return text.replace(text.find(from), from.size(), to);
    };
    const test::FieldSample field = fieldOf(wave);
    const std::string nrrd = test::fieldNrrd(field), meta = test::fieldMeta(field), nifti = test::fieldNifti(field);
    row("no files", motionOf(""), "motion.files: found nothing, expected the path of at least one");
    row("direction", motionOf("\"u.nrrd\"", R"(, "direction": "back")"), "motion.direction: found \"back\"");
    row("exponent", motionOf("\"u.nrrd\"", R"(, "exponent": 3)"), "motion.exponent: found 3");
    row("no such file", motionOf("\"none.nrrd\""), "liver: motion: none.nrrd: ");
    row("one of several", motionOf(R"("u.nrrd", "none.nrrd")"), "liver: motion: none.nrrd: ");
    file("another format", "x.nrrd", "solid x\n", "x.nrrd: an unknown format");
    file("one component", "x.mha", changed(meta, "Channels = 3", "Channels = 1"), "x.mha: 1 components per voxel");
    file("four components", "x.mha", changed(meta, "Channels = 3", "Channels = 4"), "x.mha: 4 components per voxel");
    file("three phases", "x.nrrd", test::fieldNrrd(field, false, "raw", "list"),
         "x.nrrd: header: 3 numbers per voxel that are not marked as a vector");
    file("no intent", "x.nii", test::fieldNifti(field, 0), "x.nii: header: 3 numbers per voxel that are not marked");
    file("no position", "x.nii", test::fieldNifti(field, 1007, false), "x.nii: header: neither sform nor qform");
    file("measurement frame", "x.nrrd",
         test::fieldNrrd(field, false, "raw", "vector", "measurement frame: (0,1,0) none (1,0,0)\n"),
         "x.nrrd: header: measurement frame");
    file("cut off", "x.nrrd", nrrd.substr(0, nrrd.size() - 5), "x.nrrd: 253,440 voxels declared");
    file("packed and cut off", "x.nii.gz", test::gzipped(nifti.substr(0, nifti.size() - 5)), "x.nii.gz: ");
    file("more than there are", "x.mha", changed(meta, "DimSize = 40 44 48", "DimSize = 40 44 4800"), "x.mha: ");
    file("a product beyond 64 bits", "x.nrrd",
         changed(nrrd, "sizes: 3 40 44 48", "sizes: 3 1000000000 1000000000 1000000000"),
         "x.nrrd: header: 1,000,000,000 × 1,000,000,000 × 1,000,000,000 voxels");
    file("axes in a plane", "x.nrrd", changed(nrrd, "(0,0,3)", "(0,-3,0)"),
         "x.nrrd: header: axes that lie in one plane");
    file("sheared axes", "x.nrrd", changed(nrrd, "(0,0,3)", "(0,1,3)"), "x.nrrd: header: axes 1 and 2 are sheared");
    file(
        "no voxel size", "x.nii",
        [&nifti] {
            std::string text = nifti;
            std::memset(&text[280], 0, 12);
            return text;
        }(),
        "x.nii: header: voxels of");
    const auto bad = [](double number) {
        return fieldOf([number](const Vec3& p) {
            const bool isThere = (p - Vec3(-47.0 + 8.0, 48.75 - 7.5, -64.5 + 6.0)).norm() < 0.1;
            return isThere ? Vec3(0, number, 0) : wave(p);
        });
    };
    file("NaN", "x.mha", test::fieldMeta(bad(std::nan(""))), "x.mha: voxel (3, 2, 4): a number that is not finite");
    file("NaN, by components", "x.nii", test::fieldNifti(bad(std::nan(""))), "x.nii: voxel (3, 2, 4)");
    file("infinite", "x.nrrd", test::fieldNrrd(bad(1e300)), "x.nrrd: voxel (3, 2, 4)");
    test::FieldSample small = field;
    small.size[1] = 25;
    file("does not cover the structure", "x.nrrd", test::fieldNrrd(small), "outside of the field");
    file("strain", "x.nrrd", test::fieldNrrd(fieldOf([](const Vec3& p) { return Vec3(0, 0, 0.5 * p.z()); })),
         "motion: x.nrrd: frame 0, cell (");
    file("folds", "x.nrrd", test::fieldNrrd(fieldOf([](const Vec3& p) { return Vec3(0, 0, -1.5 * p.z()); })),
         "may fold");
    row("residual", motionOf("\"x.nrrd\"", R"(, "lattice_mm": 40)"),
        "mm between the shape and the lattice of 40 mm, expected at most 1 mm", "x.nrrd",
        test::fieldNrrd(fieldOf([](const Vec3& p) { return Vec3(1.5 * std::sin(0.15 * p.x()), 0, 0); })));
    file("far too large", "x.nrrd", test::fieldNrrd(fieldOf([](const Vec3& p) { return Vec3(1e30 * p); })), "x.nrrd");
    const std::string back = R"(, "direction": "moved_to_rest")";
    row("no inverse", motionOf("\"x.nrrd\"", back), "x.nrrd: (", "x.nrrd",
        test::fieldNrrd(fieldOf([](const Vec3& p) { return Vec3(0, 0, 2.5 * p.z() + 1.0); })));
    row("frame of several", motionOf(R"("u.nrrd", "x.nrrd")"), "motion: frame 2, cell (", "x.nrrd",
        test::fieldNrrd(fieldOf([](const Vec3& p) { return Vec3(0, 0, 0.5 * p.z()); })));
}

PALPATE_TEST(FieldMotion)
#include "tst_FieldMotion.moc"

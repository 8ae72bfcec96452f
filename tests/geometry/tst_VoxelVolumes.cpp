// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/geometry/VoxelVolume.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <numbers>

using namespace palpate;
using core::Vec3;
using geometry::SectionPlane;
using geometry::VoxelVolume;

namespace {

/// Oblique volume of 21 x 11 x 6 voxels of 1 x 2 x 4 mm whose numbers are linear in the world: 3 x - y + 0.5 z.
VoxelVolume linearVolume()
{
    VoxelVolume volume;
    volume.size = {21, 11, 6};
    Eigen::Affine3d toWorld = Eigen::Affine3d::Identity();
    toWorld.translate(Vec3(40, -30, 200));
    toWorld.rotate(Eigen::AngleAxisd(0.6, Vec3(1, 2, 3).normalized()));
    toWorld.scale(Vec3(1, 2, 4));
    volume.toVoxel = toWorld.inverse();
    for (int z = 0; z < 6; ++z) {
        for (int y = 0; y < 11; ++y) {
            for (int x = 0; x < 21; ++x) {
                volume.values.push_back(static_cast<float>((toWorld * Vec3(x, y, z)).dot(Vec3(3, -1, 0.5))));
            }
        }
    }
    return volume;
}

double areaOf(const std::vector<Eigen::Vector2d>& polygon)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Eigen::Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        sum += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    return std::abs(sum);
}

} // namespace

class VoxelVolumes : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void sliceShowsTheNumbersAtTheirPlaces()
    {
        const VoxelVolume volume = linearVolume();
        const Vec3 middle = volume.toVoxel.inverse() * Vec3(10, 5, 2.5);
        const SectionPlane plane = SectionPlane::through(middle, Vec3(0.2, -0.5, 0.7));
        const geometry::GreyWindow window{middle.dot(Vec3(3, -1, 0.5)), 400.0};
        const geometry::VolumeSlice slice = geometry::sliceOf(volume, plane, window);
        QVERIFY(slice.columns > 5 && slice.rows > 5);
        int compared = 0;
        for (int y = 0; y < slice.rows; ++y) {
            for (int x = 0; x < slice.columns; ++x) {
                const Eigen::Vector2d q =
                    slice.box.min() +
                    slice.box.sizes().cwiseProduct(Eigen::Vector2d((x + 0.5) / slice.columns, (y + 0.5) / slice.rows));
                const Vec3 p = plane.inWorld(q), voxel = volume.toVoxel * p;
                if ((voxel.array() < 0.0).any() || voxel.x() > 20.0 || voxel.y() > 10.0 || voxel.z() > 5.0) {
                    continue;
                }
                const double grey = 255.0 * (0.5 + (p.dot(Vec3(3, -1, 0.5)) - window.level) / window.width);
                QVERIFY(std::abs(slice.greys[static_cast<std::size_t>(y * slice.columns + x)] - grey) < 0.51);
                ++compared;
            }
        }
        QVERIFY2(compared > 100, qPrintable(QString::number(compared)));
    }

    void outlineEndsHalfAVoxelBeyondTheCentres()
    {
        const VoxelVolume volume = linearVolume();
        const Eigen::Affine3d toWorld = volume.toVoxel.inverse();
        const auto through = [&](const Vec3& voxel, const Vec3& axis) {
            return SectionPlane::through(toWorld * voxel, toWorld.linear() * axis);
        };
        QVERIFY(std::abs(areaOf(geometry::cutOf(volume, through(Vec3(3, 5, 2), Vec3::UnitX()))) - 22.0 * 24.0) < 1e-9);
        QVERIFY(std::abs(areaOf(geometry::cutOf(volume, through(Vec3(3, 5, 5.4), Vec3::UnitZ()))) - 21.0 * 22.0) <
                1e-9);
        QVERIFY(geometry::cutOf(volume, through(Vec3(3, 5, 5.6), Vec3::UnitZ())).empty());
        QVERIFY(geometry::sliceOf(volume, through(Vec3(-0.6, 0, 0), Vec3::UnitX()), {}).greys.empty());
        // A single layer of voxels can be sliced, too.
        VoxelVolume flat;
        flat.size = {1, 1, 1};
        flat.values = {7.0F};
        const auto slice = geometry::sliceOf(flat, SectionPlane::through(Vec3::Zero(), Vec3::UnitZ()), {7.0, 2.0});
        QVERIFY(std::abs(areaOf(slice.outline) - 1.0) < 1e-12 && slice.greys.front() == 128);
    }

    void numbersAreThoseOfThePlace()
    {
        const VoxelVolume volume = linearVolume();
        const Eigen::Affine3d toWorld = volume.toVoxel.inverse();
        const auto isNear = [&](const Vec3& voxel, const Vec3& sameAs) {
            const auto number = volume.numberAt(toWorld * voxel);
            // The numbers are stored as float: of at most 400, within 2e-5.
            return number && std::abs(*number - (toWorld * sameAs).dot(Vec3(3, -1, 0.5))) < 1e-4;
        };
        QVERIFY(isNear(Vec3(7.3, 2.6, 4.9), Vec3(7.3, 2.6, 4.9)));
        QVERIFY(isNear(Vec3(-0.4, 10.4, 2), Vec3(0, 10, 2))); // half a voxel beyond the centres
        QVERIFY(!volume.numberAt(toWorld * Vec3(-0.6, 5, 2)));
        QVERIFY(!volume.numberAt(toWorld * Vec3(5, 5, 5.6)));
        QVERIFY(!volume.numberAt(Vec3::Constant(std::numeric_limits<double>::quiet_NaN())));
    }

    void windowSpansThePercentilesOfThePatient()
    {
        VoxelVolume volume;
        volume.size = {100, 100, 1};
        for (int i = 0; i < 10000; ++i) { // half of it is air
            volume.values.push_back(i < 5000 ? -1024.0F : static_cast<float>(i - 5000) / 10.0F);
        }
        volume.values[7000] = std::numeric_limits<float>::quiet_NaN();
        volume.values[7001] = std::numeric_limits<float>::infinity();
        const geometry::GreyWindow window = geometry::usualWindow(volume);
        QVERIFY(std::abs(window.level - 250.0) < 1.0 && std::abs(window.width - 490.0) < 2.0);
        volume.values.assign(10000, 3.0F);
        QVERIFY(geometry::usualWindow(volume).level == 3.0 && geometry::usualWindow(volume).width == 1.0);
        volume.values.assign(10000, std::numeric_limits<float>::quiet_NaN());
        QVERIFY(geometry::usualWindow(volume).width > 0.0);
    }
};

PALPATE_TEST(VoxelVolumes)
#include "tst_VoxelVolumes.moc"

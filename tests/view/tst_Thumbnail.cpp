// SPDX-License-Identifier: BSD-3-Clause
#include "Balls.h"
#include "TestRunner.h"

#include <palpate/view/Thumbnail.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace palpate;
using core::Vec3;

namespace {

constexpr int kSize_px = 64;
constexpr std::array<double, 3> kRed{1.0, 0.0, 0.0}, kGreen{0.0, 1.0, 0.0};

struct Pixel
{
    int red = 0, green = 0, blue = 0, alpha = 0;
};

Pixel at(const std::vector<std::uint8_t>& picture, int column, int row)
{
    const std::size_t i = 4 * static_cast<std::size_t>(row * kSize_px + column);
    return {picture[i], picture[i + 1], picture[i + 2], picture[i + 3]};
}

Pixel centre(const std::vector<std::uint8_t>& picture)
{
    return at(picture, kSize_px / 2, kSize_px / 2);
}

} // namespace

/// Tests thumbnails by their pixels.
class Thumbnail : public QObject
{
    Q_OBJECT
  private Q_SLOTS:
    void ballFillsThePicture()
    {
        const auto ball = test::ball(20.0, 4, Vec3(1000.0, -2000.0, 30.0));
        const auto picture = view::drawThumbnail(std::vector<view::ThumbnailSurface>{{&ball, kRed}}, kSize_px);
        QCOMPARE(picture.size(), std::size_t{4 * kSize_px * kSize_px});
        QVERIFY(centre(picture).alpha == 255 && centre(picture).red > 150 && centre(picture).green == 0);
        for (const int corner : {0, kSize_px - 1}) {
            QCOMPARE(at(picture, corner, corner).alpha, 0);
        }
        // The oblique box around a ball is sqrt(3) times as wide as the ball at most; the edge has parts of pixels.
        double covered_px = 0.0;
        bool hasEdge = false;
        for (int i = 0; i < kSize_px * kSize_px; ++i) {
            const int alpha = picture[4 * static_cast<std::size_t>(i) + 3];
            covered_px += alpha / 255.0;
            hasEdge = hasEdge || (alpha > 0 && alpha < 255);
        }
        QVERIFY(hasEdge);
        const double radius_px = std::sqrt(covered_px / std::numbers::pi);
        QVERIFY2(radius_px > kSize_px / 2.0 / std::sqrt(3.0) / 1.05 && radius_px < kSize_px / 2.0,
                 qPrintable(QString::number(radius_px)));
    }

    /// The viewer is in front of the patient (-y) and above (z).
    void nearerSurfaceHidesTheFarther()
    {
        const auto front = test::ball(5.0, 3, Vec3(5.5, -10.0, 4.5)), back = test::ball(5.0, 3, Vec3(-5.5, 10.0, -4.5));
        for (const bool isFrontFirst : {true, false}) {
            std::vector<view::ThumbnailSurface> surfaces{{&front, kRed}, {&back, kGreen}};
            if (!isFrontFirst) {
                std::reverse(surfaces.begin(), surfaces.end());
            }
            const Pixel pixel = centre(view::drawThumbnail(surfaces, kSize_px));
            QVERIFY(pixel.red > 100 && pixel.green == 0);
        }
    }

    void lumpShowsThroughTheOrgan()
    {
        const auto organ = test::ball(20.0, 3), lump = test::ball(5.0, 3);
        for (const double lumpOpacity : {1.0, 0.9}) {
            const auto picture = view::drawThumbnail(
                std::vector<view::ThumbnailSurface>{{&organ, kRed, 0.5}, {&lump, kGreen, lumpOpacity}}, kSize_px);
            QVERIFY(centre(picture).red > 60 && centre(picture).green > 60);
            const Pixel beside = at(picture, kSize_px / 2 + 12, kSize_px / 2);
            QVERIFY(beside.red > 100 && beside.green == 0);
            QVERIFY(std::abs(beside.alpha - 128) <= 1);
        }
    }

    void nothingIsTransparent()
    {
        const geometry::TriangleMesh none;
        for (const auto& surfaces :
             {std::vector<view::ThumbnailSurface>{}, std::vector<view::ThumbnailSurface>{{&none, kRed}}}) {
            const auto picture = view::drawThumbnail(surfaces, kSize_px);
            QCOMPARE(picture.size(), std::size_t{4 * kSize_px * kSize_px});
            QVERIFY(std::ranges::all_of(picture, [](std::uint8_t value) { return value == 0; }));
        }
    }

    /// All points on one place or line: no division by zero.
    void flatSurfacesAreDrawn()
    {
        const geometry::TriangleMesh point{{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}, {{0, 1, 2}}};
        const geometry::TriangleMesh line{{Vec3::Zero(), Vec3::UnitX(), 2.0 * Vec3::UnitX()}, {{0, 1, 2}}};
        for (const geometry::TriangleMesh* mesh : {&point, &line}) {
            QCOMPARE(centre(view::drawThumbnail(std::vector<view::ThumbnailSurface>{{mesh, kRed}}, kSize_px)).alpha, 0);
        }
    }
};

PALPATE_TEST(Thumbnail)
#include "tst_Thumbnail.moc"

// SPDX-License-Identifier: BSD-3-Clause
#include "Phantom.h"

#include "SurfaceSampler.h"
#include "VesselTree.h"

#include <algorithm>

namespace palpate::phantom {

namespace {

constexpr double kOrganCell_mm = 1.54;
constexpr double kVesselCell_mm = 1.65;
constexpr double kLumpCell_mm = 0.8;

/// Region for vessels: inside the organ, outside the lumps.
double roomForVessels(const Vec3& p)
{
    static const std::array<Lump, 2> avoided = lumps();
    double d = organDistance(p);
    for (const Lump& lump : avoided) {
        d = std::max(d, 2.0 - lump.distance(p));
    }
    return d;
}

/// Inferior vena cava behind the organ, with the right, middle and left hepatic veins that join below the diaphragm.
VesselTree hepaticVeins()
{
    VesselTree tree;
    const Vec3 cava[] = {{5, 75, -44}, {5, 73, -16}, {6, 70, 14}, {7, 66, 42}, {8, 63, 64}};
    for (int i = 0; i <= 32; ++i) {
        // Catmull-Rom spline through the points.
        const int k = std::min(i / 8, 3);
        const double t = i / 8.0 - k;
        const Vec3& a = cava[std::max(k - 1, 0)];
        const Vec3& b = cava[k];
        const Vec3& c = cava[k + 1];
        const Vec3& d = cava[std::min(k + 2, 4)];
        const Vec3 p = 0.5 * (2.0 * b + t * (c - a) + t * t * (2.0 * a - 5.0 * b + 4.0 * c - d) +
                              t * t * t * (3.0 * (b - c) + d - a));
        tree.nodes.push_back({p, i - 1, 10.5});
    }
    std::array<std::vector<Vec3>, 3> supplied;
    for (const Vec3& p : scatter(roomForVessels, 7.0, 2000, 5000)) {
        supplied[p.x() > 14.0 ? 2 : p.x() < -34.0 - 0.5 * p.y() ? 0 : 1].push_back(p);
    }
    const Vec3 joins(7, 67, 40);
    add(tree, growTree({{joins, {0, 60, 37}, {-8, 53, 34}, {-16, 47, 31}}, 3.6}, supplied[0], roomForVessels));
    add(tree, growTree({{joins, {4, 59, 39}, {1, 51, 37}, {-2, 43, 35}}, 3.4}, supplied[1], roomForVessels));
    add(tree, growTree({{joins, {9, 59, 40}, {12, 50, 38}, {16, 42, 36}}, 3.0}, supplied[2], roomForVessels));
    return tree;
}

VesselTree portalVein()
{
    return growTree({{{17, 29, -42}, {14, 26, -36}, {10, 22, -31}, {5, 18, -26}, {0, 14, -20}, {-5, 10, -15}}, 5.5},
                    scatter(roomForVessels, 6.0, 2000, 0), roomForVessels);
}

} // namespace

std::array<Lump, 2> lumps()
{
    return {lumpBelow({-45, 0, -5}, {-0.12, -1.0, 0.25}, 8.0, 10.0),
            lumpBelow({50, -20, 26}, {0.1, -0.75, 0.7}, 6.0, 6.0)};
}

std::vector<PhantomStructure> makePhantom()
{
    // Stiffness felt by a fingertip, modelled as a flat punch of radius a = 5 mm: k = 2 a E / (1 - v^2). 0.2 N/mm
    // corresponds to 15 kPa, stiffer than a healthy liver, so that every device renders the organ clearly within its
    // limits. The lumps are three times as stiff; prostate cancer is 2.1 to 2.5 times as stiff as the surrounding
    // tissue.
    constexpr double kOrgan = 0.2;
    constexpr double kLump = 0.6;
    std::vector<PhantomStructure> result;
    const core::Box organBox(Vec3(-115, -80, -70), Vec3(120, 90, 75));
    result.push_back(
        {"liver", sampleSurface(organDistance, organBox, kOrganCell_mm), {0.87, 0.51, 0.40}, 0.45, true, kOrgan, 0});
    const std::array<Lump, 2> both = lumps();
    for (std::size_t i = 0; i < both.size(); ++i) {
        const Lump& lump = both[i];
        const Vec3 reach = Vec3::Constant(1.2 * lump.radius_mm + 2.0);
        result.push_back({i == 0 ? "lump 20 mm" : "lump 12 mm",
                          sampleSurface([&](const Vec3& p) { return lump.distance(p); },
                                        core::Box(lump.centre_W - reach, lump.centre_W + reach), kLumpCell_mm),
                          {0.56, 0.93, 0.56},
                          1.0,
                          true,
                          kLump,
                          1});
    }
    result.push_back(
        {"portal vein", vesselSurface(portalVein(), kVesselCell_mm), {0.0, 0.59, 0.81}, 1.0, false, kOrgan, 0});
    result.push_back(
        {"hepatic veins", vesselSurface(hepaticVeins(), kVesselCell_mm), {0.30, 0.42, 0.75}, 1.0, false, kOrgan, 0});
    for (PhantomStructure& structure : result) {
        roundCoordinates(structure.mesh);
    }
    return result;
}

} // namespace palpate::phantom

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/FeltComparison.h"

#include "palpate/evaluation/LayeredReference.h"
#include "palpate/evaluation/LumpElements.h"

#include <palpate/core/Parallel.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>

namespace palpate::evaluation::felt {

namespace {

constexpr double kRigid = std::numeric_limits<double>::infinity();
constexpr double kHalfSpace = 1e4; // a sphere of this radius approximates a half-space

/// Sphere or half-space at a given depth; one grid serves all ratios.
struct Place
{
    double sphereRadius = 0.0, cover = 0.0;
    [[nodiscard]] bool isLayer() const { return sphereRadius == kHalfSpace; }
};

/// Results for one place.
struct Found
{
    std::vector<LayerCase> layers;
    std::vector<SphereCase> spheres;
    std::size_t elements = 0;
    double farError = 0.0;
};

std::vector<Place> placesOf(bool isQuick)
{
    using List = std::vector<double>;
    std::vector<Place> places;
    for (const double thickness : isQuick ? List{0.5, 2.0} : List{0.5, 1.0, 2.0, 4.0, 6.0}) {
        places.push_back({kHalfSpace, thickness});
    }
    for (const double radius : isQuick ? List{0.5, 2.0} : List{0.5, 1.0, 2.0, 3.0}) {
        for (const double cover : isQuick ? List{0.2, 1.0, 3.0} : List{0.2, 0.5, 1.0, 2.0, 3.0}) {
            places.push_back({radius, cover});
        }
    }
    return places;
}

Found solved(const Place& place)
{
    const LumpElements elements(place.sphereRadius, place.cover);
    // Both are relative to the same elements without a lump, which cancels the discretisation error of the press.
    const auto punch = elements.press(Press::Punch, 1.0), bell = elements.press(Press::Bell, 1.0);
    Found found;
    found.elements = elements.elementCount();
    found.farError = std::max(std::abs(punch.stiffness - 1.0), std::abs(bell.stiffness - 1.0));
    const auto ratios =
        place.isLayer() ? std::vector{2.0, 4.4, 10.0, kRigid} : std::vector{1.0 / 3.0, 2.0, 4.4, 10.0, kRigid};
    for (const double ratio : ratios) {
        const double byPunch = elements.press(Press::Punch, ratio).stiffness / punch.stiffness;
        const double byBell = elements.press(Press::Bell, ratio).stiffness / bell.stiffness;
        if (place.isLayer()) {
            found.layers.push_back({place.cover, ratio, layeredPunch(place.cover, ratio), byPunch, byBell,
                                    buried::stiffening(buried::shareBelow(place.cover, 1.0), ratio)});
        } else {
            const double share = buried::shareOfSphere(place.sphereRadius, place.cover + place.sphereRadius, 1.0);
            found.spheres.push_back({place.sphereRadius, place.cover, ratio, share, bell.share, punch.share, byBell,
                                     byPunch, buried::stiffening(share, ratio),
                                     buried::stiffening(punch.share, ratio)});
        }
    }
    return found;
}

std::string nameOf(const Place& place)
{
    char text[96];
    if (place.isLayer()) {
        std::snprintf(text, sizeof text, "layer of %g radii", place.cover);
    } else {
        std::snprintf(text, sizeof text, "sphere of %g radii under %g", place.sphereRadius, place.cover);
    }
    return text;
}

} // namespace

Comparison compare(const Options& options)
{
    const auto started = std::chrono::steady_clock::now();
    const std::vector<Place> places = placesOf(options.isQuick);
    std::vector<Found> found(places.size());
    std::atomic<std::size_t> done = 0;
    std::atomic<bool> isCancelled = false;
    core::parallelFor(places.size(), [&](std::size_t i, unsigned thread) {
        if (thread == 0 && options.progress &&
            !options.progress(static_cast<double>(done) / static_cast<double>(places.size()), nameOf(places[i]))) {
            isCancelled = true;
        }
        if (!isCancelled) {
            found[i] = solved(places[i]);
        }
        ++done;
    });
    Comparison comparison;
    comparison.isQuick = options.isQuick;
    comparison.isWhole = !isCancelled;
    for (const Found& f : found) {
        comparison.layers.insert(comparison.layers.end(), f.layers.begin(), f.layers.end());
        comparison.spheres.insert(comparison.spheres.end(), f.spheres.begin(), f.spheres.end());
        comparison.elements = std::max(comparison.elements, f.elements);
        comparison.farError = std::max(comparison.farError, f.farError);
    }
    comparison.duration_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    return comparison;
}

bool isWithin(const buried::Stiffening& bounds, double stiffness) noexcept
{
    return stiffness >= bounds.low && stiffness <= bounds.high;
}

double excessError(double estimate, double truth) noexcept
{
    return std::abs((estimate - 1.0) / (truth - 1.0) - 1.0);
}

Spread spreadOf(std::vector<double> values)
{
    if (values.empty()) {
        return {};
    }
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return {values.back(), values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half])};
}

bool Verdict::isProved(std::size_t spheres) const
{
    return bellWithin == spheres && punchWithinOwn == spheres && layerError < 0.01 && shareError < 1e-3;
}

Verdict verdictOf(const Comparison& comparison)
{
    Verdict verdict;
    for (const LayerCase& c : comparison.layers) {
        verdict.layerError = std::max(verdict.layerError, std::abs(c.punch / c.exact - 1.0));
    }
    std::vector<double> bell, own, mixed;
    for (const SphereCase& c : comparison.spheres) {
        verdict.bellWithin += isWithin(c.model, c.bell) ? 1 : 0;
        verdict.punchWithinOwn += isWithin(c.modelWithPunch, c.punch) ? 1 : 0;
        verdict.punchWithinBell += isWithin(c.model, c.punch) ? 1 : 0;
        verdict.shareError = std::max(verdict.shareError, std::abs(c.share - c.shareOfBell));
        bell.push_back(excessError(c.model.estimate, c.bell));
        own.push_back(excessError(c.modelWithPunch.estimate, c.punch));
        mixed.push_back(excessError(c.model.estimate, c.punch));
    }
    verdict.bell = spreadOf(std::move(bell));
    verdict.punchOwn = spreadOf(std::move(own));
    verdict.punchBell = spreadOf(std::move(mixed));
    return verdict;
}

} // namespace palpate::evaluation::felt

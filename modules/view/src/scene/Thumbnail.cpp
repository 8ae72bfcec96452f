// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/Thumbnail.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate::view {

using core::Vec3;

namespace {

constexpr int kSamples = 2; ///< per pixel in each direction, against jagged edges
constexpr float kFar = -std::numeric_limits<float>::infinity();

/// What is nearest in each sample, of one or more surfaces.
struct Layer
{
    std::vector<float> nearness_mm;           ///< along the direction to the viewer; kFar: nothing there
    std::vector<std::array<float, 3>> colour; ///< red, green, blue in 0 … 1, lit

    explicit Layer(std::size_t samples)
        : nearness_mm(samples, kFar)
        , colour(samples)
    {
    }
};

/// Orthographic view from the same direction as ViewFrom::Oblique.
class View
{
  public:
    View(const core::Box& bounds, int samples)
        : m_centre(bounds.center())
        , m_samples(samples)
    {
        double half_mm = 0.0;
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 p = bounds.corner(static_cast<core::Box::CornerType>(corner)) - m_centre;
            half_mm = std::max({half_mm, std::abs(p.dot(m_right)), std::abs(p.dot(m_up))});
        }
        constexpr double kMargin = 1.04;
        m_perMm = half_mm > 0.0 ? samples / (2.0 * kMargin * half_mm) : 1.0;
    }

    /// @return the sample's column and row, and the nearness to the viewer [mm]
    [[nodiscard]] Vec3 project(const Vec3& p_W) const
    {
        const Vec3 p = p_W - m_centre;
        return {0.5 * m_samples + m_perMm * p.dot(m_right), 0.5 * m_samples - m_perMm * p.dot(m_up), p.dot(m_back)};
    }

    [[nodiscard]] double light(const Vec3& normal_W) const
    {
        // From above the viewer; either side of a facet, since the sides of an open surface look alike.
        const double cosine = std::abs(normal_W.dot((m_back + 0.5 * m_up - 0.3 * m_right).normalized()));
        return 0.3 + 0.7 * cosine;
    }

  private:
    Vec3 m_back = Vec3(0.55, -1.0, 0.45).normalized(); ///< to the viewer
    Vec3 m_right = Vec3::UnitZ().cross(m_back).normalized();
    Vec3 m_up = m_back.cross(m_right);
    Vec3 m_centre;
    int m_samples = 0;
    double m_perMm = 1.0;
};

/// Draws one facet, given its corners as `View::project` returns them.
void drawFacet(const std::array<Vec3, 3>& corners, const std::array<float, 3>& colour, int samples, Layer& layer)
{
    const auto& [a, b, c] = corners;
    const double area = (b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y());
    if (std::abs(area) < 1e-12) {
        return;
    }
    const auto sample = [samples](double place) { return std::clamp(static_cast<int>(place), 0, samples - 1); };
    const int left = sample(std::min({a.x(), b.x(), c.x()}) - 0.5), right = sample(std::max({a.x(), b.x(), c.x()}));
    const int top = sample(std::min({a.y(), b.y(), c.y()}) - 0.5), bottom = sample(std::max({a.y(), b.y(), c.y()}));
    for (int row = top; row <= bottom; ++row) {
        for (int column = left; column <= right; ++column) {
            const double x = column + 0.5, y = row + 0.5;
            const double ofB = ((x - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (y - a.y())) / area;
            const double ofC = ((b.x() - a.x()) * (y - a.y()) - (x - a.x()) * (b.y() - a.y())) / area;
            if (ofB < 0.0 || ofC < 0.0 || ofB + ofC > 1.0) {
                continue;
            }
            const auto nearness = static_cast<float>(a.z() + ofB * (b.z() - a.z()) + ofC * (c.z() - a.z()));
            const std::size_t i =
                static_cast<std::size_t>(row) * static_cast<std::size_t>(samples) + static_cast<std::size_t>(column);
            if (nearness > layer.nearness_mm[i]) {
                layer.nearness_mm[i] = nearness;
                layer.colour[i] = colour;
            }
        }
    }
}

void drawSurface(const ThumbnailSurface& surface, const View& view, int samples, Layer& layer)
{
    const geometry::TriangleMesh& mesh = *surface.mesh;
    for (const geometry::Triangle& triangle : mesh.triangles) {
        const Vec3& a = mesh.vertices[triangle[0]];
        const Vec3& b = mesh.vertices[triangle[1]];
        const Vec3& c = mesh.vertices[triangle[2]];
        const double light = view.light((b - a).cross(c - a).normalized());
        std::array<float, 3> colour{};
        for (std::size_t k = 0; k < 3; ++k) {
            colour[k] = static_cast<float>(light * surface.colour[k]);
        }
        drawFacet({view.project(a), view.project(b), view.project(c)}, colour, samples, layer);
    }
}

/// Colour of a sample: red, green, blue (multiplied by alpha) and alpha.
using Rgba = std::array<float, 4>;

/// Draws the opaque surfaces, then the translucent ones over them, the one that comes nearest to the viewer last, so
/// that an organ lies over what is inside. Two layers of samples are enough for any number of surfaces.
std::vector<Rgba> drawSamples(std::span<const ThumbnailSurface> surfaces, const View& view, int samples)
{
    std::vector<Rgba> picture(static_cast<std::size_t>(samples) * static_cast<std::size_t>(samples), Rgba{});
    Layer opaque(picture.size());
    std::vector<std::pair<double, const ThumbnailSurface*>> translucent; // with the nearness
    for (const ThumbnailSurface& surface : surfaces) {
        if (surface.opacity >= 1.0) {
            drawSurface(surface, view, samples, opaque);
            continue;
        }
        double nearness = -std::numeric_limits<double>::infinity();
        for (const Vec3& p : surface.mesh->vertices) {
            nearness = std::max(nearness, view.project(p).z());
        }
        translucent.emplace_back(nearness, &surface);
    }
    const auto layOver = [&picture](const Layer& layer, std::size_t i, float opacity) {
        for (std::size_t k = 0; k < 3; ++k) {
            picture[i][k] = opacity * layer.colour[i][k] + (1.0F - opacity) * picture[i][k];
        }
        picture[i][3] = opacity + (1.0F - opacity) * picture[i][3];
    };
    for (std::size_t i = 0; i < picture.size(); ++i) {
        if (opaque.nearness_mm[i] > kFar) {
            layOver(opaque, i, 1.0F);
        }
    }
    std::stable_sort(translucent.begin(), translucent.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [nearness, surface] : translucent) {
        Layer layer(picture.size());
        drawSurface(*surface, view, samples, layer);
        for (std::size_t i = 0; i < picture.size(); ++i) {
            if (layer.nearness_mm[i] > opaque.nearness_mm[i]) {
                layOver(layer, i, static_cast<float>(surface->opacity));
            }
        }
    }
    return picture;
}

/// Averages the samples of each pixel.
std::vector<std::uint8_t> pixelsOf(const std::vector<Rgba>& samples, int size_px)
{
    std::vector<std::uint8_t> pixels;
    pixels.reserve(4 * static_cast<std::size_t>(size_px) * static_cast<std::size_t>(size_px));
    const auto byte = [](float value) {
        return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(value, 0.0F, 1.0F)));
    };
    for (int row = 0; row < size_px; ++row) {
        for (int column = 0; column < size_px; ++column) {
            Rgba sum{};
            for (int i = 0; i < kSamples * kSamples; ++i) {
                const int y = kSamples * row + i / kSamples, x = kSamples * column + i % kSamples;
                const Rgba& one = samples[static_cast<std::size_t>(y) * static_cast<std::size_t>(kSamples * size_px) +
                                          static_cast<std::size_t>(x)];
                for (std::size_t k = 0; k < 4; ++k) {
                    sum[k] += one[k] / (kSamples * kSamples);
                }
            }
            for (std::size_t k = 0; k < 3; ++k) {
                pixels.push_back(byte(sum[3] > 0.0F ? sum[k] / sum[3] : 0.0F));
            }
            pixels.push_back(byte(sum[3]));
        }
    }
    return pixels;
}

} // namespace

std::vector<std::uint8_t> drawThumbnail(std::span<const ThumbnailSurface> surfaces, int size_px)
{
    core::Box bounds;
    for (const ThumbnailSurface& surface : surfaces) {
        bounds.extend(surface.mesh->bounds());
    }
    if (bounds.isEmpty()) {
        return std::vector<std::uint8_t>(4 * static_cast<std::size_t>(size_px) * static_cast<std::size_t>(size_px));
    }
    const int samples = kSamples * size_px;
    return pixelsOf(drawSamples(surfaces, View(bounds, samples), samples), size_px);
}

} // namespace palpate::view

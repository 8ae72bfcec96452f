// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/Effort.h"

#include <algorithm>
#include <cmath>

namespace palpate::ui {

void Effort::setMost(double most_N) noexcept
{
    m_most_N = std::isfinite(most_N) ? std::clamp(most_N, kLeast_N, kMost_N) : kUsual_N;
}

bool Effort::turn(double notches) noexcept
{
    const double wanted_N = m_most_N + notches * kNotch_N;
    setMost(wanted_N);
    return m_most_N == wanted_N;
}

void Effort::end() noexcept
{
    m_touches_s.reset();
    m_share.reset();
}

void Effort::setShare(double share) noexcept
{
    m_share = std::clamp(share, 0.0, 1.0);
}

double Effort::force_N(double now_s) const noexcept
{
    if (!m_touches_s || now_s < *m_touches_s) {
        return 0.0;
    }
    return m_share ? *m_share * m_most_N : std::min(m_most_N, kRise_N_per_s * (now_s - *m_touches_s));
}

std::vector<study::PressedSurface> surfacesAlongPress(const haptics::HapticScene& scene, const view::Ray& press,
                                                      double time_s)
{
    constexpr double kFlattest = 0.05; // limits the correction for surfaces seen edge-on
    std::vector<study::PressedSurface> found;
    for (std::size_t i = 0; i < scene.layerCount(); ++i) {
        std::optional<study::PressedSurface> first;
        for (const std::uint32_t number : scene.layer(i).structures) {
            const haptics::HapticStructure& one = scene.structures()[number];
            const auto hit = one.motion == nullptr
                                 ? view::firstHit(*one.surface, press)
                                 : view::firstHit(*one.surface, *one.motion, one.motion->at(time_s), press);
            if (!hit) {
                continue;
            }
            const bool isFromInside = hit->isBehind && !one.surface->isTwoSided(hit->triangle);
            const double slant = std::max(kFlattest, -hit->n_W.dot(press.d_W));
            const double entry_mm = hit->distance_mm - scene.fingertip_mm() / slant;
            if (!isFromInside && (!first || entry_mm < first->entry_mm)) {
                first = study::PressedSurface{&one, hit->triangle, hit->rest_W, entry_mm, slant};
            }
        }
        if (first) {
            found.push_back(*first);
        }
    }
    return found;
}

} // namespace palpate::ui

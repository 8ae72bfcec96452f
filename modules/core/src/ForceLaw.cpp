// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/core/ForceLaw.h"

#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

namespace palpate::core {

namespace {

constexpr LawParameter kExponential[] = {
    {"k0_N_per_mm", PALPATE_TEXT("Initial stiffness"), "N/mm", 1e-6, 1000.0, 0.1},
    {"beta_per_mm", PALPATE_TEXT("Growth with depth"), "1/mm", 1e-6, 10.0, 0.35},
    {"k_max_N_per_mm", PALPATE_TEXT("Maximum stiffness"), "N/mm", 1e-6, 1000.0, 2.0},
};
constexpr LawParameter kHertz[] = {
    {"young_kPa", PALPATE_TEXT("Young's modulus"), "kPa", 1e-3, 1e7, 10.0},
    {"radius_mm", PALPATE_TEXT("Ball radius"), "mm", 1e-3, 1000.0, 8.0},
};
constexpr LawParameter kLayer[] = {
    {"young_kPa", PALPATE_TEXT("Young's modulus"), "kPa", 1e-3, 1e7, 10.0},
    {"radius_mm", PALPATE_TEXT("Ball radius"), "mm", 1e-3, 1000.0, 8.0},
    {"thickness_mm", PALPATE_TEXT("Layer thickness"), "mm", 1e-2, 1000.0, 20.0},
    {"bonded", PALPATE_TEXT("Bonded to the layer below"), "", 0.0, 1.0, 1.0, true},
};
constexpr LawParameter kClick[] = {
    {"k1_N_per_mm", PALPATE_TEXT("Stiffness before the click"), "N/mm", 1e-6, 1000.0, 0.5},
    {"F1_N", PALPATE_TEXT("Force at the click"), "N", 1e-3, 1000.0, 1.0},
    {"F2_N", PALPATE_TEXT("Force after the click"), "N", 0.0, 1000.0, 0.6},
    {"fall_mm", PALPATE_TEXT("Depth of the force drop"), "mm", 1e-3, 25.0, 1.0},
    {"k3_N_per_mm", PALPATE_TEXT("Stiffness after the click"), "N/mm", 1e-6, 1000.0, 0.5},
};

/// @return error of a measured point, by itself or relative to its predecessor; empty if valid.
Message pointProblem(const ForceLaw::Point& point, const ForceLaw::Point* before)
{
    const auto [depth_mm, force_N] = point;
    const Message found(PALPATE_TEXT("(%1 mm, %2 N)"), depth_mm, force_N);
    if (!std::isfinite(depth_mm) || !std::isfinite(force_N)) {
        return Message(PALPATE_TEXT("found %1, expected finite numbers"), found);
    }
    if (before == nullptr) {
        return depth_mm != 0.0 || force_N != 0.0
                   ? Message(PALPATE_TEXT("found %1, expected the first point at 0 mm and 0 N"), found)
                   : Message();
    }
    if (force_N < 0.0) {
        return Message(PALPATE_TEXT("found %1, expected a force of at least 0 N"), found);
    }
    const double step_mm = depth_mm - (*before)[0];
    if (!(step_mm >= ForceLaw::kMinPointSpacing_mm) || depth_mm > ForceLaw::kMaxPointDepth_mm) {
        return Message(PALPATE_TEXT("found %1, expected a depth of %2 to %3 mm"), found,
                       (*before)[0] + ForceLaw::kMinPointSpacing_mm, ForceLaw::kMaxPointDepth_mm);
    }
    const double slope = (force_N - (*before)[1]) / step_mm;
    if (std::abs(slope) > ForceLaw::kMaxSlope) {
        return Message(PALPATE_TEXT("found %1, a slope of %2 N/mm from the previous point, expected at most %3 N/mm"),
                       found, slope, ForceLaw::kMaxSlope);
    }
    return {};
}

} // namespace

std::string_view lawName(LawKind kind) noexcept
{
    constexpr std::array<std::string_view, kLawKinds.size()> names{"linear", "exponential", "hertz",
                                                                   "layer",  "click",       "points"};
    return names[static_cast<std::size_t>(kind)];
}

std::span<const LawParameter> lawParameters(LawKind kind) noexcept
{
    switch (kind) {
    case LawKind::Exponential:
        return kExponential;
    case LawKind::Hertz:
        return kHertz;
    case LawKind::Layer:
        return kLayer;
    case LawKind::Click:
        return kClick;
    case LawKind::Linear:
    case LawKind::Points:
        break;
    }
    return {};
}

ForceLaw usualLaw(LawKind kind)
{
    ForceLaw law{kind, {}, {}};
    std::size_t i = 0;
    for (const LawParameter& term : lawParameters(kind)) {
        law.numbers[i++] = term.usual;
    }
    if (kind == LawKind::Points) {
        law.points = {{0.0, 0.0}, {2.0, 0.2}, {5.0, 1.0}, {8.0, 2.5}};
    }
    return law;
}

PointFault firstFault(std::span<const ForceLaw::Point> points)
{
    if (points.size() < 2 || points.size() > ForceLaw::kMaxPoints) {
        return {points.size(),
                points.size() > ForceLaw::kMaxPoints
                    ? Message(PALPATE_TEXT("found more points, expected 2 to %1"), ForceLaw::kMaxPoints)
                    : Message(PALPATE_TEXT("found %1 points, expected 2 to %2"), points.size(), ForceLaw::kMaxPoints)};
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Message problem = pointProblem(points[i], i == 0 ? nullptr : &points[i - 1]);
        if (!problem.isEmpty()) {
            return {i, Message(PALPATE_TEXT("point %1 of %2: %3"), i + 1, points.size(), problem)};
        }
    }
    return {};
}

Status check(const ForceLaw& law)
{
    const std::span<const LawParameter> terms = lawParameters(law.kind);
    for (std::size_t i = 0; i < terms.size(); ++i) {
        if (!(law.numbers[i] >= terms[i].least && law.numbers[i] <= terms[i].most)) {
            return {StatusCode::OutOfRange, PALPATE_TEXT("%1: found %2, expected %3 to %4 %5"),
                    terms[i].key,           law.numbers[i],
                    terms[i].least,         terms[i].most,
                    terms[i].unit};
        }
    }
    const std::array<double, ForceLaw::kMaxParameters>& n = law.numbers;
    if (law.kind == LawKind::Exponential && n[0] > n[2]) {
        return {StatusCode::OutOfRange,
                PALPATE_TEXT("%1: found %2, expected at most %3 (%4)"),
                terms[0].key,
                n[0],
                n[2],
                terms[2].key};
    }
    if (law.kind == LawKind::Click && n[2] > n[1]) {
        return {StatusCode::OutOfRange,
                PALPATE_TEXT("%1: found %2, expected at most %3 (%4)"),
                terms[2].key,
                n[2],
                n[1],
                terms[1].key};
    }
    if (law.kind == LawKind::Click && n[1] - n[2] > ForceLaw::kMaxSlope * n[3]) {
        return {StatusCode::OutOfRange, PALPATE_TEXT("the force falls by %1 N/mm, expected at most %2 N/mm"),
                (n[1] - n[2]) / n[3], ForceLaw::kMaxSlope};
    }
    const Message fault = law.kind == LawKind::Points ? firstFault(law.points).what : Message();
    return fault.isEmpty() ? Status() : Status(StatusCode::OutOfRange, fault);
}

} // namespace palpate::core

// SPDX-License-Identifier: BSD-3-Clause
#include "motion/MotionStrain.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace palpate::geometry::internal {

namespace {

using Cell = std::array<Vec3, 27>; ///< control points or coefficients, x first

/// Replaces the three values along one axis, everywhere in the cell.
template<class Rule>
Cell along(int axis, const Cell& in, Rule rule)
{
    const std::size_t step = axis == 0 ? 1 : axis == 1 ? 3 : 9;
    Cell out;
    for (std::size_t i = 0; i < in.size(); ++i) {
        if (i / step % 3 == 0) {
            rule(in[i], in[i + step], in[i + 2 * step], out[i], out[i + step], out[i + 2 * step]);
        }
    }
    return out;
}

/// Bernstein coefficients of a quadratic B-spline in its cell.
Cell values(int axis, const Cell& in)
{
    return along(axis, in, [](const Vec3& a, const Vec3& b, const Vec3& c, Vec3& x, Vec3& y, Vec3& z) {
        x = 0.5 * (a + b);
        y = b;
        z = 0.5 * (b + c);
    });
}

/// Bernstein coefficients of its derivative, raised to the same degree.
Cell slopes(int axis, const Cell& in, double spacing_mm)
{
    return along(axis, in, [spacing_mm](const Vec3& a, const Vec3& b, const Vec3& c, Vec3& x, Vec3& y, Vec3& z) {
        x = (b - a) / spacing_mm;
        z = (c - b) / spacing_mm;
        y = 0.5 * (x + z);
    });
}

double largestPrincipal(const Mat3& gradient)
{
    Eigen::SelfAdjointEigenSolver<Mat3> squares(gradient.transpose() * gradient, Eigen::EigenvaluesOnly);
    return std::sqrt(std::max(0.0, squares.eigenvalues().maxCoeff()));
}

/// @param least  the result matters only if it exceeds this value
double strainIn(const Cell& cell, double spacing_mm, double least)
{
    const Cell alongX = values(2, values(1, slopes(0, cell, spacing_mm)));
    const Cell alongY = values(2, values(0, slopes(1, cell, spacing_mm)));
    const Cell alongZ = values(1, values(0, slopes(2, cell, spacing_mm)));
    double most = least;
    for (std::size_t i = 0; i < cell.size(); ++i) {
        Mat3 gradient;
        gradient << alongX[i], alongY[i], alongZ[i];
        if (!(gradient.squaredNorm() <= most * most)) { // the Frobenius norm is an upper bound
            most = std::max(most, largestPrincipal(gradient));
        }
    }
    return most;
}

} // namespace

void closeRim(const MotionLattice& lattice, std::vector<std::array<double, 4>>& controls)
{
    const std::size_t count = lattice.controlCount();
    const std::array<std::size_t, 3> n{lattice.cells[0] + 1, lattice.cells[1] + 1, lattice.cells[2] + 1};
    for (std::size_t first = 0; first + count <= controls.size(); first += count) {
        for (std::size_t k = 0; k <= n[2]; ++k) {
            for (std::size_t j = 0; j <= n[1]; ++j) {
                for (std::size_t i = 0; i <= n[0]; ++i) {
                    const auto in = [](std::size_t at, std::size_t last) {
                        return std::clamp<std::size_t>(at, 1, last - 1);
                    };
                    controls[first + lattice.control(i, j, k)] =
                        controls[first + lattice.control(in(i, n[0]), in(j, n[1]), in(k, n[2]))];
                }
            }
        }
    }
}

WorstStrain worstStrain(const MotionLattice& lattice, std::size_t frames,
                        const std::vector<std::array<double, 4>>& controls)
{
    WorstStrain worst;
    const std::size_t count = lattice.controlCount();
    const auto control = [&](std::size_t frame, std::size_t at) {
        return Vec3(Eigen::Map<const Vec3>(controls[frame * count + at].data()));
    };
    for (std::size_t frame = 0; frame < frames; ++frame) {
        const std::size_t before = (frame + frames - 1) % frames, after = (frame + 1) % frames;
        for (std::uint32_t z = 0; z < lattice.cells[2]; ++z) {
            for (std::uint32_t y = 0; y < lattice.cells[1]; ++y) {
                for (std::uint32_t x = 0; x < lattice.cells[0]; ++x) {
                    Cell now, third;
                    for (std::size_t i = 0; i < now.size(); ++i) {
                        const std::size_t at = lattice.control(x + i % 3, y + i / 3 % 3, z + i / 9);
                        now[i] = control(frame, at);
                        third[i] = (control(after, at) - control(before, at)) / 6.0;
                    }
                    double strain = strainIn(now, lattice.spacing_mm, worst.strain);
                    if (frames > 1) {
                        Cell earlier, later;
                        for (std::size_t i = 0; i < now.size(); ++i) {
                            earlier[i] = now[i] - third[i];
                            later[i] = now[i] + third[i];
                        }
                        strain = strainIn(earlier, lattice.spacing_mm, strain);
                        strain = strainIn(later, lattice.spacing_mm, strain);
                    }
                    if (strain > worst.strain) {
                        worst = {strain, frame, {x, y, z}};
                    }
                }
            }
        }
    }
    return worst;
}

} // namespace palpate::geometry::internal

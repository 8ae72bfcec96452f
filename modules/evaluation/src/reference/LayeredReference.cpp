// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/LayeredReference.h"

#include "reference/GaussLegendre.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace palpate::evaluation {

namespace {

constexpr double kFar = 30.0; // u above which the layer acts as a half-space: 1 - L is below 1e-22

double rigidBase(double u)
{
    if (u < 1e-2) {
        return 2.0 / 3.0 * u * u * u; // the next term is of order u^5
    }
    return (std::sinh(2.0 * u) - 2.0 * u) / (std::cosh(2.0 * u) + 2.0 * u * u + 1.0);
}

/// Derivative of the given order of e^-s, s e^-s, e^(s - u) and s e^(s - u).
Eigen::Vector4d basis(double s, int derivative, double u)
{
    const double down = (derivative % 2 == 0 ? 1.0 : -1.0) * std::exp(-s), up = std::exp(s - u);
    return {down, (s - derivative) * down, up, (s + derivative) * up};
}

/// Solves with complete pivoting, which is insensitive to the order of the equations.
Eigen::VectorXd solved(const Eigen::MatrixXd& equations, const Eigen::VectorXd& right)
{
    return equations.fullPivLu().solve(right);
}

} // namespace

double layerCompliance(double u, double ratio)
{
    if (u > kFar) {
        return 1.0;
    }
    if (std::isinf(ratio)) {
        return rigidBase(u);
    }
    // W(s): vertical displacement as a function of s = depth times wave number. Boundary conditions: no shear and unit
    // normal traction on top; displacements and tractions continuous with the half-space below,
    // where W = (A + B s) e^-s.
    const auto w = [u](double s, int derivative) { return basis(s, derivative, u); };
    Eigen::MatrixXd equations(4, 4);
    equations.row(0) = w(0.0, 2) + w(0.0, 0);
    equations.row(1) = w(u, 2) + w(u, 0) + 2.0 * ratio * w(u, 1);
    equations.row(2) = w(u, 3) - 3.0 * w(u, 1) - 2.0 * ratio * w(u, 0);
    equations.row(3) = w(0.0, 3) - 3.0 * w(0.0, 1);
    return w(0.0, 0).dot(solved(equations, Eigen::Vector4d(0.0, 0.0, 0.0, 2.0)));
}

double layeredPunch(double thickness, double ratio)
{
    constexpr int kNodes = 24, kPanelNodes = 12;
    const Quadrature x = gaussLegendre(kNodes, 0.0, 1.0);
    // Panels must be short relative to the oscillations between the centre and the rim of the punch.
    const int panels = std::max(24, static_cast<int>(std::ceil(kFar / thickness / 4.0)));
    Eigen::MatrixXd equations = Eigen::MatrixXd::Identity(kNodes, kNodes);
    const Eigen::Map<const Eigen::VectorXd> weight(x.weight.data(), kNodes);
    Eigen::VectorXd cosine(kNodes);
    for (int p = 0; p < panels; ++p) {
        const Quadrature u = gaussLegendre(kPanelNodes, kFar * p / panels, kFar * (p + 1) / panels);
        for (std::size_t q = 0; q < u.at.size(); ++q) {
            const double k = u.at[q] / thickness;
            const double part =
                2.0 / std::numbers::pi * (1.0 - layerCompliance(u.at[q], ratio)) * u.weight[q] / thickness;
            for (int i = 0; i < kNodes; ++i) {
                cosine[i] = std::cos(k * x.at[static_cast<std::size_t>(i)]);
            }
            equations.noalias() -= part * cosine * cosine.cwiseProduct(weight).transpose();
        }
    }
    return weight.dot(solved(equations, Eigen::VectorXd::Ones(kNodes)));
}

} // namespace palpate::evaluation

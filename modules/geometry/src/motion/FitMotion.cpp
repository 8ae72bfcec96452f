// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/geometry/FitMotion.h"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate::geometry {

namespace {

using core::Status;
using core::StatusCode;
using Sparse = Eigen::SparseMatrix<double>;

constexpr double kMostCells = 40.0; ///< along an axis
/// Weight of the harmonic part against the mean weight of the vertices: it decides where no vertex does, and keeps the
/// lattice from following the noise of single vertices. On smooth motions it costs some 0.01 mm (docs/motion.md).
constexpr double kHarmonic = 1e-2;

/// Unknowns are the control points of the cells; those of the rim have the values of their neighbours.
class Unknowns
{
  public:
    explicit Unknowns(const MotionLattice& lattice)
        : m_lattice(lattice)
    {
    }
    [[nodiscard]] int count() const { return static_cast<int>(cells(0) * cells(1) * cells(2)); }
    [[nodiscard]] int at(std::size_t i, std::size_t j, std::size_t k) const
    {
        return static_cast<int>(inner(i, 0) + cells(0) * (inner(j, 1) + cells(1) * inner(k, 2)));
    }

  private:
    [[nodiscard]] std::size_t cells(std::size_t axis) const { return m_lattice.cells[axis]; }
    [[nodiscard]] std::size_t inner(std::size_t i, std::size_t axis) const
    {
        return std::clamp<std::size_t>(i, 1, cells(axis)) - 1;
    }
    const MotionLattice& m_lattice;
};

/// Weights of the unknowns at each vertex.
Sparse weightsAt(std::span<const Vec3> vertices, const MotionLattice& lattice, const Unknowns& unknowns)
{
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(27 * vertices.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const Vec3 s = (vertices[v] - lattice.origin_mm) / lattice.spacing_mm;
        std::array<std::size_t, 3> cell{};
        std::array<std::array<double, 3>, 3> weight{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double at = std::clamp(s[static_cast<int>(axis)], 0.0, double(lattice.cells[axis]));
            cell[axis] = std::min(static_cast<std::size_t>(at), std::size_t{lattice.cells[axis]} - 1);
            const double t = at - static_cast<double>(cell[axis]), r = 1.0 - t;
            weight[axis] = {0.5 * r * r, 0.5 + t * r, 0.5 * t * t};
        }
        for (std::size_t n = 0; n < 27; ++n) {
            const std::size_t i = n % 3, j = n / 3 % 3, k = n / 9;
            entries.emplace_back(static_cast<int>(v), unknowns.at(cell[0] + i, cell[1] + j, cell[2] + k),
                                 weight[0][i] * weight[1][j] * weight[2][k]);
        }
    }
    Sparse weights(static_cast<Eigen::Index>(vertices.size()), unknowns.count());
    weights.setFromTriplets(entries.begin(), entries.end());
    return weights;
}

/// The graph Laplacian of the control points.
Sparse laplacian(const MotionLattice& lattice, const Unknowns& unknowns)
{
    std::vector<Eigen::Triplet<double>> entries;
    const auto join = [&](int a, int b) {
        entries.emplace_back(a, a, 1.0);
        entries.emplace_back(b, b, 1.0);
        entries.emplace_back(a, b, -1.0);
        entries.emplace_back(b, a, -1.0);
    };
    for (std::size_t k = 1; k <= lattice.cells[2]; ++k) {
        for (std::size_t j = 1; j <= lattice.cells[1]; ++j) {
            for (std::size_t i = 1; i <= lattice.cells[0]; ++i) {
                const int here = unknowns.at(i, j, k);
                for (const int next : {unknowns.at(i + 1, j, k), unknowns.at(i, j + 1, k), unknowns.at(i, j, k + 1)}) {
                    if (next != here) {
                        join(here, next);
                    }
                }
            }
        }
    }
    Sparse matrix(unknowns.count(), unknowns.count());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

/// A lattice with the residual of its fit.
struct FittedLattice
{
    MotionLattice lattice;
    std::vector<std::vector<Vec3>> controls; ///< of each frame
    double residual_mm = 0.0;
    std::size_t frame = 0, vertex = 0; ///< of the residual
};

Status checkShapes(std::span<const Vec3> rest, const std::vector<std::vector<Vec3>>& frames, double spacing_mm)
{
    if (rest.empty() || !(spacing_mm > 0.0)) {
        return {StatusCode::Empty, PALPATE_TEXT("found %1 vertices and a lattice of %2 mm, expected more than 0"),
                rest.size(), spacing_mm};
    }
    for (std::size_t f = 0; f < frames.size(); ++f) {
        if (frames[f].size() != rest.size()) {
            return {StatusCode::OutOfRange, PALPATE_TEXT("frame %1: found %2 vertices, expected %3 as at rest"), f,
                    frames[f].size(), rest.size()};
        }
        const auto wrong =
            std::find_if(frames[f].begin(), frames[f].end(), [](const Vec3& p) { return !p.allFinite(); });
        if (wrong != frames[f].end()) {
            return {StatusCode::NonFinite, PALPATE_TEXT("frame %1, vertex %2: found a number that is not finite"), f,
                    wrong - frames[f].begin()};
        }
    }
    return {};
}

/// @pre checkShapes
FittedLattice fitLattice(std::span<const Vec3> rest, const std::vector<std::vector<Vec3>>& frames, double spacing_mm)
{
    core::Box box;
    for (const Vec3& p : rest) {
        box.extend(p);
    }
    FittedLattice fitted;
    const double step_mm = std::max(spacing_mm, box.sizes().maxCoeff() / kMostCells);
    fitted.lattice =
        MotionLattice::around(core::Box(box.min().array() - step_mm, box.max().array() + step_mm), step_mm);
    const MotionLattice& lattice = fitted.lattice;
    const Unknowns unknowns(lattice);
    const Sparse weights = weightsAt(rest, lattice, unknowns);
    Sparse normal = Sparse(weights.transpose()) * weights;
    const double mean = normal.diagonal().sum() / unknowns.count();
    normal += kHarmonic * mean * laplacian(lattice, unknowns);
    const Eigen::SimplicialLDLT<Sparse> solver(normal);
    for (std::size_t f = 0; f < frames.size(); ++f) {
        Eigen::MatrixX3d u(static_cast<Eigen::Index>(rest.size()), 3);
        for (std::size_t v = 0; v < rest.size(); ++v) {
            u.row(static_cast<Eigen::Index>(v)) = frames[f][v] - rest[v];
        }
        const Eigen::MatrixX3d c = solver.solve(Eigen::MatrixX3d(weights.transpose() * u));
        const Eigen::VectorXd off = (weights * c - u).rowwise().norm();
        Eigen::Index worst = 0;
        if (const double most = off.maxCoeff(&worst); !(most <= fitted.residual_mm)) {
            fitted.residual_mm = most;
            fitted.frame = f;
            fitted.vertex = static_cast<std::size_t>(worst);
        }
        std::vector<Vec3>& out = fitted.controls.emplace_back();
        for (std::size_t k = 0; k < lattice.cells[2] + 2; ++k) {
            for (std::size_t j = 0; j < lattice.cells[1] + 2; ++j) {
                for (std::size_t i = 0; i < lattice.cells[0] + 2; ++i) {
                    out.emplace_back(c.row(unknowns.at(i, j, k)));
                }
            }
        }
    }
    return fitted;
}

core::Result<FittedMotion> checked(const FittedLattice& fitted, SurfaceMotion::Made motion)
{
    if (!motion.isOk()) {
        return motion.status();
    }
    if (!(fitted.residual_mm <= kMaxResidual_mm)) {
        return Status(
            StatusCode::OutOfRange,
            PALPATE_TEXT("frame %1, vertex %2: found %3 mm between the shape and the lattice of %4 mm, expected "
                         "at most %5 mm: use a finer lattice, or one structure for each part that slides"),
            fitted.frame, fitted.vertex, fitted.residual_mm, fitted.lattice.spacing_mm, kMaxResidual_mm);
    }
    return FittedMotion{std::move(motion).value(), fitted.residual_mm, fitted.frame, fitted.vertex};
}

} // namespace

core::Result<FittedMotion> fitMotion(double period_s, std::span<const Vec3> rest,
                                     const std::vector<std::vector<Vec3>>& frames, double spacing_mm)
{
    if (Status status = checkShapes(rest, frames, spacing_mm); !status.isOk()) {
        return status;
    }
    const FittedLattice fitted = fitLattice(rest, frames, spacing_mm);
    return checked(fitted, SurfaceMotion::frames(period_s, fitted.lattice, fitted.controls));
}

core::Result<FittedMotion> fitBreath(double period_s, int exponent, std::span<const Vec3> rest,
                                     const std::vector<Vec3>& full, double spacing_mm)
{
    const std::vector<std::vector<Vec3>> frames{full};
    if (Status status = checkShapes(rest, frames, spacing_mm); !status.isOk()) {
        return status;
    }
    const FittedLattice fitted = fitLattice(rest, frames, spacing_mm);
    return checked(fitted, SurfaceMotion::breath(period_s, exponent, fitted.lattice, fitted.controls.front()));
}

} // namespace palpate::geometry

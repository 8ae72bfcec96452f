// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/LumpElements.h"

#include "lumps/LumpGrid.h"
#include "reference/GaussLegendre.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace palpate::evaluation {

namespace {

constexpr double kBulkModulus = 1e5; // relative to the shear modulus; makes k 1e-5 too small
constexpr int kDofs = 18;            // per cell: radial and axial displacement of each node
using CellMatrix = Eigen::Matrix<double, kDofs, kDofs>;
using CellRow = Eigen::Matrix<double, 1, kDofs>;

/// Quadratic Lagrange polynomials on the nodes -1, 0, 1, with their derivatives.
struct Parabolas
{
    explicit Parabolas(double x)
        : value(0.5 * x * (x - 1.0), 1.0 - x * x, 0.5 * x * (x + 1.0))
        , slope(x - 0.5, -2.0 * x, x + 0.5)
    {
    }
    Eigen::Vector3d value, slope;
};

/// Stiffness matrix of a cell of shear modulus 1. The pressures are local to the cell and eliminated. Lazy products
/// are as fast at this size and avoid instantiating Eigen's blocked kernels.
CellMatrix cellMatrix(const LumpGrid& grid, const LumpGrid::Cell& cell)
{
    static const Quadrature kRule = gaussLegendre(4, -1.0, 1.0);
    Eigen::Matrix<double, 9, 2> places;
    for (int i = 0; i < 9; ++i) {
        places.row(i) = grid.nodes[cell[static_cast<std::size_t>(i)]];
    }
    const Eigen::RowVector2d middle = places.row(4);
    const double size = (places.rowwise() - middle).rowwise().norm().maxCoeff();
    CellMatrix stiffness = CellMatrix::Zero();
    Eigen::Matrix<double, 3, kDofs> volume = Eigen::Matrix<double, 3, kDofs>::Zero();
    Eigen::Matrix3d mass = Eigen::Matrix3d::Zero();
    for (std::size_t p = 0; p < kRule.at.size(); ++p) {
        for (std::size_t q = 0; q < kRule.at.size(); ++q) {
            const Parabolas x(kRule.at[p]), y(kRule.at[q]);
            Eigen::Matrix<double, 9, 1> shape;
            Eigen::Matrix<double, 2, 9> slope;
            for (int i = 0; i < 9; ++i) {
                shape[i] = x.value[i % 3] * y.value[i / 3];
                slope.col(i) << x.slope[i % 3] * y.value[i / 3], x.value[i % 3] * y.slope[i / 3];
            }
            const Eigen::RowVector2d place = shape.transpose().lazyProduct(places);
            const Eigen::Matrix2d jacobian = slope.lazyProduct(places);
            const double r = place[0];
            const double part =
                std::abs(jacobian.determinant()) * kRule.weight[p] * kRule.weight[q] * 2.0 * std::numbers::pi * r;
            slope = jacobian.inverse() * slope;
            // Strain components: radial, hoop, axial; shear.
            Eigen::Matrix<double, 4, kDofs> strain = Eigen::Matrix<double, 4, kDofs>::Zero();
            for (int i = 0; i < 9; ++i) {
                strain(0, 2 * i) = strain(3, 2 * i + 1) = slope(0, i);
                strain(1, 2 * i) = shape[i] / r;
                strain(2, 2 * i + 1) = strain(3, 2 * i) = slope(1, i);
            }
            const Eigen::Vector4d modulus(2.0, 2.0, 2.0, 1.0);
            stiffness += part * strain.transpose().lazyProduct(modulus.asDiagonal() * strain);
            const Eigen::Vector3d pressure(1.0, (r - middle[0]) / size, (place[1] - middle[1]) / size);
            const CellRow growth = strain.row(0) + strain.row(1) + strain.row(2);
            volume.noalias() += part * pressure * growth;
            mass.noalias() += part * pressure * pressure.transpose();
        }
    }
    const Eigen::Matrix<double, 3, kDofs> pressures = mass.inverse() * volume;
    stiffness += kBulkModulus * volume.transpose().lazyProduct(pressures);
    return stiffness;
}

/// Unknown displacements, and the prescribed values of the others.
struct Unknowns
{
    static constexpr Eigen::Index kGiven = -1;
    std::vector<Eigen::Index> of; ///< equation index of each displacement; kGiven: prescribed
    Eigen::VectorXd given;        ///< prescribed value of each displacement
    Eigen::Index count = 0;
};

Unknowns unknownsOf(const LumpGrid& grid, Press how, bool isLumpRigid)
{
    const std::size_t nodes = grid.nodes.size();
    Unknowns unknowns{std::vector<Eigen::Index>(2 * nodes, Unknowns::kGiven),
                      Eigen::VectorXd::Zero(static_cast<Eigen::Index>(2 * nodes)), 0};
    // A rigid sphere on the axis translates vertically, or is fixed if it approximates a half-space.
    Eigen::Index lump = Unknowns::kGiven;
    if (isLumpRigid) {
        bool isHeld = false;
        for (std::size_t n = 0; n < nodes; ++n) {
            isHeld = isHeld || (grid.isInLump[n] != 0 && grid.isFar[n] != 0);
        }
        lump = isHeld ? Unknowns::kGiven : unknowns.count++;
    }
    for (std::size_t n = 0; n < nodes; ++n) {
        if (isLumpRigid && grid.isInLump[n] != 0) {
            unknowns.of[2 * n + 1] = lump;
            continue;
        }
        if (grid.isFar[n] != 0) {
            continue;
        }
        if (grid.isOnAxis[n] == 0) {
            unknowns.of[2 * n] = unknowns.count++;
        }
        if (how == Press::Punch && grid.isUnderPunch[n] != 0) {
            unknowns.given[static_cast<Eigen::Index>(2 * n + 1)] = 1.0;
        } else {
            unknowns.of[2 * n + 1] = unknowns.count++;
        }
    }
    return unknowns;
}

void addBell(const LumpGrid& grid, const Unknowns& unknowns, Eigen::VectorXd& load)
{
    constexpr double kC = 1.0 / std::numbers::pi;
    const Quadrature rule = gaussLegendre(6, -1.0, 1.0);
    for (const auto& edge : grid.surface) {
        for (std::size_t q = 0; q < rule.at.size(); ++q) {
            const Parabolas x(rule.at[q]);
            double r = 0.0, along = 0.0;
            for (int i = 0; i < 3; ++i) {
                r += x.value[i] * grid.nodes[edge[static_cast<std::size_t>(i)]][0];
                along += x.slope[i] * grid.nodes[edge[static_cast<std::size_t>(i)]][0];
            }
            const double pressure = kC / (2.0 * std::numbers::pi * std::pow(r * r + kC * kC, 1.5));
            const double force = pressure * 2.0 * std::numbers::pi * r * std::abs(along) * rule.weight[q];
            for (int i = 0; i < 3; ++i) {
                if (const Eigen::Index to = unknowns.of[2 * edge[static_cast<std::size_t>(i)] + 1]; to >= 0) {
                    load[to] += force * x.value[i];
                }
            }
        }
    }
}

std::size_t dofOf(const LumpGrid::Cell& cell, int i)
{
    return 2 * cell[static_cast<std::size_t>(i / 2)] + static_cast<std::size_t>(i % 2);
}

} // namespace

struct LumpElements::Parts
{
    LumpGrid grid;
    std::vector<CellMatrix> matrices;

    /// Modulus of a cell; 0 for a rigid cell, which stores no energy.
    [[nodiscard]] double modulus(std::size_t cell, double ratio) const
    {
        return grid.isCellInLump[cell] == 0 ? 1.0 : std::isinf(ratio) ? 0.0 : ratio;
    }

    [[nodiscard]] Eigen::VectorXd displacements(Press how, double ratio) const;
};

/// Displacements of all nodes; NaN if the linear system cannot be solved.
Eigen::VectorXd LumpElements::Parts::displacements(Press how, double ratio) const
{
    const Unknowns unknowns = unknownsOf(grid, how, std::isinf(ratio));
    Eigen::VectorXd load = Eigen::VectorXd::Zero(unknowns.count);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(matrices.size() * kDofs * (kDofs + 1) / 2);
    for (std::size_t c = 0; c < matrices.size(); ++c) {
        const double modulus = this->modulus(c, ratio);
        if (modulus == 0.0) {
            continue;
        }
        for (int i = 0; i < kDofs; ++i) {
            const Eigen::Index row = unknowns.of[dofOf(grid.cells[c], i)];
            for (int j = 0; row >= 0 && j < kDofs; ++j) {
                const std::size_t dof = dofOf(grid.cells[c], j);
                const Eigen::Index column = unknowns.of[dof];
                const double entry = modulus * matrices[c](i, j);
                if (column < 0) {
                    load[row] -= entry * unknowns.given[static_cast<Eigen::Index>(dof)];
                } else if (row >= column) {
                    entries.emplace_back(static_cast<int>(row), static_cast<int>(column), entry);
                }
            }
        }
    }
    if (how == Press::Bell) {
        addBell(grid, unknowns, load);
    }
    Eigen::SparseMatrix<double> equations(unknowns.count, unknowns.count);
    equations.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> factors(equations);
    Eigen::VectorXd all = unknowns.given;
    if (factors.info() != Eigen::Success) {
        all.setConstant(std::numeric_limits<double>::quiet_NaN());
        return all;
    }
    const Eigen::VectorXd found = factors.solve(load);
    for (std::size_t d = 0; d < unknowns.of.size(); ++d) {
        if (unknowns.of[d] >= 0) {
            all[static_cast<Eigen::Index>(d)] = found[unknowns.of[d]];
        }
    }
    return all;
}

LumpElements::LumpElements(double sphereRadius, double cover, const LumpResolution& fineness)
{
    auto parts = std::make_unique<Parts>();
    parts->grid = lumpGrid(sphereRadius, cover, fineness);
    parts->matrices.reserve(parts->grid.cells.size());
    for (const LumpGrid::Cell& cell : parts->grid.cells) {
        parts->matrices.push_back(cellMatrix(parts->grid, cell));
    }
    m_parts = std::move(parts);
}

LumpElements::~LumpElements() = default;
LumpElements::LumpElements(LumpElements&&) noexcept = default;
LumpElements& LumpElements::operator=(LumpElements&&) noexcept = default;

std::size_t LumpElements::elementCount() const noexcept
{
    return m_parts->grid.cells.size();
}

LumpElements::Response LumpElements::press(Press how, double ratio) const
{
    const Eigen::VectorXd all = m_parts->displacements(how, ratio);
    double energy = 0.0, inLump = 0.0; // both without the factor 1/2
    for (std::size_t c = 0; c < m_parts->matrices.size(); ++c) {
        Eigen::Matrix<double, kDofs, 1> own;
        for (int i = 0; i < kDofs; ++i) {
            own[i] = all[static_cast<Eigen::Index>(dofOf(m_parts->grid.cells[c], i))];
        }
        const double part = m_parts->modulus(c, ratio) * own.dot(m_parts->matrices[c].lazyProduct(own));
        energy += part;
        inLump += m_parts->grid.isCellInLump[c] != 0 ? part : 0.0;
    }
    // The punch has a displacement of 1, so its force equals the energy; the bell has a force of 1, so its work equals
    // the compliance.
    return {(how == Press::Punch ? energy : 1.0 / energy) / 8.0, inLump / energy};
}

} // namespace palpate::evaluation

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/ExactSolver.h"

#include "reference/ExactBall.h"
#include "reference/ExactDescent.h"

#include <algorithm>
#include <optional>

namespace palpate::evaluation {

struct ExactSolver::Private
{
    ExactDescent point;
    std::optional<ExactBall> ball;
    int subSteps;
    double fingertip_mm;
    Long3 god = Long3::Zero();
    Long3 hip = Long3::Zero();

    /// @return true if the descent converged
    bool converge(const Long3& to, SolverStep& step)
    {
        const std::uint32_t moves = ball ? ball->converge(god, to) : point.converge(god, to);
        step.iterations += moves;
        step.constraints = ball ? ball->constraints() : point.constraints();
        return moves < (ball ? ExactBall::kMostMoves : ExactDescent::kMostMoves);
    }
};

ExactSolver::ExactSolver(const Surface& surface, int subSteps, double fingertip_mm, double friction)
    : m_d(std::make_unique<Private>(
          Private{ExactDescent(surface, friction), std::nullopt, std::max(1, subSteps), fingertip_mm}))
{
    if (fingertip_mm > 0.0) {
        m_d->ball.emplace(surface, fingertip_mm);
    }
}

ExactSolver::~ExactSolver() = default;

void ExactSolver::start(const Vec3& p_WH)
{
    resume(p_WH, p_WH);
}

void ExactSolver::resume(const Vec3& p_WG, const Vec3& p_WH)
{
    m_d->god = p_WG.cast<long double>();
    m_d->hip = p_WH.cast<long double>();
}

SolverStep ExactSolver::step(const Vec3& p_WH)
{
    SolverStep result;
    result.p_WG = m_d->god.cast<double>();
    if (!p_WH.allFinite()) {
        result.isConverged = false;
        return result;
    }
    const Long3 from = m_d->hip;
    m_d->hip = p_WH.cast<long double>();
    const Long3 way = m_d->hip - from;
    for (int i = 1; i <= m_d->subSteps; ++i) {
        const Long3 hip =
            i == m_d->subSteps ? m_d->hip : Long3(from + way * (static_cast<long double>(i) / m_d->subSteps));
        result.isConverged = m_d->converge(hip, result) && result.isConverged;
    }
    result.p_WG = m_d->god.cast<double>();
    result.spring_mm = (m_d->god - m_d->hip).cast<double>();
    return result;
}

double ExactSolver::intrusion_mm(const Vec3& p_WG)
{
    const double radius = m_d->fingertip_mm;
    return m_d->ball ? radius - m_d->ball->clearance_mm(p_WG, radius) : 0.0;
}

double residual_mm(ExactSolver& exact, const Vec3& p_WG, const Vec3& p_WH)
{
    exact.resume(p_WG, p_WH);
    const double spring = (p_WG - p_WH).norm();
    return std::max(0.0, spring - exact.step(p_WH).spring_mm.norm());
}

} // namespace palpate::evaluation

// SPDX-License-Identifier: BSD-3-Clause
#include "lumps/JudgedProduct.h"
#include "palpate/evaluation/Evaluation.h"
#include "palpate/evaluation/ExactSolver.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace palpate::evaluation {

namespace {

constexpr std::size_t kHistogram = 33; // 0 to 31 iterations, and a last bin for more

// Tolerance for lying on a surface in a scene of about 10 mm: a hundred skins, far below the resolution of any device.
constexpr double kOnSurface_mm = 1e-8;
// The force is a difference times a factor, summed with zero: one ulp. A sphere may diverge from the exact one at
// every edge and corner, hence its larger percentage below.
constexpr double kForceRounding = 1e-15;
constexpr double kLayersRounding_N = 1e-9;
constexpr double kMaxElsewhere_percent = 0.1, kMaxElsewhereOfSphere_percent = 1.0;

/// Tracks the largest value of a figure and its tick.
class Worst
{
  public:
    Worst(std::string what, double bound) { m_figure = {std::move(what), 0.0, bound, -1}; }
    void see(double value, std::int64_t tick)
    {
        if (value > m_figure.measured || !std::isfinite(value)) {
            m_figure.measured = value;
            m_figure.worstTick = tick;
        }
    }
    void count(std::int64_t tick)
    {
        m_figure.worstTick = m_figure.measured == 0.0 ? tick : m_figure.worstTick;
        m_figure.measured += 1.0;
    }
    [[nodiscard]] const HardCaseFigure& figure() const { return m_figure; }

  private:
    HardCaseFigure m_figure;
};

/// One case on one mesh: runs the product tick by tick, and the exact solver from the product's state.
class Run
{
  public:
    Run(const HardCase& hardCase, const geometry::TriangleMesh& mesh, std::function<Vec3(const Vec3&)> map)
        : m_case(hardCase)
        , m_map(std::move(map))
        , m_mesh(geometry::repair(mesh, geometry::Facing::AsGiven))
        , m_beside(hardCase.beside ? std::optional(geometry::repair(hardCase.beside(), geometry::Facing::AsGiven))
                                   : std::nullopt)
        , m_surface(m_beside ? merged({&m_mesh, &*m_beside}) : m_mesh)
        , m_product(hardCase, m_mesh, m_beside ? &*m_beside : nullptr)
        , m_straight(m_surface, 1, hardCase.fingertip_mm, hardCase.friction)
        , m_fine(m_surface, 8, hardCase.fingertip_mm, hardCase.friction)
        , m_next(hardCase.motion())
    {
        const double scale = hardCase.scale;
        m_onSurface_mm = kOnSurface_mm * scale;
        m_spring = Worst("spring longer than the exact one [mm]", 1e-3 * scale);
        m_residual = Worst("residual [mm]", 1e-6 * scale);
        m_jump = Worst("jump larger than the exact one [mm]", 1e-3 * scale);
        m_outsideCone = Worst("outside the cone of friction [mm]", kOnSurface_mm * scale);
        m_slope = Worst("change of the force by the hand's way [N/mm]", (1.0 + 1e-6) * hardCase.maxSlope_N_per_mm);
        m_result.name = hardCase.name;
        m_result.triangles = m_surface.triangleCount();
        m_result.iterations.assign(kHistogram, 0);
    }

    [[nodiscard]] Vec3 god() const { return m_god; }
    [[nodiscard]] const HardCaseResult& result() const { return m_result; }

    void tick(std::int64_t number)
    {
        const Vec3 raw = m_next();
        const Vec3 hip = m_map ? m_map(raw) : raw;
        if (number == 0) {
            m_product.start(hip);
            m_god = m_hip = hip;
            m_windingAtStart = m_surface.winding(hip);
            m_intrusion_mm = m_straight.intrusion_mm(hip);
        }
        const CheckedTick judged = m_product.step(hip);
        const haptics::TickResult& step = judged.tick;
        ++m_result.ticks;
        if (!step.p_WG.allFinite() || !step.f_W.allFinite()) {
            m_nonFinite.count(number);
            return;
        }
        if (judged.differsAfterRestore) {
            m_restoredApart.count(number);
        }
        if (!hip.allFinite()) {
            if (step.p_WG != m_god || step.f_W != Vec3::Zero()) {
                m_nonFinite.count(number); // invalid input must cause neither motion nor force
            }
            return;
        }
        ++m_result.iterations[std::min<std::size_t>(step.iterations, kHistogram - 1)];
        m_iterations.see(step.iterations, number);
        if (step.status != haptics::TickStatus::Converged) {
            m_stopped.count(number);
        }
        if (judged.lacksForce) {
            m_forceless.count(number);
        }
        m_forceError.see(judged.forceError, number);
        m_outsideCone.see(judged.outsideCone_mm, number);
        m_layersError.see(judged.layersError_N, number);
        if (m_beside && number > 0) {
            followForce(step.f_W, hip, number);
        }
        m_f_W = step.f_W;
        if (number % m_case.checkEvery == 0) {
            const bool isAtRest = step.status == haptics::TickStatus::Converged || !m_case.mayReachBound;
            check(step.p_WG, hip, isAtRest && (m_case.friction == 0.0 || m_case.fingertip_mm == 0.0), number);
        }
        m_god = step.p_WG;
        m_hip = hip;
    }

    void finish()
    {
        const HardCaseFigure elsewhere{
            "at rest elsewhere than the exact one [% of ticks]", m_checked > 0 ? 100.0 * m_elsewhere / m_checked : 0.0,
            std::max(m_case.maxElsewhere_percent,
                     m_case.fingertip_mm > 0.0 ? kMaxElsewhereOfSphere_percent : kMaxElsewhere_percent),
            -1};
        HardCaseFigure stopped = m_stopped.figure();
        if (m_case.mayReachBound) {
            stopped.bound = static_cast<double>(m_case.ticks);
        }
        m_result.figures = {m_popThrough.figure(),
                            m_nonFinite.figure(),
                            stopped,
                            m_iterations.figure(),
                            m_forceless.figure(),
                            m_forceError.figure(),
                            m_restoredApart.figure(),
                            m_spring.figure(),
                            m_residual.figure(),
                            m_jump.figure(),
                            elsewhere};
        if (m_case.friction > 0.0) {
            m_result.figures.push_back(m_outsideCone.figure());
        }
        if (m_beside) {
            m_result.figures.push_back(m_slope.figure());
            m_result.figures.push_back({"work on a closed path [mJ]", std::abs(m_work_mJ), m_case.maxWork_mJ, -1});
        }
        if (m_case.other) {
            m_result.figures.push_back(m_layersError.figure());
        }
    }

  private:
    /// Tracks the change of the force per HIP displacement, and the work on the hand.
    void followForce(const Vec3& f_W, const Vec3& hip, std::int64_t number)
    {
        const Vec3 way = hip - m_hip;
        if (way.norm() > m_onSurface_mm) {
            m_slope.see((f_W - m_f_W).norm() / way.norm(), number);
        }
        m_work_mJ += 0.5 * (f_W + m_f_W).dot(way);
    }

    /// @param isAtRest  whether the residual is checked as well
    void check(const Vec3& god, const Vec3& hip, bool isAtRest, std::int64_t number)
    {
        ++m_checked;
        const double intrusion = m_straight.intrusion_mm(god);
        if ((m_case.intrusion_mm ? m_case.intrusion_mm(god) > 0.0 : isBehind(god)) ||
            intrusion > std::max(0.0, m_intrusion_mm) + m_onSurface_mm) { // deeper than before
            m_popThrough.count(number);
        }
        m_intrusion_mm = intrusion;
        if (!isAtRest) {
            return;
        }
        const double residual = residual_mm(m_straight, god, hip);
        double excess = 0.0, jumpExcess = 0.0;
        compare(god, hip, excess, jumpExcess);
        if (residual <= m_residual.figure().bound && !isGood(residual, excess, jumpExcess)) {
            // At rest in another local minimum: the paths diverged at a ridge or a saddle, and either result is valid.
            // A sphere released where it does not fit ends elsewhere on each path, because every finite move lets it
            // out a little.
            if (m_straight.intrusion_mm(m_god) <= m_onSurface_mm) {
                m_elsewhere += 1.0;
            }
            excess = jumpExcess = 0.0;
        }
        m_residual.see(residual, number);
        m_spring.see(excess, number);
        m_jump.see(jumpExcess, number);
    }

    /// Returns true if behind a closed surface that the path started in front of, and not on the surface: a HIP
    /// exactly in a plane is not behind the plane.
    [[nodiscard]] bool isBehind(const Vec3& god) const
    {
        if (!m_surface.isClosed() || m_surface.winding(god) <= m_windingAtStart) {
            return false;
        }
        for (int i = 0; i < 6; ++i) {
            const Vec3 shift = (i < 3 ? m_onSurface_mm : -m_onSurface_mm) * Vec3::Unit(i % 3);
            if (m_surface.winding(god + shift) <= m_windingAtStart) {
                return false;
            }
        }
        return true;
    }

    [[nodiscard]] bool isGood(double residual, double excess, double jumpExcess) const
    {
        return residual <= m_residual.figure().bound && excess <= m_spring.figure().bound &&
               jumpExcess <= m_jump.figure().bound;
    }

    /// Computes the excess of the spring length and of the move in this tick over the exact solver's.
    void compare(const Vec3& god, const Vec3& hip, double& excess, double& jumpExcess)
    {
        const double spring = (god - hip).norm(), jump = (god - m_god).norm();
        // In one step like the product, or in small steps like a slow hand: both are valid and may diverge at a ridge.
        for (ExactSolver* exact : {&m_straight, &m_fine}) {
            exact->resume(m_god, m_hip);
            const SolverStep truth = exact->step(hip);
            const double e = spring - truth.spring_mm.norm(), j = jump - (truth.p_WG - m_god).norm();
            excess = exact == &m_straight ? e : std::min(excess, e);
            jumpExcess = exact == &m_straight ? j : std::min(jumpExcess, j);
            if (excess <= 0.1 * m_spring.figure().bound && jumpExcess <= 0.1 * m_jump.figure().bound) {
                return;
            }
        }
    }

    const HardCase& m_case;
    std::function<Vec3(const Vec3&)> m_map;
    geometry::RepairedMesh m_mesh;
    std::optional<geometry::RepairedMesh> m_beside;
    Surface m_surface; ///< main structure and `beside` merged
    JudgedProduct m_product;
    ExactSolver m_straight, m_fine;
    std::function<Vec3()> m_next;
    Vec3 m_god = Vec3::Zero(), m_hip = Vec3::Zero(), m_f_W = Vec3::Zero();
    double m_work_mJ = 0.0;
    int m_windingAtStart = 0;
    double m_checked = 0.0, m_elsewhere = 0.0, m_onSurface_mm = 0.0, m_intrusion_mm = 0.0;
    HardCaseResult m_result;
    Worst m_popThrough{"pop-throughs [ticks]", 0.0};
    Worst m_nonFinite{"non-finite or moved by bad input [ticks]", 0.0};
    Worst m_stopped{"stopped before rest [ticks]", 0.0};
    Worst m_iterations{"most iterations in a tick", haptics::GodObjectLimits{}.iterations - 1.0};
    Worst m_forceless{"no force away from the HIP [ticks]", 0.0};
    Worst m_forceError{"force other than k (g - p) [share]", kForceRounding};
    Worst m_restoredApart{"restored, not the same [ticks]", 0.0};
    Worst m_layersError{"force other than that of the layers alone [N]", kLayersRounding_N};
    Worst m_spring{"", 0.0}, m_residual{"", 0.0}, m_jump{"", 0.0}, m_outsideCone{"", 0.0}, m_slope{"", 0.0};
};

geometry::TriangleMesh mappedBy(const std::function<Vec3(const Vec3&)>& map, geometry::TriangleMesh mesh)
{
    for (Vec3& v : mesh.vertices) {
        v = map(v);
    }
    return mesh;
}

} // namespace

bool HardCaseResult::passed() const
{
    return std::all_of(figures.begin(), figures.end(), [](const HardCaseFigure& f) { return f.passed(); });
}

const HardCaseFigure* HardCaseResult::tightest() const
{
    const HardCaseFigure* worst = nullptr;
    const auto share = [](const HardCaseFigure& f) {
        return !f.passed() ? 1e300 : f.bound > 0.0 ? f.measured / f.bound : 0.0;
    };
    for (const HardCaseFigure& f : figures) {
        if (worst == nullptr || share(f) > share(*worst)) {
            worst = &f;
        }
    }
    return worst;
}

HardCaseResult run(const HardCase& hardCase, const std::function<bool()>& keepGoing)
{
    const geometry::TriangleMesh mesh = hardCase.mesh();
    if (!hardCase.twin) {
        Run one(hardCase, mesh, {});
        for (std::int64_t i = 0; i < hardCase.ticks; ++i) {
            if (i % 16 == 0 && keepGoing && !keepGoing()) {
                break;
            }
            one.tick(i);
        }
        one.finish();
        return one.result();
    }
    // The bounds are checked on the transformed scene; the plain scene is only the reference for the comparison.
    HardCase plain = hardCase;
    plain.checkEvery = hardCase.ticks + 1;
    HardCase mapped = hardCase;
    mapped.fingertip_mm *= hardCase.scale;
    Run here(plain, mesh, {}), there(mapped, mappedBy(hardCase.twin, mesh), hardCase.twin);
    Worst difference("difference from the plain scene [mm]", hardCase.twinBound_mm);
    for (std::int64_t i = 0; i < hardCase.ticks; ++i) {
        if (i % 16 == 0 && keepGoing && !keepGoing()) {
            break;
        }
        here.tick(i);
        there.tick(i);
        difference.see((hardCase.twin(here.god()) - there.god()).norm(), i);
    }
    there.finish();
    HardCaseResult result = there.result();
    result.figures.push_back(difference.figure());
    return result;
}

namespace {

bool isChosen(const HardCase& hardCase, HardCaseChoice choice)
{
    constexpr std::int64_t kQuickTicks = 20000;
    switch (choice) {
    case HardCaseChoice::Quick:
        return !hardCase.isLong && hardCase.ticks <= kQuickTicks;
    case HardCaseChoice::Ordinary:
        return !hardCase.isLong;
    case HardCaseChoice::All:
        break;
    }
    return true;
}

} // namespace

std::size_t hardCaseCount(HardCaseChoice choice)
{
    const auto& cases = hardCases();
    return static_cast<std::size_t>(
        std::count_if(cases.begin(), cases.end(), [choice](const HardCase& c) { return isChosen(c, choice); }));
}

std::vector<HardCaseResult> runHardCases(HardCaseChoice choice,
                                         const std::function<bool(double, const std::string&)>& progress)
{
    std::vector<HardCaseResult> results;
    const auto count = static_cast<double>(hardCaseCount(choice));
    for (const HardCase& hardCase : hardCases()) {
        if (!isChosen(hardCase, choice)) {
            continue;
        }
        bool isCancelled = false;
        const auto keepGoing = [&] {
            isCancelled =
                isCancelled || (progress && !progress(static_cast<double>(results.size()) / count, hardCase.name));
            return !isCancelled;
        };
        if (!keepGoing()) {
            break;
        }
        HardCaseResult result = run(hardCase, keepGoing);
        if (isCancelled) {
            break;
        }
        results.push_back(std::move(result));
    }
    return results;
}

} // namespace palpate::evaluation

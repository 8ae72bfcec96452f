// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/buried/FeltSurface.h"

#include "Decimated.h"
#include "palpate/buried/Ground.h"
#include "palpate/buried/LumpShape.h"

#include <palpate/core/Numbers.h>
#include <palpate/core/Parallel.h>
#include <palpate/geometry/Inside.h>
#include <palpate/geometry/SurfaceIndex.h>
#include <palpate/vtk/PolyData.h>

#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>

namespace palpate::buried {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;
using geometry::RepairedMesh;
using geometry::SurfaceIndex;

constexpr double kFinest = 0.5; ///< maximum edge length in contact radii

bool hasInside(const geometry::MeshReport& report)
{
    return report.isClosed() && report.insideOutComponents == 0 && report.volume_mm3 > 0.0;
}

/// Lump with the data structures for evaluation at each vertex.
struct Prepared
{
    std::size_t number; ///< index in the input list
    LumpShape shape;
    SurfaceIndex index;
    vtkNew<vtkStaticCellLocator> locator; ///< over all triangles of the lump
    bool overlaps = false;

    Prepared(std::size_t n, const RepairedMesh& surface)
        : number(n)
        , shape(surface)
        , index(SurfaceIndex::build(surface))
    {
        locator->SetDataSet(vtk::polyDataOf(surface.mesh));
        locator->BuildLocator();
    }

    [[nodiscard]] double distance(const Vec3& p_W) const
    {
        thread_local const vtkSmartPointer<vtkGenericCell> cell = vtkSmartPointer<vtkGenericCell>::New();
        Vec3 at = p_W;
        vtkIdType id = 0;
        int part = 0;
        double distance2 = 0.0;
        locator->FindClosestPoint(p_W.data(), at.data(), cell, id, part, distance2);
        return std::sqrt(distance2);
    }
};

bool isAnyInside(const SurfaceIndex& around, const RepairedMesh& lump)
{
    return std::any_of(lump.mesh.vertices.begin(), lump.mesh.vertices.end(),
                       [&](const Vec3& p) { return geometry::isInside(around, p); });
}

Status checked(const FeltOptions& options)
{
    if (!(options.radius_mm > 0.0 && options.radius_mm <= kMostRadius_mm)) {
        return {StatusCode::OutOfRange,
                PALPATE_TEXT("contact radius: found %1 mm, expected more than 0 and at most 30 mm"), options.radius_mm};
    }
    if (options.press_mm.empty() || options.press_mm.size() > kMaxPresses) {
        return {StatusCode::OutOfRange, PALPATE_TEXT("press depths: found %1, expected 1 to %2"),
                options.press_mm.size(), kMaxPresses};
    }
    for (std::size_t i = 0; i < options.press_mm.size(); ++i) {
        const double press = options.press_mm[i], before = i == 0 ? -1.0 : options.press_mm[i - 1];
        if (!(press >= 0.0 && press <= kMaxPress_mm && press > before)) {
            return {StatusCode::OutOfRange, PALPATE_TEXT("press depths: found %1 mm, expected 0 to 30 mm, ascending"),
                    press};
        }
    }
    return {};
}

/// Checks whether refining the organ for the contact radius stays below kMaxRefinedTriangles triangles.
Status checkedFor(const RepairedMesh& organ, const std::string& name, double radius_mm)
{
    // An equilateral triangle with edge length l has area sqrt(3)/4 l^2.
    const double least_mm =
        std::sqrt(4.0 / std::numbers::sqrt3 * organ.report.area_mm2 / kMaxRefinedTriangles) / kFinest;
    if (radius_mm >= least_mm) {
        return {};
    }
    return {StatusCode::OutOfRange,
            PALPATE_TEXT("%1: contact radius: found %2 mm, expected at least %3 mm on a surface this large"), name,
            radius_mm, std::ceil(100.0 * least_mm) / 100.0};
}

bool isPossible(const RatioRange& ratio)
{
    return ratio.low > 0.0 && ratio.low <= ratio.typical && ratio.typical <= ratio.high &&
           ratio.high <= kMaxModulusRatio;
}

/// Prepares the usable lumps; the reasons for skipped lumps are added to the notes.
Result<std::vector<std::unique_ptr<Prepared>>> prepared(const std::string& organName, const SurfaceIndex& organ,
                                                        const std::vector<BuriedLump>& lumps,
                                                        std::vector<core::Message>& notes)
{
    std::vector<std::unique_ptr<Prepared>> made;
    for (std::size_t i = 0; i < lumps.size(); ++i) {
        const BuriedLump& lump = lumps[i];
        if (lump.ratio && !isPossible(*lump.ratio)) {
            return Status(StatusCode::OutOfRange,
                          PALPATE_TEXT("%1: ratio: found %2, expected more than 0 and at most 10000"), lump.name,
                          lump.ratio->typical);
        }
        const geometry::MeshReport& report = lump.surface->report;
        if (!report.isClosed()) {
            notes.push_back(core::Message(
                PALPATE_TEXT("%1: left out, its surface is open: it has no volume to be felt"), lump.name));
        } else if (!hasInside(report)) {
            notes.push_back(core::Message(PALPATE_TEXT("%1: left out, its surface is inside out"), lump.name));
        } else if (!isAnyInside(organ, *lump.surface)) {
            notes.push_back(core::Message(PALPATE_TEXT("%1: left out, it lies outside %2"), lump.name, organName));
        } else {
            made.push_back(std::make_unique<Prepared>(i, *lump.surface));
        }
    }
    for (std::size_t i = 0; i < made.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const RepairedMesh &a = *lumps[made[i]->number].surface, &b = *lumps[made[j]->number].surface;
            if (a.report.bounds.intersects(b.report.bounds) &&
                (isAnyInside(made[i]->index, b) || isAnyInside(made[j]->index, a))) {
                made[i]->overlaps = made[j]->overlaps = true;
                notes.push_back(
                    core::Message(PALPATE_TEXT("%1 and %2 reach into each other: where both are felt is not judged"),
                                  lumps[made[i]->number].name, lumps[made[j]->number].name));
            }
        }
    }
    return made;
}

/// Outward vertex normals and vertex areas.
struct Corners
{
    std::vector<Vec3> normals;
    std::vector<double> area_mm2;

    explicit Corners(const geometry::TriangleMesh& mesh)
        : normals(mesh.vertices.size(), Vec3::Zero())
        , area_mm2(mesh.vertices.size(), 0.0)
    {
        for (const geometry::Triangle& t : mesh.triangles) {
            const Vec3& a = mesh.vertices[t[0]];
            const Vec3 n = (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
            for (const std::uint32_t corner : t) {
                normals[corner] += n;
                area_mm2[corner] += n.norm() / 6.0;
            }
        }
        for (Vec3& n : normals) {
            const double length = n.norm();
            n = length > 0.0 ? Vec3(n / length) : Vec3::UnitZ();
        }
    }
};

/// Evaluation of all vertices of an organ.
class Run
{
  public:
    Run(FeltSurface& felt, const Ground& ground, const std::vector<std::unique_ptr<Prepared>>& lumps,
        const FeltOptions& options)
        : m_felt(felt)
        , m_ground(ground)
        , m_lumps(lumps)
        , m_options(options)
        , m_corners(felt.surface)
    {
    }

    /// @return false if cancelled
    bool go()
    {
        const std::size_t vertices = m_felt.surface.vertices.size();
        const std::size_t blocks = (vertices + kBlock - 1) / kBlock;
        m_best.resize(blocks);
        std::atomic<bool> isCancelled = false;
        std::atomic<std::size_t> done = 0;
        core::parallelFor(
            blocks,
            [&](std::size_t block, unsigned thread) {
                if (isCancelled) {
                    return;
                }
                m_best[block].assign(m_lumps.size(), std::vector<Found>(m_options.press_mm.size()));
                Room room;
                for (std::size_t v = block * kBlock; v < std::min(vertices, (block + 1) * kBlock); ++v) {
                    judge(v, m_best[block], room);
                }
                const std::size_t now = ++done;
                if (thread == 0 && m_options.progress && !m_options.progress(double(now) / double(blocks))) {
                    isCancelled = true;
                }
            },
            m_options.threads);
        if (isCancelled) {
            return false;
        }
        gather();
        return true;
    }

  private:
    static constexpr std::size_t kBlock = 256;
    struct Found
    {
        FeltSurface::LumpPress told;
        bool isReachedWhereInvalid = false; ///< energy share above 0 at a place where the model is invalid
    };
    using Best = std::vector<std::vector<Found>>; ///< by lump and press

    struct Room
    {
        std::vector<double> shares;
        std::vector<LumpShare> all;
    };

    void judge(std::size_t v, Best& best, Room& room) const
    {
        const std::size_t presses = m_options.press_mm.size();
        const Vec3& p_W = m_felt.surface.vertices[v];
        const Ground::At ground = m_ground.at(p_W, m_corners.normals[v]);
        std::uint8_t reasons = static_cast<std::uint8_t>((ground.isCurved ? kCurved : 0) | (ground.isThin ? kThin : 0));

        room.shares.assign(m_lumps.size() * presses, 0.0);
        std::size_t most = 0;
        double mostShare = 0.0;
        int overlapping = 0;
        const ContactPlace place{p_W, ground.n_W, m_options.radius_mm};
        for (std::size_t i = 0; i < m_lumps.size(); ++i) {
            if (!m_felt.lumps[i].ratio) {
                continue;
            }
            const std::span<double> shares = std::span(room.shares).subspan(i * presses, presses);
            m_lumps[i]->shape.shares(place, m_options.press_mm, shares);
            if (shares.back() > LumpShape::kLeastShare) {
                overlapping += m_lumps[i]->overlaps ? 1 : 0;
                const double changes = shares.back() * std::abs(std::log(m_felt.lumps[i].ratio->typical));
                if (changes > mostShare) {
                    mostShare = changes;
                    most = i + 1;
                }
            }
        }
        reasons = static_cast<std::uint8_t>(reasons | (overlapping > 1 ? kOverlapping : 0));
        m_felt.notJudged[v] = reasons;
        m_felt.lump[v] = static_cast<std::uint8_t>(std::min<std::size_t>(most, 255));
        m_felt.cover_mm[v] =
            most == 0 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(m_lumps[most - 1]->distance(p_W));
        for (std::size_t press = 0; press < presses; ++press) {
            room.all.clear();
            for (std::size_t i = 0; i < m_lumps.size(); ++i) {
                if (!m_felt.lumps[i].ratio) {
                    continue;
                }
                const LumpShare one{room.shares[i * presses + press], m_felt.lumps[i].ratio->typical};
                room.all.push_back(one);
                if (reasons == 0) {
                    enter(best[i][press].told, v, one);
                } else if (one.share > 0.0) {
                    best[i][press].isReachedWhereInvalid = true;
                }
            }
            const Stiffening felt = stiffening(room.all);
            FeltSurface::Press& to = m_felt.press[press];
            to.low[v] = static_cast<float>(felt.low);
            to.ratio[v] = static_cast<float>(felt.estimate);
            to.high[v] = static_cast<float>(felt.high);
        }
    }

    [[nodiscard]] static double changeOf(const Stiffening& felt) { return std::abs(std::log(felt.estimate)); }

    void enter(FeltSurface::LumpPress& at, std::size_t v, const LumpShare& lump) const
    {
        const Stiffening felt = stiffening(lump.share, lump.ratio);
        const double change = changeOf(felt);
        for (std::size_t i = 0; i < kDetectableChange_percent.size(); ++i) {
            if (change >= std::log1p(kDetectableChange_percent[i] / 100.0)) {
                at.area_mm2[i] += m_corners.area_mm2[v];
            }
        }
        // A lump with the organ's modulus also gets a best place and a verdict, although its effect there is zero.
        if (lump.share > 0.0 && (!at.best.has_value() || change > changeOf(at.felt))) {
            at.best = v;
            at.share = lump.share;
            at.felt = felt;
        }
    }

    /// Sums the blocks in a fixed order, so that the result does not depend on the assignment of blocks to threads.
    void gather()
    {
        for (std::size_t i = 0; i < m_lumps.size(); ++i) {
            FeltSurface::Lump& lump = m_felt.lumps[i];
            lump.press.resize(m_options.press_mm.size());
            for (std::size_t press = 0; press < lump.press.size(); ++press) {
                FeltSurface::LumpPress& sum = lump.press[press];
                bool isReachedWhereInvalid = false;
                for (const Best& block : m_best) {
                    const FeltSurface::LumpPress& part = block[i][press].told;
                    isReachedWhereInvalid = isReachedWhereInvalid || block[i][press].isReachedWhereInvalid;
                    for (std::size_t k = 0; k < sum.area_mm2.size(); ++k) {
                        sum.area_mm2[k] += part.area_mm2[k];
                    }
                    if (part.best.has_value() && (!sum.best.has_value() || changeOf(part.felt) > changeOf(sum.felt))) {
                        sum.best = part.best;
                        sum.share = part.share;
                        sum.felt = part.felt;
                    }
                }
                const auto verdictAt = [&](double ratio) {
                    if (sum.best.has_value()) {
                        return verdictOf(stiffening(sum.share, ratio).estimate);
                    } // too deep everywhere, or effective only where the model is invalid
                    return isReachedWhereInvalid ? Verdict::NotJudged : Verdict::NotByHand;
                };
                sum.verdict = sum.verdictAtLow = sum.verdictAtHigh = Verdict::NotKnown;
                if (lump.ratio) {
                    sum.verdict = verdictAt(lump.ratio->typical);
                    sum.verdictAtLow = verdictAt(lump.ratio->low);
                    sum.verdictAtHigh = verdictAt(lump.ratio->high);
                }
            }
        }
    }

    FeltSurface& m_felt;
    const Ground& m_ground;
    const std::vector<std::unique_ptr<Prepared>>& m_lumps;
    const FeltOptions& m_options;
    Corners m_corners;
    std::vector<Best> m_best; ///< one for each block
};

/// Computes the map and the verdicts; if no lump has a known ratio, only sets the verdicts to NotKnown.
Status computeVerdicts(FeltSurface& felt, const RepairedMesh& fine, const SurfaceIndex& organ,
                       const std::vector<std::unique_ptr<Prepared>>& lumps, const FeltOptions& options)
{
    if (std::none_of(felt.lumps.begin(), felt.lumps.end(), [](const auto& lump) { return lump.ratio.has_value(); })) {
        FeltSurface::LumpPress none;
        none.verdict = none.verdictAtLow = none.verdictAtHigh = Verdict::NotKnown;
        for (FeltSurface::Lump& lump : felt.lumps) {
            lump.press.assign(options.press_mm.size(), none);
        }
        std::fill(felt.cover_mm.begin(), felt.cover_mm.end(), std::numeric_limits<float>::quiet_NaN());
        return {};
    }
    const Ground ground(fine, organ, options.radius_mm);
    Run run(felt, ground, lumps, options);
    return run.go() ? Status() : Status(StatusCode::Cancelled, PALPATE_TEXT("what can be felt was cancelled"));
}

double leastCover(const Prepared& lump, const RepairedMesh& surface, const SurfaceIndex& organ,
                  const geometry::TriangleMesh& places)
{
    if (std::any_of(surface.mesh.vertices.begin(), surface.mesh.vertices.end(),
                    [&](const Vec3& p) { return !geometry::isInside(organ, p); })) {
        return 0.0;
    }
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3& p_W : places.vertices) {
        if (lump.shape.distanceLowerBound(p_W) < least) {
            least = std::min(least, lump.distance(p_W));
        }
    }
    return least;
}

/// Maximum error of the map when interpolated linearly over the organ's original triangles [1].
double interpolationErrorOf(const geometry::TriangleMesh& organ, const FeltSurface& felt)
{
    double worst = 0.0;
    for (const FeltSurface::Press& press : felt.press) {
        const std::vector<float> own(press.ratio.begin(),
                                     press.ratio.begin() + static_cast<std::ptrdiff_t>(felt.organVertices));
        const std::vector<float> linear = refinedValues(organ, kFinest * felt.radius_mm, own);
        for (std::size_t v = felt.organVertices; v < std::min(linear.size(), press.ratio.size()); ++v) {
            worst = std::max(worst, std::abs(double{linear[v]} / double{press.ratio[v]} - 1.0));
        }
    }
    return worst;
}

/// Refines the organ to the edge length required for the contact radius.
RepairedMesh refinedForContact(const RepairedMesh& organ, double longest_mm)
{
    double longest2 = 0.0;
    for (const geometry::Triangle& t : organ.mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 edge = organ.mesh.vertices[t[(k + 1) % 3]] - organ.mesh.vertices[t[k]];
            longest2 = std::max(longest2, edge.squaredNorm());
        }
    }
    RepairedMesh fine = organ;
    fine.mesh.arrays.clear();
    if (longest2 > longest_mm * longest_mm) {
        fine.mesh = refined(organ.mesh, longest_mm);
    }
    return fine;
}

} // namespace

Verdict verdictOf(double ratio) noexcept
{
    const double change = std::abs(std::log(ratio));
    if (change >= std::log1p(kDetectableChange_percent[2] / 100.0)) {
        return Verdict::Plainly;
    }
    return change >= std::log1p(kDetectableChange_percent[1] / 100.0) ? Verdict::ByTrainedHand : Verdict::NotByHand;
}

std::string verdictText(const FeltSurface::LumpPress& press, const std::optional<RatioRange>& ratio)
{
    const auto text = [](Verdict verdict) { return std::string(kVerdictNames[static_cast<std::size_t>(verdict)]); };
    if (!ratio || (press.verdictAtLow == press.verdict && press.verdictAtHigh == press.verdict)) {
        return text(press.verdict);
    }
    return text(press.verdict) + " (at " + core::shortNumber(ratio->low) + ": " + text(press.verdictAtLow) + "; at " +
           core::shortNumber(ratio->high) + ": " + text(press.verdictAtHigh) + ")";
}

Result<FeltSurface> feltSurface(const std::string& name, const RepairedMesh& organ,
                                const std::vector<BuriedLump>& lumps, const FeltOptions& options)
{
    if (Status status = checked(options); !status.isOk()) {
        return status;
    }
    if (!hasInside(organ.report)) {
        return Status(StatusCode::Unsupported,
                      PALPATE_TEXT("%1: its surface is open or inside out; expected a closed one, or it can't be told "
                                   "what lies in it"),
                      name);
    }
    const bool isAnyKnown =
        std::any_of(lumps.begin(), lumps.end(), [](const auto& one) { return one.ratio.has_value(); });
    if (Status status = checkedFor(organ, name, options.radius_mm); isAnyKnown && !status.isOk()) {
        return status;
    }
    FeltSurface felt;
    const SurfaceIndex index = SurfaceIndex::build(organ);
    auto ready = prepared(name, index, lumps, felt.notes);
    if (!ready.isOk()) {
        return ready.status();
    }
    if (ready.value().empty()) {
        std::vector<core::Message> why{core::Message(PALPATE_TEXT("%1: found no lump in it that can be judged"), name)};
        why.insert(why.end(), felt.notes.begin(), felt.notes.end());
        return Status(StatusCode::Empty, core::joined(why));
    }
    const RepairedMesh fine = isAnyKnown ? refinedForContact(organ, kFinest * options.radius_mm) : organ;
    felt.surface = fine.mesh;
    felt.organVertices = organ.mesh.vertices.size();
    felt.radius_mm = options.radius_mm;
    const std::size_t vertices = felt.surface.vertices.size();
    for (const double press_mm : options.press_mm) {
        const std::vector<float> ones(vertices, 1.0f);
        felt.press.push_back({press_mm, ones, ones, ones});
    }
    felt.cover_mm.resize(vertices);
    felt.lump.resize(vertices);
    felt.notJudged.resize(vertices);
    for (const auto& lump : ready.value()) {
        const BuriedLump& given = lumps[lump->number];
        felt.lumps.push_back({given.name, lump->number, given.ratio, 0.0, {}});
    }
    if (Status status = computeVerdicts(felt, fine, index, ready.value(), options); !status.isOk()) {
        return status.at(name);
    }
    for (std::size_t i = 0; i < felt.lumps.size(); ++i) {
        felt.lumps[i].minCover_mm =
            leastCover(*ready.value()[i], *lumps[ready.value()[i]->number].surface, index, felt.surface);
    }
    if (vertices > felt.organVertices) {
        felt.interpolationError = interpolationErrorOf(organ.mesh, felt);
        if (100.0 * felt.interpolationError > kDetectableChange_percent[0]) {
            felt.notes.push_back(core::Message(
                PALPATE_TEXT("%1: its triangles are wider than a finger's contact: what the hand feels of its lumps "
                             "differs by up to %2 % from what is shown; a finer mesh mends it"),
                name, std::round(100.0 * felt.interpolationError)));
        }
    }
    return felt;
}

} // namespace palpate::buried

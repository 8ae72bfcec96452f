// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/FeltOverlay.h"

#include "palpate/ui/EngineTexts.h"
#include "palpate/ui/FeltWords.h"
#include "palpate/ui/VtkViewport.h"

#include <palpate/view/FeltColours.h>
#include <palpate/view/SurfaceMesh.h>

#include <Eigen/Geometry>

#include <vtkNew.h>
#include <vtkPoints.h>

#include <QLocale>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <utility>

namespace palpate::ui {

using core::Vec3;

/// What window and worker share.
struct FeltOverlay::Job
{
    std::atomic<bool> isCancelled{false};
};

/// What the worker found.
struct FeltOverlay::Found
{
    std::vector<FeltOrganShown> organs;
    QStringList notes;
};

namespace {

constexpr int kWait_ms = 300;  // after the newest change
constexpr int kBlink_ms = 400; // work that is done by then shows no progress

/// How much otherwise than without a lump, softer or stiffer. [%]
float changeOf(float ratio)
{
    return 100.0F * std::expm1(std::abs(std::log(ratio)));
}

/// @param picture  of the organ as it was given
FeltOrganShown shown(study::FeltOrgan organ, std::size_t triangles, const vtkSmartPointer<vtkPolyData>& picture)
{
    FeltOrganShown one;
    const geometry::TriangleMesh& mesh = organ.felt.surface;
    if (mesh.triangles.size() == triangles) {
        one.picture = picture;
    } else {
        geometry::RepairedMesh refined;
        refined.mesh = mesh;
        one.picture = view::makeSurface(refined);
    }
    vtkNew<vtkPoints> points;
    points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.vertices.size()));
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        points->SetPoint(static_cast<vtkIdType>(v), mesh.vertices[v].data());
    }
    vtkNew<vtkPolyData> cloud;
    cloud->SetPoints(points);
    one.vertices = vtkSmartPointer<vtkStaticPointLocator>::New();
    one.vertices->SetDataSet(cloud);
    one.vertices->BuildLocator();
    one.organ = std::move(organ);
    return one;
}

Vec3 normalAt(const geometry::TriangleMesh& mesh, std::size_t vertex)
{
    Vec3 sum = Vec3::Zero();
    for (const geometry::Triangle& t : mesh.triangles) {
        if (std::find(t.begin(), t.end(), vertex) != t.end()) {
            const Vec3& a = mesh.vertices[t[0]];
            sum += (mesh.vertices[t[1]] - a).cross(mesh.vertices[t[2]] - a);
        }
    }
    return sum.norm() > 0.0 ? Vec3(sum.normalized()) : Vec3::UnitZ();
}

} // namespace

FeltOverlay::FeltOverlay(VtkViewport& viewport, StructureModel& model, MapDisplay& maps, QObject* parent)
    : QObject(parent)
    , m_viewport(viewport)
    , m_model(model)
    , m_maps(maps)
    , m_flight(viewport)
{
    m_thread.setMaxThreadCount(1); // a new job waits until the cancelled one has noticed
    m_wait.setSingleShot(true);
    m_wait.setInterval(kWait_ms);
    connect(&m_wait, &QTimer::timeout, this, &FeltOverlay::begin);
    connect(&model, &StructureModel::edited, this, &FeltOverlay::follow);
    connect(&model, &QAbstractItemModel::rowsInserted, this, &FeltOverlay::follow);
    connect(&model, &QAbstractItemModel::modelReset, this, [this] {
        m_drawn.clear(); // the view has new pictures
        m_organs.clear();
        m_maps.setCovered(false);
        follow();
    });
}

FeltOverlay::~FeltOverlay()
{
    if (m_job != nullptr) {
        m_job->isCancelled = true;
    }
    m_thread.waitForDone();
}

void FeltOverlay::setShown(bool isShown)
{
    if (isShown == m_isShown) {
        return;
    }
    m_isShown = isShown;
    undraw();
    follow();
    draw();
}

void FeltOverlay::setTabled(bool isTabled)
{
    m_isTabled = isTabled;
    follow();
}

void FeltOverlay::setPress(std::size_t press)
{
    m_press = std::min(press, kPress_mm.size() - 1);
    m_viewport.view().placeRing().hide(); // another press may have another best place
    draw();
    Q_EMIT changed();
}

std::vector<FeltOverlay::Cause> FeltOverlay::causes() const
{
    std::vector<Cause> causes;
    for (const StructureRow& row : m_model.rows()) {
        const meshio::SceneStructure& one = row.loaded.description;
        causes.push_back({one.name, one.inside, one.young_ratio, one.young_kPa, one.felt_contact_radius_mm,
                          one.tissue.stiffness_N_per_mm, one.palpable,
                          row.isRemoved ? nullptr : row.loaded.surface.get()});
    }
    return causes;
}

/// The scene for the worker: what was removed has no surface, so that numbers stay the rows.
meshio::LoadedScene FeltOverlay::sceneNow() const
{
    meshio::LoadedScene scene;
    for (const StructureRow& row : m_model.rows()) {
        meshio::LoadedStructure one;
        one.description = row.loaded.description;
        one.surface = row.isRemoved ? nullptr : row.loaded.surface;
        scene.structures.push_back(std::move(one));
    }
    return scene;
}

/// Computes what is wanted and not there; takes from the view what holds no more.
void FeltOverlay::follow()
{
    std::vector<Cause> now = causes();
    const bool isOther = now != m_causes;
    if (isOther) {
        m_causes = std::move(now);
        m_isUpToDate = false;
        undraw();
        stop();
        Q_EMIT changed();
    }
    if (!m_isShown && !m_isTabled) {
        m_wait.stop();
        stop();
    } else if (!m_isUpToDate && m_job == nullptr && !m_wait.isActive()) {
        isOther ? m_wait.start() : begin();
    } else if (isOther) {
        m_wait.start();
    }
}

void FeltOverlay::begin()
{
    if (m_model.presentCount() == 0) {
        return;
    }
    m_since.start();
    m_job = std::make_shared<Job>();
    const auto progress = [this, job = m_job](const QString& what, double share) {
        QMetaObject::invokeMethod(this, [this, job, what, share] {
            if (job == m_job && m_since.elapsed() > kBlink_ms) {
                Q_EMIT progressed(what, share);
            }
        });
        return !job->isCancelled;
    };
    std::vector<vtkSmartPointer<vtkPolyData>> pictures;
    for (const StructureRow& row : m_model.rows()) {
        pictures.push_back(row.picture);
    }
    m_thread.start([this, job = m_job, scene = sceneNow(), pictures, progress] {
        auto found = std::make_shared<Found>();
        const auto organs = study::organsWithLumps(scene);
        if (!organs.isOk()) {
            found->notes << tr("No lump lies inside an organ here: nothing to be felt through one.");
        }
        for (std::size_t i = 0; organs.isOk() && i < organs.value().size() && !job->isCancelled; ++i) {
            const study::OrganWithLumps& organ = organs.value()[i];
            const QString what =
                tr("What can be felt of %1").arg(readableName(scene.structures[organ.organ].description.name));
            buried::FeltOptions how;
            how.radius_mm = organ.radius_mm;
            how.press_mm.assign(kPress_mm.begin(), kPress_mm.end());
            how.progress = [&, count = static_cast<double>(organs.value().size())](double share) {
                return progress(what, (static_cast<double>(i) + share) / count);
            };
            progress(what, static_cast<double>(i) / static_cast<double>(organs.value().size()));
            auto felt = study::feltSurface(scene, organ, how);
            if (felt.isOk()) {
                for (const std::string& note : felt.value().notes) {
                    found->notes << engineText(note);
                }
                found->organs.push_back(shown({organ, std::move(felt).value()},
                                              scene.structures[organ.organ].surface->mesh.triangles.size(),
                                              pictures[organ.organ]));
            } else {
                found->notes << engineText(felt.status());
            }
        }
        QMetaObject::invokeMethod(this, [this, job, found] {
            if (job == m_job && !job->isCancelled) {
                take(*found);
            }
        });
    });
}

/// The worker ends when it notices; nothing that it found is taken.
void FeltOverlay::stop()
{
    if (m_job != nullptr) {
        m_job->isCancelled = true;
        m_job = nullptr;
        Q_EMIT ended();
    }
}

void FeltOverlay::cancel()
{
    if (m_job == nullptr && !m_wait.isActive()) {
        return;
    }
    m_wait.stop();
    stop();
    m_notes = {tr("What can be felt here was cancelled.")};
    Q_EMIT cancelled();
    Q_EMIT changed();
}

void FeltOverlay::take(Found& found)
{
    m_job = nullptr;
    m_organs = std::move(found.organs);
    m_notes = std::move(found.notes);
    m_isUpToDate = true;
    draw();
    Q_EMIT ended();
    if (!m_notes.isEmpty()) {
        Q_EMIT noted(m_notes);
    }
    Q_EMIT changed();
}

void FeltOverlay::draw()
{
    if (!m_isShown || !m_isUpToDate || m_organs.empty()) {
        return;
    }
    m_maps.setCovered(true);
    m_drawn.clear();
    double greatest = buried::kTold_percent.back();
    bool isHatched = false;
    std::vector<std::vector<float>> changes;
    for (const FeltOrganShown& one : m_organs) {
        const buried::FeltSurface& felt = one.organ.felt;
        std::vector<float>& change = changes.emplace_back(felt.press[m_press].ratio);
        for (std::size_t v = 0; v < change.size(); ++v) {
            change[v] = changeOf(change[v]);
            isHatched = isHatched || felt.notJudged[v] != 0;
            greatest = felt.notJudged[v] == 0 ? std::max(greatest, double{change[v]}) : greatest;
        }
    }
    for (std::size_t i = 0; i < m_organs.size(); ++i) {
        const buried::FeltSurface& felt = m_organs[i].organ.felt;
        m_drawn.push_back(static_cast<int>(m_organs[i].organ.organ.organ));
        m_viewport.view().setPicture(
            m_organs[i].organ.organ.organ,
            view::feltColoured(*m_organs[i].picture, felt.surface, {changes[i], felt.notJudged, greatest}));
    }
    drawLegend(greatest, isHatched);
    m_viewport.update();
}

void FeltOverlay::drawLegend(double greatest_percent, bool isHatched)
{
    view::ColourLegend::Content content;
    const double press_mm = kPress_mm[m_press];
    const QString how = press_mm > 0.0 ? tr("pressed %1 mm").arg(press_mm) : tr("touched lightly");
    content.title = tr("Felt when %1\n(estimate)").arg(how).toStdString();
    content.unknown = tr("not judged").toStdString();
    content.range.high = greatest_percent;
    content.range.hasUnknown = isHatched;
    content.marks = {{0.0, tr("0 %: no lump").toStdString()},
                     {buried::kTold_percent[0], tr("7 %: half of that").toStdString()},
                     {buried::kTold_percent[1], tr("14 %: a trained hand tells").toStdString()},
                     {buried::kTold_percent[2], tr("28 %: plainly felt").toStdString()}};
    if (greatest_percent > 1.15 * buried::kTold_percent[2]) {
        content.marks.push_back(
            {greatest_percent, tr("%1 %: most here").arg(QLocale().toString(greatest_percent, 'f', 0)).toStdString()});
    }
    m_viewport.view().legend().show(content);
}

void FeltOverlay::undraw()
{
    for (const int row : m_drawn) {
        const auto i = static_cast<std::size_t>(row);
        m_viewport.view().setPicture(i, m_model.rows()[i].picture);
    }
    if (!m_drawn.empty()) {
        m_viewport.view().legend().hide();
        m_viewport.update();
    }
    m_viewport.view().placeRing().hide();
    m_drawn.clear();
    m_maps.setCovered(false);
}

QString FeltOverlay::textAt(int row, const Vec3& p_W) const
{
    if (std::find(m_drawn.begin(), m_drawn.end(), row) == m_drawn.end()) {
        return {};
    }
    for (const FeltOrganShown& one : m_organs) {
        if (one.organ.organ.organ == static_cast<std::size_t>(row)) {
            const vtkIdType vertex = one.vertices->FindClosestPoint(p_W.data());
            return vertex < 0 ? QString() : feltPlaceText(one.organ.felt, static_cast<std::size_t>(vertex), m_press);
        }
    }
    return {};
}

bool FeltOverlay::showBestPlace(std::size_t organ, std::size_t lump)
{
    constexpr double kFarthest_mm = 250.0, kOff_mm = 0.3;
    if (organ >= m_organs.size() || lump >= m_organs[organ].organ.felt.lumps.size()) {
        return false;
    }
    const buried::FeltSurface& felt = m_organs[organ].organ.felt;
    const std::optional<std::size_t> best = felt.lumps[lump].press[m_press].best;
    if (!best) {
        return false;
    }
    const Vec3& p_W = felt.surface.vertices[*best];
    const Vec3 n_W = normalAt(felt.surface, *best);
    core::ViewPose pose = viewPose(m_viewport);
    const double distance_mm = std::min((pose.position_W - pose.focus_W).norm(), kFarthest_mm);
    pose.focus_W = p_W;
    pose.position_W = p_W + distance_mm * n_W;
    const Vec3 usual = std::abs(n_W.z()) < 0.9 ? Vec3(Vec3::UnitZ()) : Vec3(-Vec3::UnitY()); // head up, else front up
    pose.up_W = (usual - usual.dot(n_W) * n_W).normalized();
    m_flight.flyTo(pose);
    m_viewport.view().placeRing().show(p_W + kOff_mm * n_W, n_W, felt.radius_mm);
    m_viewport.update();
    return true;
}

} // namespace palpate::ui

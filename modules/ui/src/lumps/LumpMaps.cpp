// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/LumpMaps.h"

#include "palpate/ui/Translated.h"

#include <palpate/view/SurfaceMesh.h>

#include <vtkNew.h>
#include <vtkPoints.h>

#include <algorithm>
#include <atomic>
#include <utility>

namespace palpate::ui {

/// State shared by the GUI thread and the worker.
struct LumpMaps::Job
{
    std::atomic<bool> isCancelled{false};
};

/// Results of the worker.
struct LumpMaps::Found
{
    DisplayedOrgans shown, felt; ///< of all lumps; of the lumps in transmitted mode
    QStringList notes;
    bool isShown = false; ///< `shown` was requested or equals `felt`
};

namespace {

constexpr int kWait_ms = 300;  // delay after the latest change
constexpr int kBlink_ms = 400; // shorter computations show no progress

/// Prepares the display data of an organ. @param picture  original display mesh of the organ
std::shared_ptr<const DisplayedOrgan> shownOrgan(study::OrganPalpability organ, std::size_t triangles,
                                                 const vtkSmartPointer<vtkPolyData>& picture)
{
    DisplayedOrgan one;
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
    return std::make_shared<const DisplayedOrgan>(std::move(one));
}

/// Extracts the maps for the haptic scene at the organ's original vertices, which precede those added by refinement.
StructureModel::TransmittedMap transmittedMap(const study::OrganPalpability& from)
{
    StructureModel::TransmittedMap to;
    to.organ = from.organ.organ;
    for (const buried::FeltSurface::Press& press : from.felt.press) {
        to.below.emplace_back(press.ratio.begin(),
                              press.ratio.begin() + static_cast<std::ptrdiff_t>(from.felt.organVertices));
    }
    for (const buried::FeltSurface::Lump& lump : from.felt.lumps) {
        if (lump.ratio) {
            to.lumps.push_back(from.organ.lumps[lump.given].structure);
        }
    }
    return to;
}

} // namespace

/// A single computation on the worker thread.
class LumpMaps::Making
{
  public:
    using Progress = std::function<bool(const QString& what, double share)>;

    /// @param forHand  rows in transmitted mode; empty: no maps for the haptic scene
    /// @param known  results that are still valid
    Making(meshio::LoadedScene scene, std::vector<vtkSmartPointer<vtkPolyData>> pictures, std::vector<bool> forHand,
           bool isShown, DisplayedOrgans known, Progress progress)
        : m_scene(std::move(scene))
        , m_pictures(std::move(pictures))
        , m_forHand(std::move(forHand))
        , m_known(std::move(known))
        , m_progress(std::move(progress))
    {
        m_found.isShown = isShown;
    }

    Found run()
    {
        std::vector<study::LumpInOpenSurface> leftOut;
        const auto all = study::organsWithLumps(m_scene, {}, &leftOut);
        noteLeftOut(leftOut);
        if (!all.isOk()) {
            if (leftOut.empty()) {
                m_found.notes << tr("No lump was found inside a closed organ.");
            }
            m_found.isShown = true;
            return std::move(m_found);
        }
        const std::vector<study::OrganWithLumps> felt = study::filterLumps(
            all.value(), [this](std::size_t row) { return row < m_forHand.size() && m_forHand[row]; });
        m_found.isShown = m_found.isShown || felt == all.value();
        m_count = static_cast<double>(felt.size() + (m_found.isShown && felt != all.value() ? all.value().size() : 0));
        for (const study::OrganWithLumps& organ : felt) {
            make(organ, tr("Computing how lumps in %1 feel; simulated as layers until then"), m_found.felt);
        }
        if (m_found.isShown) {
            for (const study::OrganWithLumps& organ : all.value()) {
                make(organ, tr("Palpability of %1"), m_found.shown);
            }
        }
        m_found.notes.removeDuplicates();
        return std::move(m_found);
    }

  private:
    void noteLeftOut(const std::vector<study::LumpInOpenSurface>& leftOut)
    {
        if (leftOut.size() > 1) {
            m_found.notes << tr("%1 lumps were left out.").arg(leftOut.size());
        }
        for (const study::LumpInOpenSurface& one : leftOut) {
            const meshio::LoadedStructure& around = m_scene.structures[one.around];
            m_found.notes << tr("%1 was left out: %2.")
                                 .arg(readableName(m_scene.structures[one.lump].description.name),
                                      translated(study::openSurface(readableName(around.description.name).toStdString(),
                                                                    *around.surface)));
        }
    }

    /// Looks for already computed maps of this organ with the same lumps; null otherwise.
    std::shared_ptr<const DisplayedOrgan> made(const study::OrganWithLumps& organ) const
    {
        for (const DisplayedOrgans* from : {&m_found.felt, &m_known}) {
            for (const auto& one : *from) {
                if (one->organ.organ == organ) {
                    return one;
                }
            }
        }
        return nullptr;
    }

    void make(const study::OrganWithLumps& organ, const QString& what, DisplayedOrgans& to)
    {
        if (auto one = made(organ); one != nullptr) {
            to.push_back(std::move(one));
            return;
        }
        const QString text = what.arg(readableName(m_scene.structures[organ.organ].description.name));
        buried::FeltOptions how;
        how.radius_mm = organ.radius_mm;
        how.press_mm.assign(haptics::kFeltPress_mm.begin(), haptics::kFeltPress_mm.end());
        how.progress = [&](double share) { return m_progress(text, (m_done + share) / m_count); };
        if (!m_progress(text, m_done / m_count)) {
            return;
        }
        auto felt = study::feltSurface(m_scene, organ, how);
        m_done += 1.0;
        if (!felt.isOk()) {
            m_found.notes << translated(felt.status());
            return;
        }
        for (const core::Message& note : felt.value().notes) {
            m_found.notes << translated(note);
        }
        for (const buried::FeltSurface::Lump& lump : felt.value().lumps) {
            if (!lump.ratio) {
                m_found.notes << tr("The stiffness ratio of %2 to %1 is unknown, so palpability is not judged. Enter a "
                                    "ratio under What can be felt (B) or choose a published one.")
                                     .arg(readableName(m_scene.structures[organ.organ].description.name),
                                          readableName(lump.name));
            }
        }
        to.push_back(shownOrgan({organ, std::move(felt).value()},
                                m_scene.structures[organ.organ].surface->mesh.triangles.size(),
                                m_pictures[organ.organ]));
    }

    meshio::LoadedScene m_scene;
    std::vector<vtkSmartPointer<vtkPolyData>> m_pictures;
    std::vector<bool> m_forHand;
    DisplayedOrgans m_known;
    Progress m_progress;
    Found m_found;
    double m_count = 1.0, m_done = 0.0; ///< in organs
};

LumpMaps::LumpMaps(StructureModel& model, QObject* parent)
    : QObject(parent)
    , m_model(model)
{
    m_thread.setMaxThreadCount(1); // a new job waits until the cancelled job has ended
    m_wait.setSingleShot(true);
    m_wait.setInterval(kWait_ms);
    connect(&m_wait, &QTimer::timeout, this, &LumpMaps::begin);
    connect(&model, &StructureModel::edited, this, &LumpMaps::follow);
    connect(&model, &QAbstractItemModel::rowsInserted, this, &LumpMaps::follow);
    connect(&model, &QAbstractItemModel::modelReset, this, &LumpMaps::reset);
    connect(&model, &StructureModel::targetsHidden, this, &LumpMaps::forget);
}

LumpMaps::~LumpMaps()
{
    if (m_job != nullptr) {
        m_job->isCancelled = true;
    }
    m_thread.waitForDone();
}

void LumpMaps::setWanted(bool isWanted)
{
    m_isWanted = isWanted;
    follow();
}

/// False while targets of an exercise are hidden: then the maps are for the haptic scene only.
bool LumpMaps::mayShow() const
{
    return m_model.scene().hiddenTargets() == 0;
}

std::vector<LumpMaps::Cause> LumpMaps::causes() const
{
    std::vector<Cause> causes;
    for (std::size_t i = 0; i < m_model.rows().size(); ++i) {
        const study::OpenStructure& row = m_model.rows()[i];
        const meshio::SceneStructure& one = m_model.scene().described(i);
        causes.push_back({one.name, one.inside, one.young_ratio, one.young_kPa, one.felt_contact_radius_mm,
                          one.tissue.stiffness_N_per_mm, one.tissue.law.kind, one.palpable,
                          row.isRemoved ? nullptr : row.loaded.surface.get()});
    }
    return causes;
}

bool LumpMaps::hasTransmittedLumps() const
{
    return std::find(m_forHand.begin(), m_forHand.end(), true) != m_forHand.end();
}

/// Starts over for another scene. Maps loaded with the scene are used as they are.
void LumpMaps::reset()
{
    stop();
    m_wait.stop();
    m_organs.clear();
    m_causes = causes();
    m_forHand = m_model.scene().transmitted();
    m_isUpToDate = m_isGivenUp = false;
    m_isHandUpToDate = true;
    for (std::size_t i = 0; i < m_forHand.size(); ++i) {
        m_isHandUpToDate = m_isHandUpToDate && m_forHand[i] == m_model.rows()[i].loaded.isTransmitted;
    }
    Q_EMIT outdated(true);
    if ((m_isWanted && mayShow()) || !isHandUpToDate()) {
        m_wait.start();
    }
}

/// Discards what is displayed, which names targets of an exercise. The maps for the haptic scene stay.
void LumpMaps::forget()
{
    m_organs.clear();
    m_notes.clear();
    m_isUpToDate = false;
    Q_EMIT outdated(false);
    Q_EMIT changed();
    follow();
}

/// Reacts to changes: starts a computation if requested results are missing.
void LumpMaps::follow()
{
    std::vector<Cause> now = causes();
    std::vector<bool> forHand = m_model.scene().transmitted();
    const bool isOther = now != m_causes, isOtherHand = isOther || forHand != m_forHand;
    if (isOtherHand) {
        m_causes = std::move(now);
        m_forHand = std::move(forHand);
        m_isHandUpToDate = m_isGivenUp = false;
        m_isUpToDate = m_isUpToDate && !isOther;
        stop();
        if (isOther) {
            Q_EMIT outdated(false);
        }
    }
    const bool isMissing = (m_isWanted && mayShow() && !m_isUpToDate) || (!isHandUpToDate() && !m_isGivenUp);
    if (!isMissing) {
        m_wait.stop();
        stop();
    } else if (isOtherHand) {
        m_wait.start();
    } else if (m_job == nullptr && !m_wait.isActive()) {
        begin();
    }
}

void LumpMaps::begin()
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
    for (int row = 0; row < m_model.rowCount(); ++row) {
        pictures.push_back(m_model.picture(row));
    }
    auto making =
        std::make_shared<Making>(m_model.scene().loadedScene(), std::move(pictures), m_forHand, m_isWanted && mayShow(),
                                 m_isUpToDate ? m_organs : DisplayedOrgans(), progress);
    m_thread.start([this, job = m_job, making] {
        auto found = std::make_shared<Found>(making->run());
        QMetaObject::invokeMethod(this, [this, job, found] {
            if (job == m_job && !job->isCancelled) {
                take(*found);
            }
        });
    });
}

/// Cancels the job. The worker ends at its next progress call, and its results are discarded.
void LumpMaps::stop()
{
    if (m_job != nullptr) {
        m_job->isCancelled = true;
        m_job = nullptr;
        Q_EMIT ended();
    }
}

void LumpMaps::cancel()
{
    if (m_job == nullptr && !m_wait.isActive()) {
        return;
    }
    m_wait.stop();
    stop();
    const bool isForTheHand = !isHandUpToDate();
    m_isGivenUp = true;
    m_notes = {isForTheHand ? tr("The computation of buried lumps was cancelled. Lumps are simulated as layers until "
                                 "the scene changes.")
                            : tr("The computation of palpability was cancelled.")};
    Q_EMIT cancelled(m_notes.front());
    Q_EMIT changed();
}

void LumpMaps::take(Found& found)
{
    m_job = nullptr;
    const bool hadHand = isHandUpToDate();
    m_isHandUpToDate = true;
    if (found.isShown && mayShow()) {
        m_organs = std::move(found.shown);
        m_isUpToDate = true;
    }
    m_notes = mayShow() ? std::move(found.notes) : QStringList();
    Q_EMIT ended();
    if (!hadHand) {
        std::vector<StructureModel::TransmittedMap> maps;
        for (const auto& one : found.felt) {
            StructureModel::TransmittedMap map = transmittedMap(one->organ);
            if (!map.lumps.empty()) {
                maps.push_back(std::move(map));
            }
        }
        m_model.setTransmittedMaps(maps); // emits `edited`, but changes none of the causes
    }
    if (!m_notes.isEmpty()) {
        Q_EMIT noted(m_notes);
    }
    Q_EMIT changed();
}

} // namespace palpate::ui

#include "palpate/ui/moc_LumpMaps.cpp"

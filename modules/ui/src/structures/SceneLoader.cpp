// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/SceneLoader.h"

#include "palpate/ui/Translated.h"

#include <palpate/meshio/MeshFolder.h>
#include <palpate/meshio/SurfaceMaps.h>
#include <palpate/session/GeometryHash.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/study/BuriedLumps.h>
#include <palpate/study/HapticCopy.h>
#include <palpate/study/SceneNotes.h>
#include <palpate/view/SurfaceMesh.h>

#include <QElapsedTimer>

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

namespace palpate::ui {

/// State shared by the GUI thread and the worker; outlives both.
struct SceneLoader::Job
{
    std::atomic<bool> isCancelled{false};
};

namespace {

constexpr double kReading = 0.7;   // fraction of the progress
constexpr double kPreparing = 0.2; // for pictures and haptic copies; the rest is for the containment

} // namespace

bool OpenedScene::areMeshes() const
{
    return !isReopened && std::none_of(files.begin(), files.end(), [](const std::filesystem::path& file) {
        return meshio::isSceneFile(file) || session::isRecordingByNameOrContent(file);
    });
}

SceneLoader::SceneLoader(QObject* parent)
    : QObject(parent)
    , m_maps(std::make_shared<Job>())
{
}

SceneLoader::~SceneLoader()
{
    finish();
    cancel();
    m_builders.clear();
    m_builders.waitForDone();
}

void SceneLoader::cancel()
{
    cancelOpening();
    m_maps->isCancelled = true;
    m_maps = std::make_shared<Job>(); // for subsequent requests
}

void SceneLoader::cancelOpening()
{
    if (m_job != nullptr) {
        m_job->isCancelled = true;
    }
}

void SceneLoader::finish()
{
    cancelOpening();
    if (m_worker.joinable()) {
        m_worker.join();
    }
    m_isBusy = false;
}

/// Opens files on the worker thread.
class SceneLoader::Opening
{
  public:
    /// @param open  structures of the scene to which the files are added; empty: a new scene
    Opening(SceneLoader& loader, std::vector<std::filesystem::path> files, const meshio::ReadOptions& options,
            std::vector<OpenSurface> open)
        : m_loader(loader)
        , m_job(loader.m_job)
        , m_read(loader.m_reader)
        , m_options(options)
        , m_files(std::move(files))
        , m_open(std::move(open))
    {
        m_opened->addedTo = m_open.size();
    }
    /// Reopens a scene from memory.
    Opening(SceneLoader& loader, std::vector<std::filesystem::path> files, meshio::SceneFile scene)
        : Opening(loader, {files.empty() ? std::filesystem::path() : files.front()}, meshio::ReadOptions(), {})
    {
        m_opened->files = std::move(files);
        m_opened->isReopened = true;
        m_read = [scene = std::move(scene)](const std::filesystem::path& path, const meshio::ReadOptions& how) {
            auto loaded = meshio::loadScene(scene, path, how);
            if (loaded.isOk()) {
                if (core::Status status = study::applyBuriedLumps(loaded.value(), how.progress); !status.isOk()) {
                    return core::Result<meshio::LoadedScene>(status);
                }
            }
            return loaded;
        };
    }

    void operator()()
    {
        QElapsedTimer timer;
        timer.start();
        for (std::size_t i = 0; i < m_files.size() && !m_job->isCancelled; ++i) {
            read(i);
        }
        dropCommonPrefix();
        emitSceneSize();
        prepare();
        m_opened->seconds = static_cast<double>(timer.elapsed()) * 1e-3;
        tell([&loader = m_loader, opened = m_opened, problems = m_problems, isCancelled = m_job->isCancelled.load()] {
            loader.m_isBusy = false;
            if (isCancelled) {
                Q_EMIT loader.structuresDropped();
                Q_EMIT loader.cancelled();
            } else if (opened->rows.empty()) {
                Q_EMIT loader.structuresDropped();
                Q_EMIT loader.failed(problems.isEmpty() ? tr("Nothing to open.") : problems.join(QLatin1Char('\n')));
            } else {
                opened->problems = problems;
                Q_EMIT loader.opened(opened);
            }
        });
    }

  private:
    /// Structures that are shown while files are being read.
    struct Previews
    {
        std::mutex mutex;
        std::map<std::shared_ptr<const geometry::RepairedMesh>, vtkSmartPointer<vtkPolyData>> pictures;
        std::vector<StructureRow> waiting; ///< not yet passed on
    };

    /// Runs a call on the GUI thread, unless another job has replaced this one.
    template<class Call>
    void tell(Call&& call)
    {
        QMetaObject::invokeMethod(
            &m_loader,
            [&loader = m_loader, job = m_job, call = std::forward<Call>(call)] {
                if (job == loader.m_job) {
                    call();
                }
            },
            Qt::QueuedConnection);
    }

    /// Reports progress in steps of 1 %, and each step of the work. Returns false when the job was cancelled.
    bool progress(const QString& what, double share)
    {
        if (share - m_lastTold >= 0.01 || share < m_lastTold || what != m_lastStep) {
            m_lastTold = share;
            m_lastStep = what;
            tell([&loader = m_loader, what, share] { Q_EMIT loader.progressed(what, share); });
        }
        return !m_job->isCancelled;
    }

    void read(std::size_t i)
    {
        const std::filesystem::path& file = m_files[i];
        const QString what = tr("Reading %1").arg(QString::fromStdString(file.filename().string()));
        const auto count = static_cast<double>(m_files.size());
        meshio::ReadOptions options = m_options;
        options.progress = [&](double share) {
            return progress(what, kReading * (static_cast<double>(i) + share) / count);
        };
        if (m_open.empty() && !m_opened->isReopened) {
            options.structureReady = [this](const meshio::LoadedStructure& one) { preview(one); };
        }
        progress(what, kReading * static_cast<double>(i) / count);
        auto loaded = m_read(file, options);
        if (loaded.isOk()) {
            add(std::move(loaded).value(), file);
        } else if (loaded.status().code() != core::StatusCode::Cancelled) {
            m_problems << translated(loaded.status());
        }
    }

    /// Makes the display mesh of a structure, and passes structures on in batches that grow with the number of those
    /// already passed, which bounds the time that drawing takes. On any thread.
    void preview(const meshio::LoadedStructure& one)
    {
        constexpr std::size_t kOldPerNew = 4;
        StructureRow row;
        row.loaded = one;
        row.picture = view::makeSurface(*one.surface);
        const std::scoped_lock lock(m_previews->mutex);
        std::vector<StructureRow>& waiting = m_previews->waiting;
        m_previews->pictures.emplace(one.surface, row.picture);
        waiting.push_back(std::move(row));
        if (waiting.size() * kOldPerNew < m_previews->pictures.size() - waiting.size()) {
            return;
        }
        tell([&loader = m_loader, rows = std::make_shared<std::vector<StructureRow>>(std::exchange(waiting, {}))] {
            Q_EMIT loader.structuresReady(rows);
        });
    }

    void add(meshio::LoadedScene part, const std::filesystem::path& file)
    {
        if (m_opened->rows.empty()) {
            m_opened->scene = part.scene;
        } else {
            join(part.scene, file);
        }
        if (!m_opened->isReopened) {
            m_opened->files.push_back(file);
        }
        for (meshio::LoadedStructure& one : part.structures) {
            m_opened->rows.emplace_back().loaded = std::move(one);
        }
        m_opened->unopened.insert(m_opened->unopened.end(), part.unopened.begin(), part.unopened.end());
        for (const core::Message& line : part.losses) {
            m_problems << translated(line);
        }
        for (const core::Message& line : part.warnings) {
            m_opened->warnings << translated(line);
        }
    }

    /// Merges a scene into the preceding ones. Only the first camera is kept.
    void join(const meshio::SceneFile& scene, const std::filesystem::path& file)
    {
        meshio::SceneFile& all = m_opened->scene;
        all.structures.insert(all.structures.end(), scene.structures.begin(), scene.structures.end());
        all.findings.insert(all.findings.end(), scene.findings.begin(), scene.findings.end());
        all.tapes.insert(all.tapes.end(), scene.tapes.begin(), scene.tapes.end());
        QStringList lost;
        if (scene.camera && all.camera) {
            lost << tr("view");
        } else if (scene.camera) {
            all.camera = scene.camera;
        }
        if (!scene.extra.empty() && !all.extra.empty()) {
            lost << tr("unknown fields");
        } else if (!scene.extra.empty()) {
            all.extra = scene.extra;
        }
        if (!lost.isEmpty()) {
            m_opened->warnings << tr("%1: opened together with another scene; not imported: %2")
                                      .arg(QString::fromStdString(file.filename().string()), lost.join(tr(", ")));
        }
    }

    /// Drops what programs write before the names of all files of a segmentation, as for a folder.
    void dropCommonPrefix()
    {
        std::vector<std::string> names;
        for (const StructureRow& row : m_opened->rows) {
            names.push_back(row.loaded.description.name);
        }
        if (m_files.size() < 2 || !m_opened->areMeshes() || m_files.size() != names.size()) {
            return; // structures with names of their own
        }
        const std::size_t prefix = meshio::commonPrefix(names).size();
        for (std::size_t i = 0; i < names.size(); ++i) {
            m_opened->rows[i].loaded.description.name = m_opened->scene.structures[i].name = names[i].substr(prefix);
        }
    }

    void emitSceneSize()
    {
        core::Box box;
        for (const StructureRow& row : m_opened->rows) {
            box.extend(row.loaded.surface->report.bounds);
        }
        const bool isOpenedAnew = m_opened->addedTo == 0 && !m_opened->isReopened;
        if (isOpenedAnew && !box.isEmpty() && !m_job->isCancelled) {
            tell([&loader = m_loader, size_mm = box.diagonal().norm()] { Q_EMIT loader.sizeKnown(size_mm); });
        }
    }

    /// Builds the display mesh and the haptic copy of each surface.
    void prepare()
    {
        double triangles = 0.0;
        for (const StructureRow& row : m_opened->rows) {
            triangles += static_cast<double>(row.loaded.surface->mesh.triangles.size());
        }
        double done = 0.0;
        for (StructureRow& row : m_opened->rows) {
            if (m_job->isCancelled) {
                break;
            }
            const auto made = m_previews->pictures.find(row.loaded.surface);
            row.picture = made != m_previews->pictures.end() ? made->second : view::makeSurface(*row.loaded.surface);
            if (row.loaded.description.palpable) {
                row.touch = study::indexed(*row.loaded.surface);
                row.sha256 = session::geometryHash(row.loaded.surface->mesh);
            }
            done += static_cast<double>(row.loaded.surface->mesh.triangles.size());
            progress(tr("Preparing for touch"), kReading + kPreparing * done / std::max(1.0, triangles));
        }
        progress(tr("Finding structures inside others"), kReading + kPreparing);
        nest();
        progress(tr("Drawing the scene"), 1.0);
    }

    /// Determines the containment of the structures.
    void nest()
    {
        if (m_job->isCancelled) {
            return;
        }
        std::vector<study::LayeredSurface> surfaces;
        for (const OpenSurface& one : m_open) {
            surfaces.push_back({one.surface.get(), one.touch.get()});
        }
        for (const StructureRow& row : m_opened->rows) {
            surfaces.push_back({row.loaded.surface.get(), row.touch.get()});
        }
        m_opened->layering = study::layering(surfaces);
        if (m_opened->areMeshes() && m_open.empty()) {
            sortByNesting();
        }
        for (std::size_t i = m_open.size(); i < surfaces.size(); ++i) {
            if (const std::optional<std::size_t> in = m_opened->layering.structures[i].in) {
                m_opened->rows[i - m_open.size()].in = in;
            }
        }
    }

    /// Sorts contained structures after their container and keeps the file order otherwise.
    void sortByNesting()
    {
        const std::vector<std::size_t> order = m_opened->layering.order();
        std::vector<StructureRow> rows;
        for (const std::size_t i : order) {
            rows.push_back(std::move(m_opened->rows[i]));
        }
        m_opened->rows = std::move(rows);
        m_opened->layering = m_opened->layering.inOrder(order);
    }

    SceneLoader& m_loader;
    std::shared_ptr<Job> m_job;
    Reader m_read;
    meshio::ReadOptions m_options;
    std::vector<std::filesystem::path> m_files; ///< files to open
    std::vector<OpenSurface> m_open;            ///< structures of the scene to which the files are added
    double m_lastTold = -1.0;
    QString m_lastStep;
    std::shared_ptr<OpenedScene> m_opened = std::make_shared<OpenedScene>();
    QStringList m_problems;
    std::shared_ptr<Previews> m_previews = std::make_shared<Previews>();
};

void SceneLoader::open(std::vector<std::filesystem::path> files, const meshio::ReadOptions& options)
{
    ++m_scene;
    begin();
    m_worker = std::thread(Opening(*this, std::move(files), options, {}));
}

void SceneLoader::add(std::vector<std::filesystem::path> files, double unit_mm, std::vector<OpenSurface> open)
{
    begin();
    meshio::ReadOptions options;
    options.unit_mm = unit_mm;
    m_worker = std::thread(Opening(*this, std::move(files), options, std::move(open)));
}

void SceneLoader::reopen(meshio::SceneFile scene, std::vector<std::filesystem::path> files)
{
    ++m_scene;
    begin();
    m_worker = std::thread(Opening(*this, std::move(files), std::move(scene)));
}

void SceneLoader::begin()
{
    finish();
    m_job = std::make_shared<Job>();
    m_isBusy = true;
    Q_EMIT structuresDropped();
}

void SceneLoader::buildTouch(int row, std::shared_ptr<const geometry::RepairedMesh> surface)
{
    m_builders.start([this, row, surface = std::move(surface), scene = m_scene] {
        auto touch = study::indexed(*surface);
        const QString hash = QString::fromStdString(session::geometryHash(surface->mesh));
        QMetaObject::invokeMethod(
            this,
            [this, row, touch, hash, scene] {
                if (scene == m_scene) { // the row belongs to the scene that is still open
                    Q_EMIT touchBuilt(row, touch, hash);
                }
            },
            Qt::QueuedConnection);
    });
}

void SceneLoader::buildSurface(int row, const meshio::LoadedStructure& structure)
{
    auto built = std::make_shared<StructureRow>();
    built->loaded = structure;
    m_builders.start([this, row, built, scene = m_scene] {
        meshio::LoadedStructure& one = built->loaded;
        meshio::ShapedSurface shaped = meshio::shapeSurface(one.asRead, one.description, one.staircase);
        one.surface = std::move(shaped.surface);
        one.staircase = shaped.staircase;
        one.closing = shaped.closing;
        one.smoothing = shaped.smoothing;
        one.curving = shaped.curving;
        std::vector<core::Message> warnings;
        meshio::resolveMaps(one, warnings, built->mapProblems);
        built->picture = view::makeSurface(*one.surface);
        if (one.description.palpable) {
            built->touch = study::indexed(*one.surface);
            built->sha256 = session::geometryHash(one.surface->mesh);
        }
        QMetaObject::invokeMethod(
            this,
            [this, row, built, scene] {
                if (scene == m_scene) {
                    Q_EMIT surfaceBuilt(row, built);
                }
            },
            Qt::QueuedConnection);
    });
}

void SceneLoader::findGaps(const std::vector<study::OpenStructure>& rows)
{
    struct Kept // keeps the data alive during the search
    {
        std::vector<std::shared_ptr<const geometry::RepairedMesh>> surfaces;
        std::vector<std::shared_ptr<const geometry::SurfaceIndex>> indices;
        std::vector<study::NeighbourSurface> neighbours;
    };
    auto kept = std::make_shared<Kept>();
    for (const study::OpenStructure& row : rows) {
        const bool counts = row.isListed() && study::canBeFelt(row.loaded.description) && !row.loaded.isTransmitted;
        kept->surfaces.push_back(row.loaded.surface);
        kept->indices.push_back(counts ? row.touch : nullptr);
        kept->neighbours.push_back({readableName(row.loaded.description.name).toStdString(),
                                    row.loaded.description.layer, kept->surfaces.back().get(),
                                    kept->indices.back().get(), study::pressStiffness(row.loaded.description.tissue)});
    }
    m_builders.start([this, kept, scene = m_scene] {
        QStringList lines;
        for (const core::Message& line : study::borderNotes(kept->neighbours)) {
            lines << translated(line);
        }
        QMetaObject::invokeMethod(
            this,
            [this, lines, scene] {
                if (scene == m_scene) {
                    Q_EMIT notesFound(lines);
                }
            },
            Qt::QueuedConnection);
    });
}

void SceneLoader::buildMaps(int row, const meshio::LoadedStructure& structure)
{
    ++m_mapJobs;
    m_builders.start([this, row, made = std::make_shared<meshio::LoadedStructure>(structure), scene = m_scene,
                      job = m_maps] {
        std::vector<core::Message> warnings, problems;
        meshio::resolveMaps(*made, warnings, problems, [&job] { return !job->isCancelled; });
        QMetaObject::invokeMethod(
            this,
            [this, row, made, problems, scene, job]() mutable {
                --m_mapJobs;
                // Results completed before the cancellation are discarded too.
                if (job->isCancelled && problems.empty()) {
                    for (const meshio::SurfaceMap& map : made->maps) {
                        problems.push_back(core::Message(PALPATE_TEXT("%1: reading was cancelled"), map.mapping.file));
                    }
                    made->maps.clear();
                }
                if (scene == m_scene) {
                    Q_EMIT mapsBuilt(row, made, problems);
                }
            },
            Qt::QueuedConnection);
    });
}

} // namespace palpate::ui

#include "palpate/ui/moc_SceneLoader.cpp"

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/meshio/LoadScene.h"
#include "palpate/meshio/MeshFormats.h"
#include "palpate/meshio/SurfaceMaps.h"

#include "scene/AnatomyColours.h"
#include "text/Fault.h"

#include <palpate/core/Parallel.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <new>
#include <set>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>

namespace palpate::meshio {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;
using namespace internal;

constexpr double kFilesShare = 0.7; ///< share of the progress for reading files; the rest is repair

/// A mesh file that the scene needs, read once.
struct Source
{
    std::filesystem::path path;
    double unit_mm = 1.0;
    FileFrame frame = FileFrame::Untagged; ///< chosen
    std::optional<Result<MeshFile>> file;
};

/// A structure while the scene is being loaded.
struct Pending
{
    SceneStructure description;
    FileFrame frame = FileFrame::Untagged;
    geometry::TriangleMesh mesh;
    std::optional<geometry::Staircase> voxels; ///< of a label map
    std::shared_ptr<const geometry::RepairedMesh> asRead;
    ShapedSurface shaped;
};

constexpr const char* kUnknownField = ": this version does not know this field; it is kept, but not used";

class Loader
{
  public:
    explicit Loader(const ReadOptions& options)
        : m_options(options)
    {
    }

    Result<LoadedScene> load(const std::filesystem::path& path);
    Result<LoadedScene> load(SceneFile scene, const std::string& name);

  private:
    Status addScene(const std::filesystem::path& path);
    Status addScene(SceneFile scene, const std::string& name);
    Result<LoadedScene> open(const std::string& name);
    Status addFolder(const std::filesystem::path& path);
    std::size_t sourceOf(const std::filesystem::path& path, double unit_mm, FileFrame frame);
    std::size_t sourceOf(const SceneStructure& one) { return sourceOf(one.mesh, one.unit_mm, one.frame); }
    void readSources();
    void expandFiles();
    void findChanged();
    void expandScene();
    void lose(const std::string& line) { m_scene.losses.push_back(line); }
    void repairAll();
    void noteSurface(const Pending& pending);
    void collect();
    void noteFrames();
    void noteUnit();

    const ReadOptions& m_options;
    bool m_isSceneFile = false;
    bool m_isFolder = false;
    std::vector<Source> m_sources;
    std::map<std::tuple<std::filesystem::path, double, FileFrame>, std::size_t> m_sourceOf;
    std::vector<Pending> m_pending;
    std::atomic<bool> m_isCancelled{false};
    Status m_firstFailure;
    LoadedScene m_scene;
};

std::size_t Loader::sourceOf(const std::filesystem::path& path, double unit_mm, FileFrame frame)
{
    const auto [found, isNew] = m_sourceOf.emplace(std::tuple(path, unit_mm, frame), m_sources.size());
    if (isNew) {
        m_sources.push_back({path, unit_mm, frame, std::nullopt});
    }
    return found->second;
}

Status Loader::addScene(const std::filesystem::path& path)
{
    Result<SceneFile> scene = readScene(path);
    return scene.isOk() ? addScene(std::move(scene).value(), path.filename().string()) : scene.status();
}

Status Loader::addScene(SceneFile scene, const std::string& name)
{
    if (scene.structures.empty()) {
        return fault(StatusCode::Empty, name, "structures", "none", "at least one");
    }
    m_scene.scene = std::move(scene);
    for (const std::string& field : unknownFields(m_scene.scene)) {
        m_scene.warnings.push_back(name + ": " + field + kUnknownField);
    }
    for (SceneStructure& structure : m_scene.scene.structures) {
        if (structure.frame == FileFrame::Untagged) {
            structure.frame = m_options.frame;
        } else if (m_options.frame != FileFrame::Untagged && structure.frame != m_options.frame) {
            m_scene.warnings.push_back(structure.name + ": taken as " + std::string(core::axesOf(structure.frame)) +
                                       ", as the scene file says; not as " +
                                       std::string(core::axesOf(m_options.frame)));
        }
        (void)sourceOf(structure);
    }
    m_isSceneFile = true;
    return {};
}

Status Loader::addFolder(const std::filesystem::path& path)
{
    std::error_code error;
    std::vector<std::filesystem::path> files;
    for (std::filesystem::directory_iterator entry(path, error), end; !error && entry != end; entry.increment(error)) {
        if (hasMeshExtension(entry->path()) && entry->is_regular_file(error)) {
            files.push_back(entry->path());
        }
    }
    const std::string name = path.filename().empty() ? path.string() : path.filename().string();
    if (error) {
        return fault(StatusCode::Unreadable, name, "", "the folder cannot be read: " + error.message(),
                     "a folder of meshes");
    }
    if (files.empty()) {
        return fault(StatusCode::Empty, name, "", "a folder without mesh files",
                     meshFormatNames("or") + " files in it");
    }
    std::sort(files.begin(), files.end());
    m_isFolder = true;
    for (const std::filesystem::path& file : files) {
        (void)sourceOf(file, m_options.unit_mm, m_options.frame);
    }
    return {};
}

void Loader::readSources()
{
    constexpr unsigned kMostAtOnce = 8; // each file is read in a separate process with separate memory
    std::atomic<std::size_t> done{0};
    const auto count = static_cast<double>(m_sources.size());
    const auto read = [&](std::size_t i, unsigned thread) {
        Source& source = m_sources[i];
        ReadOptions options;
        options.unit_mm = source.unit_mm;
        options.frame = source.frame;
        options.readsScale = m_options.readsScale && !m_isSceneFile;
        options.isPartial = m_options.isPartial;
        // The caller's function is called on the caller's thread only.
        options.progress = [&, isCaller = thread == 0](double share) {
            if (isCaller && m_options.progress &&
                !m_options.progress(kFilesShare * (static_cast<double>(done.load()) + share) / count)) {
                m_isCancelled = true;
            }
            return !m_isCancelled.load();
        };
        if (m_isCancelled) {
            source.file =
                Status(StatusCode::Cancelled, PALPATE_TEXT("%1: reading was cancelled"), source.path.filename());
        } else {
            source.file = readMesh(source.path, options);
        }
        ++done;
    };
    core::parallelFor(m_sources.size(), read, std::min(kMostAtOnce, core::coreCount()));
}

/// Mesh files without a scene: all structures, unchanged.
void Loader::expandFiles()
{
    for (Source& source : m_sources) {
        if (!source.file->isOk()) {
            continue;
        }
        MeshFile& file = source.file->value();
        for (MeshStructure& structure : file.structures) {
            Pending& pending = m_pending.emplace_back();
            SceneStructure& d = pending.description;
            d.mesh = source.path;
            d.part = file.structures.size() > 1 ? structure.name : std::string();
            d.unit_mm = file.unit_mm;
            d.frame = source.frame;
            d.name = structure.name;
            d.colour = structure.colour.value_or(anatomyColour(structure.name, m_pending.size() - 1));
            if (file.voxels) {
                d.surface = SurfaceKind::Smoothed;
                d.smoothing = kLabelSmoothing;
            }
            pending.frame = file.frame;
            pending.voxels = file.voxels;
            pending.mesh = std::move(structure.mesh);
        }
    }
}

/// Reports each mesh file that has changed since the scene was saved.
void Loader::findChanged()
{
    std::set<std::filesystem::path> seen;
    for (const SceneStructure& wanted : m_scene.scene.structures) {
        const Source& source = m_sources[sourceOf(wanted)];
        if (wanted.sha256.empty() || !source.file->isOk() || !seen.insert(wanted.mesh).second) {
            continue;
        }
        if (const std::string found = fileHash(wanted.mesh); found != wanted.sha256) {
            constexpr std::size_t kShown = 12;
            lose(wanted.mesh.filename().string() + ": changed since the scene was saved: found SHA-256 " +
                 found.substr(0, kShown) + "..., expected " + wanted.sha256.substr(0, kShown) +
                 "...; opened as it is now");
        }
    }
}

/// Creates the structures of a scene file: the named part, or all parts of the mesh file.
void Loader::expandScene()
{
    for (const SceneStructure& wanted : m_scene.scene.structures) {
        const Source& source = m_sources[sourceOf(wanted)];
        if (!source.file->isOk()) {
            m_scene.unopened.push_back(wanted);
            continue;
        }
        const MeshFile& file = source.file->value();
        bool isFound = false;
        for (const MeshStructure& structure : file.structures) {
            if (!wanted.part.empty() && structure.name != wanted.part) {
                continue;
            }
            isFound = true;
            Pending& pending = m_pending.emplace_back();
            pending.description = wanted;
            if (file.structures.size() > 1 && wanted.part.empty()) {
                pending.description.part = structure.name;
                pending.description.name = structure.name;
            }
            pending.frame = file.frame;
            pending.voxels = file.voxels;
            pending.mesh = structure.mesh;
        }
        if (!isFound) {
            m_scene.unopened.push_back(wanted);
            lose(fault(StatusCode::NotFound, source.path.filename().string(), "",
                       "no structure " + inQuotes(wanted.part), "one of that name")
                     .message());
        }
    }
}

void Loader::repairAll()
{
    std::atomic<std::size_t> done{0};
    core::parallelFor(m_pending.size(), [&](std::size_t i, unsigned thread) {
        if (m_isCancelled) {
            return;
        }
        Pending& pending = m_pending[i];
        for (core::Vec3& p : pending.mesh.vertices) {
            p = pending.description.X_WM * p;
        }
        if (pending.description.flipped) {
            geometry::flip(pending.mesh);
        }
        pending.asRead = std::make_shared<const geometry::RepairedMesh>(geometry::repair(pending.mesh));
        pending.mesh = {};
        if (m_options.turnsOutwards) {
            pending.description.outwards = true;
        }
        if (m_options.isSmoothed) {
            pending.description.surface = SurfaceKind::Smoothed;
        }
        if (m_options.smoothing && pending.description.surface == SurfaceKind::Smoothed) {
            pending.description.smoothing = *m_options.smoothing;
            pending.description.surface = *m_options.smoothing > 0.0 ? SurfaceKind::Smoothed : SurfaceKind::Facets;
        }
        if (pending.voxels) {
            pending.voxels->axes = pending.description.X_WM.linear() * pending.voxels->axes;
        }
        pending.shaped = shapeSurface(pending.asRead, pending.description, pending.voxels);
        const double share = static_cast<double>(++done) / static_cast<double>(m_pending.size());
        if (thread == 0 && m_options.progress && !m_options.progress(kFilesShare + (1.0 - kFilesShare) * share)) {
            m_isCancelled = true;
        }
    });
}

void Loader::noteSurface(const Pending& pending)
{
    const std::string name = pending.description.name + ": ";
    for (const std::string& sentence : pending.shaped.surface->report.sentences()) {
        m_scene.warnings.push_back(name + sentence);
    }
    for (const std::string& sentence : shapeSentences(pending.shaped.staircase, pending.shaped.smoothing)) {
        m_scene.warnings.push_back(name + sentence);
    }
    if (pending.description.surface == SurfaceKind::Smooth) {
        m_scene.warnings.push_back(name + "surface \"smooth\": curved facets are not available in this version; "
                                          "felt and drawn as facets");
    }
}

void Loader::collect()
{
    m_scene.scene.structures.clear();
    for (Pending& pending : m_pending) {
        const std::string& name = pending.description.name;
        if (pending.shaped.surface->mesh.triangles.empty()) {
            lose(name + ": none of " + counted(pending.asRead->report.inputTriangles, "triangle") +
                 " has an area; expected at least one");
            continue;
        }
        noteSurface(pending);
        m_scene.scene.structures.push_back(pending.description);
        LoadedStructure& loaded = m_scene.structures.emplace_back();
        loaded.description = std::move(pending.description);
        loaded.frame = pending.frame;
        loaded.surface = std::move(pending.shaped.surface);
        loaded.asRead = std::move(pending.asRead);
        loaded.staircase = pending.shaped.staircase;
        loaded.smoothing = pending.shaped.smoothing;
        resolveMaps(m_scene.structures.back(), m_scene.warnings, m_scene.losses, [this] {
            m_isCancelled = m_isCancelled || (m_options.progress && !m_options.progress(1.0));
            return !m_isCancelled;
        });
    }
}

void Loader::noteFrames()
{
    std::vector<std::string> untagged;
    for (const Source& source : m_sources) {
        if (!source.file->isOk()) {
            continue;
        }
        const MeshFile& file = source.file->value();
        const std::string name = source.path.filename().string();
        for (const std::string& note : file.notes) {
            m_scene.warnings.push_back(name + ": " + note);
        }
        if (source.frame != FileFrame::Untagged) {
            if (file.frame != FileFrame::Untagged && file.frame != source.frame) {
                m_scene.warnings.push_back(name + ": tagged SPACE=" + std::string(core::axesOf(file.frame)) +
                                           ", but taken as " + std::string(core::axesOf(source.frame)) +
                                           ", as was chosen");
            }
        } else if (file.frame == FileFrame::Untagged) {
            untagged.push_back(name);
        } else if (file.frame == FileFrame::Ras) {
            m_scene.warnings.push_back(name + ": tagged SPACE=RAS: x and y negated to get LPS");
        }
    }
    if (!untagged.empty()) {
        const std::string more =
            untagged.size() > 1 ? " and " + counted(untagged.size() - 1, "more file") : std::string();
        m_scene.warnings.push_back(untagged.front() + more + ": no SPACE tag: coordinates taken as LPS");
    }
}

void Loader::noteUnit()
{
    constexpr double kSmallest_mm = 2.0; // an organ this wide would be very small
    constexpr double kLargest_mm = 5000.0;
    if (m_isSceneFile || m_scene.structures.empty()) {
        return;
    }
    geometry::Box box;
    for (const LoadedStructure& structure : m_scene.structures) {
        box.extend(structure.surface->report.bounds);
    }
    const double units = box.sizes().maxCoeff() / m_options.unit_mm;
    const auto isLikely = [units](double unit_mm) {
        return units * unit_mm >= kSmallest_mm && units * unit_mm <= kLargest_mm;
    };
    if (isLikely(m_options.unit_mm)) {
        return;
    }
    const auto take = [this, units](double unit_mm, std::string_view taken, std::string_view likely,
                                    std::string_view option) {
        std::array<char, 32> text = {};
        std::snprintf(text.data(), text.size(), "%.3g", units);
        m_scene.likelyUnit_mm = unit_mm;
        m_scene.warnings.push_back(m_sources.front().path.filename().string() + ": " +
                                   (unit_mm > m_options.unit_mm ? "only " : "") + text.data() +
                                   " units wide, taken as " + std::string(taken) + "; looks like " +
                                   std::string(likely) + ": open with --unit " + std::string(option));
    };
    if (m_options.unit_mm == 1.0 && isLikely(1000.0)) {
        take(1000.0, "mm", "metres", "m");
    } else if (m_options.unit_mm != 1.0 && isLikely(1.0)) {
        take(1.0, m_options.unit_mm == 1000.0 ? "metres" : "larger ones", "millimetres", "mm");
    }
}

Result<LoadedScene> Loader::load(const std::filesystem::path& path)
{
    const std::filesystem::path whole = std::filesystem::absolute(path).lexically_normal();
    std::error_code error;
    Status status;
    if (std::filesystem::is_directory(whole, error)) {
        status = addFolder(whole.has_filename() ? whole : whole.parent_path());
    } else if (isSceneFile(whole)) {
        status = addScene(whole);
    } else {
        (void)sourceOf(whole, m_options.unit_mm, m_options.frame);
    }
    return status.isOk() ? open(path.filename().string()) : status;
}

Result<LoadedScene> Loader::load(SceneFile scene, const std::string& name)
{
    const Status status = addScene(std::move(scene), name);
    return status.isOk() ? open(name) : status;
}

/// Reads and repairs the added files.
Result<LoadedScene> Loader::open(const std::string& name)
{
    readSources();
    const Status cancelled(StatusCode::Cancelled, PALPATE_TEXT("%1: opening was cancelled"), name);
    if (m_isCancelled) {
        return cancelled;
    }
    for (const Source& source : m_sources) {
        if (m_isFolder && !source.file->isOk() && source.file->status().code() == StatusCode::Unsupported &&
            hasLabelMapExtension(source.path)) { // an image beside the structures
            m_scene.warnings.push_back("left out: " + source.file->status().message());
            m_firstFailure = m_firstFailure.isOk() ? source.file->status() : m_firstFailure;
        } else if (!source.file->isOk()) {
            lose(source.file->status().message());
            m_firstFailure = m_firstFailure.isOk() ? source.file->status() : m_firstFailure;
        } else if (!source.file->value().loss.empty()) {
            lose(source.file->value().loss);
        }
    }
    if (m_isSceneFile) {
        findChanged();
        expandScene();
    } else {
        expandFiles();
    }
    repairAll();
    if (m_isCancelled) {
        return cancelled;
    }
    collect();
    if (m_isCancelled) {
        return cancelled;
    }
    if (m_scene.structures.empty()) {
        return !m_firstFailure.isOk() ? m_firstFailure
                                      : Status(StatusCode::Empty, name + ": " + m_scene.losses.front());
    }
    noteFrames();
    noteUnit();
    return std::move(m_scene);
}

/// Converts an allocation failure to a message.
template<class Load>
Result<LoadedScene> guarded(const std::string& name, Load&& load)
{
    try {
        return load();
    } catch (const std::bad_alloc&) {
        return fault(StatusCode::OutOfRange, name, "", "not enough memory to open it", "a scene that fits");
    }
}

} // namespace

core::Result<LoadedScene> loadScene(const std::filesystem::path& path, const ReadOptions& options)
{
    return guarded(path.filename().string(), [&] { return Loader(options).load(path); });
}

core::Result<LoadedScene> loadScene(SceneFile scene, const std::filesystem::path& path, const ReadOptions& options)
{
    const std::string name = path.filename().string();
    return guarded(name, [&] { return Loader(options).load(std::move(scene), name); });
}

std::array<double, 3> defaultColour(const std::string& name, std::size_t number)
{
    return anatomyColour(name, number);
}

} // namespace palpate::meshio

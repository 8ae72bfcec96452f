// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/meshio/LoadScene.h"
#include "palpate/meshio/MeshFolder.h"
#include "palpate/meshio/MeshFormats.h"
#include "palpate/meshio/SurfaceMaps.h"

#include "scene/AnatomyColours.h"
#include "scene/BlockFile.h"
#include "text/Encoding.h"
#include "text/Fault.h"
#include "text/FileStem.h"

#include <palpate/core/Parallel.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <new>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <tuple>
#include <type_traits>
#include <utility>

namespace palpate::meshio {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;
using namespace internal;

constexpr double kFilesShare = 0.7; ///< share of the progress for reading files; the rest is repair

/// A structure while the scene is being loaded.
struct Pending
{
    SceneStructure description;
    std::string format;
    FileFrame frame = FileFrame::Untagged;
    geometry::TriangleMesh mesh;
    std::optional<geometry::Staircase> voxels;            ///< of a label map
    std::shared_ptr<const geometry::RepairedMesh> asRead; ///< null until shaped
    ShapedSurface shaped;
};

/// A mesh file that the scene needs, read once.
struct Source
{
    std::filesystem::path path;
    double unit_mm = 1.0;
    FileFrame frame = FileFrame::Untagged; ///< chosen
    std::optional<Result<MeshFile>> file;
    std::optional<Block> block{}; ///< in a file that names this one
    std::vector<Pending> early{}; ///< the first structures, shaped while files were being read
};

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
    Status addBlocks(const std::filesystem::path& path);
    [[nodiscard]] std::string displayName(const Source& source, const std::string& name, std::size_t structures) const;
    std::size_t sourceOf(const std::filesystem::path& path, double unit_mm, FileFrame frame);
    std::size_t sourceOf(const SceneStructure& one) { return sourceOf(one.mesh, one.unit_mm, one.frame); }
    void readSources();
    [[nodiscard]] Pending pendingOf(const Source& source, MeshFile& file, std::size_t structure) const;
    void name(Pending& pending, const Source& source, const MeshFile& file, std::size_t structure,
              std::size_t number) const;
    void shapeEarly(Source& source, MeshFile& file, std::size_t structures);
    void shape(Pending& pending) const;
    void announce(const Pending& pending) const;
    void expandFiles();
    void findChanged();
    void expandScene();
    void lose(const core::Message& line) { m_scene.losses.push_back(line); }
    template<class... Arguments>
    void warn(core::MessageText<std::type_identity_t<Arguments>...> text, const Arguments&... arguments)
    {
        m_scene.warnings.emplace_back(text, arguments...);
    }
    void repairAll();
    void noteSurface(const Pending& pending);
    void collect();
    [[nodiscard]] Status addMotions(const std::string& name);
    void noteMotion(const LoadedStructure& one);
    void noteFrames();
    void noteUnit();

    const ReadOptions& m_options;
    bool m_isSceneFile = false;
    std::string m_prefix; ///< before the names of all files of a folder; not shown
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
        return fault(StatusCode::Empty, name, {PALPATE_TEXT("%1"), "structures"}, {PALPATE_TEXT("none")},
                     {PALPATE_TEXT("at least one")});
    }
    m_scene.scene = std::move(scene);
    for (const std::string& field : unknownFields(m_scene.scene)) {
        warn(PALPATE_TEXT("%1: %2: this version does not know this field; it is kept, but not used"), name, field);
    }
    for (SceneStructure& structure : m_scene.scene.structures) {
        if (structure.frame == FileFrame::Untagged) {
            structure.frame = m_options.frame;
        } else if (m_options.frame != FileFrame::Untagged && structure.frame != m_options.frame) {
            warn(PALPATE_TEXT("%1: taken as %2, as the scene file says; not as %3"), structure.name,
                 core::axesOf(structure.frame), core::axesOf(m_options.frame));
        }
        (void)sourceOf(structure);
    }
    m_isSceneFile = true;
    return {};
}

Status Loader::addFolder(const std::filesystem::path& path)
{
    std::error_code error;
    const std::vector<std::filesystem::path> files = meshFilesIn(path, error);
    const std::string name = path.filename().empty() ? path.string() : path.filename().string();
    if (error) {
        return fault(StatusCode::Unreadable, name, {},
                     {PALPATE_TEXT("the folder cannot be read: %1"), core::systemError(error.value())},
                     {PALPATE_TEXT("a folder of meshes")});
    }
    if (files.empty()) {
        return fault(StatusCode::Empty, name, {}, {PALPATE_TEXT("a folder without mesh files")},
                     {PALPATE_TEXT("%1 files in it"), meshFormatNames("or")});
    }
    std::vector<std::string> stems;
    m_isFolder = true;
    for (const std::filesystem::path& file : files) {
        (void)sourceOf(file, m_options.unit_mm, m_options.frame);
        stems.push_back(utf8Of(fileStem(file)));
    }
    m_prefix = commonPrefix(stems);
    return {};
}

/// Adds the files that a multi-block file names.
Status Loader::addBlocks(const std::filesystem::path& path)
{
    Result<Blocks> blocks = readBlocks(path);
    if (!blocks.isOk()) {
        return blocks.status();
    }
    for (const core::Message& loss : blocks.value().losses) {
        lose(loss);
    }
    for (Block& block : blocks.value().blocks) {
        block.name = utf8Of(block.name);
        const FileFrame frame = m_options.frame == FileFrame::Untagged ? block.frame : m_options.frame;
        m_sources[sourceOf(block.file, m_options.unit_mm * block.unit_mm, frame)].block = std::move(block);
    }
    return {};
}

/// @return the name of a structure, whose file may have a name in a multi-block file or a prefix in front of its own
std::string Loader::displayName(const Source& source, const std::string& name, std::size_t structures) const
{
    const bool isOfFile = structures == 1 && name == utf8Of(fileStem(source.path));
    if (isOfFile && source.block && !source.block->name.empty()) {
        return source.block->name;
    }
    return isOfFile && name.starts_with(m_prefix) ? name.substr(m_prefix.size()) : name;
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
        if (!m_isSceneFile) {
            options.structureRead = [&](MeshFile& file) { shapeEarly(source, file, file.structures.size()); };
        }
        if (m_isCancelled) {
            source.file =
                Status(StatusCode::Cancelled, PALPATE_TEXT("%1: reading was cancelled"), source.path.filename());
        } else {
            source.file = readMesh(source.path, options);
        }
        // Of many structures in one file, each is shaped on any thread later.
        if (!m_isSceneFile && m_sources.size() > 1 && source.file->isOk() &&
            source.file->value().structures.size() == 1) {
            shapeEarly(source, source.file->value(), 1);
        }
        ++done;
    };
    core::parallelFor(m_sources.size(), read, std::min(kMostAtOnce, core::coreCount()));
}

/// @return a structure of a mesh file without a scene, unchanged and without a name; takes the mesh
Pending Loader::pendingOf(const Source& source, MeshFile& file, std::size_t structure) const
{
    Pending pending;
    SceneStructure& d = pending.description;
    d.mesh = source.path;
    d.unit_mm = file.unit_mm;
    d.frame = source.frame;
    d.opacity = file.structures[structure].opacity;
    if (source.block) {
        d.opacity *= source.block->opacity;
        d.visible = source.block->isVisible;
        d.X_WM = source.block->X_WM;
    }
    if (file.voxels) {
        d.surface = SurfaceKind::Smoothed;
        d.smoothing = kLabelSmoothing;
    }
    pending.format = file.format;
    pending.frame = file.frame;
    pending.voxels = file.voxels;
    pending.mesh = std::move(file.structures[structure].mesh);
    return pending;
}

/// Sets name and colour. @param number  of the structure in the scene
void Loader::name(Pending& pending, const Source& source, const MeshFile& file, std::size_t structure,
                  std::size_t number) const
{
    const MeshStructure& from = file.structures[structure];
    SceneStructure& d = pending.description;
    d.part = file.structures.size() > 1 ? from.name : std::string();
    d.name = displayName(source, from.name, file.structures.size());
    d.colour = from.colour.value_or(anatomyColour(d.name, number));
    if (source.block) {
        d.colour = source.block->colour.value_or(d.colour);
    }
}

/// Shapes the structures of a file that are not yet shaped, up to the given number.
void Loader::shapeEarly(Source& source, MeshFile& file, std::size_t structures)
{
    while (source.early.size() < structures && !m_isCancelled) {
        const std::size_t i = source.early.size();
        Pending& pending = source.early.emplace_back(pendingOf(source, file, i));
        name(pending, source, file, i, static_cast<std::size_t>(&source - m_sources.data()) + i);
        shape(pending);
        announce(pending);
    }
}

/// Mesh files without a scene: all structures, unchanged.
void Loader::expandFiles()
{
    for (Source& source : m_sources) {
        if (!source.file->isOk()) {
            continue;
        }
        MeshFile& file = source.file->value();
        for (std::size_t i = 0; i < file.structures.size(); ++i) {
            m_pending.push_back(i < source.early.size() ? std::move(source.early[i]) : pendingOf(source, file, i));
            name(m_pending.back(), source, file, i, m_pending.size() - 1);
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
            lose({PALPATE_TEXT(
                      "%1: changed since the scene was saved: found SHA-256 %2..., expected %3...; opened as it "
                      "is now"),
                  wanted.mesh.filename(), found.substr(0, kShown), wanted.sha256.substr(0, kShown)});
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
            pending.format = file.format;
            pending.frame = file.frame;
            pending.voxels = file.voxels;
            pending.mesh = structure.mesh;
        }
        if (!isFound) {
            m_scene.unopened.push_back(wanted);
            lose(fault(StatusCode::NotFound, source.path.filename().string(), {},
                       {PALPATE_TEXT("no structure %1"), inQuotes(wanted.part)}, {PALPATE_TEXT("one of that name")})
                     .text());
        }
    }
}

/// Repairs the mesh of a structure, and turns, closes and smooths its surface as described.
void Loader::shape(Pending& pending) const
{
    for (core::Vec3& p : pending.mesh.vertices) {
        p = pending.description.X_WM * p;
    }
    if (pending.description.flipped) {
        geometry::flip(pending.mesh);
    }
    pending.asRead =
        std::make_shared<const geometry::RepairedMesh>(geometry::repair(pending.mesh, geometry::Facing::AsGiven));
    pending.mesh = {};
    if (m_options.turnsOutwards) {
        pending.description.outwards = true;
    }
    if (m_options.closeHoles_mm > 0.0) {
        pending.description.closeHoles_mm = m_options.closeHoles_mm;
    }
    if (m_options.isSmoothed || m_options.isCurved) {
        pending.description.surface = surfaceKind(m_options.isSmoothed || isSmoothed(pending.description.surface),
                                                  m_options.isCurved || isCurved(pending.description.surface));
    }
    if (m_options.smoothing && isSmoothed(pending.description.surface)) {
        pending.description.smoothing = *m_options.smoothing;
        pending.description.surface = surfaceKind(*m_options.smoothing > 0.0, isCurved(pending.description.surface));
    }
    if (pending.voxels) {
        pending.voxels->axes = pending.description.X_WM.linear() * pending.voxels->axes;
    }
    pending.shaped = shapeSurface(pending.asRead, pending.description, pending.voxels);
}

/// Shows a shaped structure to the caller.
void Loader::announce(const Pending& pending) const
{
    if (m_options.structureReady && !pending.shaped.surface->mesh.triangles.empty()) {
        LoadedStructure one;
        one.description = pending.description;
        one.surface = pending.shaped.surface;
        m_options.structureReady(one);
    }
}

void Loader::repairAll()
{
    std::atomic<std::size_t> done{0};
    core::parallelFor(m_pending.size(), [&](std::size_t i, unsigned thread) {
        if (m_isCancelled) {
            return;
        }
        if (m_pending[i].asRead == nullptr) {
            shape(m_pending[i]);
            announce(m_pending[i]);
        }
        const double share = static_cast<double>(++done) / static_cast<double>(m_pending.size());
        if (thread == 0 && m_options.progress && !m_options.progress(kFilesShare + (1.0 - kFilesShare) * share)) {
            m_isCancelled = true;
        }
    });
}

void Loader::noteSurface(const Pending& pending)
{
    const std::string& name = pending.description.name;
    for (const core::Message& sentence : pending.shaped.surface->report.sentences()) {
        warn(PALPATE_TEXT("%1: %2"), name, sentence);
    }
    for (const core::Message& sentence : shapeSentences(pending.shaped.staircase, pending.shaped.smoothing)) {
        warn(PALPATE_TEXT("%1: %2"), name, sentence);
    }
    if (pending.shaped.closing) {
        warn(PALPATE_TEXT("%1: %2"), name, pending.shaped.closing->message());
    }
    if (pending.shaped.curving) {
        const SurfaceCurving& curving = *pending.shaped.curving;
        (curving.isRefused ? m_scene.losses : m_scene.warnings)
            .push_back(core::Message(PALPATE_TEXT("%1: %2"), name, curving.message()));
    }
}

void Loader::collect()
{
    m_scene.scene.structures.clear();
    for (Pending& pending : m_pending) {
        const std::string& name = pending.description.name;
        if (pending.shaped.surface->mesh.triangles.empty()) {
            lose({PALPATE_TEXT(
                      "%1: all triangles have zero area (number of triangles: %2); expected at least one with an "
                      "area"),
                  name, Count(pending.asRead->report.inputTriangles)});
            continue;
        }
        noteSurface(pending);
        m_scene.scene.structures.push_back(pending.description);
        LoadedStructure& loaded = m_scene.structures.emplace_back();
        loaded.description = std::move(pending.description);
        loaded.format = std::move(pending.format);
        loaded.frame = pending.frame;
        loaded.surface = std::move(pending.shaped.surface);
        loaded.asRead = std::move(pending.asRead);
        loaded.staircase = pending.shaped.staircase;
        loaded.closing = pending.shaped.closing;
        loaded.smoothing = pending.shaped.smoothing;
        loaded.curving = pending.shaped.curving;
        resolveMaps(m_scene.structures.back(), m_scene.warnings, m_scene.losses, [this] {
            m_isCancelled = m_isCancelled || (m_options.progress && !m_options.progress(1.0));
            return !m_isCancelled;
        });
    }
}

void Loader::noteMotion(const LoadedStructure& one)
{
    const SceneStructure& described = one.description;
    if (described.motion && described.motion->kind == MotionKind::Poses) {
        warn(PALPATE_TEXT("%1: moves along the poses of %2"), described.name,
             described.motion->files.front().filename());
    } else if (described.motion) {
        warn(PALPATE_TEXT("%1: moves by up to %2 mm in a period of %3 s, with a strain of up to %4 %"), described.name,
             core::Rounded{one.motion->reach_mm(), 3}, core::Rounded{described.motion->period_s, 3},
             core::Rounded{100.0 * one.motion->strain(), 3});
    }
    if (described.pulse) {
        warn(PALPATE_TEXT("%1: its force pulses by %2 % in a period of %3 s"), described.name,
             core::Rounded{100.0 * described.pulse->share, 3}, core::Rounded{described.pulse->period_s, 3});
    }
}

/// Makes the motions. Structures with equal breaths, poses or fields share one, so that one god-object can feel them.
Status Loader::addMotions(const std::string& name)
{
    std::vector<LoadedStructure>& all = m_scene.structures;
    const auto isAlike = [](const SceneStructure& a, const SceneStructure& b) {
        const auto isOf = [&a](MotionKind kind) { return a.motion && a.motion->kind == kind; };
        return a.motion == b.motion && a.pulse == b.pulse && !isOf(MotionKind::Frames) &&
               (!isOf(MotionKind::Field) || a.frame == b.frame); // the axes of a field that states none
    };
    std::set<std::pair<std::uint32_t, const geometry::SurfaceMotion*>> layers;
    bool isMoving = false;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const SceneStructure& one = all[i].description;
        MotionSubject subject{{}, one.mesh, one.part, one.unit_mm, one.frame, one.X_WM, {}};
        for (std::size_t j = 0; j < all.size(); ++j) {
            if (j == i || isAlike(one, all[j].description)) {
                subject.bounds.extend(all[j].surface->report.bounds);
                subject.surfaces.emplace_back(all[j].surface->mesh.vertices);
            }
            if (j < i && isAlike(one, all[j].description)) {
                all[i].motion = all[j].motion;
            }
        }
        if (all[i].motion == nullptr && (one.motion || one.pulse)) {
            auto made = makeMotion(one.motion ? &*one.motion : nullptr, one.pulse ? &*one.pulse : nullptr, subject);
            if (!made.isOk()) {
                return made.status().at(one.name).at(name);
            }
            all[i].motion = std::move(made).value();
        }
        noteMotion(all[i]);
        isMoving = isMoving || all[i].motion != nullptr;
        if (one.palpable && (one.visible || one.isHiddenTarget)) {
            layers.emplace(one.layer, all[i].motion.get());
        }
    }
    constexpr std::size_t kMostLayers = 4; // haptics::kMaxLayers
    if (isMoving && layers.size() > kMostLayers) {
        return fault(StatusCode::Unsupported, name, {PALPATE_TEXT("%1"), "motion"},
                     {PALPATE_TEXT("%1 layers with different motions"), layers.size()},
                     {PALPATE_TEXT("at most %1: let the structures of a layer move alike"), kMostLayers});
    }
    return {};
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
        for (const core::Message& note : file.notes) {
            warn(PALPATE_TEXT("%1: %2"), name, note);
        }
        if (source.frame != FileFrame::Untagged) {
            if (file.frame != FileFrame::Untagged && file.frame != source.frame) {
                warn(PALPATE_TEXT("%1: tagged SPACE=%2, but taken as %3, as was chosen"), name,
                     core::axesOf(file.frame), core::axesOf(source.frame));
            }
        } else if (file.frame == FileFrame::Untagged) {
            untagged.push_back(name);
        } else if (file.frame == FileFrame::Ras) {
            warn(PALPATE_TEXT("%1: tagged SPACE=RAS: x and y negated to get LPS"), name);
        }
    }
    if (untagged.size() > 2) {
        warn(PALPATE_TEXT("%1 and %2 more files: no SPACE tag: coordinates taken as LPS"), untagged.front(),
             Count(untagged.size() - 1));
    } else if (untagged.size() == 2) {
        warn(PALPATE_TEXT("%1 and %2: no SPACE tag: coordinates taken as LPS"), untagged.front(), untagged.back());
    } else if (!untagged.empty()) {
        warn(PALPATE_TEXT("%1: no SPACE tag: coordinates taken as LPS"), untagged.front());
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
    const std::filesystem::path file = m_sources.front().path.filename();
    const core::Rounded wide{units, 3};
    if (m_options.unit_mm == 1.0 && isLikely(1000.0)) {
        m_scene.likelyUnit_mm = 1000.0;
        warn(PALPATE_TEXT("%1: only %2 units wide, taken as mm; looks like metres: open with --unit m"), file, wide);
    } else if (m_options.unit_mm != 1.0 && isLikely(1.0)) {
        m_scene.likelyUnit_mm = 1.0;
        warn(PALPATE_TEXT("%1: %2 units wide, with units of %3 mm; looks like millimetres: open with --unit mm"), file,
             wide, m_options.unit_mm);
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
    } else if (isBlockFile(whole)) {
        status = addBlocks(whole);
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
        const StatusCode code = source.file->isOk() ? StatusCode::Ok : source.file->status().code();
        if (m_isFolder && (code == StatusCode::Unsupported || code == StatusCode::Empty) &&
            hasLabelMapExtension(source.path)) { // an image beside the structures, or a structure that was not found
            warn(PALPATE_TEXT("left out: %1"), source.file->status().text());
            m_firstFailure = m_firstFailure.isOk() ? source.file->status() : m_firstFailure;
        } else if (!source.file->isOk()) {
            lose(source.file->status().text());
            m_firstFailure = m_firstFailure.isOk() ? source.file->status() : m_firstFailure;
        } else if (!source.file->value().loss.isEmpty()) {
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
        return !m_firstFailure.isOk() ? m_firstFailure : Status(StatusCode::Empty, m_scene.losses.front()).at(name);
    }
    if (Status status = addMotions(name); !status.isOk()) {
        return status;
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
        return fault(StatusCode::OutOfRange, name, {}, {PALPATE_TEXT("not enough memory to open it")},
                     {PALPATE_TEXT("a smaller scene, or more free memory")});
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

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/StructureModel.h"

#include <palpate/core/Export.h>
#include <palpate/study/Layers.h>

#include <QObject>
#include <QThreadPool>

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

namespace palpate::ui {

/// Content of newly opened files for the window.
struct PALPATE_EXPORT OpenedScene
{
    std::vector<std::filesystem::path> files; ///< files that were opened
    meshio::SceneFile scene;
    std::vector<StructureRow> rows;
    std::vector<meshio::SceneStructure> unopened; ///< structures of a scene file that could not be opened
    QStringList problems;     ///< files that failed or have changed while others were opened, one line each
    QStringList warnings;     ///< one line each
    study::Layering layering; ///< containment of the structures by row; the rows keep the layers of their files
    bool isReopened = false;  ///< meshes re-read with another axis convention; everything else is unchanged
    /// True when only mesh files were opened, which contain no layers: no scene file and no recording.
    [[nodiscard]] bool areMeshes() const;
    double seconds = 0.0; ///< from the request to completion
    /// Number of structures of the open scene to which these are added; they come first in `layering`. 0: a new scene.
    std::size_t addedTo = 0;
};

/// Already open structure for the containment test; null surfaces are ignored.
struct OpenSurface
{
    std::shared_ptr<const geometry::RepairedMesh> surface;
    std::shared_ptr<const geometry::SurfaceIndex> touch;
};

/// Opens files on a worker thread: reading, repair, display meshes and haptic copies. The window never blocks.
///
/// @par Thread All functions and signals on the GUI thread.
class PALPATE_EXPORT SceneLoader : public QObject
{
    Q_OBJECT
  public:
    explicit SceneLoader(QObject* parent = nullptr);
    ~SceneLoader() override; ///< cancels

    /// Function that opens one file, by default meshio::loadScene; set when the window supports more formats. Called on
    /// a worker thread.
    using Reader =
        std::function<core::Result<meshio::LoadedScene>(const std::filesystem::path&, const meshio::ReadOptions&)>;
    void setReader(Reader reader) { m_reader = std::move(reader); }

    /// Opens mesh and scene files as one scene. Cancels a running job.
    /// @param options  as of meshio::loadScene; `progress` is replaced
    void open(std::vector<std::filesystem::path> files, const meshio::ReadOptions& options = {});
    /// Opens files and adds them to the open scene. @param open  existing structures by row
    void add(std::vector<std::filesystem::path> files, double unit_mm, std::vector<OpenSurface> open);
    /// Reads the meshes of an open scene again. @param files  files from which the scene was opened
    void reopen(meshio::SceneFile scene, std::vector<std::filesystem::path> files);
    /// Builds the haptic copy of one structure.
    void buildTouch(int row, std::shared_ptr<const geometry::RepairedMesh> surface);
    /// Rebuilds a structure's surface according to the description, with all dependent data. @param structure  includes
    /// the surface as read
    void buildSurface(int row, const meshio::LoadedStructure& structure);
    /// Searches for structures with a small gap between them, and for touching structures of different stiffness
    /// (study::borderNotes). Emits `notesFound`.
    void findGaps(const std::vector<study::OpenStructure>& rows);
    /// Builds the maps of a structure by reading and sampling volumes. When cancelled, `mapsBuilt` reports this in a
    /// line and omits the maps of volumes.
    void buildMaps(int row, const meshio::LoadedStructure& structure);
    /// Cancels opening and map building at the next possible step. Emits `cancelled` for opening.
    void cancel();
    [[nodiscard]] bool isBusy() const noexcept { return m_isBusy; }
    [[nodiscard]] bool isBuildingMaps() const noexcept { return m_mapJobs > 0; }

  Q_SIGNALS:
    /// @param share  0 to 1
    void progressed(const QString& what, double share);
    /// Structures of a scene that is being opened, for a preview: description, surface and display mesh. Names and
    /// colours may still change. Not emitted for added files and for a scene that is read again.
    void structuresReady(const std::shared_ptr<std::vector<palpate::ui::StructureRow>>& rows);
    /// What `structuresReady` has passed is void; emitted before `failed` and `cancelled`, and when another job begins.
    void structuresDropped();
    void opened(const std::shared_ptr<palpate::ui::OpenedScene>& scene);
    /// Emitted when nothing could be opened. @param line  cause, file and remedy
    void failed(const QString& line);
    void cancelled();
    void touchBuilt(int row, const std::shared_ptr<const palpate::geometry::SurfaceIndex>& touch,
                    const QString& sha256);
    /// @param built  surface, display mesh, haptic copy if palpable, hash and maps
    void surfaceBuilt(int row, const std::shared_ptr<palpate::ui::StructureRow>& built);
    /// @param lines  one note each, empty without notes
    void notesFound(const QStringList& lines);
    /// Emitted when the meshes of a new scene were read, before indexing. @param size_mm  diagonal of the whole scene
    void sizeKnown(double size_mm);
    /// @param structure  with maps and the mappings used
    /// @param problems  one line each
    void mapsBuilt(int row, const std::shared_ptr<palpate::meshio::LoadedStructure>& structure,
                   const std::vector<palpate::core::Message>& problems);

  private:
    struct Job;
    class Opening;
    void finish();
    void begin();
    void cancelOpening();

    Reader m_reader = [](const auto& path, const auto& options) { return meshio::loadScene(path, options); };
    std::shared_ptr<Job> m_job;
    std::thread m_worker;
    QThreadPool m_builders;      ///< builds haptic copies and maps; hundreds of jobs may be queued
    std::shared_ptr<Job> m_maps; ///< running map job
    int m_mapJobs = 0;
    int m_scene = 0; ///< generation of the open scene, since rows are only valid within a scene
    bool m_isBusy = false;
};

} // namespace palpate::ui

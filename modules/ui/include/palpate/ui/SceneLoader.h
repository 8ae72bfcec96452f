// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/StructureModel.h"

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

/// Everything the window needs of newly opened files.
struct OpenedScene
{
    std::vector<std::filesystem::path> files; ///< those that could be opened
    meshio::SceneFile scene;
    std::vector<StructureRow> rows;
    std::vector<meshio::SceneStructure> unopened; ///< what a scene file names but could not be opened
    QStringList problems;     ///< what could not be opened, or is another one now, while others could; one line each
    QStringList warnings;     ///< one line each
    study::Layering layering; ///< what lies in what, row by row; the rows have the layers of their files
    bool isReopened = false;  ///< its meshes were read again, in other axes: the scene is as it was but for these
    /// True when mesh files alone were opened, which say nothing of layers: no scene file, no recording.
    [[nodiscard]] bool areMeshes() const;
    double seconds = 0.0; ///< from the wish to open to ready
    /// Structures of the open scene that these are added to: `layering` has them first. 0: they are a scene of their
    /// own
    std::size_t addedTo = 0;
};

/// A structure that is open already, as containment sees it; null surfaces where it counts for nothing.
struct OpenSurface
{
    std::shared_ptr<const geometry::RepairedMesh> surface;
    std::shared_ptr<const geometry::SurfaceIndex> touch;
};

/// Opens files on a thread of its own: reads, repairs, makes the pictures and the haptic copies. The window never
/// waits.
/// @par Thread All functions on the window's thread; the signals come there too.
class SceneLoader : public QObject
{
    Q_OBJECT
  public:
    explicit SceneLoader(QObject* parent = nullptr);
    ~SceneLoader() override; ///< cancels

    /// What opens one file; meshio::loadScene unless the window knows more kinds. Called on another thread.
    using Reader =
        std::function<core::Result<meshio::LoadedScene>(const std::filesystem::path&, const meshio::ReadOptions&)>;
    void setReader(Reader reader) { m_reader = std::move(reader); }

    /// Opens mesh and scene files as one scene. What was being opened is cancelled.
    /// @param frame  of mesh files, whatever their tags say; Untagged: as these say
    void open(std::vector<std::filesystem::path> files, double unit_mm,
              core::FileFrame frame = core::FileFrame::Untagged);
    /// Opens files to be added to the open scene. @param open  its structures, row by row
    void add(std::vector<std::filesystem::path> files, double unit_mm, std::vector<OpenSurface> open);
    /// Reads the meshes of an open scene again. @param files  as which it was opened
    void reopen(meshio::SceneFile scene, std::vector<std::filesystem::path> files);
    /// Builds the haptic copy of one structure.
    void buildTouch(int row, std::shared_ptr<const geometry::RepairedMesh> surface);
    /// Makes a structure's surface anew, as its description says, and all that is built from it.
    /// @param structure  with the surface that was read
    void buildSurface(int row, const meshio::LoadedStructure& structure);
    /// Looks for structures that come close to each other without touching, or touch and differ in stiffness
    /// (study::borderNotes); `notesFound` follows.
    void findGaps(const std::vector<StructureRow>& rows);
    /// Finds what varies over a structure: reads and samples its volumes. Where that is cancelled, `mapsBuilt` follows
    /// with a line that says so, and without the volumes' maps.
    void buildMaps(int row, const meshio::LoadedStructure& structure);
    /// Stops opening and the building of maps as soon as the present step allows; of opening `cancelled` follows.
    void cancel();
    [[nodiscard]] bool isBusy() const noexcept { return m_isBusy; }
    [[nodiscard]] bool isBuildingMaps() const noexcept { return m_mapJobs > 0; }

  Q_SIGNALS:
    /// @param share  0 … 1
    void progressed(const QString& what, double share);
    void opened(const std::shared_ptr<palpate::ui::OpenedScene>& scene);
    /// Nothing could be opened. @param line  what happened, to which file, what to do
    void failed(const QString& line);
    void cancelled();
    void touchBuilt(int row, const std::shared_ptr<const palpate::geometry::SurfaceIndex>& touch,
                    const QString& sha256);
    /// @param built  with surface, picture, touch where it is palpable, hash and maps
    void surfaceBuilt(int row, const std::shared_ptr<palpate::ui::StructureRow>& built);
    /// @param lines  one each, empty when nothing was found
    void notesFound(const QStringList& lines);
    /// The meshes of a scene of their own were read and their size is known; they are indexed next.
    /// @param size_mm  diagonal of all of them
    void sizeKnown(double size_mm);
    /// @param structure  with its maps, and the mappings that they were found by; @param problems  one line each
    void mapsBuilt(int row, const std::shared_ptr<palpate::meshio::LoadedStructure>& structure,
                   const QStringList& problems);

  private:
    struct Job;
    class Opening;
    void finish();
    void begin();
    void cancelOpening();

    Reader m_reader = [](const auto& path, const auto& options) { return meshio::loadScene(path, options); };
    std::shared_ptr<Job> m_job;
    std::thread m_worker;
    QThreadPool m_builders;      ///< of haptic copies and maps: hundreds may be asked for at once
    std::shared_ptr<Job> m_maps; ///< that are being built
    int m_mapJobs = 0;
    int m_scene = 0; ///< rows are numbers in the scene that is open
    bool m_isBusy = false;
};

} // namespace palpate::ui

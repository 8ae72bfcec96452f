// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/geometry/Holes.h>
#include <palpate/geometry/SurfaceIndex.h>
#include <palpate/geometry/SurfaceMotion.h>
#include <palpate/haptics/HapticScene.h>
#include <palpate/meshio/LoadScene.h>
#include <palpate/session/Recording.h>
#include <palpate/study/OpenScene.h>
#include <palpate/view/StructureActor.h>

#include <QAbstractTableModel>
#include <QColor>
#include <QUndoStack>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace palpate::ui {

/// Structure to be opened: data and picture.
struct StructureRow : study::OpenStructure
{
    vtkSmartPointer<vtkPolyData> picture;
};

/// Table of the open scene's structures: visible, name and colour, mesh health, palpable. An adapter of
/// study::OpenScene, which view, haptics, panels and files share.
///
/// @par Thread GUI thread only.
class PALPATE_EXPORT StructureModel : public QAbstractTableModel
{
    Q_OBJECT
  public:
    enum Column
    {
        Shown,
        Name,
        Health,
        Felt,
        ColumnCount
    };

    /// Indentation of a name in the list, equal to the structure's layer.
    static constexpr int kLayerRole = Qt::UserRole;

    /// Aspect of a change: appearance for the view, touch for the haptic scene.
    enum class Change
    {
        Look,
        Touch
    };

    explicit StructureModel(QObject* parent = nullptr);

    /// Replaces all rows. @param buried  touch mode of structures inside organs
    /// @param exercise  of these structures; the targets are hidden as their descriptions state
    void setRows(std::vector<StructureRow> rows, meshio::BuriedTouch buried = meshio::BuriedTouch::Layers,
                 std::optional<meshio::Exercise> exercise = {});
    /// Hides the targets of the exercise, which are felt all the same, or shows them. Not undoable; clears the undo
    /// stack.
    void setTargetsHidden(bool areHidden);
    /// True for a row in the scene that may be shown and named: not a hidden target.
    [[nodiscard]] bool isListed(int row) const { return rows()[static_cast<std::size_t>(row)].isListed(); }
    /// Readable name for display. For a hidden target this is the structure around it, or "unnamed structure".
    [[nodiscard]] QString shownName(int row) const;
    [[nodiscard]] const study::OpenScene& scene() const noexcept { return m_scene; }
    [[nodiscard]] const std::vector<study::OpenStructure>& rows() const noexcept { return m_scene.structures(); }
    /// Surface as drawn.
    [[nodiscard]] const vtkSmartPointer<vtkPolyData>& picture(int row) const
    {
        return m_pictures[static_cast<std::size_t>(row)];
    }
    [[nodiscard]] const meshio::SceneStructure& structure(int row) const;

    /// New description of a structure.
    struct Edited
    {
        int row = 0;
        meshio::SceneStructure description;
    };

    /// Replaces a structure's description as an undo step and emits `edited`. The mesh is unchanged.
    void edit(int row, const meshio::SceneStructure& description);
    /// Edits several structures as one undo step; no step without a change.
    /// @param text  label of the undo step
    /// @param buried  new touch mode of structures inside organs; empty: unchanged
    void editAll(std::vector<Edited> edits, const QString& text,
                 std::optional<meshio::BuriedTouch> buried = std::nullopt);
    /// Appends structures as an undo step. @param text  label of the undo step, "Add lump"
    void addRows(std::vector<StructureRow> rows, const QString& text);
    /// Removes structures from the scene as an undo step.
    void removeRows(std::vector<int> rows);
    /// Sets the surrounding structure of each row after a containment test. Not undoable.
    void setNesting(const std::vector<std::optional<std::size_t>>& in);
    /// Number of structures in the scene, without removed rows.
    [[nodiscard]] int presentCount() const;
    /// Number of structures that may be named: those in the scene without hidden targets.
    [[nodiscard]] int listedCount() const;
    /// Assigns the layers as one undo step. Structures with a layer above 0 leave the transmitted mode.
    /// @param text  label of the undo step, "Feel below"
    void setLayers(const std::vector<std::uint32_t>& layers, const QString& text);
    /// Touch mode of structures inside organs.
    [[nodiscard]] meshio::BuriedTouch buried() const noexcept { return m_scene.buried(); }
    /// True for a lump in transmitted mode, felt through its organ (see study::applyBuriedLumps). Until the map is
    /// computed, `loaded.isTransmitted` is false and the lump is a separate layer.
    [[nodiscard]] bool isTransmitted(int row) const;
    /// Organ through which a structure is or would be felt (study::LumpRule::organAround).
    [[nodiscard]] std::optional<int> organAround(int row) const;
    /// Layer of a transmitted lump until the map is computed (study::LumpRule::layerWithin).
    [[nodiscard]] std::uint32_t layerWithin(int row) const;
    using TransmittedMap = study::OpenScene::TransmittedMap;
    /// Replaces the maps of all organs and emits `edited` for changed rows. Not an edit.
    void setTransmittedMaps(const std::vector<TransmittedMap>& maps);
    /// Position in the order of touch for a layer: "outermost", "below liver" when the structure is directly below the
    /// liver (structures that are not palpable are skipped), else "2 below".
    [[nodiscard]] QString touchOrderText(int row, std::uint32_t layer) const;
    /// Position of a structure with its current layer, or "through liver" in transmitted mode.
    [[nodiscard]] QString touchOrderText(int row) const;
    [[nodiscard]] QUndoStack& undoStack() noexcept { return m_undo; }
    /// Replaces each motion of the scene, for a change of pace. Structures that share a motion still do. Not an edit.
    using ChangeOfMotion = std::function<std::shared_ptr<const geometry::SurfaceMotion>(
        const std::shared_ptr<const geometry::SurfaceMotion>& motion)>;
    void changeMotions(const ChangeOfMotion& change);
    /// Sets a structure's haptic copy; null removes the copy.
    void setTouch(int row, std::shared_ptr<const geometry::SurfaceIndex> touch, std::string sha256);
    /// Takes the maps computed by `meshio::resolveMaps` on a worker thread.
    /// @param of  mappings used for the computation; the call has no effect when the mappings have changed since
    void setMaps(int row, const std::optional<std::vector<core::TissueMapping>>& of,
                 std::vector<meshio::SurfaceMap> maps, std::vector<core::Message> problems);
    /// Takes the surface requested by `surfaceWanted` with all derived data. No effect when the description has changed
    /// since. Not an edit.
    void setSurface(int row, const StructureRow& built);
    /// True when a surface can be smoothed and reoriented, that is, read from a mesh file.
    [[nodiscard]] bool isReshapable(int row) const;
    /// Present rows that are inside out, and present rows with voxel steps that are not smoothed.
    [[nodiscard]] std::vector<int> insideOutRows() const;
    [[nodiscard]] std::vector<int> steppedRows() const;
    /// Reorients closed parts outwards, or smooths the surfaces, as one undo step. The new surfaces follow
    /// asynchronously (`surfaceWanted`).
    void turnOutwards(const std::vector<int>& rows);
    void smooth(const std::vector<int>& rows);
    /// Holes of a surface, the largest first; none if it cannot be reshaped. @par Cost O(n log n)
    [[nodiscard]] std::vector<geometry::Hole> holes(int row) const;
    /// Closes the holes of surfaces up to the largest, and turns closed parts outwards, as one undo step. As
    /// `turnOutwards`, the new surfaces follow.
    void closeHoles(const std::vector<int>& rows);
    /// Removes the triangles that `closeHoles` added, as one undo step.
    void reopenHoles(const std::vector<int>& rows);
    /// Mesh findings of a structure, one sentence each; empty for a clean mesh.
    [[nodiscard]] QStringList findings(int row) const;
    /// Effect of the mesh findings on touch in plain words, one entry per kind.
    [[nodiscard]] QStringList defects(int row) const;
    /// True for findings beyond an open boundary: repaired or conspicuous geometry. Vessels and sheets are open by
    /// nature.
    [[nodiscard]] bool isDefective(int row) const;

    /// Appearance in the view; removed structures are hidden.
    [[nodiscard]] view::Appearance appearanceOf(int row) const;
    [[nodiscard]] static view::Appearance appearanceOf(const meshio::SceneStructure& structure);
    /// Builds the haptic scene; structure numbers equal rows.
    /// @param fingertip_mm  radius of the probe sphere, 0: a point
    /// @param greatest  stable limit of the device, applied to the sum of the layers, see study/DeviceLimit.h
    [[nodiscard]] std::shared_ptr<const haptics::HapticScene> hapticScene(const haptics::Tissue& greatest,
                                                                          double fingertip_mm = 0.0) const
    {
        return m_scene.hapticScene(greatest, fingertip_mm);
    }
    /// Structures with parameters limited by the device's total stiffness; numbers equal rows.
    [[nodiscard]] std::vector<haptics::HapticStructure> hapticStructures(const haptics::Tissue& greatest) const
    {
        return m_scene.hapticStructures(greatest);
    }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    /// Shown and Felt take a Qt::CheckStateRole, Name a Qt::EditRole.
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

  Q_SIGNALS:
    void edited(int row, palpate::ui::StructureModel::Change change);
    /// Emitted before `edited` when a structure's name changed.
    void renamed(int row, const QString& before, const QString& after);
    /// Emitted when maps from volumes must be read; `setMaps` delivers the result. The old maps stay in use until then.
    void mapsWanted(int row);
    /// Emitted when a surface must be rebuilt from `loaded.asRead` according to the description; `setSurface` delivers
    /// the result. The old surface stays in use until then.
    void surfaceWanted(int row);
    /// Emitted after `setTargetsHidden` changed any structure.
    void targetsHidden(bool areHidden);
    /// Emitted when `changeMotions` changed any.
    void motionsChanged();
    /// Emitted after a surface was replaced together with picture, haptic copy and maps.
    void surfaceReplaced(int row);

  private:
    class Step;
    void push(study::SceneEdit edit, const QString& text);
    void apply(const study::SceneEdit& edit);
    void announce(const study::SceneEvents& events);
    [[nodiscard]] static QStringList surfaceTexts(const meshio::LoadedStructure& one);

    study::OpenScene m_scene;
    std::vector<vtkSmartPointer<vtkPolyData>> m_pictures; ///< one per row
    QUndoStack m_undo;
};

/// Display colour of a structure.
[[nodiscard]] PALPATE_EXPORT QColor colourOf(const meshio::SceneStructure& structure);
/// Readable name, see study::readableName.
[[nodiscard]] PALPATE_EXPORT QString readableName(const std::string& name);

} // namespace palpate::ui

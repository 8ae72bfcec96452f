// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/geometry/SurfaceIndex.h>
#include <palpate/haptics/HapticScene.h>
#include <palpate/meshio/LoadScene.h>
#include <palpate/session/Recording.h>
#include <palpate/view/StructureActor.h>

#include <QAbstractTableModel>
#include <QColor>
#include <QUndoStack>

#include <memory>
#include <optional>
#include <vector>

namespace palpate::ui {

/// A structure of the open scene: what its file said, how it is now, and what was built from it.
struct StructureRow
{
    meshio::LoadedStructure loaded; ///< `loaded.description` is what the panel edits
    vtkSmartPointer<vtkPolyData> picture;
    std::shared_ptr<const geometry::SurfaceIndex> touch; ///< null until it is palpable and built
    std::string sha256;                                  ///< geometryHash, where `touch` is
    std::optional<int> in{};                             ///< row of the smallest structure that it lies in
    haptics::TissueMaps felt{};                          ///< `loaded.maps` for the tick, where `touch` is
    QStringList mapProblems{};                           ///< why a map can't be had, one sentence an entry
    /// `loaded.feltBelow` as a recording had it: felt while lumps are felt as layers, and never made anew.
    std::vector<std::vector<float>> recordedBelow{};
    /// Taken out of the scene: neither shown, felt, listed nor saved. It keeps its number, which recordings, undo steps
    /// and the view know it by, and comes back with undo.
    bool isRemoved = false;
};

/// The open scene's structures as a table: shown, name and colour, health, felt. One place holds what view, hand, panel
/// and file agree on.
class StructureModel : public QAbstractTableModel
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

    /// How far in a name stands in the list, as a number: its layer.
    static constexpr int kLayerRole = Qt::UserRole;

    /// What a change is about; view and hand take what concerns them.
    enum class Change
    {
        Look,
        Touch
    };

    explicit StructureModel(QObject* parent = nullptr);

    /// @param buried  how what lies in an organ is felt
    void setRows(std::vector<StructureRow> rows, meshio::BuriedTouch buried = meshio::BuriedTouch::Layers);
    [[nodiscard]] const std::vector<StructureRow>& rows() const noexcept { return m_rows; }
    [[nodiscard]] const meshio::SceneStructure& structure(int row) const;

    /// A structure as it is to be.
    struct Edited
    {
        int row = 0;
        meshio::SceneStructure description;
    };

    /// Replaces a structure's description, undoably; tells what changed. The mesh stays.
    void edit(int row, const meshio::SceneStructure& description);
    /// The same of several structures as one step to undo; nothing when there is none. @param text  what is undone
    /// @param buried  how what lies in an organ is felt from now on; nothing: as it is
    void editAll(std::vector<Edited> edits, const QString& text,
                 std::optional<meshio::BuriedTouch> buried = std::nullopt);
    /// Appends structures, undoably. @param text  what is undone, "Add lump"
    void addRows(std::vector<StructureRow> rows, const QString& text);
    /// Takes structures out of the scene, undoably.
    void removeRows(std::vector<int> rows);
    /// Says what each structure lies in, as was found out for another set of them. Not undone.
    void setNesting(const std::vector<std::optional<int>>& in);
    /// Structures that are in the scene.
    [[nodiscard]] int presentCount() const;
    /// Gives each structure its layer, as one step to undo; what gets one below is no longer felt through its organ.
    /// @param text  what is undone, "Feel below"
    void setLayers(const std::vector<std::uint32_t>& layers, const QString& text);
    /// How what lies in an organ is felt.
    [[nodiscard]] meshio::BuriedTouch buried() const noexcept { return m_buried; }
    /// @return true for a lump that is to be felt through its organ (see study::feelBuried). Until its map is
    /// there, `loaded.isFeltThrough` is false and it is felt as a layer.
    [[nodiscard]] bool isToBeFeltThrough(int row) const;
    /// @return the organ that a lump is, or would be, felt through: the one that it names, else the smallest around it
    /// that is felt and closed, in a scene that names none the largest; nothing where there is none.
    [[nodiscard]] std::optional<int> organAround(int row) const;
    /// @return how many structures that are felt lie around one: the layer in which it is felt meanwhile
    [[nodiscard]] std::uint32_t layerWithin(int row) const;
    /// What the lumps in an organ make of its surface, for each of haptics::kFeltPress_mm a number at each vertex.
    struct FeltThrough
    {
        int organ = 0;
        std::vector<int> lumps;
        std::vector<std::vector<float>> below; ///< k/k0 [1]
    };
    /// Takes all maps of what is felt through organs, in place of those before; tells what changed. Not an edit.
    void setFeltThrough(const std::vector<FeltThrough>& maps);
    /// In which order a structure would be felt in a layer: "outermost", "below liver" when it lies in the liver and
    /// that is felt just outside of it (what the hand passes through in between is not named), else "2 below".
    [[nodiscard]] QString feltText(int row, std::uint32_t layer) const;
    /// The same as a structure is felt now; of one that is felt through its organ: "through liver".
    [[nodiscard]] QString feltText(int row) const;
    [[nodiscard]] QUndoStack& undoStack() noexcept { return m_undo; }
    /// Gives a structure its haptic copy, or takes it back with null.
    void setTouch(int row, std::shared_ptr<const geometry::SurfaceIndex> touch, std::string sha256);
    /// Takes what varies over a structure, as `meshio::resolveMaps` found it on another thread.
    /// @param of  the mappings that it was found for: nothing happens when the structure has others by now
    void setMaps(int row, const std::optional<std::vector<core::TissueMapping>>& of,
                 std::vector<meshio::SurfaceMap> maps, const QStringList& problems);
    /// Takes the surface that `surfaceWanted` asked for, with all that was built from it. Nothing happens when the
    /// structure is to have another one by now. Not an edit.
    void setSurface(int row, const StructureRow& built);
    /// @return true when a structure's surface can be smoothed and turned: it was read from a mesh file.
    [[nodiscard]] bool isReshapable(int row) const;
    /// Rows that are in the scene and inside out, and those that are staircases and not smoothed.
    [[nodiscard]] std::vector<int> insideOutRows() const;
    [[nodiscard]] std::vector<int> steppedRows() const;
    /// Turns closed parts of structures outwards, or smooths their surfaces, as one step to undo. The surfaces follow
    /// (`surfaceWanted`).
    void turnOutwards(const std::vector<int>& rows);
    void smooth(const std::vector<int>& rows);
    /// What was found in the structure's mesh, one sentence an entry, empty when it is clean.
    [[nodiscard]] QStringList findings(int row) const;
    /// The same in plain words: how it feels for that, an entry a kind.
    [[nodiscard]] QStringList defects(int row) const;
    /// More than an open rim, which vessels and sheets have by nature: something was repaired or stands out.
    [[nodiscard]] bool isDefective(int row) const;

    /// How the view shows a structure; one that was removed is hidden.
    [[nodiscard]] view::Appearance appearanceOf(int row) const;
    /// A structure is felt when it is palpable and shown: a hidden one must not be an invisible wall.
    [[nodiscard]] static bool isFelt(const meshio::SceneStructure& structure) noexcept;
    [[nodiscard]] static view::Appearance appearanceOf(const meshio::SceneStructure& structure);
    /// What the servo thread can feel now; numbers are the rows.
    /// @param fingertip_mm  radius of the ball that touches, 0 = a point
    /// @param greatest  what the device holds stably bounds the sum of the layers: see study/DeviceLimit.h
    [[nodiscard]] std::shared_ptr<const haptics::HapticScene> hapticScene(const haptics::Tissue& greatest,
                                                                          double fingertip_mm = 0.0) const;
    /// The structures as they are felt, numbers are the rows: bounded by what the device holds in all.
    [[nodiscard]] std::vector<haptics::HapticStructure> feltStructures(const haptics::Tissue& greatest) const;
    /// Where the surfaces came from, with those themselves that can be felt.
    [[nodiscard]] std::vector<session::StructureSource> sources() const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    /// Shown and Felt take a Qt::CheckStateRole, Name a Qt::EditRole.
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

  Q_SIGNALS:
    void edited(int row, palpate::ui::StructureModel::Change change);
    /// A structure has another name, before `edited`.
    void renamed(int row, const QString& before, const QString& after);
    /// A structure's maps are of volumes, which take time to read: `setMaps` brings them. Until then the old ones are
    /// felt.
    void mapsWanted(int row);
    /// A structure's surface is to be made anew from `loaded.asRead`, as its description says now: `setSurface` brings
    /// it. Until then the old one is drawn and felt.
    void surfaceWanted(int row);
    /// A structure has another surface: picture, touch and maps are of that.
    void surfaceReplaced(int row);

  private:
    class Edit;
    class Presence;
    void apply(const std::vector<Edited>& edits, std::optional<meshio::BuriedTouch> buried);
    [[nodiscard]] std::vector<int> dropFeltThrough();
    [[nodiscard]] static QStringList surfaceTexts(const meshio::LoadedStructure& one);
    [[nodiscard]] bool areLumpsNamed() const;
    void setRemoved(const std::vector<int>& rows, bool isRemoved);
    void tell(int row, const meshio::SceneStructure& before, bool hasOtherMaps);
    void resolveMaps(int row);
    void refreshFelt(StructureRow& row);

    std::vector<StructureRow> m_rows;
    meshio::BuriedTouch m_buried = meshio::BuriedTouch::Layers;
    QUndoStack m_undo;
};

/// The colour that a structure is drawn in.
[[nodiscard]] QColor colourOf(const meshio::SceneStructure& structure);
/// "VH_F_liver_capsule" or "liver_capsule" as a person writes it: "liver capsule".
[[nodiscard]] QString readableName(const std::string& name);

} // namespace palpate::ui

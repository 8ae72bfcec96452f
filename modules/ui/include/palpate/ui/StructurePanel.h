// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/StructureModel.h"
#include "palpate/ui/TissuePresets.h"
#include "palpate/ui/TouchMode.h"

#include <palpate/core/Export.h>

#include <QWidget>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QMenu;
class QSlider;
class QToolButton;

namespace palpate::ui {

class LawEditor;
class MapEditor;
class StructureList;
struct TouchReading;

/// Structure list with an editor for appearance and touch of the selection. An edit applies to all selected structures
/// as one undo step.
class PALPATE_EXPORT StructurePanel : public QWidget
{
    Q_OBJECT
  public:
    explicit StructurePanel(StructureModel& model, QWidget* parent = nullptr);

    /// Sets the stable limit of the device. Edits beyond the limit are rejected: the value is restored and a line next
    /// to the field gives the reason.
    /// @param why  device, limit and cause of the limit, for the user
    void setGreatest(const haptics::Tissue& greatest, const QString& why);
    /// Sets the stability warnings of maps by row, see MapWarnings.
    void setMapWarnings(const QStringList& lines);
    [[nodiscard]] int currentRow() const;
    [[nodiscard]] std::vector<int> selectedRows() const;
    void select(int row);
    /// Selects the structure picked in the view and highlights it there; empty clears the picked selection.
    /// @param adds  toggles the structure in the selection
    void choose(std::optional<std::size_t> row, bool adds);
    /// Moves the keyboard focus to the filter field.
    void focusFilter();
    /// Removes the selected structures from the scene.
    void removeSelected();
    /// Starts renaming the current structure in the list.
    void renameCurrent();
    /// Marks the current penetration depth in the force law plot of the selected structure.
    void showTouch(const TouchReading& reading);

    /// Applies the surface colours stored in a scene file, where available.
    void colourBy(const meshio::ShownMap& shown);

  Q_SIGNALS:
    /// Emitted when one structure is to be coloured by a scalar field. @param what  id from `SurfaceField::what`;
    /// empty: uncoloured
    void colourChosen(int row, const QString& what);
    /// Emitted when the user selects structures in the list or the view, to highlight them.
    void highlighted(const std::vector<int>& rows);

  protected:
    /// Keys of the list: Ctrl+E shows or hides the selected structures, Ctrl+H toggles palpability, Ctrl+Down and
    /// Ctrl+Up move to a deeper or outer layer, Del removes, Esc clears the selection.
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    using Change = std::function<void(meshio::SceneStructure&)>;
    void change(const std::vector<int>& rows, const Change& change, const QString& text = {});
    void changeTissue(const std::function<void(haptics::Tissue&)>& change);
    void click(const QModelIndex& index);
    void toggle(const std::vector<int>& rows, int column);
    void moveLayers(int steps);
    void showSelection();
    void showHead(const std::vector<int>& rows);
    void fitTitle();
    void refuse(const QString& line);
    [[nodiscard]] QString refusal(int row, const haptics::Tissue& asked, const haptics::Tissue& now) const;
    void setLayer(const QVariant& chosen);
    void changeWays(const std::vector<TouchMode>& ways);
    void showLayer(int row);
    void showBound(int row);
    void showMapWarning();
    [[nodiscard]] QString otherLayersText(const std::vector<haptics::HapticStructure>& felt, int row) const;
    void editOpacity(int percent);
    void chooseColour();
    void addHoleActions(QMenu& menu, const std::vector<int>& rows);
    void openMenu(const QPoint& place);
    QWidget* makeTissueBox();
    void addHead(QFormLayout& form, QWidget* box);
    void addOpacity(QFormLayout& form, QWidget* box);
    void addLayer(QFormLayout& form, QWidget* box);
    void addSurface(QFormLayout& form, QWidget* box);
    void showSurface(const std::vector<int>& rows);
    void setSmoothing(double factor);
    void addTerm(std::size_t i, QFormLayout& form, QWidget* box);
    void addStiffness(QFormLayout& form, QWidget* box);
    void addOtherTerms(QFormLayout& form, QWidget* box);
    void addPresets(QFormLayout& form, QWidget* box);
    void addLaw(QFormLayout& form, QWidget* box);
    void addMap(QFormLayout& form, QWidget* box);
    void showFrictionTerms();
    void addFriction(QFormLayout& form, QWidget* box);
    void showTissue(const haptics::Tissue& tissue);
    QDoubleSpinBox* makeField(const core::TissueTerm& term, QWidget* box);

    StructureModel& m_model;
    StructureList* m_list = nullptr;
    QLabel* m_title = nullptr;
    QLabel* m_findings = nullptr;
    QLabel* m_size = nullptr; ///< volume, area and extent
    QToolButton* m_colour = nullptr;
    QSlider* m_opacity = nullptr;
    QLabel* m_opacityText = nullptr;
    QComboBox* m_preset = nullptr;
    QLabel* m_source = nullptr; ///< source of the preset's numbers
    LawEditor* m_law = nullptr;
    MapEditor* m_map = nullptr;
    QLabel* m_mapWarning = nullptr; ///< stability warning of the map
    QStringList m_mapWarnings;      ///< indexed by row
    int m_colouredRow = -1;
    QString m_coloured; ///< scalar field of the colours
    QComboBox* m_friction = nullptr;
    std::array<QDoubleSpinBox*, core::kTissueTerms.size()> m_terms{};
    QComboBox* m_surface = nullptr; ///< the data of each item is a meshio::SurfaceKind
    QWidget* m_surfaceRow = nullptr;
    QDoubleSpinBox* m_smoothing = nullptr; ///< SceneStructure::smoothing
    QLabel* m_surfaceCost = nullptr;       ///< triangles and memory of curved surfaces
    QComboBox* m_layer = nullptr;          ///< item data: layer; invalid: transmitted through the surrounding organ
    QLabel* m_bound = nullptr;             ///< effective values when limited by the device
    QLabel* m_refusal = nullptr;
    haptics::Tissue m_greatest = core::unbounded(); ///< unbounded until a device is known
    QString m_limitReason;
    QWidget* m_tissue = nullptr;
    bool m_isShowing = false;
    bool m_isChosen = false; ///< selection made by the user
};

} // namespace palpate::ui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/StructureModel.h"

#include <palpate/core/Export.h>

#include <QWidget>

#include <filesystem>
#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;

namespace palpate::ui {

/// Editor of tissue maps: the mesh array or volume that varies a tissue parameter over the surface, and the scalar
/// field that colours the structure.
class PALPATE_EXPORT MapEditor : public QWidget
{
    Q_OBJECT
  public:
    /// Empty: maps inferred from array names.
    using Maps = std::optional<std::vector<core::TissueMapping>>;

    explicit MapEditor(QWidget* parent = nullptr);

    /// Shows a structure. @param coloured  `SurfaceField::what` of the colours; empty: uncoloured
    void show(const study::OpenStructure& row, const QString& coloured);
    /// Uses a volume as source of the selected quantity.
    void load(const std::filesystem::path& volume);

  Q_SIGNALS:
    void edited(const palpate::ui::MapEditor::Maps& maps);
    void colourChosen(const QString& what);

  private:
    void makeFields();
    void connectFields();
    void chooseHow(int how);
    void chooseSource(int source);
    void editNumbers();
    void put(const core::TissueMapping& mapping);
    void setUnit(core::MapUnit unit);
    void change(const core::TissueMapping& mapping);
    void askForVolume();
    void refresh();
    void refreshSources(const core::TissueMapping* now);
    void refreshNumbers(const core::TissueMapping* now);
    void refreshColours(const QString& coloured);
    [[nodiscard]] QString note() const;
    [[nodiscard]] std::vector<core::TissueMapping> mappings() const;
    [[nodiscard]] const core::TissueMapping* current() const;
    [[nodiscard]] core::MappedQuantity quantity() const;

    meshio::LoadedStructure m_structure; ///< current state
    std::vector<core::TissueMapping> m_mappings;
    QStringList m_problems;
    bool m_isByHand = false;                         ///< manual mode was chosen but no mapping exists yet
    std::optional<core::TissueMapping> m_unitless{}; ///< source chosen, unit still open
    bool m_isShowing = false;
    QFormLayout* m_form = nullptr;
    QComboBox* m_how = nullptr;
    QComboBox* m_quantity = nullptr;
    QComboBox* m_source = nullptr;
    QComboBox* m_unit = nullptr;
    QDoubleSpinBox* m_radius = nullptr;
    QCheckBox* m_clamp = nullptr;
    QDoubleSpinBox* m_low = nullptr;
    QDoubleSpinBox* m_high = nullptr;
    QComboBox* m_colours = nullptr;
    QLabel* m_note = nullptr;
};

} // namespace palpate::ui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/StructureModel.h"

#include <palpate/core/Export.h>

#include <QObject>
#include <QStringList>

#include <optional>

#include <vector>

namespace palpate::ui {

class VtkViewport;

/// Scalar field over a structure, for colouring.
struct SurfaceField
{
    QString what;  ///< internal id: "felt:stiffness", "array:StiffnessScale"
    QString title; ///< display title with unit: "felt, N/mm"
    bool isPerTriangle = false;
    std::vector<float> values{}; ///< NaN: unknown
};

/// Lists the available scalar fields: the resulting quantity of each map, then each array of the mesh. Values are not
/// filled in.
[[nodiscard]] PALPATE_EXPORT std::vector<SurfaceField> surfaceFields(const meshio::LoadedStructure& structure);
/// Scalar field with values. @param felt  the structure in the haptic scene; values are clamped to the device's limit
[[nodiscard]] PALPATE_EXPORT SurfaceField surfaceFields(const meshio::LoadedStructure& structure, const QString& what,
                                                        const haptics::HapticStructure& felt);

/// Colours one structure of the view by a scalar field with a legend and follows changes of the data.
///
/// @par Thread GUI thread only.
class PALPATE_EXPORT MapDisplay : public QObject
{
    Q_OBJECT
  public:
    /// Both references must outlive this object.
    MapDisplay(VtkViewport& viewport, StructureModel& model, QObject* parent = nullptr);

    /// Shows a scalar field. @param what  id from `SurfaceField::what`; empty: the structure's own colour
    void show(int row, const QString& what);
    /// Current selection in the form stored in scene files; empty while no structure is coloured by a field.
    [[nodiscard]] std::optional<meshio::ShownMap> shown() const;
    /// Value of the displayed field at a place: "stiffness felt 0.42 N/mm"; empty for other structures.
    /// @param triangle  index in the structure's repaired mesh
    /// @param p_W  place on the structure [mm]
    [[nodiscard]] QString textAt(int row, std::size_t triangle, const core::Vec3& p_W) const;
    /// Suspends the colours while another overlay colours the structures; false restores the selection.
    void setCovered(bool isCovered);
    /// Sets the stable limit of the device.
    void setGreatest(const haptics::Tissue& greatest);

  private:
    void refresh();
    void restore();

    VtkViewport& m_viewport;
    StructureModel& m_model;
    haptics::Tissue m_greatest = core::unbounded();
    int m_row = -1;
    bool m_isCovered = false;
    QString m_what;
    SurfaceField m_shown; ///< empty values: nothing shown
};

} // namespace palpate::ui

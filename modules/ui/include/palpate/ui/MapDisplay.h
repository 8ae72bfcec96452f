// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/StructureModel.h"

#include <QObject>
#include <QStringList>

#include <optional>

#include <vector>

namespace palpate::ui {

class VtkViewport;

/// Numbers over a structure that it can be coloured by.
struct SurfaceNumbers
{
    QString what;  ///< names them for the program: "felt:stiffness", "array:StiffnessScale"
    QString title; ///< for a person, with the unit: "felt, N/mm"
    bool isPerTriangle = false;
    std::vector<float> values{}; ///< NaN: not known
};

/// What a structure can be coloured by: what is felt of each map, then each array of its mesh. Without their values.
[[nodiscard]] std::vector<SurfaceNumbers> numbersOf(const meshio::LoadedStructure& structure);
/// The same with its values. @param felt  the structure as it is felt: nothing is shown above what the device holds
[[nodiscard]] SurfaceNumbers numbersOf(const meshio::LoadedStructure& structure, const QString& what,
                                       const haptics::HapticStructure& felt);

/// Colours one structure of the view by numbers, with a legend; follows what changes them.
/// @par Thread The window's.
class MapDisplay : public QObject
{
    Q_OBJECT
  public:
    /// Both must outlive this.
    MapDisplay(VtkViewport& viewport, StructureModel& model, QObject* parent = nullptr);

    /// @param what  a `SurfaceNumbers::what`; empty: in its own colour again
    void show(int row, const QString& what);
    /// What is shown, as a scene file keeps it; nothing where each structure has its own colour.
    [[nodiscard]] std::optional<meshio::ShownMap> shown() const;
    /// The number that is shown at a place: "stiffness felt 0.42 N/mm"; empty where this structure has no such colours.
    /// @param triangle  number in the structure's repaired mesh; @param p_W  on it [mm]
    [[nodiscard]] QString textAt(int row, std::size_t triangle, const core::Vec3& p_W) const;
    /// Draws nothing while something else colours the structures; then what was chosen again.
    void setCovered(bool isCovered);
    /// Says what the device holds.
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
    SurfaceNumbers m_shown; ///< without values: none
};

} // namespace palpate::ui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/CameraFlight.h"
#include "palpate/ui/LumpMaps.h"
#include "palpate/ui/MapDisplay.h"
#include "palpate/ui/StructureModel.h"

#include <QObject>

#include <vector>

namespace palpate::ui {

/// What can be felt of lumps through the organs of the open scene (see LumpMaps), drawn on the organs.
class FeltOverlay : public QObject
{
    Q_OBJECT
  public:
    /// How deep the finger is pressed in. [mm]
    static constexpr const auto& kPress_mm = haptics::kFeltPress_mm;

    /// All must outlive this. @param maps  draws nothing while this does
    FeltOverlay(VtkViewport& viewport, StructureModel& model, LumpMaps& lumps, MapDisplay& maps,
                QObject* parent = nullptr);

    /// Draws it on the organs, or no more.
    void setShown(bool isShown);
    [[nodiscard]] bool isShown() const noexcept { return m_isShown; }
    /// Computes it for a table, drawn or not.
    void setTabled(bool isTabled);
    /// @param press  number in kPress_mm, for what is drawn and said
    void setPress(std::size_t press);
    [[nodiscard]] std::size_t press() const noexcept { return m_press; }
    [[nodiscard]] const FeltOrgans& organs() const noexcept { return m_lumps.organs(); }
    [[nodiscard]] bool isUpToDate() const noexcept { return m_lumps.isUpToDate(); }
    [[nodiscard]] bool isBusy() const noexcept { return m_lumps.isBusy(); }
    [[nodiscard]] const QStringList& notes() const noexcept { return m_lumps.notes(); }

    /// What is felt at a place, in words; empty where nothing is drawn. @param p_W  on the structure [mm]
    [[nodiscard]] QString textAt(int row, const core::Vec3& p_W) const;
    /// Flies to where a lump is felt most and marks it. @param organ,lump  numbers in organs(), and of its lumps
    /// @return false where no place is judged
    bool showBestPlace(std::size_t organ, std::size_t lump);

  Q_SIGNALS:
    /// Other results, or they are out of date, or another press.
    void changed();

  private:
    void take();
    void draw();
    void drawLegend(double greatest_percent, bool isHatched);
    void undraw();

    VtkViewport& m_viewport;
    StructureModel& m_model;
    LumpMaps& m_lumps;
    MapDisplay& m_maps;
    CameraFlight m_flight;
    std::vector<int> m_drawn; ///< rows
    std::size_t m_press = 0;
    bool m_isShown = false, m_isTabled = false;
};

} // namespace palpate::ui

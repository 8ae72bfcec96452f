// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/CameraFlight.h"
#include "palpate/ui/LumpMaps.h"
#include "palpate/ui/MapDisplay.h"
#include "palpate/ui/StructureModel.h"

#include <palpate/core/Export.h>

#include <QObject>

#include <vector>

namespace palpate::ui {

/// Draws the computed palpability of buried lumps (see LumpMaps) on the organs of the open scene.
class PALPATE_EXPORT FeltOverlay : public QObject
{
    Q_OBJECT
  public:
    /// Penetration depths for which the maps are computed. [mm]
    static constexpr const auto& kPress_mm = haptics::kFeltPress_mm;

    /// All references must outlive this object. @param maps  hidden while this overlay is drawn
    FeltOverlay(VtkViewport& viewport, StructureModel& model, LumpMaps& lumps, MapDisplay& maps,
                QObject* parent = nullptr);

    /// Shows or hides the overlay.
    void setShown(bool isShown);
    [[nodiscard]] bool isShown() const noexcept { return m_isShown; }
    /// Requests the results for a table, independent of drawing.
    void setTabled(bool isTabled);
    /// Selects the penetration depth for drawing and texts. @param press  index into kPress_mm
    void setPress(std::size_t press);
    [[nodiscard]] std::size_t press() const noexcept { return m_press; }
    [[nodiscard]] const DisplayedOrgans& organs() const noexcept { return m_lumps.organs(); }
    [[nodiscard]] bool isUpToDate() const noexcept { return m_lumps.isUpToDate(); }
    [[nodiscard]] bool isBusy() const noexcept { return m_lumps.isBusy(); }
    [[nodiscard]] const QStringList& notes() const noexcept { return m_lumps.notes(); }

    /// Description of the palpability at a place; empty where nothing is drawn. @param p_W  on the structure, world
    /// frame [mm]
    [[nodiscard]] QString textAt(int row, const core::Vec3& p_W) const;
    /// Moves the camera to the place where a lump is most palpable and marks the place.
    /// @param organ,lump  index in organs() and index of the organ's lump
    /// @return false where no place was evaluated
    bool showBestPlace(std::size_t organ, std::size_t lump);

  Q_SIGNALS:
    /// Emitted when results change, become outdated, or another penetration depth is selected.
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
    std::vector<int> m_drawn; ///< rows of structures with overlay colours
    std::size_t m_press = 0;
    bool m_isShown = false, m_isTabled = false;
};

} // namespace palpate::ui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/CameraFlight.h"
#include "palpate/ui/MapDisplay.h"
#include "palpate/ui/SceneDistances.h"
#include "palpate/ui/TapeTool.h"

#include <palpate/core/Export.h>

#include <QObject>
#include <QThreadPool>

#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace palpate::ui {

class VtkViewport;

/// Draws measured distances in the view: the tapes, and for the chosen pair of structures the line between the two
/// closest points, the bands of the margin on the lump, and a legend.
///
/// @par Thread GUI thread only.
class PALPATE_EXPORT MarginOverlay : public QObject
{
    Q_OBJECT
  public:
    /// All references must outlive this object. @param maps  hidden while the bands are drawn
    MarginOverlay(VtkViewport& viewport, StructureModel& model, SceneDistances& distances, MapDisplay& maps,
                  const TapesModel& tapes, const TapeTool& tool, QObject* parent = nullptr);
    ~MarginOverlay() override; ///< waits for the worker

    /// Shows or hides line and bands of the chosen pair. Tapes are always shown.
    void setShown(bool isShown);
    /// Chooses a pair of SceneDistances::table(); empty: none.
    void choose(std::optional<std::size_t> pair);
    /// Chooses a tape, drawn with a wider line. @param row  -1: none
    void chooseTape(int row);
    /// Moves the camera to the line between the closest points of the chosen pair, or to the chosen tape.
    void flyToPair();
    void flyToTape();

    /// Margin of a pair: the first structure is the lump. @return null without margin
    [[nodiscard]] const study::LumpMargin* marginOf(std::size_t pair) const;

  private:
    void draw();
    void drawLines();
    void colour(const study::LumpMargin& margin);
    void fadeAround(std::size_t lump);
    void drawLegend(const study::LumpMargin& margin);
    void undraw();
    void fly(const core::Vec3& from_W, const core::Vec3& to_W);

    VtkViewport& m_viewport;
    StructureModel& m_model;
    SceneDistances& m_distances;
    MapDisplay& m_maps;
    const TapesModel& m_tapes;
    const TapeTool& m_tool;
    CameraFlight m_flight;
    QThreadPool m_thread;
    std::atomic<std::size_t> m_asked{0}; ///< number of requested pictures; older results are discarded
    std::optional<int> m_drawn;          ///< row of the structure with bands
    std::vector<int> m_faded;            ///< rows of translucent structures
    std::optional<std::size_t> m_pair;
    int m_tape = -1;
    bool m_isShown = false;
};

} // namespace palpate::ui

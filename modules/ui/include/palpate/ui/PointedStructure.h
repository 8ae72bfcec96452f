// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/MapDisplay.h"
#include "palpate/ui/StructureModel.h"

#include <QObject>
#include <QPointF>
#include <QTimer>

#include <functional>
#include <optional>
#include <utility>

class QLabel;

namespace palpate::ui {

class VtkViewport;

/// Which structure the pointer is on: names it beside the pointer, with its number where the structure is coloured by a
/// map, and says which was clicked. Also one that can't be felt.
/// @par Thread The GUI's.
class PointedStructure : public QObject
{
    Q_OBJECT
  public:
    /// A place on a structure.
    struct Place
    {
        int row = 0;
        std::size_t triangle = 0; ///< number in the structure's repaired mesh
        core::Vec3 p_W = core::Vec3::Zero();
    };

    /// All must outlive this.
    PointedStructure(VtkViewport& viewport, const StructureModel& model, const MapDisplay& maps,
                     QObject* parent = nullptr);

    /// The nearest structure that is shown at a place of the view. @par Cost As `view::firstHit`.
    [[nodiscard]] std::optional<Place> at(const QPointF& place) const;
    /// Says more of a place after the structure's name; an empty text says nothing.
    void setMore(std::function<QString(const Place&)> more) { m_more = std::move(more); }
    /// "liver · stiffness felt 0.42 N/mm"
    [[nodiscard]] QString textOf(const Place& place) const;

  Q_SIGNALS:
    /// A structure was clicked while the pointer moves the camera. @param row  -1: beside all
    void clicked(int row, Qt::KeyboardModifiers modifiers);

  private:
    void show();

    VtkViewport& m_viewport;
    const StructureModel& m_model;
    const MapDisplay& m_maps;
    std::function<QString(const Place&)> m_more;
    QTimer m_frame; ///< at most one look a frame
    QPointF m_place;
    QLabel* m_name = nullptr;
};

} // namespace palpate::ui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/MapDisplay.h"
#include "palpate/ui/StructureModel.h"

#include <palpate/core/Export.h>

#include <QObject>
#include <QPointF>
#include <QTimer>

#include <functional>
#include <optional>
#include <utility>

class QLabel;

namespace palpate::ui {

class VtkViewport;

/// Identifies the structure under the pointer: shows a label with the name and the value of a displayed scalar field,
/// and reports clicks. Includes structures that are not palpable.
///
/// @par Thread GUI thread only.
class PALPATE_EXPORT PointedStructure : public QObject
{
    Q_OBJECT
  public:
    /// Place on a structure.
    struct Place
    {
        int row = 0;
        std::size_t triangle = 0; ///< index in the structure's repaired mesh
        core::Vec3 p_W = core::Vec3::Zero();
        core::Vec3 rest_W = core::Vec3::Zero(); ///< of a moving structure: on the rest shape
        bool isOnCut = false;                   ///< on a cut face of the section; then without a triangle
    };

    /// All references must outlive this object.
    PointedStructure(VtkViewport& viewport, const StructureModel& model, const MapDisplay& maps,
                     QObject* parent = nullptr);

    /// Nearest visible structure at a place of the view. @par Cost as `view::firstHit`.
    [[nodiscard]] std::optional<Place> at(const QPointF& place) const;
    /// The same among structures of at least an opacity: what is seen behind translucent tissue. @param opacity  0 to 1
    [[nodiscard]] std::optional<Place> at(const QPointF& place, double opacity) const;
    /// Sets a callback that adds text after the structure's name; an empty result adds nothing.
    void setMore(std::function<QString(const Place&)> more) { m_more = std::move(more); }
    /// Sets a callback that may take a click, which then selects nothing.
    void setClickTaker(std::function<bool(const QPointF& place)> taker) { m_taker = std::move(taker); }
    /// Readable name of the structure.
    [[nodiscard]] QString nameOf(const Place& place) const;
    /// Label text: "liver · stiffness felt 0.42 N/mm".
    [[nodiscard]] QString textOf(const Place& place) const;

  Q_SIGNALS:
    /// Emitted for a click in camera mode. @param row  -1: background
    void clicked(int row, Qt::KeyboardModifiers modifiers);

  private:
    void show();

    VtkViewport& m_viewport;
    const StructureModel& m_model;
    const MapDisplay& m_maps;
    std::function<QString(const Place&)> m_more;
    std::function<bool(const QPointF&)> m_taker;
    QTimer m_frame; ///< at most one lookup per frame
    QPointF m_place;
    QLabel* m_name = nullptr;
};

} // namespace palpate::ui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/TapesModel.h"

#include <palpate/core/Export.h>
#include <palpate/core/Types.h>

#include <QObject>
#include <QPointF>

#include <functional>
#include <optional>
#include <string>

namespace palpate::ui {

class PointedStructure;
class VtkViewport;

/// Measures straight distances in the view: from one click on a surface to the next, or between two places that the
/// hand touches. An end snaps to a finding nearby.
///
/// @par Thread GUI thread only.
class PALPATE_EXPORT TapeTool : public QObject
{
    Q_OBJECT
  public:
    static constexpr double kSnap_px = 8.0; ///< distance of a place to a finding, for snapping

    /// @param touched  name of the structure that the hand touches; all references must outlive this object
    TapeTool(VtkViewport& viewport, PointedStructure& pointed, TapesModel& tapes, std::function<QString()> touched,
             QObject* parent = nullptr);
    ~TapeTool() override;

    /// Takes the place that the hand touches as an end. Without contact, starts measuring by clicks, or gives up the
    /// begun tape.
    void press();
    /// Gives up a begun tape. @return false if none was begun
    bool cancel();
    [[nodiscard]] bool isMeasuring() const noexcept { return m_isMeasuring; }
    /// First end of the begun tape, and the line to the pointer.
    [[nodiscard]] const std::optional<core::Tape>& begun() const noexcept { return m_begun; }

  Q_SIGNALS:
    void said(const QString& line);
    /// The begun tape changed: its line must be drawn again.
    void changed();
    void ended();

  private:
    struct End
    {
        core::Vec3 p_W = core::Vec3::Zero();
        std::string on;
    };
    [[nodiscard]] End snapped(const End& end) const;
    [[nodiscard]] std::optional<End> endAt(const QPointF& place) const;
    bool click(const QPointF& place);
    void follow(const QPointF& place);
    void take(const End& end);
    void setMeasuring(bool isMeasuring);
    void finish();

    VtkViewport& m_viewport;
    PointedStructure& m_pointed;
    TapesModel& m_tapes;
    std::function<QString()> m_touched;
    bool m_isMeasuring = false;
    std::optional<core::Tape> m_begun; ///< `to_W` follows the pointer
};

} // namespace palpate::ui

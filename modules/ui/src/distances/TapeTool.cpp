// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/TapeTool.h"

#include "palpate/ui/PointedStructure.h"
#include "palpate/ui/StructureModel.h"
#include "palpate/ui/VtkViewport.h"

#include <cmath>
#include <utility>

namespace palpate::ui {

TapeTool::TapeTool(VtkViewport& viewport, PointedStructure& pointed, TapesModel& tapes,
                   std::function<QString()> touched, QObject* parent)
    : QObject(parent)
    , m_viewport(viewport)
    , m_pointed(pointed)
    , m_tapes(tapes)
    , m_touched(std::move(touched))
{
    pointed.setClickTaker([this](const QPointF& place) { return click(place); });
    connect(&viewport, &VtkViewport::hovered, this, &TapeTool::follow);
}

TapeTool::~TapeTool()
{
    m_pointed.setClickTaker({});
}

void TapeTool::press()
{
    const view::TouchState& touch = m_viewport.view().cursor().state();
    if (touch.isInContact) {
        setMeasuring(true);
        take(snapped({touch.onSurface_W(), m_touched().toStdString()}));
    } else if (m_begun) {
        cancel();
    } else {
        setMeasuring(!m_isMeasuring);
        Q_EMIT said(m_isMeasuring ? tr("Tape: click on two places, or touch a place and press T, then another. Esc "
                                       "ends.")
                                  : tr("The tape is put away."));
    }
}

bool TapeTool::cancel()
{
    if (!m_isMeasuring) {
        return false;
    }
    Q_EMIT said(tr("The tape is put away."));
    finish();
    return true;
}

void TapeTool::finish()
{
    setMeasuring(false);
    m_begun.reset();
    Q_EMIT changed();
    Q_EMIT ended();
}

/// While the tape is chosen, a click is an end in palpation mode, too. The key in the middle of a press of the mouse
/// makes that press no click.
void TapeTool::setMeasuring(bool isMeasuring)
{
    m_isMeasuring = isMeasuring;
    m_viewport.setClicksWhilePalpating(isMeasuring);
}

/// Moves an end onto the nearest finding in the view that tissue does not hide.
TapeTool::End TapeTool::snapped(const End& end) const
{
    const QPointF at = m_viewport.placeOf(end.p_W);
    view::FindingMarkers& findings = m_viewport.view().findings();
    End best = end;
    double nearest_px = kSnap_px;
    for (std::size_t i = 0; i < findings.count(); ++i) {
        const view::FindingMark& mark = findings.marks()[i];
        const QPointF apart = m_viewport.placeOf(mark.p_W) - at;
        if (const double distance_px = std::hypot(apart.x(), apart.y());
            distance_px <= nearest_px && !findings.isHidden(i)) {
            nearest_px = distance_px;
            best = {mark.p_W, mark.name};
        }
    }
    return best;
}

std::optional<TapeTool::End> TapeTool::endAt(const QPointF& place) const
{
    constexpr double kOpaque = 0.75; // a click on a vessel behind translucent tissue means the vessel
    const auto opaque = m_pointed.at(place, kOpaque);
    const auto found = opaque ? opaque : m_pointed.at(place);
    return found ? std::optional(snapped({found->p_W, m_pointed.nameOf(*found).toStdString()})) : std::nullopt;
}

bool TapeTool::click(const QPointF& place)
{
    if (!m_isMeasuring) {
        return false;
    }
    if (const auto end = endAt(place)) {
        take(*end);
    } else {
        Q_EMIT said(tr("Tape: click on a structure."));
    }
    return true;
}

void TapeTool::follow(const QPointF& place)
{
    if (!m_begun) {
        return;
    }
    if (const auto end = endAt(place)) {
        m_begun->to_W = end->p_W;
        Q_EMIT changed();
    }
}

void TapeTool::take(const End& end)
{
    if (!m_begun) {
        m_begun = core::Tape{{}, end.p_W, end.p_W, end.on, {}, {}};
        Q_EMIT said(end.on.empty() ? tr("Tape: first end set.")
                                   : tr("Tape: first end on %1.").arg(QString::fromStdString(end.on)));
        Q_EMIT changed();
        return;
    }
    core::Tape tape = *m_begun;
    tape.to_W = end.p_W;
    tape.toOn = end.on;
    finish();
    m_tapes.add({std::move(tape)});
    const core::Tape& added = m_tapes.tapes().back();
    Q_EMIT said(tr("%1: %2").arg(QString::fromStdString(added.name), lengthText(added.length_mm())));
}

} // namespace palpate::ui

#include "palpate/ui/moc_TapeTool.cpp"

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/TouchHistory.h"

#include <palpate/core/Tissue.h>
#include <palpate/servo/TickRecord.h>
#include <palpate/view/TouchCursor.h>

#include <QColor>
#include <QString>

#include <cstdint>
#include <functional>
#include <vector>

namespace palpate::ui {

/// One structure that is touched, as panel and chart show it: in most ticks the only one of its layer.
struct FeltLayer
{
    QString name;
    QColor colour;
    double force_N = 0.0; ///< length of its share of the force
    double along_N = 0.0; ///< its share along the whole force: these add up to it
    double depth_mm = 0.0;
    haptics::Friction friction = haptics::Friction::None;
    double sideways_N = 0.0;     ///< part of its share along the surface
    double stiffnessScale = 1.0; ///< by which maps and lumps below scale its law at the touch [1]
};

/// How stiff what a tick touches is.
struct FeltStiffness
{
    double whole_N_per_mm = 0.0; ///< of all layers together, with maps and lumps below
    double ratio = 1.0;          ///< by that of the outermost layer's tissue alone
};
/// @return nothing for a structure that is not known
using TissueOf = std::function<const core::Tissue*(std::uint32_t structure)>;
[[nodiscard]] FeltStiffness feltStiffness(const servo::TickRecord& tick, const TissueOf& tissueOf);

/// What a structure is called and how it is drawn.
struct LayerLook
{
    QString name;
    QColor colour;
};
/// @param structure  number in the scene that was felt
using LayerLooks = std::function<LayerLook(std::uint32_t structure)>;

/// "holds 0.4 N" or "slides 0.4 N": what friction does to a layer; empty without it.
[[nodiscard]] QString frictionText(const FeltLayer& layer);

/// The structures that a tick touches: the outermost layer first, in a layer the one that pushes most.
/// @param shown_N  length of the force that the hand gets [N]: shares are those of the model, in proportion
[[nodiscard]] std::vector<FeltLayer> feltLayers(const servo::TickRecord& tick, double shown_N, const LayerLooks& looks);
/// "liver 2.53 N · lump 20 mm 3.48 N, pressed in 5.8 mm"; of a single layer its name. The forces are the parts along
/// the whole, which add up to it.
[[nodiscard]] QString layersText(const std::vector<FeltLayer>& layers);
/// The same as rich text, a line a layer, each behind a mark in the structure's colour.
[[nodiscard]] QString layersMarkup(const std::vector<FeltLayer>& layers);
/// What the chart keeps of them.
[[nodiscard]] std::vector<LayerForce> layerForces(const std::vector<FeltLayer>& layers);
/// Puts the disc within which friction holds the god-object into the cursor: for the outermost layer, on a face.
/// @param tissue  of the structure that is reported
void showFriction(const servo::TickRecord& tick, const core::Tissue& tissue, view::TouchState& state);
/// A tick as the cursor shows it.
/// @param f_W  force on the hand [N]; @param tissue  of the structure that is reported; null: none of friction is shown
[[nodiscard]] view::TouchState touchState(const servo::TickRecord& tick, const core::Vec3& f_W, double fingertip_mm,
                                          const std::vector<FeltLayer>& layers, const core::Tissue* tissue);
/// Puts the god-objects below the reported one into the cursor.
void showInner(const servo::TickRecord& tick, const std::vector<FeltLayer>& layers, view::TouchState& state);

} // namespace palpate::ui

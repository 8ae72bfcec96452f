// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/TouchHistory.h"

#include <palpate/core/Export.h>
#include <palpate/core/Tissue.h>
#include <palpate/servo/TickRecord.h>
#include <palpate/view/TouchCursor.h>

#include <QColor>
#include <QString>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace palpate::ui {

/// Contact with one structure, for panel and chart. In most ticks a layer contains a single structure.
struct LayerShare
{
    QString name;
    QColor colour;
    double force_N = 0.0; ///< magnitude of this structure's force
    double along_N = 0.0; ///< component along the total force; the components add up to the total
    double depth_mm = 0.0;
    haptics::Friction friction = haptics::Friction::None;
    double sideways_N = 0.0;     ///< component along the surface
    double stiffnessScale = 1.0; ///< scale of the force law at the contact, from maps and buried lumps [1]
    std::size_t contact = 0;     ///< index in the contacts of the tick
};

/// Stiffness at the contact of a tick.
struct ContactStiffness
{
    double whole_N_per_mm = 0.0; ///< all layers together, including maps and buried lumps
    double ratio = 1.0;          ///< relative to the tissue of the outermost layer alone
};
/// Looks up a structure's tissue; null for an unknown structure.
using TissueOf = std::function<const core::Tissue*(std::uint32_t structure)>;
[[nodiscard]] PALPATE_EXPORT ContactStiffness contactStiffness(const servo::TickRecord& tick, const TissueOf& tissueOf);

/// Name and display colour of a structure.
struct LayerStyle
{
    QString name;
    QColor colour;
    bool isHidden = false; ///< must not be shown: a hidden target of an exercise
};
/// Looks up a structure's name and colour. @param structure  number in the scene of the tick
using LayerStyleLookup = std::function<LayerStyle(std::uint32_t structure)>;

/// Friction state of a layer: "holds 0.4 N" or "slides 0.4 N"; empty without friction.
[[nodiscard]] PALPATE_EXPORT QString frictionText(const LayerShare& layer);

/// Lists the structures in contact, outermost layer first, within a layer by decreasing force. The force of a hidden
/// target is added to the structure around it; only a hidden target that nothing else covers has an entry of its own.
/// @param shown_N  magnitude of the force on the hand [N]; the model's forces are scaled in proportion
[[nodiscard]] PALPATE_EXPORT std::vector<LayerShare> layerShares(const servo::TickRecord& tick, double shown_N,
                                                                 const LayerStyleLookup& looks);
/// One-line description: "liver 2.53 N · lump 20 mm 3.48 N, pressed in 5.8 mm". A single layer gives only the name. The
/// forces are components along the total force and add up to the total.
[[nodiscard]] PALPATE_EXPORT QString layersText(const std::vector<LayerShare>& layers);
/// Rich-text version of `layersText` with one line per layer and a mark in the structure's colour.
[[nodiscard]] PALPATE_EXPORT QString layersMarkup(const std::vector<LayerShare>& layers);
/// Converts layers to chart samples.
[[nodiscard]] PALPATE_EXPORT std::vector<LayerForce> layerForces(const std::vector<LayerShare>& layers);
/// Adds the friction disc to the cursor: the region in which friction holds the god-object. Only for the outermost
/// layer in contact with a face.
/// @param tissue  tissue of the reported structure
PALPATE_EXPORT void showFriction(const servo::TickRecord& tick, const core::Tissue& tissue, view::TouchState& state);
/// Converts a tick to the cursor's state.
/// @param f_W  force on the hand, world frame [N]
/// @param tissue  tissue of the reported structure; null omits friction
[[nodiscard]] PALPATE_EXPORT view::TouchState touchState(const servo::TickRecord& tick, const core::Vec3& f_W,
                                                         double fingertip_mm, const std::vector<LayerShare>& layers,
                                                         const core::Tissue* tissue);
/// Adds the god-objects of the inner layers to the cursor.
PALPATE_EXPORT void showInner(const servo::TickRecord& tick, const std::vector<LayerShare>& layers,
                              view::TouchState& state);

} // namespace palpate::ui

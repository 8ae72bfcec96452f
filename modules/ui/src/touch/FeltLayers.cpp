// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/FeltLayers.h"

#include <palpate/haptics/ForceTable.h>
#include <palpate/view/Dimple.h>
#include <palpate/view/StateOf.h>

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include <algorithm>

namespace palpate::ui {

namespace {

QString number(double value)
{
    return QLocale().toString(value, 'f', value < 0.95 ? 2 : 1);
}

/// True for further structures in contact with the god-object of a layer; the first of them has the largest force.
bool sharesGodObject(const servo::TickRecord& tick, std::size_t i)
{
    return i > 0 && tick.felt.contacts[i].layer == tick.felt.contacts[i - 1].layer;
}

/// Text of a layer's force. @param isInner  adds the penetration depth, which the panel shows elsewhere for the
/// outermost layer
QString shareText(const LayerShare& layer, bool isInner)
{
    // The component along the total force, with fixed digits. These components add up to the total; the vector lengths
    // do not.
    const QString along = QLocale().toString(layer.along_N, 'f', 2);
    const QString share =
        isInner ? QCoreApplication::translate("FeltLayers", "%1 N, pressed in %2 mm").arg(along, number(layer.depth_mm))
                : QCoreApplication::translate("FeltLayers", "%1 N").arg(along);
    return layer.friction == haptics::Friction::None ? share : share + QStringLiteral(", ") + frictionText(layer);
}

} // namespace

QString frictionText(const LayerShare& layer)
{
    switch (layer.friction) {
    case haptics::Friction::Holds:
        return QCoreApplication::translate("FeltLayers", "holds %1 N").arg(number(layer.sideways_N));
    case haptics::Friction::Slides:
        return QCoreApplication::translate("FeltLayers", "slides %1 N").arg(number(layer.sideways_N));
    case haptics::Friction::None:
        break;
    }
    return {};
}

std::vector<LayerShare> layerShares(const servo::TickRecord& tick, double shown_N, const LayerStyleLookup& looks)
{
    const double model_N = tick.felt.f_W.norm();
    const double scale = model_N > 0.0 ? shown_N / model_N : 0.0;
    const core::Vec3 direction = model_N > 0.0 ? core::Vec3(tick.felt.f_W / model_N) : core::Vec3::Zero();
    std::vector<LayerShare> layers;
    bool isAlone = false; // the only entry is a hidden target
    for (std::size_t i = 0; i < tick.felt.contactCount; ++i) {
        const haptics::Contact& contact = tick.felt.contacts[i];
        LayerStyle look = looks(contact.structure);
        const core::Vec3 sideways = contact.f_W - contact.f_W.dot(contact.n_W) * contact.n_W;
        LayerShare share{std::move(look.name),
                         look.colour,
                         scale * contact.f_W.norm(),
                         scale * contact.f_W.dot(direction),
                         contact.depth_mm,
                         contact.friction,
                         scale * sideways.norm(),
                         contact.stiffnessScale,
                         i};
        if (layers.empty() || !(look.isHidden || isAlone)) {
            isAlone = layers.empty() && look.isHidden;
            layers.push_back(std::move(share));
        } else if (look.isHidden) {
            layers.back().force_N += share.force_N;
            layers.back().along_N += share.along_N;
        } else {
            share.force_N += layers.back().force_N;
            share.along_N += layers.back().along_N;
            layers.back() = std::move(share);
            isAlone = false;
        }
    }
    return layers;
}

ContactStiffness contactStiffness(const servo::TickRecord& tick, const TissueOf& tissueOf)
{
    ContactStiffness felt;
    double alone_N_per_mm = 0.0;
    for (std::size_t i = 0; i < tick.felt.contactCount; ++i) {
        const haptics::Contact& contact = tick.felt.contacts[i];
        if (sharesGodObject(tick, i)) {
            continue; // its force has another direction
        }
        const core::Tissue* tissue = tissueOf(contact.structure);
        const double own_N_per_mm = tissue != nullptr ? haptics::stiffnessAt(*tissue, contact.depth_mm) : 0.0;
        felt.whole_N_per_mm += contact.stiffnessScale * own_N_per_mm;
        alone_N_per_mm = i == 0 ? own_N_per_mm : alone_N_per_mm;
    }
    felt.ratio = alone_N_per_mm > 0.0 ? felt.whole_N_per_mm / alone_N_per_mm : 1.0;
    return felt;
}

QString layersText(const std::vector<LayerShare>& layers)
{
    if (layers.size() == 1 && layers.front().friction == haptics::Friction::None) {
        return layers.front().name;
    }
    QStringList parts;
    for (const LayerShare& layer : layers) {
        parts << layer.name + QLatin1Char(' ') + shareText(layer, !parts.isEmpty());
    }
    return parts.join(QStringLiteral(" · "));
}

QString layersMarkup(const std::vector<LayerShare>& layers)
{
    QStringList parts;
    for (const LayerShare& layer : layers) {
        const bool isInner = !parts.isEmpty();
        const QString text = QStringLiteral("<b>%1</b> %2").arg(layer.name.toHtmlEscaped(), shareText(layer, isInner));
        parts << QStringLiteral("<span style='color:%1'>■</span> %2").arg(layer.colour.name(), text);
    }
    return QStringLiteral("<p style='white-space:pre'>%1</p>").arg(parts.join(QStringLiteral("<br>")));
}

std::vector<LayerForce> layerForces(const std::vector<LayerShare>& layers)
{
    std::vector<LayerForce> forces;
    for (const LayerShare& layer : layers) {
        forces.push_back({layer.colour, layer.along_N});
    }
    return forces;
}

void showFriction(const servo::TickRecord& tick, const core::Tissue& tissue, view::TouchState& state)
{
    state.friction = {};
    const haptics::TickResult& felt = tick.felt;
    if (felt.friction() == haptics::Friction::None || felt.constraints != 1) {
        return;
    }
    const double depth_mm = (felt.p_WG - tick.p_WH).dot(felt.n_W);
    const bool slides = felt.friction() == haptics::Friction::Slides;
    state.friction = {tick.p_WH + depth_mm * felt.n_W, felt.n_W,
                      depth_mm * (slides ? tissue.friction_dynamic : tissue.friction_static)};
}

void showInner(const servo::TickRecord& tick, const std::vector<LayerShare>& layers, view::TouchState& state)
{
    state.innerCount = 0;
    for (const LayerShare& layer : layers) {
        if (layer.contact == 0 || layer.contact >= tick.felt.contactCount || sharesGodObject(tick, layer.contact)) {
            continue;
        }
        const haptics::Contact& contact = tick.felt.contacts[layer.contact];
        state.inner[state.innerCount++] = {
            contact.p_WG, {layer.colour.redF(), layer.colour.greenF(), layer.colour.blueF()}, contact.depth_mm};
    }
}

view::TouchState touchState(const servo::TickRecord& tick, const core::Vec3& f_W, double fingertip_mm,
                            const std::vector<LayerShare>& layers, const core::Tissue* tissue)
{
    view::TouchState state = view::stateOf(tick, fingertip_mm);
    state.f_W = f_W;
    if (state.isInContact) {
        showInner(tick, layers, state);
    }
    if (state.isInContact && tissue != nullptr) {
        showFriction(tick, *tissue, state);
        state.bends = tissue->stiffness_N_per_mm <= view::Dimple::kRigid_N_per_mm;
    }
    return state;
}

} // namespace palpate::ui

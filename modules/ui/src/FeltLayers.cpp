// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/FeltLayers.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include <algorithm>

namespace palpate::ui {

namespace {

QString shareText(const FeltLayer& layer, bool isInner)
{
    const auto number = [](double value) { return QLocale().toString(value, 'f', value < 0.95 ? 2 : 1); };
    return isInner ? QCoreApplication::translate("FeltLayers", "%1 %2 N, %3 mm in")
                         .arg(layer.name, number(layer.force_N), number(layer.depth_mm))
                   : QCoreApplication::translate("FeltLayers", "%1 %2 N").arg(layer.name, number(layer.force_N));
}

} // namespace

std::vector<FeltLayer> feltLayers(const servo::TickRecord& tick, double shown_N, const LayerLooks& looks)
{
    const double model_N = tick.felt.f_W.norm();
    const double scale = model_N > 0.0 ? shown_N / model_N : 0.0;
    const core::Vec3 direction = model_N > 0.0 ? core::Vec3(tick.felt.f_W / model_N) : core::Vec3::Zero();
    std::vector<FeltLayer> layers;
    for (std::size_t i = 0; i < tick.felt.contactCount; ++i) {
        const haptics::Contact& contact = tick.felt.contacts[i];
        LayerLook look = looks(contact.structure);
        layers.push_back({std::move(look.name), look.colour, scale * contact.f_W.norm(),
                          scale * contact.f_W.dot(direction), contact.depth_mm});
    }
    return layers;
}

QString layersText(const std::vector<FeltLayer>& layers)
{
    if (layers.size() == 1) {
        return layers.front().name;
    }
    QStringList parts;
    for (const FeltLayer& layer : layers) {
        parts << shareText(layer, !parts.isEmpty());
    }
    return parts.join(QStringLiteral(" · "));
}

QString layersMarkup(const std::vector<FeltLayer>& layers)
{
    QStringList parts;
    for (const FeltLayer& layer : layers) {
        const bool isInner = !parts.isEmpty();
        // A line may break between layers alone.
        const QString text =
            shareText(layer, isInner).toHtmlEscaped().replace(QLatin1Char(' '), QStringLiteral("&nbsp;"));
        parts << QStringLiteral("<span style='color:%1'>%2</span>&nbsp;%3")
                     .arg(layer.colour.name(), QString(isInner ? QChar(0x25a8) : QChar(0x25a0)), text);
    }
    return parts.join(QStringLiteral(" · "));
}

std::vector<LayerForce> layerForces(const std::vector<FeltLayer>& layers)
{
    std::vector<LayerForce> forces;
    for (const FeltLayer& layer : layers) {
        forces.push_back({layer.colour, layer.along_N});
    }
    return forces;
}

void showInner(const servo::TickRecord& tick, const std::vector<FeltLayer>& layers, view::TouchState& state)
{
    state.innerCount = 0;
    for (std::size_t i = 1; i < std::min<std::size_t>(layers.size(), tick.felt.contactCount); ++i) {
        const QColor& colour = layers[i].colour;
        state.inner[state.innerCount++] = {tick.felt.contacts[i].p_WG,
                                           {colour.redF(), colour.greenF(), colour.blueF()}};
    }
}

} // namespace palpate::ui

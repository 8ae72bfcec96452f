// SPDX-License-Identifier: BSD-3-Clause
#include "scene/LayerOffers.h"

#include "shared/LumpLayout.h"

#include <palpate/haptics/HapticScene.h>
#include <palpate/study/BuriedLumps.h>
#include <palpate/study/HapticCopy.h>
#include <palpate/study/Layers.h>
#include <palpate/ui/MessageBar.h>
#include <palpate/ui/SceneLoader.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/ui/TouchMode.h>
#include <palpate/ui/Translated.h>

#include <QUndoStack>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace palpate::app {

using ui::StructureModel;

namespace {

/// Joins up to two sentences; of more, gives the first and the number of others.
QString joinedSentences(const QStringList& sentences)
{
    const QString& first = sentences.front();
    if (sentences.size() <= 2) {
        return sentences.join(QStringLiteral("; ")) + QLatin1Char('.');
    }
    return LayerOffers::tr("%1; %2 more are listed in the panel.").arg(first).arg(sentences.size() - 1);
}

/// Layer of a structure by nesting in structures that were open before others were added.
std::uint32_t layerBefore(const ui::OpenedScene& scene, std::size_t row)
{
    std::uint32_t layer = 0;
    for (auto in = scene.layering.structures[row].in; in; in = scene.layering.structures[*in].in) {
        layer += *in < scene.addedTo ? 1 : 0;
    }
    return std::min<std::uint32_t>(layer, haptics::kMaxLayers - 1);
}

} // namespace

LayerOffers::LayerOffers(StructureModel& model, ui::MessageBar& bar, QObject* parent)
    : QObject(parent)
    , m_model(model)
    , m_bar(bar)
{
}

bool LayerOffers::isFlat() const
{
    bool isFlat = m_model.buried() == meshio::BuriedTouch::Layers;
    for (int row = 0; row < m_model.rowCount(); ++row) {
        isFlat = isFlat && m_model.structure(row).layer == 0;
    }
    return isFlat;
}

void LayerOffers::layOut(const ui::OpenedScene& scene, bool hasRecording)
{
    if (!isFlat()) {
        return;
    }
    const bool areMeshes = scene.areMeshes();
    const bool isLayered = scene.layering.isLayered();
    if (isLayered && (!areMeshes || hasRecording)) {
        offer(scene.layering);
    } else if (areMeshes) {
        const LumpLayout found(m_model, scene.layering, 0);
        if (isLayered) {
            ui::feel(m_model, found.ways(), tr("Feel inner structures below outer ones"));
            m_model.undoStack().setClean(); // automatic changes do not make the document modified
            offerOther(found, joinedSentences(found.lines()));
        } else if (!found.lines().isEmpty()) {
            m_bar.showError(joinedSentences(found.lines())); // duplicate surface
        }
        offerBelowOpen(found);
    }
}

/// Offers to close the open surfaces around lumps, or to feel the lumps as layers below them.
void LayerOffers::offerBelowOpen(const LumpLayout& layout)
{
    if (layout.inOpenSurfaces().empty()) {
        return;
    }
    QStringList lines;
    std::vector<ui::TouchMode> ways;
    std::vector<int> closable;
    for (const LumpLayout::InOpen& one : layout.inOpenSurfaces()) {
        const QString lump = ui::readableName(m_model.structure(one.lump).name);
        const QString around = ui::readableName(m_model.structure(one.around).name);
        const study::OpenStructure& surface = m_model.rows()[static_cast<std::size_t>(one.around)];
        lines << tr("%1 cannot be felt through %2 yet: %3")
                     .arg(lump, around,
                          ui::translated(study::openSurface(around.toStdString(), *surface.loaded.surface)));
        const std::uint32_t below = m_model.structure(one.around).layer + 1;
        ways.push_back({one.lump, std::min<std::uint32_t>(below, haptics::kMaxLayers - 1)});
        if (std::find(closable.begin(), closable.end(), one.around) == closable.end() &&
            !m_model.holes(one.around).empty()) {
            closable.push_back(one.around);
        }
    }
    const QString below = lines.size() == 1 ? tr("Feel it as a layer below") : tr("Feel them as layers below");
    const auto feelBelow = [this, ways] { ui::feel(m_model, ways, tr("Feel inner structures below outer ones")); };
    if (closable.empty()) {
        m_bar.offer(joinedSentences(lines), below, feelBelow);
        return;
    }
    m_bar.ask(
        joinedSentences(lines), tr("Close the holes"), [this, closable] { m_model.closeHoles(closable); }, below,
        feelBelow);
}

void LayerOffers::layOutClosed(const study::Layering& layering)
{
    if (!isFlat()) {
        return;
    }
    const LumpLayout found(m_model, layering, 0);
    ui::feel(m_model, found.ways(), tr("Feel inner structures below outer ones"));
    if (!found.lines().isEmpty()) {
        offerOther(found, joinedSentences(found.lines()));
    }
}

/// Shows how nested structures are palpated and offers the alternative.
void LayerOffers::offerOther(const LumpLayout& layout, const QString& line)
{
    if (layout.lines().isEmpty()) {
        return;
    }
    if (layout.hasTransmittedLump()) {
        m_bar.offer(line, tr("Feel it as a layer"), [this, ways = layout.inLayers()] {
            ui::feel(m_model, ways, tr("Feel inner structures below outer ones"));
        });
        return;
    }
    m_bar.offer(line, tr("All in one layer"), [this, count = m_model.rowCount()] {
        m_model.setLayers(std::vector<std::uint32_t>(static_cast<std::size_t>(count), 0), tr("Feel all in one layer"));
    });
}

void LayerOffers::offer(const study::Layering& layering)
{
    std::vector<bool> isFelt;
    std::vector<std::uint32_t> layers;
    for (int row = 0; row < m_model.rowCount(); ++row) {
        isFelt.push_back(study::canBeFelt(m_model.structure(row)));
        layers.push_back(layering.structures[static_cast<std::size_t>(row)].layer);
    }
    for (std::size_t row = 0; row < isFelt.size(); ++row) {
        const auto in = isFelt[row] ? layering.palpableParent(row, isFelt) : std::nullopt;
        if (in) {
            m_bar.offer(
                tr("%1 lies in %2, but all structures of this scene are in one layer: %1 cannot be felt through %2.")
                    .arg(ui::readableName(m_model.structure(static_cast<int>(row)).name),
                         ui::readableName(m_model.structure(static_cast<int>(*in)).name)),
                tr("Feel it below"),
                [this, layers] { m_model.setLayers(layers, tr("Feel inner structures below outer ones")); });
            return;
        }
    }
}

void LayerOffers::layOutAdded(const ui::OpenedScene& scene, bool isUnsaved)
{
    const LumpLayout layout(m_model, scene.layering, static_cast<int>(scene.addedTo));
    offerBelowOpen(layout);
    bool isAsFound = isUnsaved && scene.areMeshes();
    bool isOther = false;
    for (const ui::TouchMode& way : layout.ways()) {
        const auto i = static_cast<std::size_t>(way.row);
        const std::uint32_t now = m_model.structure(way.row).layer;
        const bool isThrough = m_model.isTransmitted(way.row);
        const bool isFound =
            i >= scene.addedTo || m_model.rows()[i].isRemoved || isThrough || now == layerBefore(scene, i);
        isAsFound = isAsFound && isFound;
        isOther = isOther || (way.layer ? *way.layer != now : !isThrough);
    }
    if (!isOther) {
        return;
    }
    const QString text = tr("Feel inner structures below outer ones");
    if (isAsFound) {
        ui::feel(m_model, layout.ways(), text);
        if (!layout.lines().isEmpty()) {
            offerOther(layout, layout.lines().back() + QLatin1Char('.'));
        }
    } else if (!layout.lines().isEmpty()) {
        m_bar.offer(tr("Added structures lie in or around others. The existing layers were kept."), tr("Feel it below"),
                    [this, ways = layout.inLayers(), text] { ui::feel(m_model, ways, text); });
    }
}

} // namespace palpate::app

#include "moc_LayerOffers.cpp"

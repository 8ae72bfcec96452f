// SPDX-License-Identifier: BSD-3-Clause
#include "shared/LumpLayout.h"

#include <palpate/study/HapticCopy.h>
#include <palpate/study/StiffnessRatio.h>
#include <palpate/ui/FeltWords.h>
#include <palpate/ui/Translated.h>

#include <optional>

using namespace palpate;
using namespace palpate::ui;

namespace {

std::optional<study::StiffnessRatio> ratioOf(const StructureModel& model, int lump, int organ)
{
    return study::stiffnessRatio(model.structure(lump), model.structure(organ));
}

} // namespace

LumpLayout::LumpLayout(const StructureModel& model, const study::Layering& layering, int first)
    : m_model(model)
{
    std::vector<std::string> names;
    for (int row = 0; row < model.rowCount(); ++row) {
        const auto i = static_cast<std::size_t>(row);
        const bool isThere = !model.rows()[i].isRemoved;
        names.push_back(readableName(model.structure(row).name).toStdString());
        m_needsSentence.push_back(isThere && study::canBeFelt(model.structure(row)));
        m_layers.push_back(isThere ? layering.structures[i].layer : model.structure(row).layer);
        m_ways.push_back({row, m_layers.back()});
        if (model.isTransmitted(row)) {
            m_ways.back().layer.reset();
            m_hasTransmittedLump = true;
        }
    }
    const std::vector<bool> isFelt = m_needsSentence;
    for (int row = first; row < model.rowCount(); ++row) {
        const auto i = static_cast<std::size_t>(row);
        const study::Layering::Structure& one = layering.structures[i];
        if (!isFelt[i] || one.twin || !meshio::isLump(meshio::anatomyKind(model.structure(row).name))) {
            continue;
        }
        if (const auto around = layering.palpableParent(i, isFelt)) {
            assignLump(row, model.organAround(row).value_or(static_cast<int>(*around)));
        } else if (one.unreliableParent && isFelt[*one.unreliableParent]) {
            m_open.push_back({row, static_cast<int>(*one.unreliableParent)});
            m_needsSentence[i] = false;
        }
    }
    for (const core::Message& sentence : layering.sentences(names, m_needsSentence)) {
        m_lines << translated(sentence);
    }
}

std::vector<TouchMode> LumpLayout::inLayers() const
{
    std::vector<TouchMode> ways = m_ways;
    for (std::size_t i = 0; i < ways.size(); ++i) {
        ways[i].layer = m_layers[i];
    }
    return ways;
}

/// Lays out one lump. @param around  its organ, else the smallest palpable structure around it
void LumpLayout::assignLump(int row, int around)
{
    const auto i = static_cast<std::size_t>(row);
    const QString name = readableName(m_model.structure(row).name),
                  aroundName = readableName(m_model.structure(around).name);
    const QString why = reasonForLayer(row, around);
    if (why.isEmpty()) {
        m_ways[i].layer.reset();
        m_hasTransmittedLump = true;
        const std::optional<study::StiffnessRatio> ratio = ratioOf(m_model, row, around);
        m_lines << tr("%1 lies in %2 and is felt through it, %3 times as stiff (%4)")
                       .arg(name, aroundName, ratioRangeText(ratio), ratioSourceText(ratio->source));
    } else {
        m_lines << tr("%1: inside %2, felt as a layer below %2 (%3)").arg(name, aroundName, why);
    }
    m_needsSentence[i] = false;
}

/// Reason why the lump cannot be palpated through the organ. @return empty if the model of buried lumps applies
QString LumpLayout::reasonForLayer(int row, int around) const
{
    const study::OpenStructure &lump = m_model.rows()[static_cast<std::size_t>(row)],
                               &organ = m_model.rows()[static_cast<std::size_t>(around)];
    const QString organName = readableName(organ.loaded.description.name);
    if (!study::hasReliableInterior(lump.loaded.surface->report)) {
        return tr("surface open or inside out");
    }
    if (meshio::isLump(meshio::anatomyKind(organ.loaded.description.name))) {
        return tr("%1 is also a lump").arg(organName);
    }
    if (transmittingOrgan(m_model, row) != around) {
        return tr("the name %1 is not unique").arg(organName);
    }
    if (!study::isWhollyInside(*lump.loaded.surface, *organ.touch)) {
        return tr("extends beyond %1").arg(organName);
    }
    if (!lump.loaded.maps.empty() || !organ.loaded.maps.empty()) {
        return tr("stiffness map on the lump or on %1").arg(organName);
    }
    const std::optional<study::StiffnessRatio> ratio = ratioOf(m_model, row, around);
    if (!ratio) {
        return tr("stiffness ratio to %1 unknown: enter a ratio under What can be felt (B)").arg(organName);
    }
    if (ratio->typical == 1.0) {
        return tr("same stiffness as %1").arg(organName);
    }
    return {};
}

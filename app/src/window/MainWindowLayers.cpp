// SPDX-License-Identifier: BSD-3-Clause
// Layout of nested structures: palpated through the outer structure or as layers below. Applied to mesh files,
// offered for scenes without layer information.
#include "shared/LumpLayout.h"
#include "window/MainWindow.h"

#include <palpate/study/HapticCopy.h>

using namespace palpate;
using namespace palpate::ui;

namespace {

/// Joins up to two sentences; of more, gives the first and the number of others.
QString oneLine(const QStringList& sentences)
{
    const QString& first = sentences.front();
    if (sentences.size() <= 2) {
        return sentences.join(QStringLiteral("; ")) + QLatin1Char('.');
    }
    return MainWindow::tr("%1; %2 more of that kind: Felt in the panel has each.").arg(first).arg(sentences.size() - 1);
}

} // namespace

void MainWindow::layOut(const OpenedScene& scene)
{
    bool isFlat = m_model.buried() == meshio::BuriedTouch::Layers;
    for (int row = 0; row < m_model.rowCount(); ++row) {
        isFlat = isFlat && m_model.structure(row).layer == 0;
    }
    if (!isFlat) {
        return;
    }
    const bool areMeshes = scene.areMeshes();
    const bool isLayered = scene.layering.isLayered();
    if (isLayered && !(areMeshes && m_waitingRecording == std::nullopt)) {
        offerLayers(scene.layering);
    } else if (areMeshes) {
        const LumpLayout found(m_model, scene.layering, 0);
        if (isLayered) {
            feel(m_model, found.ways(), tr("Feel what is inside below what is around it"));
            m_model.undoStack().setClean(); // automatic changes do not make the document modified
            offerOtherLayout(found, oneLine(found.lines()));
        } else if (!found.lines().isEmpty()) {
            m_message->showError(oneLine(found.lines())); // duplicate surface or surface with holes
        }
    }
}

/// Shows how nested structures are palpated and offers the alternative.
void MainWindow::offerOtherLayout(const LumpLayout& layout, const QString& line)
{
    if (layout.lines().isEmpty()) {
        return;
    }
    if (layout.hasTransmittedLump()) {
        m_message->offer(line, tr("Feel it as a layer"), [this, ways = layout.inLayers()] {
            feel(m_model, ways, tr("Feel what is inside below what is around it"));
        });
        return;
    }
    m_message->offer(line, tr("All in one layer"), [this, count = m_model.rowCount()] {
        m_model.setLayers(std::vector<std::uint32_t>(static_cast<std::size_t>(count), 0), tr("Feel all in one layer"));
    });
}

/// Offers layers for a scene with a single layer. The message names the first structure whose contact would change.
void MainWindow::offerLayers(const study::Layering& layering)
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
            m_message->offer(tr("%1 lies in %2, but this scene has all in one layer: it is not felt through %2.")
                                 .arg(readableName(m_model.structure(static_cast<int>(row)).name),
                                      readableName(m_model.structure(static_cast<int>(*in)).name)),
                             tr("Feel it below"), [this, layers] {
                                 m_model.setLayers(layers, tr("Feel what is inside below what is around it"));
                             });
            return;
        }
    }
}

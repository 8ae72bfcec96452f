// SPDX-License-Identifier: BSD-3-Clause
// What lies in something is felt below it: set for mesh files, offered for a scene that says nothing of layers.
#include "MainWindow.h"

#include <palpate/ui/EngineTexts.h>

using namespace palpate;
using namespace palpate::ui;

namespace {

/// One or two sentences as one line; of more, the first, and how many there are.
QString oneLine(const std::vector<std::string>& sentences)
{
    const QString first = engineText(sentences.front());
    if (sentences.size() <= 2) {
        return (sentences.size() == 1 ? first : first + QStringLiteral("; ") + engineText(sentences[1])) +
               QLatin1Char('.');
    }
    return MainWindow::tr("%1; %2 more of that kind: Felt in the panel has each.").arg(first).arg(sentences.size() - 1);
}

} // namespace

void MainWindow::layOut(const OpenedScene& scene)
{
    std::vector<std::string> names;
    std::vector<bool> isFelt;
    bool isFlat = true;
    for (int row = 0; row < m_model.rowCount(); ++row) {
        names.push_back(readableName(m_model.structure(row).name).toStdString());
        isFelt.push_back(StructureModel::isFelt(m_model.structure(row)));
        isFlat = isFlat && m_model.structure(row).layer == 0;
    }
    if (!isFlat) {
        return;
    }
    const std::vector<std::string> sentences = scene.layering.sentences(names, isFelt);
    std::vector<std::uint32_t> layers;
    for (const study::Layering::Structure& one : scene.layering.structures) {
        layers.push_back(one.layer);
    }
    const bool areMeshes = scene.areMeshes();
    const bool isLayered = scene.layering.isLayered();
    if (!isLayered && areMeshes && !sentences.empty()) {
        m_message->showError(oneLine(sentences)); // the same surface twice, or one with holes
    } else if (isLayered && areMeshes && !m_waitingRecording) {
        m_model.setLayers(layers, tr("Feel what is inside below what is around it"));
        m_model.undoStack().setClean(); // nothing that a person did and would miss
        if (!sentences.empty()) {
            m_message->offer(oneLine(sentences), tr("All in one layer"), [this, count = layers.size()] {
                m_model.setLayers(std::vector<std::uint32_t>(count, 0), tr("Feel all in one layer"));
            });
        }
    } else if (isLayered) {
        offerLayers(scene.layering, names, isFelt, layers);
    }
}

/// Offers layers to a scene that has all in one, by the first structure that would then be felt through another.
void MainWindow::offerLayers(const study::Layering& layering, const std::vector<std::string>& names,
                             const std::vector<bool>& isFelt, const std::vector<std::uint32_t>& layers)
{
    for (std::size_t row = 0; row < names.size(); ++row) {
        const auto in = isFelt[row] ? layering.feltAround(row, isFelt) : std::nullopt;
        if (in) {
            m_message->offer(tr("%1 lies in %2, but this scene has all in one layer: it is not felt through %2.")
                                 .arg(QString::fromStdString(names[row]), QString::fromStdString(names[*in])),
                             tr("Feel it below"), [this, layers] {
                                 m_model.setLayers(layers, tr("Feel what is inside below what is around it"));
                             });
            return;
        }
    }
}

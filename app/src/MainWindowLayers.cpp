// SPDX-License-Identifier: BSD-3-Clause
// What lies in something is felt below it: set for mesh files, offered for a scene that says nothing of layers.
#include "MainWindow.h"

#include <palpate/meshio/SceneFile.h>
#include <palpate/session/RecordingReader.h>

#include <algorithm>

using namespace palpate;
using namespace palpate::ui;

namespace {

/// One line of a few sentences, the others counted.
QString oneLine(const std::vector<std::string>& sentences)
{
    constexpr std::size_t kShown = 2;
    QStringList shown;
    for (std::size_t i = 0; i < std::min(kShown, sentences.size()); ++i) {
        shown << QString::fromStdString(sentences[i]);
    }
    QString line = shown.join(QStringLiteral("; "));
    if (sentences.size() > kShown) {
        line += MainWindow::tr("; and %1 more of that kind, see Felt in the panel").arg(sentences.size() - kShown);
    }
    return line + QLatin1Char('.');
}

} // namespace

void MainWindow::layOut(const OpenedScene& scene)
{
    std::vector<std::string> names;
    bool isFlat = true;
    for (int row = 0; row < m_model.rowCount(); ++row) {
        names.push_back(readableName(m_model.structure(row).name).toStdString());
        isFlat = isFlat && m_model.structure(row).layer == 0;
    }
    const std::vector<std::string> sentences = scene.layering.sentences(names);
    if (!isFlat || sentences.empty()) {
        return;
    }
    std::vector<std::uint32_t> layers;
    for (const study::Layering::Structure& one : scene.layering.structures) {
        layers.push_back(one.layer);
    }
    const bool areMeshes = std::none_of(scene.files.begin(), scene.files.end(), [](const auto& file) {
        return meshio::isSceneFile(file) || session::isRecordingFile(file);
    });
    const bool isLayered = scene.layering.isLayered();
    if (!isLayered && areMeshes) {
        m_message->showError(oneLine(sentences)); // the same surface twice, or one with holes
    } else if (isLayered && areMeshes && !m_waitingRecording) {
        m_model.setLayers(layers, tr("Feel what is inside below what is around it"));
        m_model.undoStack().setClean(); // nothing that a person did and would miss
        m_message->offer(oneLine(sentences), tr("All in one layer"), [this, count = layers.size()] {
            m_model.setLayers(std::vector<std::uint32_t>(count, 0), tr("Feel all in one layer"));
        });
    } else if (isLayered) {
        const auto inner = std::find_if(scene.layering.structures.begin(), scene.layering.structures.end(),
                                        [](const study::Layering::Structure& one) { return one.in.has_value(); });
        const auto row = static_cast<std::size_t>(inner - scene.layering.structures.begin());
        m_message->offer(tr("%1 lies in %2, but this scene has all in one layer: it is not felt through %2.")
                             .arg(QString::fromStdString(names[row]), QString::fromStdString(names[*inner->in])),
                         tr("Feel it below"), [this, layers] {
                             m_model.setLayers(layers, tr("Feel what is inside below what is around it"));
                         });
    }
}

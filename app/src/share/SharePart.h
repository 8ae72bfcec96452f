// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

#include <palpate/igtl/ShareServer.h>

#include <QElapsedTimer>
#include <QString>
#include <QTimer>

#include <cstdint>
#include <deque>
#include <filesystem>
#include <utility>

namespace palpate::ui {
class Chip;
}

namespace palpate::app {

class DocumentPart;
class ReceivedSurfaces;
class SceneFiles;
class ShareDialog;

/// Command *Share with 3D Slicer*: an OpenIGTLink server that sends the touch of the view, live and in playback, and
/// the findings, and adds received surfaces to the scene. Off at each start.
class SharePart : public WindowPart
{
    Q_OBJECT
  public:
    /// The references must outlive this part.
    SharePart(const WindowCore& core, DocumentPart& document, SceneFiles& files);
    ~SharePart() override;
    void addActions() override;

  private:
    void ask();
    void begin();
    void end();
    void shareTouch();
    void shareFindings();
    void refresh();
    void takeSurface(const std::filesystem::path& file, const QString& name);
    void addNext();

    WindowCore m_core;
    DocumentPart& m_document;
    SceneFiles& m_files;
    ui::Chip& m_chip;
    ShareDialog* m_dialog = nullptr;        ///< made when first opened
    ReceivedSurfaces* m_received = nullptr; ///< outlives the server
    igtl::ShareServer m_server;
    QTimer m_sample;  ///< takes the touch from the view
    QTimer m_refresh; ///< shows the state of the server
    QTimer m_adding;  ///< while surfaces wait for the scene
    QElapsedTimer m_sinceRefresh;
    std::uint64_t m_sent = 0;                                         ///< at the last refresh
    std::deque<std::pair<std::filesystem::path, QString>> m_surfaces; ///< stored, not yet added
};

} // namespace palpate::app

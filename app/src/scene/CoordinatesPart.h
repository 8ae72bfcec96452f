// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

#include <palpate/core/FileFrame.h>

class CoordinatesChoice;
class QWidget;

namespace palpate::app {

class DocumentPart;
class SceneFiles;

/// Coordinate axes of the open meshes: the choice, the display in status bar and view, and reading with other axes.
class CoordinatesPart : public WindowPart
{
    Q_OBJECT
  public:
    /// The references must outlive this part.
    CoordinatesPart(const WindowCore& core, DocumentPart& document, SceneFiles& files);
    void addActions() override;

    /// Button for the status bar. @pre `addActions` was called
    [[nodiscard]] QWidget& button() const;
    /// Name of the axes of the open meshes, as shown on the button.
    [[nodiscard]] QString axesText() const;
    /// Reads the open meshes again with other axes.
    void readAs(core::FileFrame frame);
    /// True if the scene was edited since `readAs`, so that the meshes which are being read lack the edits.
    [[nodiscard]] bool isEditedSince() const noexcept { return m_isEdited; }

  private:
    void show();

    WindowCore m_core;
    DocumentPart& m_document;
    SceneFiles& m_files;
    CoordinatesChoice* m_choice = nullptr;
    bool m_isEdited = false;
};

} // namespace palpate::app

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

#include <palpate/core/Status.h>
#include <palpate/geometry/VoxelVolume.h>

#include <QThreadPool>

#include <atomic>
#include <filesystem>
#include <memory>

namespace palpate::app {

class DocumentPart;
class SceneFiles;
class SectionPart;

/// Image of the patient, such as a CT, that sections show: reading, window and level.
class ImagePart : public WindowPart
{
    Q_OBJECT
  public:
    /// The references must outlive this part.
    ImagePart(const WindowCore& core, DocumentPart& document, SceneFiles& files, SectionPart& section);
    ~ImagePart() override; ///< cancels reading
    void addActions() override;
    void showState(const WindowState& state) override;

  private:
    using Volume = std::shared_ptr<const geometry::VoxelVolume>;
    void choose();
    void read();
    void take(const std::filesystem::path& file, const core::Status& status, const Volume& volume);
    void takeWindow();
    void draw();

    WindowCore m_core;
    DocumentPart& m_document;
    SectionPart& m_section;
    Volume m_volume;                                  ///< null: no image
    geometry::GreyWindow m_usual;                     ///< window of this image unless the document has one
    bool m_isWanted = false;                          ///< the user has just chosen the image
    std::shared_ptr<std::atomic<bool>> m_isCancelled; ///< of the running job
    QThreadPool m_pool;
};

} // namespace palpate::app

// SPDX-License-Identifier: BSD-3-Clause
#include "inside/ImagePart.h"

#include "inside/SectionPart.h"
#include "scene/DocumentPart.h"
#include "scene/SceneFiles.h"
#include "shared/Paths.h"
#include "shell/Notices.h"

#include <palpate/meshio/ImageFile.h>
#include <palpate/ui/ActionList.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/ui/Translated.h>
#include <palpate/ui/VtkViewport.h>

#include <QAction>
#include <QFileDialog>
#include <QMainWindow>

#include <utility>

namespace palpate::app {

using ui::ActionGroup;

namespace {

/// Bounding box of an image in the world [mm].
core::Box boundsOf(const geometry::VoxelVolume& volume)
{
    const Eigen::Affine3d toWorld = volume.toVoxel.inverse();
    core::Box box;
    for (int corner = 0; corner < 8; ++corner) {
        core::Vec3 p;
        for (int axis = 0; axis < 3; ++axis) {
            p[axis] = ((corner >> axis) & 1) != 0 ? volume.size[static_cast<std::size_t>(axis)] - 1.0 : 0.0;
        }
        box.extend(toWorld * p);
    }
    return box;
}

/// Window for the anatomy: usualWindow of the voxels about the structures, so that air and table do not count, and a
/// little wider.
geometry::GreyWindow windowAbout(const core::Box& box_W, const geometry::VoxelVolume& volume)
{
    constexpr std::size_t kFewest = 1000, kAsked = 10'000'000;
    constexpr double kWider = 1.2;
    const Eigen::Affine3d toWorld = volume.toVoxel.inverse();
    const std::size_t row = volume.size[0], slice = row * volume.size[1];
    geometry::VoxelVolume part;
    for (std::size_t i = 0; i < volume.values.size(); i += 1 + volume.values.size() / kAsked) {
        const core::Vec3 voxel(static_cast<double>(i % row), static_cast<double>(i % slice / row),
                               static_cast<double>(i / slice));
        if (box_W.contains(toWorld * voxel)) {
            part.values.push_back(volume.values[i]);
        }
    }
    geometry::GreyWindow window = geometry::usualWindow(part.values.size() < kFewest ? volume : part);
    window.width *= kWider;
    return window;
}

} // namespace

ImagePart::ImagePart(const WindowCore& core, DocumentPart& document, SceneFiles& files, SectionPart& section)
    : WindowPart(&core.window)
    , m_core(core)
    , m_document(document)
    , m_section(section)
{
    m_pool.setMaxThreadCount(1);
    connect(&files, &SceneFiles::imageWanted, this, [this](const std::filesystem::path& file) {
        m_isWanted = true;
        m_document.document().setImage(file);
    });
    connect(&document.document(), &SceneDocument::imageChanged, this, &ImagePart::read);
    connect(&section.bar(), &ui::SectionBar::windowChosen, this, [this](double width, double level) {
        if (m_volume != nullptr) {
            m_document.document().setImageWindow({level, width});
        }
    });
    connect(&document.document(), &SceneDocument::imageWindowChanged, this, &ImagePart::takeWindow);
    connect(&section.bar(), &ui::SectionBar::imageToggled, this, &ImagePart::draw);
}

ImagePart::~ImagePart()
{
    if (m_isCancelled != nullptr) {
        *m_isCancelled = true;
    }
    m_pool.waitForDone();
}

void ImagePart::addActions()
{
    ui::ActionList& actions = m_core.actions;
    connect(actions.add("image", ActionGroup::Section, tr("Show an image…"),
                        tr("Show a CT, MR or ultrasound volume in sections")),
            &QAction::triggered, this, &ImagePart::choose);
    connect(actions.add("image-remove", ActionGroup::Section, tr("Remove the image"),
                        tr("Show sections without the image; the file is kept")),
            &QAction::triggered, this, [this] { m_document.document().setImage({}); });
}

void ImagePart::showState(const WindowState& state)
{
    m_core.actions.at("image").setEnabled(state.hasScene);
    m_core.actions.at("image-remove").setEnabled(state.hasScene && !m_document.document().image().empty());
}

void ImagePart::choose()
{
    const QString file = QFileDialog::getOpenFileName(
        &m_core.window, tr("Show an image"), QString(),
        tr("Images (%1);;All files (*)").arg(QStringLiteral("*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.vti")));
    if (!file.isEmpty()) {
        m_isWanted = true;
        m_document.document().setImage(toPath(file));
    }
}

/// Reads the image of the document on another thread.
void ImagePart::read()
{
    if (m_isCancelled != nullptr) {
        *m_isCancelled = true;
    }
    m_volume.reset();
    draw();
    const std::filesystem::path file = m_document.document().image();
    Q_EMIT stateChanged();
    if (file.empty()) {
        return;
    }
    m_core.notices.say(tr("Reading %1…").arg(toText(file.filename())), 60000);
    m_isCancelled = std::make_shared<std::atomic<bool>>(false);
    const core::FileFrame frame =
        m_core.model.rowCount() > 0 ? m_core.model.structure(0).frame : core::FileFrame::Untagged;
    m_pool.start([this, file, frame, isCancelled = m_isCancelled] {
        auto found = meshio::readImage(file, frame, [&](double) { return !*isCancelled; });
        const core::Status status = found.isOk() ? core::Status() : found.status();
        const Volume volume =
            found.isOk() ? std::make_shared<const geometry::VoxelVolume>(std::move(found).value()) : nullptr;
        QMetaObject::invokeMethod(this, [this, file, status, volume, isCancelled] {
            if (!*isCancelled) {
                take(file, status, volume);
            }
        });
    });
}

void ImagePart::take(const std::filesystem::path& file, const core::Status& status, const Volume& volume)
{
    const bool isWanted = std::exchange(m_isWanted, false);
    if (volume == nullptr) {
        m_core.notices.showError(ui::translated(status));
        return;
    }
    // Opened as a segmentation before, the file was refused; it is of use now.
    m_core.notices.bar().withdrawIf(
        [begin = toText(file.filename()) + QLatin1Char(':')](const QString& text) { return text.startsWith(begin); });
    m_volume = volume;
    m_usual = windowAbout(m_core.viewport.view().bounds(), *volume);
    m_section.bar().setImage(toText(file.filename()), m_usual.width, m_usual.level);
    takeWindow();
    if (boundsOf(*volume).intersects(m_core.viewport.view().bounds())) {
        m_core.notices.say(tr("%1 is shown in sections (X).").arg(toText(file.filename())));
    } else {
        m_core.notices.warn({tr("%1 lies beside all structures. Do the axes and units of image and meshes agree?")
                                 .arg(toText(file.filename()))});
    }
    if (isWanted) {
        m_core.actions.at("section").setChecked(true);
    }
}

/// Shows the image with the window of the document.
void ImagePart::takeWindow()
{
    if (m_volume != nullptr) {
        const geometry::GreyWindow window = m_document.document().imageWindow().value_or(m_usual);
        m_section.bar().setWindow(window.width, window.level);
        draw();
    }
}

void ImagePart::draw()
{
    if (m_volume == nullptr) {
        m_section.bar().setImage({}, 1.0, 0.0);
    }
    m_core.viewport.view().setImage(m_section.bar().isImageShown() ? m_volume : nullptr,
                                    m_document.document().imageWindow().value_or(m_usual));
    m_core.viewport.update();
}

} // namespace palpate::app

#include "moc_ImagePart.cpp"

// SPDX-License-Identifier: BSD-3-Clause
// palpate thumbnail: draws a small picture of a file for file managers (resources/desktop/palpate.thumbnailer).
#include "commands/Commands.h"
#include "shared/Console.h"

#include <palpate/core/AtomicFile.h>
#include <palpate/meshio/LoadScene.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/study/RecordedScene.h>
#include <palpate/view/Thumbnail.h>

#include <CLI/CLI.hpp>

#include <QBuffer>
#include <QImage>

#include <filesystem>
#include <memory>
#include <vector>

namespace palpate::app {

using core::Status;
using core::StatusCode;

namespace {

struct ThumbnailCommandOptions
{
    std::filesystem::path file, out;
    int size_px = 256;
};

/// Lists what the window would draw; hidden targets of an exercise remain hidden.
std::vector<view::ThumbnailSurface> visibleSurfaces(const meshio::LoadedScene& scene)
{
    std::vector<view::ThumbnailSurface> surfaces;
    for (const meshio::LoadedStructure& structure : scene.structures) {
        const meshio::SceneStructure& looks = structure.description;
        if (looks.visible && !looks.isHiddenTarget && looks.opacity > 0.0) {
            surfaces.push_back({&structure.surface->mesh, looks.colour, looks.opacity});
        }
    }
    return surfaces;
}

int runThumbnail(const ThumbnailCommandOptions& options)
{
    if (const Status status = checkOutputs({options.file}, {options.out}); !status.isOk()) {
        return report(status);
    }
    // Not study::openScene, which computes how lumps are felt.
    const auto scene = session::isRecordingByNameOrContent(options.file) ? study::sceneOfRecording(options.file)
                                                                         : meshio::loadScene(options.file);
    if (!scene.isOk()) {
        return report(scene.status());
    }
    const auto surfaces = visibleSurfaces(scene.value());
    if (surfaces.empty()) {
        return report(Status(StatusCode::Empty, PALPATE_TEXT("%1: found no visible surface, expected one to draw"),
                             options.file));
    }
    const std::vector<std::uint8_t> pixels = view::drawThumbnail(surfaces, options.size_px);
    const QImage picture(pixels.data(), options.size_px, options.size_px, 4 * options.size_px, QImage::Format_RGBA8888);
    QBuffer bytes;
    (void)picture.save(&bytes, "PNG");
    const Status written =
        core::writeAtomically(options.out, {bytes.data().constData(), static_cast<std::size_t>(bytes.size())});
    return written.isOk() ? int{kDone} : report(written);
}

} // namespace

void addThumbnailCommand(CLI::App& app, Chosen& chosen)
{
    auto options = std::make_shared<ThumbnailCommandOptions>();
    CLI::App* command = app.add_subcommand("thumbnail", "Draw a small picture of a file without a display");
    command->add_option("FILE", options->file, "Mesh file, label map, scene file or recording")->required();
    command->add_option("--out", options->out, "Where the picture goes, as PNG")->required();
    command->add_option("--size", options->size_px, "Width and height in pixels")
        ->capture_default_str()
        ->check(CLI::Range(1, 2048));
    command->callback([options, &chosen] { chosen = [options] { return runThumbnail(*options); }; });
}

} // namespace palpate::app

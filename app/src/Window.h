// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/FileFrame.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// What the command line asks of the window.
struct WindowOptions
{
    /// Mesh and scene files to open as one scene, and at most one recording (`*.palpate`) to play in it.
    std::vector<std::filesystem::path> files;
    double unit_mm = 1.0; ///< what one unit of a mesh file is [mm]; a scene file says its own
    palpate::core::FileFrame frame = palpate::core::FileFrame::Untagged; ///< of mesh files; Untagged: as they say
    /// Without a person at hand: opens the files, touches the scene with a scripted hand (or plays the recording),
    /// writes a PNG of the whole window in contact, prints one line of what it saw to stdout and exits.
    std::optional<std::filesystem::path> screenshot;
    int screenshotWidth = 1280;
    int screenshotHeight = 800;
    std::string device;                               ///< the hand's; empty: the mouse
    std::optional<int> cpu;                           ///< that the servo loop runs on alone; none: as kept
    std::vector<std::filesystem::path> pluginFolders; ///< to look for device plugins in first
    bool darkPalette = false;                         ///< for the screenshot: the dark palette instead of the system's
};

/// Runs the desktop application until its window closes.
/// @param argc,argv  for Qt, which takes its own options out of them
/// @return the exit code: 0 done, 2 a file could not be opened in screenshot mode, 1 anything else
int runWindow(int argc, char** argv, const WindowOptions& options);

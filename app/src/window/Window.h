// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/meshio/MeshFile.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

/// Command line options of the window.
struct WindowOptions
{
    /// Mesh and scene files to open as one scene, and at most one recording (`*.palpate`) to play in that scene.
    std::vector<std::filesystem::path> files;
    palpate::meshio::ReadOptions read; ///< unit and axes of mesh files, and the surfaces made of all files
    /// Runs without user: opens the files, touches the scene with a scripted hand (or plays the recording), writes a
    /// PNG of the whole window during contact, prints a one-line summary to stdout and exits.
    std::optional<std::filesystem::path> screenshot;
    int screenshotWidth = 1280;
    int screenshotHeight = 800;
    std::string device;     ///< the hand's device; empty: the mouse
    std::optional<int> cpu; ///< CPU reserved for the servo loop; empty: as saved for the device
    std::vector<std::filesystem::path> pluginFolders; ///< plugin folders searched first
    bool darkPalette = false;                         ///< screenshot only: dark palette instead of the system's
};

/// Runs the desktop application until the window closes.
/// @param argc,argv  for Qt, which removes its own options
/// @return the exit code: 0 success, 2 a file could not be opened in screenshot mode, 1 any other failure
int runWindow(int argc, char** argv, const WindowOptions& options);

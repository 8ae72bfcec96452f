// SPDX-License-Identifier: BSD-3-Clause
#include "shared/Devices.h"

#include "shared/Console.h"

#include <system_error>

namespace palpate::app {

namespace {

std::filesystem::path program()
{
    std::error_code error;
    return std::filesystem::read_symlink("/proc/self/exe", error);
}

} // namespace

std::unique_ptr<device::PluginHost> findPlugins(const std::vector<std::filesystem::path>& named)
{
    return std::make_unique<device::PluginHost>(device::pluginFolders(named, program().parent_path()),
                                                std::vector{program().string(), std::string(kProbeWord)});
}

int probe(const char* file)
{
    const core::Status status = device::answerProbe(file);
    if (!status.isOk()) {
        printError(status.text());
        return kFailed;
    }
    return kDone;
}

core::Status checkPluginFolders(const std::vector<std::filesystem::path>& named)
{
    for (const std::filesystem::path& folder : named) {
        std::error_code error;
        if (!std::filesystem::is_directory(folder, error)) {
            return {core::StatusCode::BadCommandLine, PALPATE_TEXT("--plugin-path: %1: expected a folder"), folder};
        }
    }
    return {};
}

} // namespace palpate::app

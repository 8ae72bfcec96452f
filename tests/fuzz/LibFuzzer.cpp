// SPDX-License-Identifier: BSD-3-Clause
// Connects a target to libFuzzer: `PALPATE_FUZZ=stl fuzz_meshio FOLDER -max_total_time=60` writes the target's seeds to
// FOLDER, then fuzzes from there and keeps inputs with new coverage. A failing input is saved as crash-… in the working
// folder and should become a row of `seeds`. The target is in the environment because libFuzzer restarts the program in
// some modes.
#include "Fuzz.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>

namespace {

const palpate::fuzz::Target* g_target = nullptr;

} // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv)
{
    const char* name = std::getenv("PALPATE_FUZZ");
    g_target = &palpate::fuzz::target(name != nullptr ? name : "");
    for (int i = 1; i < *argc; ++i) {
        const std::filesystem::path folder = (*argv)[i];
        if (std::filesystem::is_directory(folder)) {
            int number = 0;
            for (const std::string& seed : g_target->seeds()) {
                std::ofstream(folder / ("seed" + std::to_string(number++)), std::ios::binary) << seed;
            }
            break;
        }
    }
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    g_target->tryInput({reinterpret_cast<const char*>(data), size});
    return 0;
}

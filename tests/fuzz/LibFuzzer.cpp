// SPDX-License-Identifier: BSD-3-Clause
// Joins a target to libFuzzer: `PALPATE_FUZZ=stl fuzz_meshio FOLDER -max_total_time=60` writes the target's seeds to
// FOLDER, then goes on from there, keeping what reaches new code. A finding is left as crash-… in the working folder;
// it becomes a row of `seeds`. In the environment, because libFuzzer starts the program anew for some of what it does.
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

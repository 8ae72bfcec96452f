// SPDX-License-Identifier: BSD-3-Clause
// Joins a target to libFuzzer: `fuzz_stl FOLDER -max_total_time=60` writes the target's seeds to FOLDER, then goes on
// from there, keeping what reaches new code. A finding is left as crash-… in the working folder; it becomes a row of
// `seeds`.
#include "Fuzz.h"

#include <cstddef>
#include <cstdint>
#include <fstream>

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv)
{
    for (int i = 1; i < *argc; ++i) {
        const std::filesystem::path folder = (*argv)[i];
        if (std::filesystem::is_directory(folder)) {
            int number = 0;
            for (const std::string& seed : palpate::fuzz::seeds()) {
                std::ofstream(folder / ("seed" + std::to_string(number++)), std::ios::binary) << seed;
            }
            break;
        }
    }
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    palpate::fuzz::tryInput({reinterpret_cast<const char*>(data), size});
    return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
// Times the overhead of reading in a child process compared to reading in this process.
//
// bench_import [FILE …] [--rounds N]
//
// Both methods alternate in one run. Each row: the medians of N rounds (default 15) in this process and in a child, the
// difference, and its fraction. Without files: the largest and a small file of shared/anatomy, or two generated files.
#include "Shapes.h"
#include "read/ReadMesh.h"

#include <palpate/meshio/ImportServer.h>
#include <palpate/meshio/MeshFile.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include <unistd.h>

namespace {

using namespace palpate;

double read_ms(const std::filesystem::path& path, bool isChild)
{
    const auto start = std::chrono::steady_clock::now();
    const auto file = isChild ? meshio::readMesh(path) : meshio::internal::readHere(path, {});
    const double time = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    if (!file.isOk()) {
        std::fprintf(stderr, "bench_import: %s\n", file.status().message().c_str());
        std::exit(2);
    }
    return time;
}

double median(std::vector<double> times)
{
    std::sort(times.begin(), times.end());
    return times[times.size() / 2];
}

} // namespace

int main(int argc, char** argv)
{
    if (!meshio::startImportServer().isOk()) {
        return 1;
    }
    std::vector<std::filesystem::path> files;
    std::size_t rounds = 15;
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (word == "--rounds" && i + 1 < argc) {
            rounds = std::max(1UL, std::strtoul(argv[++i], nullptr, 10));
        } else if (word.starts_with("--benchmark")) {
            rounds = 3; // a smoke test
        } else {
            files.emplace_back(word);
        }
    }
    const std::filesystem::path shared = PALPATE_SHARED_DIR "/anatomy";
    const std::filesystem::path own =
        std::filesystem::temp_directory_path() / ("bench_import." + std::to_string(::getpid()));
    if (files.empty() && std::filesystem::is_directory(shared)) {
        files = {shared / "vh_f_body_large.vtp", shared / "carotids.stl"};
    } else if (files.empty()) {
        std::filesystem::create_directory(own);
        for (const int steps : {500, 20}) {
            files.push_back(own / (std::to_string(steps) + ".vtp"));
            const std::vector<meshio::MeshStructure> ball{{"ball", test::sphere(steps, 50.0), std::nullopt}};
            if (!meshio::writeMesh(files.back(), ball).isOk()) {
                return 1;
            }
        }
    }
    std::printf("%-28s %14s %12s %10s %8s\n", "file", "in-process ms", "child ms", "extra ms", "extra");
    for (const std::filesystem::path& file : files) {
        std::vector<double> inside, outside, extra;
        (void)read_ms(file, false); // the first run pays for shared initialisation
        for (std::size_t i = 0; i < rounds; ++i) {
            inside.push_back(read_ms(file, false));
            outside.push_back(read_ms(file, true));
            extra.push_back(outside.back() - inside.back());
        }
        const double in = median(inside), more = median(extra);
        std::printf("%-28s %14.1f %12.1f %10.1f %7.1f%%\n", file.filename().c_str(), in, median(outside), more,
                    100.0 * more / in);
    }
    std::filesystem::remove_all(own);
    return 0;
}

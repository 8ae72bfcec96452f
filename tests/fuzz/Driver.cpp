// SPDX-License-Identifier: BSD-3-Clause
// Runs a target without libFuzzer: the seeds, then deterministic mutations.
//
// fuzz_meshio TARGET [--mutations N] [FILE …]
//
// N mutations of each seed; with files, only those files are run.
#include "Fuzz.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <unistd.h>

namespace {

std::size_t g_seed = 0;
std::size_t g_mutation = 0;
std::string g_input;
const palpate::fuzz::Target* g_target = nullptr;

/// Saves the failing input, for a row of `seeds`.
void found(int signal)
{
    std::fprintf(stderr, "finding: seed %zu, change %zu, signal %d: the input is in fuzz-finding\n", g_seed, g_mutation,
                 signal);
    std::ofstream("fuzz-finding", std::ios::binary) << g_input;
    ::_exit(1);
}

void feed(std::string input)
{
    g_input = std::move(input);
    g_target->tryInput(g_input);
}

/// Mutates `text` in one to six places, like accidental or deliberate damage.
std::string changed(std::string text, const std::vector<std::string>& seeds, std::mt19937& random)
{
    static constexpr std::array<std::string_view, 20> kWords{"0",
                                                             "-1",
                                                             "1",
                                                             "255",
                                                             "65536",
                                                             "2147483647",
                                                             "2147483648",
                                                             "4294967295",
                                                             "4294967296",
                                                             "9223372036854775807",
                                                             "-9223372036854775808",
                                                             "1e308",
                                                             "1e999",
                                                             "nan",
                                                             "inf",
                                                             ",",
                                                             "\n",
                                                             "\"",
                                                             "<",
                                                             " "};
    static constexpr std::array<unsigned char, 8> kBytes{0x00, 0x01, 0x7f, 0x80, 0xff, '\n', ' ', '9'};
    const auto below = [&random](std::size_t n) { return n == 0 ? 0 : static_cast<std::size_t>(random()) % n; };
    for (std::size_t times = 1 + below(6); times > 0; --times) {
        const std::size_t at = below(text.size() + 1);
        const std::size_t length = std::min(text.size() - at, below(std::size_t{1} << below(10)));
        switch (below(8)) {
        case 0:
            if (at < text.size()) {
                text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
            }
            break;
        case 1:
            if (at < text.size()) {
                text[at] = static_cast<char>(kBytes[below(kBytes.size())]);
            }
            break;
        case 2:
            text.erase(at, length);
            break;
        case 3:
            text.insert(at, text.substr(below(text.size() + 1), length));
            break;
        case 4:
            text.insert(at, kWords[below(kWords.size())]);
            break;
        case 5: { // a number or its replacement
            const std::size_t digit = text.find_first_of("0123456789", at);
            if (digit != std::string::npos) {
                const std::size_t end = std::min(text.find_first_not_of("0123456789.", digit), text.size());
                text.replace(digit, end - digit, kWords[below(kWords.size())]);
            }
            break;
        }
        case 6:
            text.resize(at);
            break;
        default: {
            const std::string& other = seeds[below(seeds.size())];
            text.replace(at, length, other.substr(below(other.size() + 1), length + below(40)));
            break;
        }
        }
    }
    return text;
}

} // namespace

int main(int argc, char** argv)
{
    g_target = &palpate::fuzz::target(argc > 1 ? argv[1] : "");
    std::size_t mutations = g_target->mutations;
    bool hasFile = false;
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL}) {
        (void)std::signal(signal, found);
    }
    for (int i = 2; i < argc; ++i) {
        if (std::string_view(argv[i]) == "--mutations" && i + 1 < argc) {
            mutations = std::strtoul(argv[++i], nullptr, 10);
            continue;
        }
        std::ifstream in(argv[i], std::ios::binary);
        feed({std::istreambuf_iterator<char>(in), {}});
        hasFile = true;
    }
    if (hasFile) {
        return 0;
    }
    const std::vector<std::string> seeds = g_target->seeds();
    for (g_seed = 0; g_seed < seeds.size(); ++g_seed) {
        feed(seeds[g_seed]);
        for (g_mutation = 1; g_mutation <= mutations; ++g_mutation) {
            std::mt19937 random(static_cast<unsigned>(g_seed * 1000003 + g_mutation));
            feed(changed(seeds[g_seed], seeds, random));
        }
    }
    std::printf("%zu seeds, %zu changes of each\n", seeds.size(), mutations);
    return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
// The plugin probe in a separate process, as the program runs on itself.
#include <palpate/device/PluginHost.h>

#include <cstdio>

int main(int argc, char** argv)
{
    const auto status =
        argc == 2 ? palpate::device::answerProbe(argv[1])
                  : palpate::core::Status(palpate::core::StatusCode::BadCommandLine, PALPATE_TEXT("one file"));
    std::fprintf(stderr, "%s", status.message().c_str());
    return status.isOk() ? 0 : 1;
}

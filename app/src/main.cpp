// SPDX-License-Identifier: BSD-3-Clause
#include "commands/CommandLine.h"

int main(int argc, char** argv)
{
    return palpate::app::runCommandLine(argc, argv);
}

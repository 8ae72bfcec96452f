// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdio>

#include <malloc.h>
#include <unistd.h>

namespace palpate::test {

/// Returns the resident memory of this process after releasing free memory [bytes]. Linux only.
inline double residentBytes()
{
    (void)malloc_trim(0);
    long pages = 0;
    if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
        if (std::fscanf(file, "%*s %ld", &pages) != 1) {
            pages = 0;
        }
        (void)std::fclose(file);
    }
    return static_cast<double>(pages) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

} // namespace palpate::test

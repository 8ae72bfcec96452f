// SPDX-License-Identifier: BSD-3-Clause
#include <palpate/core/Numbers.h>
#include <palpate/core/Version.h>

#include <cstdio>

static_assert(palpate::core::kVersion >= PALPATE_VERSION_NUMBER(0, 1, 0));
#if PALPATE_VERSION < PALPATE_VERSION_NUMBER(0, 1, 0)
#error "an older Palpate"
#endif

/// Prints the version of Palpate, and a number by a function of its library.
int main()
{
    std::printf("%s %s\n", palpate::core::kVersionText, palpate::core::shortNumber(0.25).c_str());
    return 0;
}

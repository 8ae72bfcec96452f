// SPDX-License-Identifier: BSD-3-Clause
#include "Fuzz.h"

namespace palpate::fuzz {

extern const Target kIgtl;

std::span<const Target* const> targets()
{
    static const Target* const all[] = {&kIgtl};
    return all;
}

} // namespace palpate::fuzz

// SPDX-License-Identifier: BSD-3-Clause
#include "Fuzz.h"

namespace palpate::fuzz {

extern const Target kMotion, kRecording;

std::span<const Target* const> targets()
{
    static const Target* const all[] = {&kMotion, &kRecording};
    return all;
}

} // namespace palpate::fuzz

// SPDX-License-Identifier: BSD-3-Clause
#include "Fuzz.h"

namespace palpate::fuzz {

extern const Target kMha, kNii, kNrrd, kObj, kPly, kScene, kStl, kStlAscii, kVolumeWire, kVti, kVtk, kVtp, kVtu;

std::span<const Target* const> targets()
{
    static const Target* const all[] = {&kMha,      &kNii,        &kNrrd, &kObj, &kPly, &kScene, &kStl,
                                        &kStlAscii, &kVolumeWire, &kVti,  &kVtk, &kVtp, &kVtu};
    return all;
}

} // namespace palpate::fuzz

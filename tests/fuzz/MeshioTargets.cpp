// SPDX-License-Identifier: BSD-3-Clause
#include "Fuzz.h"

namespace palpate::fuzz {

extern const Target kGii, kGzip, kMha, kMniObject, kNii, kNrrd, kObj, kOff, kPial, kPly, kScene, kStl, kStlAscii,
    kMeshWire, kVolumeWire, kVti, kVtk, kVtp, kVtu;

std::span<const Target* const> targets()
{
    static const Target* const all[] = {&kGii,        &kGzip, &kMha, &kMniObject, &kNii, &kNrrd,     &kObj,
                                        &kOff,        &kPial, &kPly, &kScene,     &kStl, &kStlAscii, &kMeshWire,
                                        &kVolumeWire, &kVti,  &kVtk, &kVtp,       &kVtu};
    return all;
}

} // namespace palpate::fuzz

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

namespace palpate::meshio {

/// What a structure's name says that it is, as far as touch cares.
enum class AnatomyKind
{
    Other, ///< the name says nothing, or nothing that a fingertip would tell apart
    Lump,  ///< tumour, lesion, nodule, cyst
    Vessel,
    Nerve,
    Duct, ///< of bile or pancreas
    Bone,
    Liver,
    Organ,
    SoftOrgan, ///< lung, brain
    Skin
};

/// @return by the words of the name that also choose a structure's colour; what a part is comes before the organ that
/// it belongs to: a hepatic artery is a vessel.
[[nodiscard]] AnatomyKind anatomyKind(std::string_view name);

} // namespace palpate::meshio

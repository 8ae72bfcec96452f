// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <cstdint>
#include <string_view>

namespace palpate::meshio {

/// Anatomical kind of a structure by its name, as far as relevant for haptics. In order of precedence: the kind of a
/// part precedes the organ, so that a hepatic artery is a vessel and a kidney cyst a cyst.
enum class AnatomyKind : std::uint8_t
{
    Other,         ///< no known word in the name
    Cyst,          ///< filled with fluid
    BenignLump,    ///< adenoma, haemangioma, fibroid
    MalignantLump, ///< carcinoma, metastasis
    FibroticArea,
    Lump, ///< tumour, nodule, lesion, mass: not specified as benign or malignant
    Vessel,
    Nerve,
    Duct, ///< of bile, pancreas or urine
    LymphNode,
    Tendon, ///< and ligaments
    Cartilage,
    Muscle,
    Bone,
    Fat,
    Kidney,
    Spleen,
    Pancreas,
    Prostate,
    Breast,
    Thyroid,
    SalivaryGland,
    Liver,
    Lung,
    Brain, ///< and spinal cord
    Organ, ///< any other: heart, stomach, bowel, bladder, uterus
    Skin
};

/// Finds the kind of a structure by the words of its name. Words end at any non-letter and before a capital that
/// follows a lower-case letter; case and a plural s are ignored. The longest phrases match first, and each word counts
/// once: "caudate lobe" belongs to the liver, "caudate nucleus" to the brain. For the sources of the words see the
/// table.
[[nodiscard]] PALPATE_EXPORT AnatomyKind anatomyKind(std::string_view name);

/// @return true for all kinds of lump, including the specific kinds.
[[nodiscard]] constexpr bool isLump(AnatomyKind kind) noexcept
{
    return kind >= AnatomyKind::Cyst && kind <= AnatomyKind::Lump;
}

} // namespace palpate::meshio

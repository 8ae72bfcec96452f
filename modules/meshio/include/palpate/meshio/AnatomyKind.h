// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string_view>

namespace palpate::meshio {

/// What a structure's name says that it is, as far as touch cares. In order of precedence: what a part is comes before
/// the organ that it belongs to, so that a hepatic artery is a vessel and a kidney cyst a cyst.
enum class AnatomyKind : std::uint8_t
{
    Other,         ///< the name says nothing about touch
    Cyst,          ///< filled with fluid
    BenignLump,    ///< adenoma, haemangioma, fibroid
    MalignantLump, ///< carcinoma, metastasis
    FibroticArea,
    Lump, ///< tumour, nodule, lesion, mass: benign or malignant is not said
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

/// Finds the kind of a structure by the words of its name. Words end at anything that is no letter and before a capital
/// that follows a small letter; case and a plural's s do not matter. The longest phrases are looked for first, and a
/// word counts once: "caudate lobe" is of the liver, "caudate nucleus" of the brain. Sources of the words are named
/// with the table.
[[nodiscard]] AnatomyKind anatomyKind(std::string_view name);

/// @return true for all kinds of lump, those of which more is known included.
[[nodiscard]] constexpr bool isLump(AnatomyKind kind) noexcept
{
    return kind >= AnatomyKind::Cyst && kind <= AnatomyKind::Lump;
}

} // namespace palpate::meshio

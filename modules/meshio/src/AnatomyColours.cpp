// SPDX-License-Identifier: BSD-3-Clause
#include "AnatomyColours.h"

#include "palpate/meshio/AnatomyKind.h"

#include <algorithm>
#include <string>

namespace palpate::meshio {

namespace {

struct Rgb
{
    int r, g, b;
};

struct NamedTissue
{
    Rgb colour;
    AnatomyKind kind = AnatomyKind::Other;
};

struct Known
{
    std::string_view word; ///< lower case, as it begins a word of the name; a '$' ends the word there
    NamedTissue tissue;
};

constexpr NamedTissue kTumour{{144, 238, 144}, AnatomyKind::Lump};
constexpr NamedTissue kArtery{{216, 101, 79}, AnatomyKind::Vessel};
constexpr NamedTissue kVein{{0, 151, 206}, AnatomyKind::Vessel};
constexpr NamedTissue kNerve{{244, 214, 49}, AnatomyKind::Nerve};
constexpr NamedTissue kBile{{139, 150, 98}, AnatomyKind::Duct};
constexpr NamedTissue kCartilage{{111, 184, 210}};
constexpr NamedTissue kLigament{{183, 214, 211}};
constexpr NamedTissue kMuscle{{192, 104, 88}};
constexpr NamedTissue kBone{{241, 214, 145}, AnatomyKind::Bone};
constexpr NamedTissue kLiver{{221, 130, 101}, AnatomyKind::Liver};
constexpr NamedTissue kKidney{{185, 102, 83}, AnatomyKind::Organ};
constexpr NamedTissue kSkin{{177, 122, 101}, AnatomyKind::Skin};
constexpr NamedTissue kBrain{{250, 250, 225}, AnatomyKind::SoftOrgan};

/// 3D Slicer's generic anatomy colours. The first match counts: what a part is comes before the organ it belongs to,
/// so that the hepatic artery is an artery.
constexpr std::array kKnown = std::to_array<Known>({
    {"tumo", kTumour},
    {"lump", kTumour},
    {"lesion", kTumour},
    {"nodul", kTumour},
    {"metasta", kTumour},
    {"cyst$", kTumour},
    {"carcinoma", kTumour},
    {"mass$", kTumour},
    {"arter", kArtery},
    {"aort", kArtery},
    {"carotid", kArtery},
    {"aneurysm", kArtery},
    {"vein", kVein},
    {"vena$", kVein},
    {"venous", kVein},
    {"cava$", kVein},
    {"portal", kVein},
    {"nerve", kNerve},
    {"duct", kBile},
    {"ampulla", kBile},
    {"gallbladder", {kBile.colour, AnatomyKind::Organ}},
    {"bile", kBile},
    {"cartilag", kCartilage},
    {"menisc", {{178, 212, 242}}},
    {"ligament", kLigament},
    {"tendon", {{152, 189, 207}}},
    {"muscle", kMuscle},
    {"femoris", kMuscle},
    {"bone", kBone},
    {"femur", kBone},
    {"tibia", kBone},
    {"fibula$", kBone},
    {"patella", kBone},
    {"scapula", kBone},
    {"humer", kBone},
    {"ulna", kBone},
    {"radius", kBone},
    {"spine", kBone},
    {"vertebra", kBone},
    {"sacrum", kBone},
    {"rib$", kBone},
    {"ribs$", kBone},
    {"skull", kBone},
    {"pelvi", kBone},
    {"mandib", kBone},
    {"condyl", kBone},
    {"spleen", {{157, 108, 162}, AnatomyKind::Organ}},
    {"pancrea", {{249, 180, 111}, AnatomyKind::Organ}},
    {"heart", {{206, 110, 84}, AnatomyKind::Organ}},
    {"lung", {{197, 165, 145}, AnatomyKind::SoftOrgan}},
    {"liver", kLiver},
    {"hepat", kLiver},
    {"caudate", kLiver},
    {"kidney", kKidney},
    {"renal", kKidney},
    {"bladder", {{222, 154, 132}, AnatomyKind::Organ}},
    {"brain", kBrain},
    {"cortex", kBrain},
    {"gyrus", kBrain},
    {"skin", kSkin},
});

/// Okabe and Ito's palette without its black.
constexpr std::array kCycle = std::to_array<Rgb>(
    {{230, 159, 0}, {86, 180, 233}, {0, 158, 115}, {240, 228, 66}, {0, 114, 178}, {213, 94, 0}, {204, 121, 167}});

std::array<double, 3> toUnit(const Rgb& c)
{
    return {c.r / 255.0, c.g / 255.0, c.b / 255.0};
}

/// @return nullptr for a name that says nothing.
const NamedTissue* knownTissue(std::string_view name)
{
    // Lower-case words, each between '$' signs.
    std::string words = "$";
    for (const char c : name) {
        const char lower = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        if (lower >= 'a' && lower <= 'z') {
            words += lower;
        } else if (words.back() != '$') {
            words += '$';
        }
    }
    words += '$';
    const auto found = std::find_if(kKnown.begin(), kKnown.end(), [&](const Known& known) {
        return words.find(std::string(1, '$').append(known.word)) != std::string::npos;
    });
    return found != kKnown.end() ? &found->tissue : nullptr;
}

} // namespace

std::array<double, 3> internal::anatomyColour(std::string_view name, std::size_t index)
{
    const NamedTissue* known = knownTissue(name);
    return toUnit(known != nullptr ? known->colour : kCycle[index % kCycle.size()]);
}

AnatomyKind anatomyKind(std::string_view name)
{
    const NamedTissue* known = knownTissue(name);
    return known != nullptr ? known->kind : AnatomyKind::Other;
}

} // namespace palpate::meshio

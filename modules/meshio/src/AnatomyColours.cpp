// SPDX-License-Identifier: BSD-3-Clause
#include "AnatomyColours.h"

#include <algorithm>
#include <string>

namespace palpate::meshio::internal {

namespace {

struct Rgb
{
    int r, g, b;
};

struct Known
{
    std::string_view word; ///< lower case, as it begins a word of the name; a '$' ends the word there
    Rgb colour;
};

constexpr Rgb kTumour{144, 238, 144};
constexpr Rgb kArtery{216, 101, 79};
constexpr Rgb kVein{0, 151, 206};
constexpr Rgb kNerve{244, 214, 49};
constexpr Rgb kBile{139, 150, 98};
constexpr Rgb kCartilage{111, 184, 210};
constexpr Rgb kLigament{183, 214, 211};
constexpr Rgb kMuscle{192, 104, 88};
constexpr Rgb kBone{241, 214, 145};
constexpr Rgb kLiver{221, 130, 101};
constexpr Rgb kKidney{185, 102, 83};
constexpr Rgb kSkin{177, 122, 101};
constexpr Rgb kBrain{250, 250, 225};

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
    {"gallbladder", kBile},
    {"bile", kBile},
    {"cartilag", kCartilage},
    {"menisc", {178, 212, 242}},
    {"ligament", kLigament},
    {"tendon", {152, 189, 207}},
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
    {"spleen", {157, 108, 162}},
    {"pancrea", {249, 180, 111}},
    {"heart", {206, 110, 84}},
    {"lung", {197, 165, 145}},
    {"liver", kLiver},
    {"hepat", kLiver},
    {"caudate", kLiver},
    {"kidney", kKidney},
    {"renal", kKidney},
    {"bladder", {222, 154, 132}},
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

} // namespace

std::array<double, 3> anatomyColour(std::string_view name, std::size_t index)
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
    return toUnit(found != kKnown.end() ? found->colour : kCycle[index % kCycle.size()]);
}

} // namespace palpate::meshio::internal

// SPDX-License-Identifier: BSD-3-Clause
// Facts: FreeSurferColorLUT.txt of FreeSurfer 7 (numbers, names, colours), and the class map "total" of
// TotalSegmentator 2 (numbers, names).
#include "labels/LabelNames.h"

#include "text/TextScan.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace palpate::meshio::internal {

namespace {

struct Known
{
    std::uint32_t value;
    std::string_view name;
    std::array<int, 3> rgb;
};

constexpr auto kFreeSurfer = std::to_array<Known>({
    {2, "Left-Cerebral-White-Matter", {245, 245, 245}},
    {3, "Left-Cerebral-Cortex", {205, 62, 78}},
    {4, "Left-Lateral-Ventricle", {120, 18, 134}},
    {5, "Left-Inf-Lat-Vent", {196, 58, 250}},
    {7, "Left-Cerebellum-White-Matter", {220, 248, 164}},
    {8, "Left-Cerebellum-Cortex", {230, 148, 34}},
    {10, "Left-Thalamus", {0, 118, 14}},
    {11, "Left-Caudate", {122, 186, 220}},
    {12, "Left-Putamen", {236, 13, 176}},
    {13, "Left-Pallidum", {12, 48, 255}},
    {14, "3rd-Ventricle", {204, 182, 142}},
    {15, "4th-Ventricle", {42, 204, 164}},
    {16, "Brain-Stem", {119, 159, 176}},
    {17, "Left-Hippocampus", {220, 216, 20}},
    {18, "Left-Amygdala", {103, 255, 255}},
    {24, "CSF", {60, 60, 60}},
    {26, "Left-Accumbens-area", {255, 165, 0}},
    {28, "Left-VentralDC", {165, 42, 42}},
    {30, "Left-vessel", {160, 32, 240}},
    {31, "Left-choroid-plexus", {0, 200, 200}},
    {41, "Right-Cerebral-White-Matter", {245, 245, 245}},
    {42, "Right-Cerebral-Cortex", {205, 62, 78}},
    {43, "Right-Lateral-Ventricle", {120, 18, 134}},
    {44, "Right-Inf-Lat-Vent", {196, 58, 250}},
    {46, "Right-Cerebellum-White-Matter", {220, 248, 164}},
    {47, "Right-Cerebellum-Cortex", {230, 148, 34}},
    {49, "Right-Thalamus", {0, 118, 14}},
    {50, "Right-Caudate", {122, 186, 220}},
    {51, "Right-Putamen", {236, 13, 176}},
    {52, "Right-Pallidum", {13, 48, 255}},
    {53, "Right-Hippocampus", {220, 216, 20}},
    {54, "Right-Amygdala", {103, 255, 255}},
    {58, "Right-Accumbens-area", {255, 165, 0}},
    {60, "Right-VentralDC", {165, 42, 42}},
    {62, "Right-vessel", {160, 32, 240}},
    {63, "Right-choroid-plexus", {0, 200, 221}},
    {72, "5th-Ventricle", {120, 190, 150}},
    {77, "WM-hypointensities", {200, 70, 255}},
    {80, "non-WM-hypointensities", {164, 108, 226}},
    {85, "Optic-Chiasm", {234, 169, 30}},
    {251, "CC_Posterior", {0, 0, 64}},
    {252, "CC_Mid_Posterior", {0, 0, 112}},
    {253, "CC_Central", {0, 0, 160}},
    {254, "CC_Mid_Anterior", {0, 0, 208}},
    {255, "CC_Anterior", {0, 0, 255}},
});

/// Cortical areas from 1001 (left) and 2001 (right) on, in this order.
constexpr auto kCortex = std::to_array<std::string_view>({"bankssts",
                                                          "caudalanteriorcingulate",
                                                          "caudalmiddlefrontal",
                                                          "corpuscallosum",
                                                          "cuneus",
                                                          "entorhinal",
                                                          "fusiform",
                                                          "inferiorparietal",
                                                          "inferiortemporal",
                                                          "isthmuscingulate",
                                                          "lateraloccipital",
                                                          "lateralorbitofrontal",
                                                          "lingual",
                                                          "medialorbitofrontal",
                                                          "middletemporal",
                                                          "parahippocampal",
                                                          "paracentral",
                                                          "parsopercularis",
                                                          "parsorbitalis",
                                                          "parstriangularis",
                                                          "pericalcarine",
                                                          "postcentral",
                                                          "posteriorcingulate",
                                                          "precentral",
                                                          "precuneus",
                                                          "rostralanteriorcingulate",
                                                          "rostralmiddlefrontal",
                                                          "superiorfrontal",
                                                          "superiorparietal",
                                                          "superiortemporal",
                                                          "supramarginal",
                                                          "frontalpole",
                                                          "temporalpole",
                                                          "transversetemporal",
                                                          "insula"});

/// From 1 on, in this order.
constexpr auto kTotalSegmentator = std::to_array<std::string_view>({"spleen",
                                                                    "kidney_right",
                                                                    "kidney_left",
                                                                    "gallbladder",
                                                                    "liver",
                                                                    "stomach",
                                                                    "pancreas",
                                                                    "adrenal_gland_right",
                                                                    "adrenal_gland_left",
                                                                    "lung_upper_lobe_left",
                                                                    "lung_lower_lobe_left",
                                                                    "lung_upper_lobe_right",
                                                                    "lung_middle_lobe_right",
                                                                    "lung_lower_lobe_right",
                                                                    "esophagus",
                                                                    "trachea",
                                                                    "thyroid_gland",
                                                                    "small_bowel",
                                                                    "duodenum",
                                                                    "colon",
                                                                    "urinary_bladder",
                                                                    "prostate",
                                                                    "kidney_cyst_left",
                                                                    "kidney_cyst_right",
                                                                    "sacrum",
                                                                    "vertebrae_S1",
                                                                    "vertebrae_L5",
                                                                    "vertebrae_L4",
                                                                    "vertebrae_L3",
                                                                    "vertebrae_L2",
                                                                    "vertebrae_L1",
                                                                    "vertebrae_T12",
                                                                    "vertebrae_T11",
                                                                    "vertebrae_T10",
                                                                    "vertebrae_T9",
                                                                    "vertebrae_T8",
                                                                    "vertebrae_T7",
                                                                    "vertebrae_T6",
                                                                    "vertebrae_T5",
                                                                    "vertebrae_T4",
                                                                    "vertebrae_T3",
                                                                    "vertebrae_T2",
                                                                    "vertebrae_T1",
                                                                    "vertebrae_C7",
                                                                    "vertebrae_C6",
                                                                    "vertebrae_C5",
                                                                    "vertebrae_C4",
                                                                    "vertebrae_C3",
                                                                    "vertebrae_C2",
                                                                    "vertebrae_C1",
                                                                    "heart",
                                                                    "aorta",
                                                                    "pulmonary_vein",
                                                                    "brachiocephalic_trunk",
                                                                    "subclavian_artery_right",
                                                                    "subclavian_artery_left",
                                                                    "common_carotid_artery_right",
                                                                    "common_carotid_artery_left",
                                                                    "brachiocephalic_vein_left",
                                                                    "brachiocephalic_vein_right",
                                                                    "atrial_appendage_left",
                                                                    "superior_vena_cava",
                                                                    "inferior_vena_cava",
                                                                    "portal_vein_and_splenic_vein",
                                                                    "iliac_artery_left",
                                                                    "iliac_artery_right",
                                                                    "iliac_vena_left",
                                                                    "iliac_vena_right",
                                                                    "humerus_left",
                                                                    "humerus_right",
                                                                    "scapula_left",
                                                                    "scapula_right",
                                                                    "clavicula_left",
                                                                    "clavicula_right",
                                                                    "femur_left",
                                                                    "femur_right",
                                                                    "hip_left",
                                                                    "hip_right",
                                                                    "spinal_cord",
                                                                    "gluteus_maximus_left",
                                                                    "gluteus_maximus_right",
                                                                    "gluteus_medius_left",
                                                                    "gluteus_medius_right",
                                                                    "gluteus_minimus_left",
                                                                    "gluteus_minimus_right",
                                                                    "autochthon_left",
                                                                    "autochthon_right",
                                                                    "iliopsoas_left",
                                                                    "iliopsoas_right",
                                                                    "brain",
                                                                    "skull",
                                                                    "rib_left_1",
                                                                    "rib_left_2",
                                                                    "rib_left_3",
                                                                    "rib_left_4",
                                                                    "rib_left_5",
                                                                    "rib_left_6",
                                                                    "rib_left_7",
                                                                    "rib_left_8",
                                                                    "rib_left_9",
                                                                    "rib_left_10",
                                                                    "rib_left_11",
                                                                    "rib_left_12",
                                                                    "rib_right_1",
                                                                    "rib_right_2",
                                                                    "rib_right_3",
                                                                    "rib_right_4",
                                                                    "rib_right_5",
                                                                    "rib_right_6",
                                                                    "rib_right_7",
                                                                    "rib_right_8",
                                                                    "rib_right_9",
                                                                    "rib_right_10",
                                                                    "rib_right_11",
                                                                    "rib_right_12",
                                                                    "sternum",
                                                                    "costal_cartilages"});

LabelNames freeSurferNames()
{
    constexpr std::uint32_t kLeft = 1001, kRight = 2001;
    LabelNames names;
    for (const Known& known : kFreeSurfer) {
        names[{0, known.value}] = {
            std::string(known.name),
            std::array<double, 3>{known.rgb[0] / 255.0, known.rgb[1] / 255.0, known.rgb[2] / 255.0}};
    }
    for (std::uint32_t i = 0; i < kCortex.size(); ++i) {
        names[{0, kLeft + i}].name = "ctx-lh-" + std::string(kCortex[i]);
        names[{0, kRight + i}].name = "ctx-rh-" + std::string(kCortex[i]);
    }
    return names;
}

LabelNames totalSegmentatorNames()
{
    LabelNames names;
    for (std::uint32_t i = 0; i < kTotalSegmentator.size(); ++i) {
        names[{0, i + 1}].name = std::string(kTotalSegmentator[i]);
    }
    return names;
}

bool contains(std::string_view text, std::string_view word)
{
    for (std::size_t at = 0; at + word.size() <= text.size(); ++at) {
        if (sameWord(text.substr(at, word.size()), word)) {
            return true;
        }
    }
    return false;
}

} // namespace

std::optional<LabelTable> standardTable(const std::vector<Label>& labels, std::string_view file)
{
    const auto fits = [&labels](const LabelNames& names) {
        return std::all_of(labels.begin(), labels.end(), [&names](const Label& label) {
            return names.contains({label.layer, label.value});
        });
    };
    const auto has = [&labels](std::uint32_t value) {
        return std::any_of(labels.begin(), labels.end(), [value](const Label& label) { return label.value == value; });
    };
    static constexpr std::array<std::string_view, 4> kFiles{"aseg", "aparc", "wmparc", "synthseg"};
    const bool isNamed =
        std::any_of(kFiles.begin(), kFiles.end(), [file](std::string_view word) { return contains(file, word); });
    if (isNamed || (has(2) && has(3) && has(41) && has(42))) {
        if (LabelTable table{"FreeSurfer", freeSurferNames()}; isNamed || fits(table.names)) {
            return table;
        }
    }
    if (contains(file, "total")) {
        if (LabelTable table{"TotalSegmentator", totalSegmentatorNames()}; fits(table.names)) {
            return table;
        }
    }
    return std::nullopt;
}

} // namespace palpate::meshio::internal

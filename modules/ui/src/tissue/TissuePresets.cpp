// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/TissuePresets.h"

#include <palpate/study/StiffnessRatio.h>

#include <QtGlobal>

namespace palpate::ui {

namespace {

using meshio::AnatomyKind;

core::Tissue linear(double stiffness_N_per_mm, double damping_Ns_per_mm = 0.0)
{
    core::Tissue tissue;
    tissue.stiffness_N_per_mm = stiffness_N_per_mm;
    tissue.damping_Ns_per_mm = damping_Ns_per_mm;
    return tissue;
}

/// Same value as for the selection by name, defined in one place.
core::Tissue healthy(AnatomyKind kind)
{
    return linear(study::tissueStiffness_N_per_mm(kind).value());
}

core::Tissue lawful(core::LawKind kind, const std::array<double, core::ForceLaw::kMaxParameters>& numbers)
{
    core::Tissue tissue = linear(0.25);
    tissue.law = {kind, numbers, {}};
    return tissue;
}

} // namespace

const std::vector<TissuePreset>& tissuePresets()
{
    // A fingertip is modelled as a flat punch of radius a = 5 mm on a half space of Young's modulus E:
    //     k = 2 a E / (1 - nu^2), with the shear modulus mu and nu = 1/2: k = 8 a mu
    // 5 kPa gives 0.07 N/mm, 17 kPa 0.23, 24 kPa 0.32, 100 kPa 1.3. "Bone" is a stiffness that feels rigid within the
    // range of common devices.
    static const char* const kChosen = QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "none, assumed values");
    static const char* const kElastography =
        QT_TRANSLATE_NOOP("palpate::ui::StructurePanel",
                          "shear modulus from MR elastography (PMC2894569), for a fingertip of 5 mm radius");
    static const char* const kUltrasound = QT_TRANSLATE_NOOP(
        "palpate::ui::StructurePanel",
        "Young's modulus from shear-wave ultrasound (Arda et al. 2011, AJR 197:532), for a fingertip of 5 mm radius");
    static const std::vector<TissuePreset> presets{
        {QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "Very soft organ"), kChosen, linear(0.07)},
        {QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "Soft organ"), kChosen, linear(0.25)},
        {QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "Firm organ"), kChosen, linear(0.50)},
        {QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "Firm lump"), kChosen, linear(0.80)},
        {QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "Hard lump"), kChosen, linear(1.30)},
        {QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "Bone"), kChosen, linear(2.00, 0.0005)},
        {QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "Liver, healthy (2.3 kPa)"), kElastography,
         healthy(AnatomyKind::Liver)},
        {QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "Liver, fibrotic (5.9 kPa)"), kElastography, linear(0.236)},
        {QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "Liver, malignant (10.1 kPa)"), kElastography, linear(0.404)},
        {QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "Kidney (5.0 kPa)"), kUltrasound,
         healthy(AnatomyKind::Kidney)},
        {QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "Spleen (2.9 kPa)"), kUltrasound,
         healthy(AnatomyKind::Spleen)},
        {QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "Pancreas (4.8 kPa)"), kUltrasound,
         healthy(AnatomyKind::Pancreas)},
        {QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "Thyroid (11.0 kPa)"), kUltrasound,
         healthy(AnatomyKind::Thyroid)},
        {QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "Salivary gland (10.9 kPa)"), kUltrasound,
         healthy(AnatomyKind::SalivaryGland)},
        {QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "Muscle at rest (11.1 kPa)"), kUltrasound,
         healthy(AnatomyKind::Muscle)},
        {QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "Tendon (51.5 kPa)"), kUltrasound,
         healthy(AnatomyKind::Tendon)},
        {QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "Prostate (17.0 kPa)"),
         QT_TRANSLATE_NOOP("palpate::ui::StructurePanel",
                           "Young's modulus from indentation (Urology 2010), for a fingertip of 5 mm radius"),
         healthy(AnatomyKind::Prostate)},
        {QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "Breast (3.2 kPa)"),
         QT_TRANSLATE_NOOP("palpate::ui::StructurePanel",
                           "Young's modulus from indentation (Teixeira et al. 2023), for a fingertip of 5 mm radius"),
         healthy(AnatomyKind::Breast)},
        {QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "Lymph node"),
         QT_TRANSLATE_NOOP(
             "palpate::ui::StructurePanel",
             "assumed value below 22 kPa, the malignancy threshold of lymph nodes (2.71 m/s by shear-wave ultrasound)"),
         healthy(AnatomyKind::LymphNode)},
        {QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "Liver, stiffer with depth"),
         QT_TRANSLATE_NOOP("palpate::ui::StructurePanel",
                           "shape after Carter et al. 2001 (exponential), assumed values"),
         lawful(core::LawKind::Exponential, {0.1, 0.35, 1.5})},
        {QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "Demo: ball on soft ground"),
         QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "shape after Hertz 1882, assumed values"),
         lawful(core::LawKind::Hertz, {10.0, 8.0})},
        {QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "Demo: clicking button"), kChosen,
         lawful(core::LawKind::Click, {0.5, 1.0, 0.6, 1.0, 0.5})},
    };
    return presets;
}

core::Tissue withPreset(core::Tissue tissue, const TissuePreset& preset)
{
    tissue.stiffness_N_per_mm = preset.tissue.stiffness_N_per_mm;
    tissue.damping_Ns_per_mm = preset.tissue.damping_Ns_per_mm;
    tissue.law = preset.tissue.law;
    return tissue;
}

int presetOf(const core::Tissue& tissue)
{
    for (std::size_t i = 0; i < tissuePresets().size(); ++i) {
        if (withPreset(tissue, tissuePresets()[i]) == tissue) {
            return static_cast<int>(i);
        }
    }
    return -1;
}

const std::vector<FrictionPreset>& frictionPresets()
{
    // All values are assumptions: no measured coefficient was found for a gloved finger on an organ.
    static const std::vector<FrictionPreset> presets{
        {QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "None"), 0.0},
        {QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "Wet (0.05, assumed)"), 0.05},
        {QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "Moist (0.15, assumed)"), 0.15},
        {QT_TRANSLATE_NOOP("palpate::ui::StructurePanel", "Dry (0.40, assumed)"), 0.40},
    };
    return presets;
}

int frictionPresetOf(const core::Tissue& tissue)
{
    for (std::size_t i = 0; i < frictionPresets().size(); ++i) {
        const double coefficient = frictionPresets()[i].coefficient;
        if (tissue.friction_static == coefficient && tissue.friction_dynamic == coefficient) {
            return static_cast<int>(i);
        }
    }
    return -1;
}

} // namespace palpate::ui

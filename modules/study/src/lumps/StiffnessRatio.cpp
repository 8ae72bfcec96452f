// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/StiffnessRatio.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace palpate::study {

namespace {

using meshio::AnatomyKind;
using Row = PublishedRatio;

constexpr std::string_view kLiver = "shear modulus by MR elastography, normal liver 2.3 kPa: Venkatesh et al. 2008 "
                                    "(PMC2894569); stiffest tumours by shear-wave ultrasound: "
                                    "doi:10.1186/s43055-020-00186-2";
constexpr std::string_view kProstate =
    "cancer by normal tissue, 2.1 at 0.1 Hz and 2.5 at 150 Hz: Hoyt et al. 2008 (PubMed 18957712); 1.4 by "
    "indentation, 24.1 by 17.0 kPa: Urology 2010";
constexpr std::string_view kPancreas = "tumour by parenchyma by MR elastography, median and quartiles: PubMed 37237155";
constexpr std::string_view kBreast = "Young's modulus of 169 samples, tumour by normal tissue: Samani et al. 2007 "
                                     "(doi:10.1088/0031-9155/52/6/002)";
constexpr std::string_view kThyroid = "Young's modulus by shear-wave ultrasound, nodules 105.4 ± 48.8 and 37.6 ± 26.1 "
                                      "kPa (PMC7879443) by normal thyroid 10.97 kPa (doi:10.2214/AJR.10.5449)";
constexpr std::string_view kFluid = "a fluid has no shear modulus: the least ratio that is computed; under tension it "
                                    "feels firmer";

constexpr StiffnessRatio range(double low, double typical, double high, std::string_view citation)
{
    return {low, typical, high, RatioSource::Published, citation};
}

// If the name does not distinguish benign from malignant lumps, the range covers both, and the typical ratio is the
// malignant one.
constexpr std::array kPublished{
    // Typical: 10.1 / 2.3 kPa. Range: from 5.0, the cut-off to benign tumours, to 35.9 / 3, cholangiocarcinoma by
    // shear-wave ultrasound.
    Row{AnatomyKind::MalignantLump, AnatomyKind::Liver, range(2.2, 4.4, 5.2, kLiver),
        PALPATE_TEXT("malignant tumour of the liver")},
    // Typical: 2.7 / 2.3 kPa. Range: from normal liver to 26.7 / 3, focal nodular hyperplasia.
    Row{AnatomyKind::BenignLump, AnatomyKind::Liver, range(1.0, 1.2, 3.9, kLiver),
        PALPATE_TEXT("benign tumour of the liver")},
    Row{AnatomyKind::Lump, AnatomyKind::Liver, range(1.0, 4.4, 5.2, kLiver), PALPATE_TEXT("tumour of the liver")},
    // Typical: 5.9 / 2.3 kPa. Values overlap the ranges of benign and of malignant tumours.
    Row{AnatomyKind::FibroticArea, AnatomyKind::Liver, range(1.2, 2.6, 4.4, kLiver), PALPATE_TEXT("fibrotic liver")},
    Row{AnatomyKind::MalignantLump, AnatomyKind::Prostate, range(1.4, 2.1, 2.5, kProstate),
        PALPATE_TEXT("cancer of the prostate")},
    // Benign hyperplasia is no stiffer than normal tissue (Krouskop et al. 1998).
    Row{AnatomyKind::Lump, AnatomyKind::Prostate, range(1.0, 2.1, 2.5, kProstate),
        PALPATE_TEXT("nodule of the prostate")},
    Row{AnatomyKind::MalignantLump, AnatomyKind::Breast, range(3.0, 4.5, 13.0, kBreast),
        PALPATE_TEXT("malignant tumour of the breast")},
    Row{AnatomyKind::BenignLump, AnatomyKind::Breast, range(2.0, 2.0, 6.0, kBreast),
        PALPATE_TEXT("benign tumour of the breast")},
    Row{AnatomyKind::Lump, AnatomyKind::Breast, range(2.0, 4.5, 13.0, kBreast), PALPATE_TEXT("tumour of the breast")},
    Row{AnatomyKind::MalignantLump, AnatomyKind::Thyroid, range(5.2, 9.6, 14.1, kThyroid),
        PALPATE_TEXT("malignant nodule of the thyroid")},
    Row{AnatomyKind::BenignLump, AnatomyKind::Thyroid, range(1.0, 3.4, 5.8, kThyroid),
        PALPATE_TEXT("benign nodule of the thyroid")},
    Row{AnatomyKind::Lump, AnatomyKind::Thyroid, range(1.0, 9.6, 14.1, kThyroid),
        PALPATE_TEXT("nodule of the thyroid")},
    Row{AnatomyKind::MalignantLump, AnatomyKind::Pancreas, range(1.6, 1.9, 2.5, kPancreas),
        PALPATE_TEXT("cancer of the pancreas")},
    Row{AnatomyKind::BenignLump, AnatomyKind::Pancreas, range(1.0, 1.2, 1.5, kPancreas),
        PALPATE_TEXT("benign tumour of the pancreas")},
    Row{AnatomyKind::Lump, AnatomyKind::Pancreas, range(1.0, 1.9, 2.5, kPancreas),
        PALPATE_TEXT("tumour of the pancreas")},
    Row{AnatomyKind::Cyst, AnatomyKind::Other, range(0.001, 0.001, 0.001, kFluid), PALPATE_TEXT("cyst")},
    Row{AnatomyKind::Vessel, AnatomyKind::Other, range(0.001, 0.001, 0.001, kFluid), PALPATE_TEXT("vessel")},
};

/// Stiffness of a half-space under a flat punch of radius a = 5 mm, approximating a fingertip: k = 2 a E / (1 - nu^2),
/// nu = 1/2.
constexpr double punchStiffness_N_per_mm(double young_kPa)
{
    return 2.0 * 5.0 * 1e-3 * young_kPa / 0.75;
}

} // namespace

std::string_view sourceText(RatioSource source) noexcept
{
    switch (source) {
    case RatioSource::Typed:
        return "as typed";
    case RatioSource::Moduli:
        return "from the moduli";
    case RatioSource::Published:
        return "published for such lumps";
    case RatioSource::Tissue:
        break;
    }
    return "from the tissues' stiffness";
}

std::span<const PublishedRatio> publishedRatios()
{
    return kPublished;
}

const PublishedRatio* publishedRatio(AnatomyKind lump, AnatomyKind organ)
{
    const auto find = [lump](AnatomyKind in) -> const PublishedRatio* {
        const auto* found = std::find_if(kPublished.begin(), kPublished.end(),
                                         [&](const Row& row) { return row.lump == lump && row.organ == in; });
        return found != kPublished.end() ? found : nullptr;
    };
    const PublishedRatio* own = find(organ);
    return own != nullptr ? own : find(AnatomyKind::Other);
}

std::optional<double> tissueStiffness_N_per_mm(AnatomyKind kind)
{
    switch (kind) {
    case AnatomyKind::Liver: // 2.3 kPa of shear modulus: Venkatesh et al. 2008
        return 0.092;
    case AnatomyKind::Kidney: // Young's moduli of kidney to tendon: Arda et al. 2011, doi:10.2214/AJR.10.5449
        return punchStiffness_N_per_mm(5.0);
    case AnatomyKind::Spleen:
        return punchStiffness_N_per_mm(2.9);
    case AnatomyKind::Pancreas:
        return punchStiffness_N_per_mm(4.8);
    case AnatomyKind::Thyroid:
        return punchStiffness_N_per_mm(10.97);
    case AnatomyKind::SalivaryGland:
        return punchStiffness_N_per_mm(10.92);
    case AnatomyKind::Muscle:
        return punchStiffness_N_per_mm(11.1);
    case AnatomyKind::Tendon:
        return punchStiffness_N_per_mm(51.5);
    case AnatomyKind::Prostate: // by indentation, Urology 2010
        return punchStiffness_N_per_mm(17.0);
    case AnatomyKind::Breast: // first linear region: doi in resources/docs/felt.md
        return punchStiffness_N_per_mm(3.2);
    case AnatomyKind::LymphNode: // below 2.71 m/s, above which nodes count as malignant; assumed value
        return 0.15;
    case AnatomyKind::Bone: // rigid within the limits of devices; assumed value
    case AnatomyKind::Cartilage:
        return 2.0;
    case AnatomyKind::Organ: // assumed values
    case AnatomyKind::Skin:
        return 0.25;
    case AnatomyKind::Lung:
    case AnatomyKind::Brain:
    case AnatomyKind::Fat:
        return 0.07;
    default:
        return std::nullopt;
    }
}

std::optional<double> namedStiffness_N_per_mm(const std::string& name, const std::string* organ)
{
    const AnatomyKind kind = meshio::anatomyKind(name);
    if (!meshio::isLump(kind)) {
        return tissueStiffness_N_per_mm(kind);
    }
    const AnatomyKind in = organ != nullptr ? meshio::anatomyKind(*organ) : AnatomyKind::Other;
    const PublishedRatio* ratio = publishedRatio(kind, in);
    const std::optional<double> around = tissueStiffness_N_per_mm(in);
    return ratio != nullptr && around ? std::optional(ratio->ratio.typical * *around) : std::nullopt;
}

std::optional<StiffnessRatio> stiffnessRatio(const meshio::SceneStructure& lump, const meshio::SceneStructure& organ,
                                             std::optional<double> typed)
{
    if (typed || lump.young_ratio) {
        return StiffnessRatio::exactly(typed ? *typed : *lump.young_ratio, RatioSource::Typed);
    }
    if (lump.young_kPa && organ.young_kPa) {
        return StiffnessRatio::exactly(*lump.young_kPa / *organ.young_kPa, RatioSource::Moduli);
    }
    // A stiffness counts as chosen if it differs from both the default and the value implied by the name.
    const auto isChosen = [](const meshio::SceneStructure& one, const std::string* in) {
        const double k = one.tissue.stiffness_N_per_mm;
        return one.tissue.law.kind == core::LawKind::Linear && k > 0.0 && k != core::Tissue().stiffness_N_per_mm &&
               k != namedStiffness_N_per_mm(one.name, in).value_or(k + 1.0);
    };
    const bool areLinear =
        lump.tissue.law.kind == core::LawKind::Linear && organ.tissue.law.kind == core::LawKind::Linear;
    const StiffnessRatio byTissue =
        StiffnessRatio::exactly(lump.tissue.stiffness_N_per_mm / organ.tissue.stiffness_N_per_mm, RatioSource::Tissue);
    const bool hasTissue = areLinear && std::isfinite(byTissue.typical) && byTissue.typical > 0.0;
    if (hasTissue && isChosen(lump, &organ.name)) {
        return byTissue;
    }
    if (const PublishedRatio* found = publishedRatio(meshio::anatomyKind(lump.name), meshio::anatomyKind(organ.name))) {
        return found->ratio;
    }
    return hasTissue && isChosen(organ, nullptr) ? std::optional(byTissue) : std::nullopt;
}

core::Message ratioQuestion(const std::string& lump, const std::string& organ)
{
    const AnatomyKind in = meshio::anatomyKind(organ);
    std::vector<core::Message> known;
    for (const PublishedRatio& one : kPublished) {
        if (one.organ != in && one.organ != AnatomyKind::Other) {
            continue;
        }
        const core::Message name(one.name);
        known.push_back(one.ratio.isRange() ? core::Message(PALPATE_TEXT("%1 %2 (%3 to %4)"), name, one.ratio.typical,
                                                            one.ratio.low, one.ratio.high)
                                            : core::Message(PALPATE_TEXT("%1 %2"), name, one.ratio.typical));
    }
    return {
        PALPATE_TEXT("%1: the stiffness ratio to %2 is not known, so no verdict is given; expected a ratio, as --ratio "
                     "\"%1=R\" or `young_ratio` in a scene file. Published: %3"),
        lump, organ, core::joined(known)};
}

} // namespace palpate::study

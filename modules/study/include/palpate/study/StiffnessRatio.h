// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Message.h>
#include <palpate/meshio/AnatomyKind.h>
#include <palpate/meshio/SceneFile.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace palpate::study {

/// Origin of a stiffness ratio.
enum class RatioSource : std::uint8_t
{
    Typed,     ///< `young_ratio`, or entered by the user
    Moduli,    ///< `young_kPa` of the lump and of the organ
    Tissue,    ///< stiffness ratio of the two tissues, if chosen by the user or a scene file
    Published, ///< measured ratios for the kinds of lump and organ given by the names
};

/// Returns "as typed", "from the moduli", "from the tissues' stiffness" or "published for such lumps".
[[nodiscard]] std::string_view sourceText(RatioSource source) noexcept;

/// Ratio of stiffness, lump to organ [1].
struct StiffnessRatio
{
    double low = 1.0, typical = 1.0, high = 1.0; ///< all equal if the ratio is a single number
    RatioSource source = RatioSource::Typed;
    std::string_view citation{}; ///< of a published range; else empty

    [[nodiscard]] static StiffnessRatio exactly(double ratio, RatioSource source)
    {
        return {ratio, ratio, ratio, source, {}};
    }
    [[nodiscard]] bool isRange() const noexcept { return low != high; }
    friend bool operator==(const StiffnessRatio&, const StiffnessRatio&) = default;
};

/// Published modulus ratio for a kind of lump in an organ.
struct PublishedRatio
{
    meshio::AnatomyKind lump;
    meshio::AnatomyKind organ; ///< Other: any organ
    StiffnessRatio ratio;
    core::MessageText<> name; ///< "malignant tumour of the liver"
};
/// Returns all published ratios, in display order.
[[nodiscard]] std::span<const PublishedRatio> publishedRatios();
/// Returns nullptr if there is no published ratio for this lump and organ.
[[nodiscard]] const PublishedRatio* publishedRatio(meshio::AnatomyKind lump, meshio::AnatomyKind organ);

/// Determines the stiffness ratio of a lump to the organ; shared by window, command line and scene files. Sources in
/// order: entered ratio; moduli of both; stiffness of both tissues if chosen explicitly; published ratio for the names.
/// @return empty without any source. Palpability must then not be reported, see `ratioQuestion`
/// @param typed  ratio from the command line; takes precedence
[[nodiscard]] std::optional<StiffnessRatio> stiffnessRatio(const meshio::SceneStructure& lump,
                                                           const meshio::SceneStructure& organ,
                                                           std::optional<double> typed = std::nullopt);

/// Returns the stiffness of healthy tissue under a fingertip of 5 mm radius [N/mm]; empty for kinds without a value.
/// @par Source resources/docs/felt.md#tissue-by-name
[[nodiscard]] std::optional<double> tissueStiffness_N_per_mm(meshio::AnatomyKind kind);

/// Returns the stiffness under a fingertip of 5 mm radius that the name of a structure implies [N/mm]; empty for other
/// names. For a lump: the organ's stiffness times the published ratio.
/// @param organ  name of the enclosing structure; null: none
/// @par Source resources/docs/felt.md#tissue-by-name
[[nodiscard]] std::optional<double> namedStiffness_N_per_mm(const std::string& name,
                                                            const std::string* organ = nullptr);

/// Returns a question about the ratio with the published choices: "lump x in thing: how many times as stiff as thing it
/// is is not known; ...".
[[nodiscard]] core::Message ratioQuestion(const std::string& lump, const std::string& organ);

} // namespace palpate::study

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/meshio/AnatomyKind.h>
#include <palpate/meshio/SceneFile.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace palpate::study {

/// Where a stiffness ratio comes from.
enum class RatioSource : std::uint8_t
{
    Typed,     ///< `young_ratio`, or given by the person
    Moduli,    ///< `young_kPa` of the lump and of its organ
    Tissue,    ///< stiffness of the lump's tissue by that of the organ's, where a person or a scene file chose them
    Published, ///< measured ratios of such lumps in such organs; the names say which
};

/// @return "as typed", "from the moduli", "from the tissues' stiffness", "published for such lumps"
[[nodiscard]] std::string_view sourceText(RatioSource source) noexcept;

/// How many times as stiff as its organ a lump is [1].
struct StiffnessRatio
{
    double low = 1.0, typical = 1.0, high = 1.0; ///< the same three times where one number is known
    RatioSource source = RatioSource::Typed;
    std::string_view citation{}; ///< of a published range; else empty

    [[nodiscard]] static StiffnessRatio exactly(double ratio, RatioSource source)
    {
        return {ratio, ratio, ratio, source, {}};
    }
    [[nodiscard]] bool isRange() const noexcept { return low != high; }
    friend bool operator==(const StiffnessRatio&, const StiffnessRatio&) = default;
};

/// Published ratios of the moduli, lump by organ.
struct PublishedRatio
{
    meshio::AnatomyKind lump;
    meshio::AnatomyKind organ; ///< Other: in any organ
    StiffnessRatio ratio;
    std::string_view name; ///< "malignant tumour of the liver"
};
/// All that is known, in the order of a list for a person.
[[nodiscard]] std::span<const PublishedRatio> publishedRatios();
/// @return nullptr where nothing is published for such a lump in such an organ.
[[nodiscard]] const PublishedRatio* publishedRatio(meshio::AnatomyKind lump, meshio::AnatomyKind organ);

/// Decides how stiff a lump is against its organ, for window, command line and scene files alike. In this order: what
/// is typed; the moduli of both; the tissues' stiffnesses where they were chosen; what is published for such names.
/// @return nothing where none of these says it: then nothing may be said of what a hand feels, see `ratioQuestion`
/// @param typed  a ratio from the command line, before all else
[[nodiscard]] std::optional<StiffnessRatio> stiffnessRatio(const meshio::SceneStructure& lump,
                                                           const meshio::SceneStructure& organ,
                                                           std::optional<double> typed = std::nullopt);

/// The stiffness that a fingertip of 5 mm radius feels of healthy tissue [N/mm]; nothing for kinds that have none.
/// @par Source resources/docs/felt.md#tissue-by-name
[[nodiscard]] std::optional<double> tissueStiffness_N_per_mm(meshio::AnatomyKind kind);

/// The stiffness that a structure's name says a fingertip of 5 mm radius feels [N/mm]; nothing for a name that says
/// none. Of a lump that of its organ times the published ratio.
/// @param organ  that the structure lies in; null: none
/// @par Source resources/docs/felt.md#tissue-by-name
[[nodiscard]] std::optional<double> namedStiffness_N_per_mm(const std::string& name,
                                                            const std::string* organ = nullptr);

/// @return what must be known of a lump, and the published ratios to choose from: "lump x in thing: how many times as
/// stiff as thing it is is not known; ..."
[[nodiscard]] std::string ratioQuestion(const std::string& lump, const std::string& organ);

} // namespace palpate::study

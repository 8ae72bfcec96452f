// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "labels/LabelVolume.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace palpate::meshio::internal {

/// Name and colour of a label.
struct LabelName
{
    std::string name;                              ///< valid UTF-8
    std::optional<std::array<double, 3>> colour{}; ///< red, green, blue in 0 … 1
};

/// Names of labels by layer and value.
using LabelNames = std::map<std::pair<std::uint32_t, std::uint32_t>, LabelName>;

/// Names from the fields `SegmentN_Name`, `_Color`, `_LabelValue` and `_Layer` of 3D Slicer. Without the latter two,
/// as written by old versions for four axes, each segment has its own layer with the value 1.
[[nodiscard]] LabelNames slicerNames(const VolumeLayout& layout);

/// Names from the XML that TotalSegmentator and Connectome Workbench write into a NIfTI extension:
/// `<Label Key="1" Red="0.2" Green="0" Blue="0"><![CDATA[spleen]]></Label>`. Broken XML has the names up to there.
[[nodiscard]] LabelNames niftiNames(const std::string& xml);

/// Names from an ITK-SNAP label description: `IDX R G B A VIS MSH "LABEL"` per line.
[[nodiscard]] LabelNames itkSnapNames(std::string_view text);

/// Finds an ITK-SNAP label description beside a volume: `case.txt` or `case.label` for `case.nii.gz`, otherwise the
/// only file of this content with one of these extensions in the folder.
[[nodiscard]] std::optional<std::filesystem::path> labelDescriptionBeside(const std::filesystem::path& volume);

/// Standard names of labels, for files without names.
struct LabelTable
{
    std::string_view source; ///< for users, "FreeSurfer"
    LabelNames names;
};

/// @return the table that fits the labels of a file; nothing if none fits for certain. TotalSegmentator's table is used
/// only if the file name contains "total", because any file has labels from 1 on; FreeSurfer's if the file name
/// contains "aseg", "aparc", "wmparc" or "synthseg", or if the labels contain both cerebral white matters and cortices.
[[nodiscard]] std::optional<LabelTable> standardTable(const std::vector<Label>& labels, std::string_view file);

} // namespace palpate::meshio::internal

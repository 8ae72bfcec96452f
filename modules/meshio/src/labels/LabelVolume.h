// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "voxels/VolumeLayout.h"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace palpate::meshio::internal {

/// One label of a label map.
struct Label
{
    std::uint32_t layer = 0;
    std::uint32_t value = 0; ///< never 0, which is the background
    std::uint64_t voxels = 0;
    std::array<std::uint32_t, 3> first{}, last{}; ///< bounding box, both included [voxels]
};

/// Labels of all voxels as numbers of two bytes, which bounds the memory whatever type the file has.
struct LabelVolume
{
    std::array<std::uint32_t, 3> size{};
    std::vector<Label> labels; ///< in the order of layer and value; at least one
    /// For each layer one volume, x fastest: 0 for the background, otherwise 1 + the place in `labels`.
    std::vector<std::uint16_t> voxels;
};

inline constexpr std::size_t kMostLabels = 1024;

/// Collects the voxels of a file and decides whether they are labels: whole numbers from 0, and either few of them, or
/// most of them in contiguous areas. The numbers of an image differ from voxel to voxel.
class LabelCollector
{
  public:
    explicit LabelCollector(const VolumeLayout& layout);
    /// Takes the next voxels in file order. @return false if further voxels cannot make it a label map
    bool take(std::span<const double> numbers);
    /// @param file  name for messages
    /// @return an error if the voxels are intensities, or if there is no label
    [[nodiscard]] core::Result<LabelVolume> finish(const std::string& file) &&;

  private:
    struct Seen
    {
        Label label;
        std::uint64_t continued = 0; ///< voxels whose predecessor along x has the same value
    };
    std::uint16_t numberOf(double value, std::uint32_t layer);
    void add(double value);
    [[nodiscard]] bool isOfAreas() const;

    const VolumeLayout& m_layout;
    std::vector<std::uint16_t> m_voxels;
    std::vector<Seen> m_seen;
    std::map<std::pair<std::uint32_t, double>, std::uint16_t> m_numbers;
    std::map<double, bool> m_foreign;                     ///< values that are no label
    std::vector<std::pair<double, std::uint16_t>> m_last; ///< of each layer
    std::array<std::uint32_t, 3> m_at{};
    std::uint32_t m_layer = 0;
    bool m_isFull = false; ///< too many different values
};

} // namespace palpate::meshio::internal

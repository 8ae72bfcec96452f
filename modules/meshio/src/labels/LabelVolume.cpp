// SPDX-License-Identifier: BSD-3-Clause
#include "labels/LabelVolume.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <tuple>

namespace palpate::meshio::internal {

using core::Message;
using core::Result;
using core::StatusCode;

namespace {

constexpr std::size_t kMostValues = 65535; ///< different values that are counted
constexpr double kMostValue = std::numeric_limits<std::uint32_t>::max();

} // namespace

LabelCollector::LabelCollector(const VolumeLayout& layout)
    : m_layout(layout)
{
}

/// @return number of a value that is not 0; 0 for a value that is no label
std::uint16_t LabelCollector::numberOf(double value, std::uint32_t layer)
{
    if (!(value > 0.0 && value <= kMostValue && value == std::floor(value))) {
        m_foreign.emplace(std::isnan(value) ? std::numeric_limits<double>::infinity() : value, true);
        m_isFull = m_isFull || m_foreign.size() + m_seen.size() >= kMostValues;
        return 0;
    }
    const auto [found, isNew] =
        m_numbers.emplace(std::pair(layer, value), static_cast<std::uint16_t>(m_seen.size() + 1));
    if (isNew) {
        Seen& seen = m_seen.emplace_back();
        seen.label.layer = layer;
        seen.label.value = static_cast<std::uint32_t>(value);
        seen.label.first = seen.label.last = m_at;
        m_isFull = m_isFull || m_foreign.size() + m_seen.size() >= kMostValues;
    }
    return found->second;
}

void LabelCollector::add(double value)
{
    auto& [lastValue, lastNumber] = m_last[m_layer];
    const bool isSame = value == lastValue && m_at[0] > 0;
    if (value != lastValue) {
        lastNumber = value == 0.0 ? std::uint16_t{0} : numberOf(value, m_layer);
        lastValue = value;
    }
    if (lastNumber == 0) {
        return;
    }
    Seen& seen = m_seen[lastNumber - std::size_t{1}];
    ++seen.label.voxels;
    seen.continued += isSame ? 1 : 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        seen.label.first[axis] = std::min(seen.label.first[axis], m_at[axis]);
        seen.label.last[axis] = std::max(seen.label.last[axis], m_at[axis]);
    }
    const auto& size = m_layout.size;
    m_voxels[m_at[0] + size[0] * (m_at[1] + size[1] * (m_at[2] + std::uint64_t{size[2]} * m_layer))] = lastNumber;
}

bool LabelCollector::take(std::span<const double> numbers)
{
    if (m_voxels.empty()) { // only now is it certain that the file has as many voxels as its header states
        m_voxels.assign(m_layout.voxels(), 0);
        m_last.assign(m_layout.layers, {0.0, 0});
    }
    const auto& size = m_layout.size;
    for (const double number : numbers) {
        add(number);
        if (m_isFull) {
            return false;
        }
        if (m_layout.isInterleaved && ++m_layer < m_layout.layers) {
            continue;
        }
        m_layer = m_layout.isInterleaved ? 0 : m_layer;
        if (++m_at[0] < size[0]) {
            continue;
        }
        m_at[0] = 0;
        if (++m_at[1] < size[1]) {
            continue;
        }
        m_at[1] = 0;
        if (++m_at[2] < size[2]) {
            continue;
        }
        m_at[2] = 0;
        m_layer += m_layout.isInterleaved ? 0 : 1;
    }
    return true;
}

/// @return true if at least half of the labels consist of runs of voxels rather than of single ones
bool LabelCollector::isOfAreas() const
{
    constexpr std::size_t kFew = 32; // whole numbers from 0 with so few values are labels, however small
    constexpr double kLeastShare = 0.3;
    const auto areas = std::count_if(m_seen.begin(), m_seen.end(), [](const Seen& seen) {
        return static_cast<double>(seen.continued) >= kLeastShare * static_cast<double>(seen.label.voxels);
    });
    return m_seen.size() <= kFew || 2 * static_cast<std::size_t>(areas) >= m_seen.size();
}

Result<LabelVolume> LabelCollector::finish(const std::string& file) &&
{
    const std::size_t values = m_seen.size() + m_foreign.size();
    const Message expected(
        PALPATE_TEXT("a label map: whole numbers from 0, one for each structure. A CT or MR image is segmented first "
                     "(3D Slicer, TotalSegmentator), or shown in the sections of an open scene (View › Section plane "
                     "› Show an image…). As a map of stiffness, a volume is named in a scene (maps.md)"));
    if (m_isFull) {
        return fault(StatusCode::Unsupported, file, Message(),
                     Message(PALPATE_TEXT("a %1 volume with more than %2 intensities, not labels"), m_layout.format,
                             core::Count(kMostValues - 1)),
                     expected);
    }
    if (!m_foreign.empty() || (!m_layout.isStatedLabels && (m_seen.size() > kMostLabels || !isOfAreas()))) {
        return fault(
            StatusCode::Unsupported, file, Message(),
            Message(PALPATE_TEXT("a %1 volume with %2 intensities, not labels"), m_layout.format, core::Count(values)),
            expected);
    }
    if (m_seen.size() > kMostLabels) {
        return fault(StatusCode::OutOfRange, file, Message(),
                     Message(PALPATE_TEXT("a label map with %1 labels"), core::Count(m_seen.size())),
                     Message(PALPATE_TEXT("at most %1 labels"), core::Count(kMostLabels)));
    }
    if (m_seen.empty()) {
        return fault(StatusCode::Empty, file, Message(),
                     Message(PALPATE_TEXT("a %1 volume without labels: every voxel is 0"), m_layout.format),
                     Message(PALPATE_TEXT("at least one voxel with a label")));
    }
    std::vector<std::uint16_t> order(m_seen.size());
    std::iota(order.begin(), order.end(), std::uint16_t{0});
    std::sort(order.begin(), order.end(), [this](std::uint16_t a, std::uint16_t b) {
        const Label &left = m_seen[a].label, &right = m_seen[b].label;
        return std::tie(left.layer, left.value) < std::tie(right.layer, right.value);
    });
    LabelVolume out;
    out.size = m_layout.size;
    std::vector<std::uint16_t> numbers(m_seen.size() + 1, 0);
    for (const std::uint16_t from : order) {
        out.labels.push_back(m_seen[from].label);
        numbers[from + std::size_t{1}] = static_cast<std::uint16_t>(out.labels.size());
    }
    out.voxels = std::move(m_voxels);
    std::transform(out.voxels.begin(), out.voxels.end(), out.voxels.begin(),
                   [&numbers](std::uint16_t number) { return numbers[number]; });
    return out;
}

} // namespace palpate::meshio::internal

// SPDX-License-Identifier: BSD-3-Clause
// Source of the format: https://nifti.nimh.nih.gov/nifti-1/documentation/nifti1.h and nifti2.h
#include "voxels/Unpack.h"
#include "voxels/VolumeLayout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

namespace palpate::meshio::internal {

namespace {

using core::Message;
using core::Result;
using core::Status;
using core::StatusCode;
using core::Vec3;

constexpr std::size_t kNifti1 = 348, kNifti2 = 540;            ///< bytes of the header: NIfTI-1, NIfTI-2
constexpr std::size_t kMostNiftiHeader = std::size_t{1} << 26; ///< header and extensions [bytes]

bool isPackedNifti(std::string_view bytes)
{
    return bytes.starts_with("\x1f\x8b");
}

/// @return up to `size` first bytes of the file, unpacked
std::string beginningOf(std::string_view bytes, std::size_t size)
{
    if (!isPackedNifti(bytes)) {
        return std::string(bytes.substr(0, size));
    }
    constexpr std::size_t kPiece = std::size_t{1} << 16;
    ByteStream stream([&] { return std::exchange(bytes, {}); }, true);
    std::string out;
    for (std::size_t got = 1; out.size() < size && got > 0;) {
        const std::size_t before = out.size();
        out.resize(std::min(size, before + kPiece));
        got = stream.read({&out[before], out.size() - before});
        out.resize(before + got);
    }
    return out;
}

/// Reads the numbers of a header.
class NiftiHead
{
  public:
    /// @param bytes  of the header and the extensions
    explicit NiftiHead(std::string bytes)
        : m_bytes(std::move(bytes))
    {
        for (const bool isSwapped : {false, true}) {
            m_isSwapped = isSwapped;
            const auto size = at<std::int32_t>(0);
            m_size =
                size == std::int32_t{kNifti1} || size == std::int32_t{kNifti2} ? static_cast<std::size_t>(size) : 0;
            if (m_size != 0) {
                break;
            }
        }
    }
    [[nodiscard]] bool isWhole() const { return m_size != 0 && m_bytes.size() >= m_size; }
    [[nodiscard]] bool isSecond() const { return m_size == kNifti2; }
    [[nodiscard]] bool isBigEndian() const { return m_isSwapped; } // this program runs on little-endian machines only
    [[nodiscard]] std::size_t size() const { return m_size; }
    [[nodiscard]] std::string_view bytes() const { return m_bytes; }
    /// @return the number at that offset; 0 behind the end
    template<class T>
    [[nodiscard]] T at(std::size_t offset) const
    {
        std::array<char, sizeof(T)> raw{};
        if (offset + sizeof(T) <= m_bytes.size()) {
            std::memcpy(raw.data(), &m_bytes[offset], sizeof(T));
        }
        if (m_isSwapped) {
            std::reverse(raw.begin(), raw.end());
        }
        T value;
        std::memcpy(&value, raw.data(), sizeof(T));
        return value;
    }
    /// Reads a number that NIfTI-2 stores with twice as many bytes.
    template<class T>
    [[nodiscard]] auto either(std::size_t first, std::size_t second) const
    {
        using Wide = std::conditional_t<std::is_floating_point_v<T>, double, std::int64_t>;
        return isSecond() ? at<Wide>(second) : static_cast<Wide>(at<T>(first));
    }
    /// Same for element `i` of an array.
    template<class T>
    [[nodiscard]] auto either(std::size_t first, std::size_t second, std::size_t i) const
    {
        return either<T>(first + i * sizeof(T), second + i * 8);
    }

  private:
    std::string m_bytes;
    bool m_isSwapped = false;
    std::size_t m_size = 0;
};

std::optional<VoxelType> niftiType(std::int16_t code)
{
    static constexpr auto kTypes = std::to_array<std::pair<std::int16_t, VoxelType>>({{2, VoxelType::UInt8},
                                                                                      {4, VoxelType::Int16},
                                                                                      {8, VoxelType::Int32},
                                                                                      {16, VoxelType::Float32},
                                                                                      {64, VoxelType::Float64},
                                                                                      {256, VoxelType::Int8},
                                                                                      {512, VoxelType::UInt16},
                                                                                      {768, VoxelType::UInt32},
                                                                                      {1024, VoxelType::Int64},
                                                                                      {1280, VoxelType::UInt64}});
    const auto* const found =
        std::find_if(kTypes.begin(), kTypes.end(), [code](const auto& one) { return one.first == code; });
    return found == kTypes.end() ? std::nullopt : std::optional(found->second);
}

Status takeNiftiSizes(const NiftiHead& head, const std::string& file, VolumeLayout& layout)
{
    const auto axes = head.either<std::int16_t>(40, 16, 0);
    std::array<std::int64_t, 7> sizes{1, 1, 1, 1, 1, 1, 1};
    constexpr auto kMostCount = static_cast<std::int64_t>(kMostAlong);
    const Message place(PALPATE_TEXT("header: %1"), "dim");
    if (axes < 1 || axes > 7) {
        return fault(StatusCode::BadFormat, file, place, Message(PALPATE_TEXT("%1 axes"), axes),
                     Message(PALPATE_TEXT("%1 to %2"), 1, 7));
    }
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(axes); ++axis) {
        sizes[axis] = head.either<std::int16_t>(40, 16, axis + 1);
        if (sizes[axis] < 1 || sizes[axis] > kMostCount) {
            return fault(StatusCode::BadFormat, file, place,
                         Message(PALPATE_TEXT("%1 voxels along axis %2"), core::Count(sizes[axis]), axis + 1),
                         Message(PALPATE_TEXT("%1 to %2"), 1, core::Count(kMostAlong)));
        }
    }
    std::int64_t layers = 1;
    for (std::size_t axis = 3; axis < sizes.size(); ++axis) {
        layers = layers > kMostCount ? layers : layers * sizes[axis];
    }
    if (layers > kMostCount) {
        return fault(StatusCode::BadFormat, file, place,
                     Message(PALPATE_TEXT("more than %1 numbers per voxel"), core::Count(kMostAlong)),
                     Message(PALPATE_TEXT("%1 to %2"), 1, core::Count(kMostAlong)));
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        layout.size[axis] = static_cast<std::uint32_t>(sizes[axis]);
    }
    layout.layers = static_cast<std::uint32_t>(layers);
    return {};
}

/// @return millimetres per unit of length
double unitOf(const NiftiHead& head)
{
    const int code = (head.isSecond() ? head.at<std::int32_t>(500) : head.at<std::int8_t>(123)) & 7;
    return code == 1 ? 1000.0 : code == 3 ? 1e-3 : 1.0;
}

/// Places the voxels by the sform, else by the qform, else by the voxel size without a stated side.
void takePlace(const NiftiHead& head, VolumeLayout& layout)
{
    const auto code = [&head](std::size_t first, std::size_t second) {
        return head.isSecond() ? head.at<std::int32_t>(second) : std::int32_t{head.at<std::int16_t>(first)};
    };
    std::array<double, 4> size{}; // the first number is the direction of the slices
    for (std::size_t i = 0; i < size.size(); ++i) {
        size[i] = i == 0 ? head.either<float>(76, 104, i) : std::abs(double{head.either<float>(76, 104, i)});
    }
    if (code(254, 348) > 0) { // sform
        for (std::size_t row = 0; row < 3; ++row) {
            const auto r = static_cast<Eigen::Index>(row);
            for (std::size_t column = 0; column < 3; ++column) {
                layout.steps(r, static_cast<Eigen::Index>(column)) = head.either<float>(280, 400, 4 * row + column);
            }
            layout.origin[r] = head.either<float>(280, 400, 4 * row + 3);
        }
        layout.frame = core::FileFrame::Ras;
    } else if (code(252, 344) > 0) { // qform: a quaternion with b, c, d
        double b = head.either<float>(256, 352, 0), c = head.either<float>(256, 352, 1),
               d = head.either<float>(256, 352, 2);
        const double squares = b * b + c * c + d * d;
        const double a = squares < 1.0 ? std::sqrt(1.0 - squares) : 0.0;
        if (squares > 1.0) { // half a turn; as in nifti1_io.c, nifti_quatern_to_mat44
            const double length = std::sqrt(squares);
            b /= length;
            c /= length;
            d /= length;
        }
        Eigen::Matrix3d R;
        R << a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c), 2 * (b * c + a * d),
            a * a + c * c - b * b - d * d, 2 * (c * d - a * b), 2 * (b * d - a * c), 2 * (c * d + a * b),
            a * a + d * d - c * c - b * b;
        layout.steps = R * Vec3(size[1], size[2], size[0] < 0.0 ? -size[3] : size[3]).asDiagonal();
        for (std::size_t row = 0; row < 3; ++row) {
            layout.origin[static_cast<Eigen::Index>(row)] = head.either<float>(268, 376, row);
        }
        layout.frame = core::FileFrame::Ras;
    } else {
        layout.steps = Vec3(size[1], size[2], size[3]).asDiagonal();
    }
    const double unit_mm = unitOf(head);
    layout.steps *= unit_mm;
    layout.origin *= unit_mm;
}

/// @return the first extension that contains XML with labels; empty without one
std::string labelTableOf(const NiftiHead& head, std::size_t end)
{
    const std::string_view bytes = head.bytes();
    std::size_t at = head.size();
    if (at >= bytes.size() || bytes[at] == '\0') { // no extensions
        return {};
    }
    constexpr std::size_t kHead = 8; // size and code
    at += 4;
    while (at + kHead <= std::min(end, bytes.size())) {
        const auto size = head.at<std::int32_t>(at);
        if (size < std::int32_t{kHead} || static_cast<std::size_t>(size) > bytes.size() - at) {
            return {};
        }
        std::string text(bytes.substr(at + kHead, static_cast<std::size_t>(size) - kHead));
        if (text.find("<LabelTable>") != std::string::npos) {
            text.resize(std::min(text.size(), text.find('\0')));
            return text;
        }
        at += static_cast<std::size_t>(size);
    }
    return {};
}

} // namespace

bool looksLikeNifti(std::string_view bytes)
{
    const std::string head = beginningOf(bytes, kNifti1);
    const std::string_view view = head;
    return view.size() == kNifti1 && (view.substr(344, 3) == "n+1" || view.substr(344, 3) == "ni1" ||
                                      view.substr(4, 3) == "n+2" || view.substr(4, 3) == "ni2");
}

Result<VolumeLayout> niftiLayout(std::string_view bytes, const std::string& file)
{
    const NiftiHead first(beginningOf(bytes, kNifti2));
    const double stated =
        first.isSecond() ? static_cast<double>(first.at<std::int64_t>(168)) : double{first.at<float>(108)};
    const double whole = std::isfinite(stated) ? std::clamp(stated, double{kNifti2}, double{kMostNiftiHeader}) : 0.0;
    const NiftiHead head(beginningOf(bytes, std::max(kNifti2, static_cast<std::size_t>(whole))));
    const Message place(PALPATE_TEXT("header"));
    if (!head.isWhole()) {
        return fault(StatusCode::BadFormat, file, place, Message(PALPATE_TEXT("no complete header of a NIfTI file")),
                     Message(PALPATE_TEXT("348 or 540 bytes")));
    }
    const char form = head.bytes()[head.isSecond() ? 5 : 345];
    if (form != '+') {
        return fault(StatusCode::Unsupported, file, place, Message(PALPATE_TEXT("voxels in a separate .img file")),
                     Message(PALPATE_TEXT("a single file: save it as .nii or .nii.gz")));
    }
    VolumeLayout layout;
    layout.format = "NIfTI";
    layout.isBigEndian = head.isBigEndian();
    layout.isPacked = layout.isWholePacked = isPackedNifti(bytes);
    const auto code = head.at<std::int16_t>(head.isSecond() ? 12 : 70);
    const std::optional<VoxelType> type = niftiType(code);
    if (!type) {
        return fault(StatusCode::Unsupported, file, Message(PALPATE_TEXT("header: datatype")),
                     Message(PALPATE_TEXT("%1"), code), Message(PALPATE_TEXT("one number for each voxel, as 2 or 4")));
    }
    layout.type = *type;
    if (Status status = takeNiftiSizes(head, file, layout); !status.isOk()) {
        return status;
    }
    constexpr double kMostOffset = 1e9, kNoExtension = 4.0;
    const double offset = stated == 0.0 ? static_cast<double>(head.size()) + kNoExtension : stated; // as in nibabel
    if (!(offset >= static_cast<double>(head.size())) || offset > kMostOffset || offset != std::floor(offset)) {
        return fault(StatusCode::BadFormat, file, Message(PALPATE_TEXT("header: vox_offset")),
                     Message(PALPATE_TEXT("%1"), offset),
                     Message(PALPATE_TEXT("the byte of the first voxel, %1 or more"), head.size()));
    }
    layout.offset = static_cast<std::uint64_t>(offset);
    const double slope = head.either<float>(112, 176), intercept = head.either<float>(116, 184);
    if (slope != 0.0 && std::isfinite(slope) && std::isfinite(intercept)) {
        layout.slope = slope;
        layout.intercept = intercept;
    }
    constexpr std::int32_t kLabelIntent = 1002;
    const std::int32_t intent = head.isSecond() ? head.at<std::int32_t>(504) : std::int32_t{head.at<std::int16_t>(68)};
    // Displacement vectors (1006) are in the axes of the file, RAS. ITK, and with it ANTs and elastix, writes vectors
    // (1007) in its own axes, LPS. Source: ITK 5.4, Modules/IO/NIFTI, ConvertRASDisplacementVectors, ConvertRASVectors
    constexpr std::int32_t kDisplacementIntent = 1006, kVectorIntent = 1007;
    layout.isVector = intent == kDisplacementIntent || intent == kVectorIntent;
    if (intent == kVectorIntent) {
        layout.components.diagonal() = Vec3(-1, -1, 1);
    }
    layout.labelTable = labelTableOf(head, layout.offset);
    layout.isStatedLabels = intent == kLabelIntent || !layout.labelTable.empty();
    takePlace(head, layout);
    if (Status status = checkLayout(layout, file); !status.isOk()) {
        return status;
    }
    return layout;
}

} // namespace palpate::meshio::internal

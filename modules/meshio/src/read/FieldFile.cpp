// SPDX-License-Identifier: BSD-3-Clause
#include "read/FieldFile.h"

#include "guard/FileImage.h"
#include "read/ImportServer.h"
#include "text/Fault.h"
#include "voxels/VoxelReader.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace palpate::meshio::internal {

namespace {

using core::Message;
using core::Result;
using core::Status;
using core::StatusCode;
using core::Vec3;

Result<VolumeLayout> fieldLayout(std::string_view bytes, const std::string& file)
{
    Result<VolumeLayout> layout =
        volumeLayout(bytes, file, {PALPATE_TEXT("a displacement field as .nrrd, .mha or .nii")});
    if (!layout.isOk()) {
        return layout;
    }
    const VolumeLayout& found = layout.value();
    if (Status status = checkRightAngles(found, file); !status.isOk()) {
        return status;
    }
    if (found.layers != 3) {
        return fault(StatusCode::BadFormat, file, {}, {PALPATE_TEXT("%1 components per voxel"), Count(found.layers)},
                     {PALPATE_TEXT("a displacement field with 3")});
    }
    if (!found.isVector) {
        return fault(StatusCode::BadFormat, file, {PALPATE_TEXT("header")},
                     {PALPATE_TEXT("3 numbers per voxel that are not marked as a vector")},
                     {PALPATE_TEXT("a displacement field: the kind \"vector\" (NRRD), 3 channels (MetaImage) or the "
                                   "intent 1006 or 1007 (NIfTI)")});
    }
    if (!found.components.allFinite()) {
        return fault(StatusCode::BadFormat, file, {PALPATE_TEXT("header: %1"), "measurement frame"},
                     {PALPATE_TEXT("directions that are not finite numbers")},
                     {PALPATE_TEXT("three vectors of three numbers")});
    }
    if (found.format == "NIfTI" && found.frame == core::FileFrame::Untagged) {
        return fault(StatusCode::Unsupported, file, {PALPATE_TEXT("header")}, {PALPATE_TEXT("neither sform nor qform")},
                     {PALPATE_TEXT("the position of its voxels")});
    }
    return layout;
}

/// Receives the numbers of a field in file order.
class FieldCollector
{
  public:
    FieldCollector(const VolumeLayout& layout, const Eigen::Matrix3d& toLps, FieldGrid& grid)
        : m_toLps(toLps)
        , m_isInterleaved(layout.isInterleaved)
        , m_count(layout.voxels() / 3)
        , m_grid(grid)
    {
    }
    /// @return false at a number that is not finite
    bool take(std::span<const double> numbers)
    {
        m_grid.values.resize(m_count); // only now is it certain that the file has as many voxels as its header states
        for (const double number : numbers) {
            const std::size_t voxel = m_isInterleaved ? m_taken / 3 : m_taken % m_count;
            m_grid.values[voxel][m_isInterleaved ? m_taken % 3 : m_taken / m_count] = static_cast<float>(number);
            if (!std::isfinite(static_cast<float>(number))) {
                m_wrong = voxel;
                return false;
            }
            ++m_taken;
        }
        return true;
    }
    /// @return the first voxel with a number that is not finite
    [[nodiscard]] std::optional<std::size_t> wrong() const { return m_wrong; }
    /// Turns the vectors to LPS.
    void finish()
    {
        if (m_toLps.isIdentity(0.0)) {
            return;
        }
        for (std::array<float, 3>& value : m_grid.values) {
            const Vec3 u = m_toLps * Vec3(value[0], value[1], value[2]);
            value = {static_cast<float>(u.x()), static_cast<float>(u.y()), static_cast<float>(u.z())};
        }
    }

  private:
    Eigen::Matrix3d m_toLps;
    bool m_isInterleaved;
    std::size_t m_count; ///< voxels
    FieldGrid& m_grid;
    std::size_t m_taken = 0; ///< numbers
    std::optional<std::size_t> m_wrong;
};

} // namespace

bool FieldGrid::covers(const Vec3& p_W) const
{
    const Vec3 p = toVoxel * p_W;
    bool isInside = true;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double at = p[static_cast<Eigen::Index>(axis)];
        isInside = isInside && at >= -0.5 && at <= size[axis] - 0.5;
    }
    return isInside;
}

Vec3 FieldGrid::at(const Vec3& p_W) const
{
    const Vec3 p = toVoxel * p_W;
    std::array<std::size_t, 3> cell{}, next{};
    std::array<double, 3> share{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double found = p[static_cast<Eigen::Index>(axis)];
        const double at = found > 0.0 ? std::min(found, size[axis] - 1.0) : 0.0; // 0 for NaN
        cell[axis] = static_cast<std::size_t>(at);
        next[axis] = std::min(cell[axis] + 1, std::size_t{size[axis]} - 1);
        share[axis] = at - static_cast<double>(cell[axis]);
    }
    Vec3 sum = Vec3::Zero();
    for (std::size_t corner = 0; corner < 8; ++corner) {
        double weight = 1.0;
        std::size_t index = 0;
        for (std::size_t axis = 3; axis-- > 0;) {
            const bool isNext = (corner >> axis & 1U) != 0;
            weight *= isNext ? share[axis] : 1.0 - share[axis];
            index = index * size[axis] + (isNext ? next[axis] : cell[axis]);
        }
        const std::array<float, 3>& u = values[index];
        sum += weight * Vec3(u[0], u[1], u[2]);
    }
    return sum;
}

Result<FieldGrid> readFieldHere(const std::filesystem::path& path, core::FileFrame frame,
                                const std::function<bool(double)>& progress)
{
    const std::string file = path.filename().string();
    const Result<FileImage> image = FileImage::load(path);
    if (!image.isOk()) {
        return image.status();
    }
    const Result<VolumeLayout> found = fieldLayout(image.value().bytes(), file);
    if (!found.isOk()) {
        return found.status();
    }
    const VolumeLayout& layout = found.value();
    const Eigen::Matrix3d toLps = core::lpsRotation(layout.frame == core::FileFrame::Untagged ? frame : layout.frame);
    FieldGrid grid;
    grid.size = layout.size;
    Eigen::Affine3d toWorld = Eigen::Affine3d::Identity();
    toWorld.linear() = toLps * layout.steps;
    toWorld.translation() = toLps * layout.origin;
    grid.toVoxel = toWorld.inverse();
    if (!grid.toVoxel.matrix().allFinite()) {
        return fault(StatusCode::BadFormat, file, {PALPATE_TEXT("header")},
                     {PALPATE_TEXT("an origin that is too far away")}, {PALPATE_TEXT("positions in mm")});
    }
    FieldCollector collector(layout, toLps * layout.components, grid);
    const Status status = readVoxels(layout, image.value().bytes(), path, progress,
                                     [&](std::span<const double> numbers) { return collector.take(numbers); });
    if (!status.isOk()) {
        return status;
    }
    if (const std::optional<std::size_t> wrong = collector.wrong()) {
        const std::size_t row = grid.size[0], slice = row * grid.size[1];
        return fault(StatusCode::NonFinite, file,
                     {PALPATE_TEXT("voxel (%1, %2, %3)"), *wrong % row, *wrong % slice / row, *wrong / slice},
                     {PALPATE_TEXT("a number that is not finite")}, {PALPATE_TEXT("a displacement in mm")});
    }
    collector.finish();
    return grid;
}

Result<FieldGrid> readField(const std::filesystem::path& path, core::FileFrame frame)
{
    const std::string file = path.filename().string();
    try {
        if (!hasImportServer()) {
            return readFieldHere(path, frame, {});
        }
        const Result<OpenFile> open = openFile(path);
        return open.isOk() ? readFieldInChild(open.value(), path, frame) : open.status();
    } catch (const std::bad_alloc&) {
        return fault(StatusCode::OutOfRange, file, {}, {PALPATE_TEXT("not enough memory to read it")},
                     {PALPATE_TEXT("a smaller volume, or more free memory")});
    }
}

} // namespace palpate::meshio::internal

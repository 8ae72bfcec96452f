// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes.h"
#include "read/FieldFile.h"
#include "read/VolumeFile.h"

#include <sys/mman.h>
#include <unistd.h>

namespace palpate::fuzz {

namespace volumewire {

template<class Grid, class Write>
std::string handedOver(core::Result<Grid> outcome, const Write& write)
{
    const int descriptor = ::memfd_create("palpate-fuzz", MFD_CLOEXEC);
    require(descriptor >= 0 && write(descriptor, std::move(outcome)), "an outcome can be handed over");
    std::string bytes(static_cast<std::size_t>(::lseek(descriptor, 0, SEEK_END)), '\0');
    require(::pread(descriptor, bytes.data(), bytes.size(), 0) == static_cast<ssize_t>(bytes.size()),
            "a memory file can be read");
    ::close(descriptor);
    return bytes;
}

std::vector<std::string> seeds()
{
    meshio::internal::VoxelGrid grid;
    grid.size = {3, 2, 2};
    grid.values.assign(12, 1.5F);
    meshio::internal::FieldGrid field;
    field.size = {3, 2, 1};
    field.values.assign(6, {1.0F, 0.5F, 0.25F});
    const core::Result<meshio::internal::VoxelGrid> refusal =
        core::Status(core::StatusCode::BadFormat, PALPATE_TEXT("a.mha: found, expected"));
    return {handedOver(core::Result(grid), meshio::internal::writeVolume),
            handedOver(core::Result(field), meshio::internal::writeField),
            handedOver(refusal, meshio::internal::writeVolume)};
}

void tryInput(std::string_view bytes)
{
    tryHandedBack(bytes);
}

} // namespace volumewire

extern const Target kVolumeWire{"volumewire", 200, volumewire::seeds, volumewire::tryInput};

} // namespace palpate::fuzz

// SPDX-License-Identifier: BSD-3-Clause
#include "store/DiskReserve.h"

#include <palpate/core/Scratch.h>

#include <fcntl.h>
#include <unistd.h>

namespace palpate::session::internal {

DiskReserve::DiskReserve(const std::filesystem::path& beside, std::size_t bytes)
{
    if (const auto made = core::Scratch::create(beside, core::Scratch::Kind::File); made.isOk()) {
        m_file = ::fcntl(made.value()->descriptor(), F_DUPFD_CLOEXEC, 0); // the name is removed with the scratch file
    }
    if (m_file < 0) {
        return;
    }
    if (::posix_fallocate(m_file, 0, static_cast<off_t>(bytes)) != 0) {
        release();
    }
}

void DiskReserve::release() noexcept
{
    if (m_file >= 0) {
        (void)::close(m_file);
        m_file = -1;
    }
}

} // namespace palpate::session::internal

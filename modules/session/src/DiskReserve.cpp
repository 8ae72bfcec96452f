// SPDX-License-Identifier: BSD-3-Clause
#include "DiskReserve.h"

#include <string>

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

namespace palpate::session::internal {

DiskReserve::DiskReserve(const std::filesystem::path& beside, std::size_t bytes)
{
    std::string name = beside.string() + ".XXXXXX";
    m_file = ::mkostemp(name.data(), O_CLOEXEC);
    if (m_file < 0) {
        return;
    }
    (void)::unlink(name.c_str());
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

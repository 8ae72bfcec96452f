// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/AtomicFile.h"

#include <palpate/core/Types.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace palpate::session {

/// One row of the tick table. [mm, N, ns]
struct TickRow
{
    std::int64_t tick = 0;
    core::Vec3 p_WH = core::Vec3::Zero();
    core::Vec3 p_WG = core::Vec3::Zero();
    core::Vec3 f_W = core::Vec3::Zero(); ///< force on the hand
    unsigned constraints = 0;
    std::string_view structure; ///< name of the touched structure, empty in free space
    std::uint32_t solve_ns = 0;
};

/// Writes ticks as CSV with 17 significant digits, which give the same doubles back. Atomic as AtomicFile is.
class TickCsv
{
  public:
    static constexpr std::string_view kHeader = "tick,hip_x,hip_y,hip_z,god_x,god_y,god_z,force_x,force_y,force_z,"
                                                "constraints,structure,solve_ns";

    [[nodiscard]] static core::Result<TickCsv> create(const std::filesystem::path& path);
    void write(const TickRow& row);
    [[nodiscard]] core::Status finish();

  private:
    explicit TickCsv(AtomicFile file);

    AtomicFile m_file;
    std::string m_line;
};

} // namespace palpate::session

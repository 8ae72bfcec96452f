// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/session/AtomicFile.h"
#include "palpate/session/StructureNames.h"

#include <palpate/servo/TickRecord.h>

#include <filesystem>
#include <string>

namespace palpate::session {

/// Writes ticks as CSV, the columns of session/src/TickColumns.h that have a place in it, then `slides` and `layers`;
/// with 17 significant digits, which give the same doubles back. Atomic as AtomicFile is.
class TickCsv
{
  public:
    [[nodiscard]] static core::Result<TickCsv> create(const std::filesystem::path& path);
    void write(const servo::TickRecord& tick, const StructureNames& names);
    [[nodiscard]] core::Status finish();

  private:
    explicit TickCsv(AtomicFile file);

    AtomicFile m_file;
    std::string m_line;
};

} // namespace palpate::session

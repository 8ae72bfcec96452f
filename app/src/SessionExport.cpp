// SPDX-License-Identifier: BSD-3-Clause
#include "SessionExport.h"

#include <palpate/session/TickCsv.h>

#include <limits>

namespace palpate::app {

core::Status exportTicks(const session::RecordingReader& reader, const std::filesystem::path& path)
{
    auto csv = session::TickCsv::create(path);
    if (!csv.isOk()) {
        return csv.status();
    }
    const core::Status status =
        reader.forEach(std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max(),
                       [&](const servo::TickRecord& tick) {
                           if ((tick.flags & servo::kNoHand) == 0) {
                               const std::string name = reader.structureName(tick);
                               csv.value().write(tick, name);
                           }
                           return true;
                       });
    return status.isOk() ? csv.value().finish() : status;
}

std::filesystem::path surfaceFileOf(const std::filesystem::path& path)
{
    std::filesystem::path surface = path;
    return surface.replace_filename(path.stem().string() + "-surface" + path.extension().string());
}

} // namespace palpate::app

// SPDX-License-Identifier: BSD-3-Clause
#include "Settings.h"

#include <hid/NumberFields.h>
#include <hid/SettingsFile.h>

namespace palpate::spacemouse {

using core::Status;

core::Result<RateSettings> readSettings(const std::vector<std::filesystem::path>& folders)
{
    RateSettings settings;
    const hid::NumberField fields[] = {{"speed_mm_per_s", &settings.speed_mm_per_s, 0.0, 1000.0},
                                       {"turn_rad_per_s", &settings.turn_rad_per_s, 0.0, 20.0},
                                       {"dead_zone", &settings.deadZone, 0.0, 0.9},
                                       {"stale_after_s", &settings.staleAfter_s, 0.02, 1.0},
                                       {"reach_mm", &settings.reach_mm, 1.0, 10'000.0}};
    const auto file = hid::readSettingsFile(folders, "spacemouse.json", "{\"dead_zone\": 0.06}");
    if (!file.isOk()) {
        return file.status();
    }
    if (Status status = hid::readNumbers(file.value().object, fields, file.value().path.string()); !status.isOk()) {
        return status;
    }
    return settings;
}

} // namespace palpate::spacemouse

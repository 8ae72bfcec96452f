// SPDX-License-Identifier: BSD-3-Clause
#include "Settings.h"

#include <hid/NumberFields.h>

namespace palpate::forcedimension {

core::Result<Settings> readSettings(const std::vector<std::filesystem::path>& folders)
{
    Settings settings;
    const auto file =
        vendor::readVendorSettings(folders, {"forcedimension.json", "{\"serial\": 1234}", "libdhd.so.3"}, settings);
    if (!file.isOk()) {
        return file.status();
    }
    double serial = 0.0;
    const hid::NumberField fields[] = {{"serial", &serial, 0.0, 65535.0}};
    if (const core::Status status = hid::readNumbers(file.value().object, fields, file.value().path.string());
        !status.isOk()) {
        return status;
    }
    settings.serial = static_cast<int>(serial);
    return settings;
}

} // namespace palpate::forcedimension

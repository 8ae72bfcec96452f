// SPDX-License-Identifier: BSD-3-Clause
#include "Settings.h"

namespace palpate::openhaptics {

using core::Status;
using core::StatusCode;

core::Result<Settings> readSettings(const std::vector<std::filesystem::path>& folders)
{
    Settings settings;
    const auto file = vendor::readVendorSettings(
        folders, {"openhaptics.json", "{\"device\": \"Default Device\"}", "libHD.so.3.4"}, settings);
    if (!file.isOk()) {
        return file.status();
    }
    const QJsonValue device = file.value().object.value(QLatin1String("device"));
    if (!device.isUndefined() && !device.isString()) {
        return Status(StatusCode::BadFormat,
                      PALPATE_TEXT("%1: device: expected the name of a configuration, or a serial number, in quotes"),
                      file.value().path);
    }
    settings.device = device.toString().toStdString();
    return settings;
}

} // namespace palpate::openhaptics

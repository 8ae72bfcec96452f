// SPDX-License-Identifier: BSD-3-Clause
#include "Settings.h"

#include <hid/NumberFields.h>
#include <hid/SettingsFile.h>

#include <QJsonObject>

namespace palpate::forcedimension {

using core::Status;
using core::StatusCode;

core::Result<Settings> readSettings(const std::vector<std::filesystem::path>& folders)
{
    const auto file = hid::readSettingsFile(folders, "forcedimension.json", "{\"serial\": 1234}");
    if (!file.isOk()) {
        return file.status();
    }
    Settings settings;
    double serial = 0.0;
    const hid::NumberField fields[] = {{"serial", &serial, 0.0, 65535.0},
                                       {"max_force_N", &settings.maxForce_N, 0.1, 50.0},
                                       {"max_stiffness_N_per_mm", &settings.maxStiffness_N_per_mm, 0.01, 50.0},
                                       {"max_damping_Ns_per_mm", &settings.maxDamping_Ns_per_mm, 0.0, 1.0},
                                       {"workspace_radius_mm", &settings.workspaceRadius_mm, 1.0, 1000.0}};
    const QJsonObject& object = file.value().object;
    if (const Status status = hid::readNumbers(object, fields, file.value().path.string()); !status.isOk()) {
        return status;
    }
    settings.serial = static_cast<int>(serial);
    const QJsonValue library = object.value(QLatin1String("library"));
    if (!library.isUndefined() && !library.isString()) {
        return Status(StatusCode::BadFormat, PALPATE_TEXT("%1: library: expected the path of libdhd.so.3 in quotes"),
                      file.value().path);
    }
    settings.library = std::filesystem::path(library.toString().toStdU16String());
    return settings;
}

} // namespace palpate::forcedimension

// SPDX-License-Identifier: BSD-3-Clause
#include "Settings.h"

#include <hid/NumberFields.h>
#include <hid/SettingsFile.h>

#include <QJsonObject>

namespace palpate::haply {

using core::Status;
using core::StatusCode;

core::Result<Settings> readSettings(const std::vector<std::filesystem::path>& folders)
{
    const auto file = hid::readSettingsFile(folders, "haply.json", "{\"device_id\": \"049D\"}");
    if (!file.isOk()) {
        return file.status();
    }
    Settings settings;
    double port = settings.port;
    double httpPort = settings.httpPort;
    const hid::NumberField fields[] = {{"port", &port, 1.0, 65535.0},
                                       {"http_port", &httpPort, 1.0, 65535.0},
                                       {"max_force_N", &settings.maxForce_N, 0.1, 50.0},
                                       {"max_stiffness_N_per_mm", &settings.maxStiffness_N_per_mm, 0.01, 50.0},
                                       {"max_damping_Ns_per_mm", &settings.maxDamping_Ns_per_mm, 0.0, 1.0},
                                       {"workspace_radius_mm", &settings.workspaceRadius_mm, 1.0, 1000.0}};
    const QJsonObject& object = file.value().object;
    if (const Status status = hid::readNumbers(object, fields, file.value().path.string()); !status.isOk()) {
        return status;
    }
    settings.port = static_cast<std::uint16_t>(port);
    settings.httpPort = static_cast<std::uint16_t>(httpPort);
    settings.hasFile = !file.value().path.empty();
    const struct
    {
        const char* name;
        std::string* value;
    } ids[] = {{"device_id", &settings.deviceId}, {"grip_id", &settings.gripId}};
    for (const auto& [name, value] : ids) {
        const QJsonValue stated = object.value(QLatin1String(name));
        if (!stated.isUndefined() && !stated.isString()) {
            return Status(StatusCode::BadFormat, PALPATE_TEXT("%1: %2: expected an identifier in quotes, as \"049D\""),
                          file.value().path, name);
        }
        *value = stated.toString().toStdString();
    }
    return settings;
}

} // namespace palpate::haply

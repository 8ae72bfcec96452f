// SPDX-License-Identifier: BSD-3-Clause
#include "VendorSettings.h"

#include <hid/NumberFields.h>

namespace palpate::vendor {

using core::Status;
using core::StatusCode;

core::Result<hid::SettingsFile> readVendorSettings(const std::vector<std::filesystem::path>& folders,
                                                   const SettingsKind& kind, VendorSettings& settings)
{
    auto file = hid::readSettingsFile(folders, kind.file, kind.example);
    if (!file.isOk()) {
        return file;
    }
    const hid::NumberField fields[] = {{"max_force_N", &settings.maxForce_N, 0.1, 50.0},
                                       {"max_stiffness_N_per_mm", &settings.maxStiffness_N_per_mm, 0.01, 50.0},
                                       {"max_damping_Ns_per_mm", &settings.maxDamping_Ns_per_mm, 0.0, 1.0},
                                       {"workspace_radius_mm", &settings.workspaceRadius_mm, 1.0, 1000.0}};
    if (Status status = hid::readNumbers(file.value().object, fields, file.value().path.string()); !status.isOk()) {
        return status;
    }
    const QJsonValue library = file.value().object.value(QLatin1String("library"));
    if (!library.isUndefined() && !library.isString()) {
        return Status(StatusCode::BadFormat, PALPATE_TEXT("%1: library: expected the path of %2 in quotes"),
                      file.value().path, kind.library);
    }
    settings.library = std::filesystem::path(library.toString().toStdU16String());
    return file;
}

} // namespace palpate::vendor

// SPDX-License-Identifier: BSD-3-Clause
#include "Settings.h"

#include <hid/NumberFields.h>

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>

#include <system_error>

namespace palpate::spacemouse {

using core::Status;
using core::StatusCode;

core::Result<RateSettings> readSettings(const std::vector<std::filesystem::path>& folders)
{
    RateSettings settings;
    const hid::NumberField fields[] = {{"speed_mm_per_s", &settings.speed_mm_per_s, 0.0, 1000.0},
                                       {"turn_rad_per_s", &settings.turn_rad_per_s, 0.0, 20.0},
                                       {"dead_zone", &settings.deadZone, 0.0, 0.9},
                                       {"stale_after_s", &settings.staleAfter_s, 0.02, 1.0},
                                       {"reach_mm", &settings.reach_mm, 1.0, 10'000.0}};
    for (const std::filesystem::path& folder : folders) {
        const std::filesystem::path path = folder / "spacemouse.json";
        std::error_code error;
        if (!std::filesystem::exists(path, error)) {
            continue;
        }
        constexpr qint64 kLargest = 64 * 1024;
        QFile file(QString::fromStdU16String(path.u16string()));
        if (!file.open(QIODevice::ReadOnly)) {
            return Status(StatusCode::Unreadable, PALPATE_TEXT("%1: %2"), path, file.errorString().toStdString());
        }
        const QJsonDocument document = QJsonDocument::fromJson(file.read(kLargest));
        if (!document.isObject()) {
            return Status(StatusCode::BadFormat, PALPATE_TEXT("%1: expected an object, as {\"dead_zone\": 0.06}"),
                          path);
        }
        if (Status status = hid::readNumbers(document.object(), fields, path.string()); !status.isOk()) {
            return status;
        }
        break;
    }
    return settings;
}

} // namespace palpate::spacemouse

// SPDX-License-Identifier: BSD-3-Clause
#include "SettingsFile.h"

#include <QFile>
#include <QJsonDocument>

#include <system_error>

namespace palpate::hid {

using core::Status;
using core::StatusCode;

core::Result<SettingsFile> readSettingsFile(const std::vector<std::filesystem::path>& folders, const std::string& name,
                                            const char* example)
{
    for (const std::filesystem::path& folder : folders) {
        const std::filesystem::path path = folder / name;
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
            return Status(StatusCode::BadFormat, PALPATE_TEXT("%1: expected an object, as %2"), path, example);
        }
        return SettingsFile{path, document.object()};
    }
    return SettingsFile{};
}

} // namespace palpate::hid

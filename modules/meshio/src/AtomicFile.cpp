// SPDX-License-Identifier: BSD-3-Clause
#include "AtomicFile.h"

#include "Fault.h"

#include <QSaveFile>

namespace palpate::meshio::internal {

core::Status writeAtomically(const std::filesystem::path& path, std::string_view bytes)
{
    const QString name = QString::fromStdString(path.string());
    const auto failed = [&](std::string_view why) {
        const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
        std::error_code ignored;
        return fault(
            std::filesystem::exists(folder, ignored) ? core::StatusCode::Unreadable : core::StatusCode::NotFound,
            path.filename().string(), "", "cannot be written: " + std::string(why) + "; choose another folder", "");
    };
    if (name.toStdString() != path.string()) { // Qt would write to another one
        return failed("its name is not UTF-8");
    }
    std::error_code unknown;
    if (const auto kind = std::filesystem::status(path, unknown);
        std::filesystem::exists(kind) && !std::filesystem::is_regular_file(kind)) {
        return failed("not a file"); // it would be replaced
    }
    QSaveFile file(name);
    if (!file.open(QIODevice::WriteOnly) ||
        file.write(bytes.data(), static_cast<qint64>(bytes.size())) != static_cast<qint64>(bytes.size()) ||
        !file.commit()) {
        return failed(file.errorString().toStdString());
    }
    return {};
}

} // namespace palpate::meshio::internal

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDateTime>
#include <QDir>
#include <QStandardPaths>
#include <QString>

#include <filesystem>

[[nodiscard]] inline std::filesystem::path toPath(const QString& text)
{
    return std::filesystem::path(text.toStdU16String());
}

[[nodiscard]] inline QString toText(const std::filesystem::path& path)
{
    return QString::fromStdU16String(path.u16string());
}

/// Existing folder to propose for files of the user: the documents, or home.
[[nodiscard]] inline QString documentsFolder()
{
    const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QDir(documents).exists() ? documents : QDir::homePath();
}

/// Path of a new file such as "2026-11-21 05.12.33" in a folder.
[[nodiscard]] inline std::filesystem::path newFileIn(const QString& folder, const QString& ending)
{
    return toPath(folder + QLatin1Char('/') +
                  QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd hh.mm.ss")) + ending);
}

/// Path of a new file such as "2026-11-21 05.12.33" in the user's folder of this kind.
[[nodiscard]] inline std::filesystem::path newFile(QStandardPaths::StandardLocation kind, const QString& ending)
{
    const QString folder = QStandardPaths::writableLocation(kind) + QStringLiteral("/Palpate");
    QDir().mkpath(folder);
    return newFileIn(folder, ending);
}

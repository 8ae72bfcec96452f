// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/AtomicFile.h"

#include <QFile>
#include <QSaveFile>

namespace palpate::session {

namespace {

core::Status cannotWrite(const std::filesystem::path& path, const std::string& why)
{
    return {core::StatusCode::Unreadable, path.string() + ": cannot be written: " + why};
}

} // namespace

AtomicFile::AtomicFile(std::filesystem::path path, std::unique_ptr<QFileDevice> file)
    : m_path(std::move(path))
    , m_file(std::move(file))
{
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept = default;
AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept = default;
AtomicFile::~AtomicFile() = default;

core::Result<AtomicFile> AtomicFile::create(const std::filesystem::path& path)
{
    const QString name = QString::fromStdString(path.string());
    if (name.toStdString() != path.string()) { // Qt would write to another one
        return cannotWrite(path, "its name is not UTF-8");
    }
    std::error_code ignored;
    const auto kind = std::filesystem::status(path, ignored).type();
    const bool isDevice = kind == std::filesystem::file_type::character || kind == std::filesystem::file_type::fifo ||
                          kind == std::filesystem::file_type::socket || kind == std::filesystem::file_type::block;
    std::unique_ptr<QFileDevice> file;
    if (isDevice) { // would be replaced
        file = std::make_unique<QFile>(name);
    } else {
        file = std::make_unique<QSaveFile>(name);
    }
    if (!file->open(QIODevice::WriteOnly)) {
        return cannotWrite(path, file->errorString().toStdString());
    }
    return AtomicFile(path, std::move(file));
}

void AtomicFile::write(std::string_view text)
{
    m_file->write(text.data(), static_cast<qint64>(text.size()));
}

core::Status AtomicFile::finish()
{
    auto* const saved = qobject_cast<QSaveFile*>(m_file.get());
    bool isDone = m_file->flush() && m_file->error() == QFileDevice::NoError;
    isDone = (saved == nullptr || saved->commit()) && isDone;
    return isDone ? core::Status() : cannotWrite(m_path, m_file->errorString().toStdString());
}

core::Status writeAtomically(const std::filesystem::path& path, std::string_view text)
{
    auto file = AtomicFile::create(path);
    if (!file.isOk()) {
        return file.status();
    }
    file.value().write(text);
    return file.value().finish();
}

} // namespace palpate::session

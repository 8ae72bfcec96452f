// SPDX-License-Identifier: BSD-3-Clause
#include "touch/RecordingTrace.h"

#include "shared/Paths.h"

#include <palpate/core/AtomicFile.h>

#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <QUuid>

#include <system_error>

namespace palpate::app {

namespace {

QString noteFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/recordings");
}

std::unique_ptr<QLockFile> lockFor(const std::filesystem::path& note)
{
    auto lock = std::make_unique<QLockFile>(toText(note) + QStringLiteral(".lock"));
    lock->setStaleLockTime(0);
    return lock;
}

/// Returns the absolute path in a note.
std::filesystem::path recordingIn(const std::filesystem::path& note)
{
    constexpr qint64 kLongest = 1 << 16;
    QFile file(toText(note));
    return file.open(QIODevice::ReadOnly) ? toPath(QString::fromUtf8(file.read(kLongest))) : std::filesystem::path();
}

} // namespace

void RecordingTrace::begin(const std::filesystem::path& recording)
{
    end();
    QDir().mkpath(noteFolder());
    const std::filesystem::path note = toPath(
        noteFolder() + QLatin1Char('/') + QUuid::createUuid().toString(QUuid::WithoutBraces) + QStringLiteral(".txt"));
    std::unique_ptr<QLockFile> lock = lockFor(note);
    std::error_code error;
    const std::string path = toText(std::filesystem::absolute(recording, error)).toStdString();
    if (lock->tryLock(0) && core::writeAtomically(note, path).isOk()) {
        m_note = note;
        m_lock = std::move(lock);
    }
}

void RecordingTrace::end()
{
    if (!m_note.empty()) {
        std::error_code ignored;
        std::filesystem::remove(m_note, ignored);
        m_note.clear();
        m_lock.reset();
    }
}

std::optional<RecordingTrace::Left> RecordingTrace::findLeft()
{
    const QDir folder(noteFolder());
    for (const QString& name : folder.entryList({QStringLiteral("*.txt")}, QDir::Files, QDir::Time)) {
        const std::filesystem::path note = toPath(folder.filePath(name));
        const std::unique_ptr<QLockFile> lock = lockFor(note);
        if (!lock->tryLock(0)) {
            continue; // still being recorded by another window
        }
        const Left left{note, recordingIn(note)};
        std::error_code error;
        if (std::filesystem::is_regular_file(left.recording, error)) {
            return left;
        }
        discard(left);
    }
    return std::nullopt;
}

void RecordingTrace::discard(const Left& left)
{
    std::error_code ignored;
    std::filesystem::remove(left.note, ignored);
}

} // namespace palpate::app

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/SharedCopy.h"

#include "palpate/session/RecordingReader.h"
#include "palpate/session/RecordingWriter.h"

#include <QCryptographicHash>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>

#include <algorithm>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <system_error>
#include <utility>

namespace palpate::session {

using core::Status;
using core::StatusCode;

namespace {

namespace fs = std::filesystem;

std::string fileNameOf(const std::string& path)
{
    return fs::path(path).filename().string();
}

/// Removes the folders of absolute paths from a text. A slash within a word, such as "N/mm", does not begin a path.
QString withoutFolders(QString text)
{
    static const QRegularExpression kFolders(QStringLiteral(R"((?<![\w.)])/(?:[^\s/][^/\n]*/)+)"),
                                             QRegularExpression::UseUnicodePropertiesOption);
    return text.remove(kFolders);
}

QJsonValue withoutFolders(const QJsonValue& value)
{
    if (value.isString()) {
        return withoutFolders(value.toString());
    }
    if (value.isArray()) {
        QJsonArray out;
        for (const QJsonValue& one : value.toArray()) {
            out.append(withoutFolders(one));
        }
        return out;
    }
    if (value.isObject()) {
        QJsonObject out = value.toObject();
        for (auto one = out.begin(); one != out.end(); ++one) {
            *one = withoutFolders(QJsonValue(*one));
        }
        return out;
    }
    return value;
}

/// Returns an event without the folders of paths. An event without paths keeps its bytes.
RecordingEvent withoutFolders(RecordingEvent event)
{
    const QJsonObject before = QJsonDocument::fromJson(QByteArray::fromStdString(event.json)).object();
    const QJsonObject after = withoutFolders(QJsonValue(before)).toObject();
    if (after != before) {
        event.json = QJsonDocument(after).toJson(QJsonDocument::Compact).toStdString();
    }
    return event;
}

core::Result<std::string> hashOfFile(const fs::path& path)
{
    QFile file(QString::fromStdString(path.string()));
    QCryptographicHash hash(QCryptographicHash::Sha256);
    if (!file.open(QIODevice::ReadOnly) || !hash.addData(&file)) {
        return Status(StatusCode::Unreadable, PALPATE_TEXT("%1: cannot be read: %2"), path,
                      file.errorString().toStdString());
    }
    return hash.result().toHex().toStdString();
}

Status addScenes(const RecordingReader& reader, RecordingWriter& writer)
{
    std::set<std::string> embedded; // a surface is read once, not for each scene
    for (SceneRecord scene : reader.scenes()) {
        for (StructureRecord& structure : scene.structures) {
            structure.source.mesh = fileNameOf(structure.source.mesh);
            if (!embedded.insert(structure.source.sha256).second) {
                continue;
            }
            auto surface = reader.embedded(structure.source.sha256);
            if (surface.isOk()) {
                structure.source.embed = std::make_shared<const geometry::RepairedMesh>(std::move(surface).value());
            } else if (surface.status().code() != StatusCode::NotFound) {
                return surface.status();
            }
        }
        if (Status status = writer.addScene(scene); !status.isOk()) {
            return status;
        }
        if (Status status = writer.commit(); !status.isOk()) { // releases the surfaces
            return status;
        }
    }
    return {};
}

Status addEvents(const RecordingReader& reader, RecordingWriter& writer)
{
    for (const RecordingEvent& event : reader.events()) {
        (void)writer.addEvent(withoutFolders(event));
    }
    auto hash = hashOfFile(reader.path());
    if (!hash.isOk()) {
        return hash.status();
    }
    const QJsonObject json{{"from_sha256", QString::fromStdString(hash.value())},
                           {"palpate", QString::fromStdString(palpateVersion())}};
    return writer.addEvent({std::max<std::int64_t>(reader.extent().lastTick, 0), "shared",
                            QJsonDocument(json).toJson(QJsonDocument::Compact).toStdString()});
}

Status addTicks(const RecordingReader& reader, RecordingWriter& writer, std::int64_t& ticks)
{
    Status written;
    const Status read = reader.forEach(std::numeric_limits<std::int64_t>::min(),
                                       std::numeric_limits<std::int64_t>::max(), [&](const servo::TickRecord& tick) {
                                           written = writer.append(tick);
                                           ++ticks;
                                           return written.isOk();
                                       });
    return read.isOk() ? written : read;
}

} // namespace

core::Result<std::int64_t> shareRecording(const fs::path& from, const fs::path& to)
{
    const auto opened = RecordingReader::open(from);
    if (!opened.isOk()) {
        return opened.status();
    }
    const RecordingReader& reader = *opened.value();
    std::error_code error;
    if (fs::equivalent(from, to, error)) {
        return Status(StatusCode::BadCommandLine, PALPATE_TEXT("%1: is the recording itself, expected another name"),
                      to);
    }
    if (const auto kind = fs::status(to, error); fs::exists(kind) && !fs::is_regular_file(kind)) {
        return Status(StatusCode::Unreadable, PALPATE_TEXT("%1: cannot be written: not a file"), to);
    }
    if (const Status status = reader.verify(); !status.isOk()) {
        return Status(status.code(),
                      PALPATE_TEXT("%1; copy the readable parts with `palpate session recover` first, then share the "
                                   "copy"),
                      status.text());
    }
    RecordingInfo info = reader.info();
    info.scene = fileNameOf(info.scene);
    info.sceneBeside.clear();
    auto made = RecordingWriter::create(to, info, RecordingWriter::Sync::AtEnd, RecordingWriter::Events::AsGiven,
                                        core::ExistingFile::Replace);
    if (!made.isOk()) {
        return made.status();
    }
    RecordingWriter& writer = *made.value();
    std::int64_t ticks = 0;
    Status status = addScenes(reader, writer);
    if (status.isOk()) {
        status = addEvents(reader, writer);
    }
    if (status.isOk()) {
        status = addTicks(reader, writer, ticks);
    }
    if (status.isOk()) {
        status = writer.finish(reader.extent().isComplete ? RecordingWriter::Ending::Complete
                                                          : RecordingWriter::Ending::CutOff);
    }
    if (!status.isOk()) {
        writer.discard();
        return status;
    }
    return ticks;
}

} // namespace palpate::session

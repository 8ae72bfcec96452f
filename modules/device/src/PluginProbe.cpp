// SPDX-License-Identifier: BSD-3-Clause
#include "PluginProbe.h"

#include <QObject>
#include <QPluginLoader>
#include <QProcess>
#include <QRandomGenerator>

#include <cstdio>
#include <exception>
#include <iostream>
#include <string>
#include <system_error>

namespace palpate::device {

using core::Status;
using core::StatusCode;

core::Result<DevicePlugin*> loadPlugin(const std::filesystem::path& file)
{
    std::error_code error; // absolute, because the loader searches Qt's own folders for relative names
    QPluginLoader loader(QString::fromStdU16String(std::filesystem::absolute(file, error).u16string()));
    QObject* root = loader.instance();
    if (root == nullptr) {
        return Status(StatusCode::Unreadable, PALPATE_TEXT("%1: %2"), file, loader.errorString().toStdString());
    }
    auto* plugin = qobject_cast<DevicePlugin*>(root);
    if (plugin == nullptr) {
        return Status(StatusCode::BadFormat, PALPATE_TEXT("%1: its root object is not a device plugin"), file);
    }
    return plugin;
}

Status runProbe(const std::vector<std::string>& command, const std::filesystem::path& file, int timeout_ms)
{
    QStringList arguments;
    for (std::size_t i = 1; i < command.size(); ++i) {
        arguments << QString::fromStdString(command[i]);
    }
    arguments << QString::fromStdU16String(file.u16string());
    const QByteArray word = QByteArray::number(QRandomGenerator::system()->generate64(), 16);
    QProcess process;
    process.start(QString::fromStdString(command.front()), arguments, QIODevice::ReadWrite);
    process.write(word + '\n');
    process.closeWriteChannel();
    if (!process.waitForFinished(timeout_ms)) {
        const bool hasStarted = process.error() == QProcess::Timedout;
        process.kill();
        process.waitForFinished(1000);
        return hasStarted
                   ? Status(StatusCode::Unsupported, PALPATE_TEXT("%1: skipped, it hung when it was started"), file)
                   : Status(StatusCode::Internal, PALPATE_TEXT("%1: could not be tried: %2: %3"), file, command.front(),
                            process.errorString().toStdString());
    }
    if (process.exitStatus() == QProcess::CrashExit) {
        return {StatusCode::Unsupported, PALPATE_TEXT("%1: skipped, it crashed when it was started (signal %2)"), file,
                process.exitCode()};
    }
    if (process.exitCode() != 0 || !process.readAllStandardOutput().endsWith(word + '\n')) {
        const std::string said = process.readAllStandardError().trimmed().toStdString();
        return {StatusCode::Unsupported,
                said.empty()
                    ? core::Message(PALPATE_TEXT("%1: skipped, it ended the process when it was started"), file)
                    : core::Message::untranslated(said)};
    }
    return {};
}

Status probePlugin(const std::filesystem::path& file)
{
    std::mutex bus;
    const PluginServices services{bus, deviceSettingsFolders()};
    try {
        const auto plugin = loadPlugin(file);
        if (!plugin.isOk()) {
            return plugin.status();
        }
        (void)plugin.value()->find(services);
    } catch (const std::exception& error) {
        return {StatusCode::Unsupported, PALPATE_TEXT("%1: skipped, it failed when it was started: %2"), file,
                error.what()};
    } catch (...) {
        return {StatusCode::Unsupported, PALPATE_TEXT("%1: skipped, it failed when it was started"), file};
    }
    return {};
}

Status answerProbe(const std::filesystem::path& file)
{
    std::string word;
    std::getline(std::cin, word);
    Status status = probePlugin(file);
    if (status.isOk()) {
        std::printf("%s\n", word.c_str());
        std::fflush(stdout);
    }
    return status;
}

} // namespace palpate::device

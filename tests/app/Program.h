// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QByteArray>
#include <QProcess>
#include <QProcessEnvironment>
#include <QStringList>

#include <functional>

namespace palpate::test {

/// What a run of `palpate` left.
struct Outcome
{
    int exitCode = -1; ///< -1 after a crash, a signal or two minutes
    QByteArray out, error;
};

/// Starts `palpate` without a display, which no command of these tests needs.
/// @param folder   working directory of the program
/// @param prepare  called in the child process before the program
inline void startProgram(QProcess& process, const QString& folder, const QStringList& arguments,
                         const std::function<void()>& prepare = {})
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* display : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
        environment.remove(display);
    }
    process.setProcessEnvironment(environment);
    process.setWorkingDirectory(folder);
    if (prepare) {
        process.setChildProcessModifier(prepare);
    }
    process.start(PALPATE_EXECUTABLE, arguments);
}

/// Runs `palpate` to its end; parameters as for `startProgram`.
inline Outcome runProgram(const QString& folder, const QStringList& arguments,
                          const std::function<void()>& prepare = {})
{
    QProcess process;
    startProgram(process, folder, arguments, prepare);
    const bool isDone = process.waitForFinished(120000);
    Outcome outcome;
    outcome.exitCode = isDone && process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1;
    outcome.out = process.readAllStandardOutput();
    outcome.error = process.readAllStandardError();
    return outcome;
}

} // namespace palpate::test

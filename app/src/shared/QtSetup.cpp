// SPDX-License-Identifier: BSD-3-Clause
#include "shared/QtSetup.h"

#include <QFile>
#include <QFileInfo>
#include <QGuiApplication>

#include <clocale>
#include <string_view>

#include <langinfo.h>
#include <unistd.h>

namespace palpate::app {

RuntimeFolder::RuntimeFolder()
{
    const QFileInfo given(qEnvironmentVariable("XDG_RUNTIME_DIR"));
    constexpr auto kOfOthers = QFileDevice::ReadGroup | QFileDevice::WriteGroup | QFileDevice::ExeGroup |
                               QFileDevice::ReadOther | QFileDevice::WriteOther | QFileDevice::ExeOther;
    if (given.isDir() && given.ownerId() == ::getuid() && (given.permissions() & kOfOthers) == 0) {
        return;
    }
    m_own = std::make_unique<QTemporaryDir>(); // accessible to this user only
    if (m_own->isValid()) {
        qputenv("XDG_RUNTIME_DIR", QFile::encodeName(m_own->path()));
    }
}

void useUtf8()
{
    if (std::setlocale(LC_CTYPE, "") != nullptr && std::string_view(::nl_langinfo(CODESET)) == "UTF-8") {
        return;
    }
    if (!qEnvironmentVariableIsEmpty("LC_ALL")) { // LC_ALL would override LC_CTYPE
        qputenv("LANG", qgetenv("LC_ALL"));
        qunsetenv("LC_ALL");
    }
    qputenv("LC_CTYPE", "C.UTF-8");
}

void identifyProgram()
{
    QGuiApplication::setApplicationDisplayName(QStringLiteral("Palpate"));
    QGuiApplication::setDesktopFileName(QStringLiteral("palpate"));
    QGuiApplication::setWindowIcon(programIcon());
}

QIcon programIcon()
{
    QIcon icon(QStringLiteral(":/icons/palpate-48.png"));
    icon.addFile(QStringLiteral(":/icons/palpate-256.png"));
    return icon;
}

} // namespace palpate::app

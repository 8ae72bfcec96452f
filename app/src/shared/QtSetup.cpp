// SPDX-License-Identifier: BSD-3-Clause
#include "shared/QtSetup.h"

#include <QFile>
#include <QFileInfo>
#include <QFont>
#include <QFontInfo>
#include <QGuiApplication>

#include <fontconfig/fontconfig.h>

#include <clocale>
#include <memory>
#include <string>
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

std::string boldFontFile(const QFont& font)
{
    const auto drop = [](FcPattern* pattern) { FcPatternDestroy(pattern); };
    const std::unique_ptr<FcPattern, decltype(drop)> wanted(FcPatternCreate(), drop);
    const std::string family = QFontInfo(font).family().toStdString();
    FcPatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family.c_str()));
    FcPatternAddInteger(wanted.get(), FC_WEIGHT, FC_WEIGHT_BOLD);
    FcConfigSubstitute(nullptr, wanted.get(), FcMatchPattern);
    FcDefaultSubstitute(wanted.get());
    FcResult result = FcResultMatch;
    const std::unique_ptr<FcPattern, decltype(drop)> found(FcFontMatch(nullptr, wanted.get(), &result), drop);
    FcChar8* file = nullptr;
    int index = 0;
    FcBool isScalable = FcFalse, isVariable = FcFalse;
    // VTK opens the first font of a file, in its usual weight.
    const bool isUsable = found != nullptr && FcPatternGetString(found.get(), FC_FILE, 0, &file) == FcResultMatch &&
                          FcPatternGetInteger(found.get(), FC_INDEX, 0, &index) == FcResultMatch && index == 0 &&
                          FcPatternGetBool(found.get(), FC_SCALABLE, 0, &isScalable) == FcResultMatch && isScalable &&
                          (FcPatternGetBool(found.get(), FC_VARIABLE, 0, &isVariable) != FcResultMatch || !isVariable);
    return isUsable ? std::string(reinterpret_cast<const char*>(file)) : std::string();
}

} // namespace palpate::app

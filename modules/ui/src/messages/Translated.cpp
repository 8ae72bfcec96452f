// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/Translated.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>

namespace palpate::ui {

namespace {

constexpr const char* kMessageContext = "palpate::Message"; // set by resources/translations/update.sh
constexpr core::MessageText<core::Message> kInEnglish(PALPATE_TEXT("%1 (in English)"));

/// Reformats a number of an English message for the window's locale.
std::string localized(const std::string& english)
{
    std::string out;
    for (const char digit : english) {
        out += digit == ','   ? QLocale().groupSeparator().toStdString()
               : digit == '.' ? QLocale().decimalPoint().toStdString()
                              : std::string(1, digit);
    }
    return out;
}

std::string translatedBytes(const core::Message& message)
{
    std::vector<std::string> parts;
    for (const core::MessageArgument& argument : message.arguments()) {
        switch (argument.kind) {
        case core::MessageArgument::Kind::Name:
            parts.push_back(argument.english);
            break;
        case core::MessageArgument::Kind::Number:
            parts.push_back(localized(argument.english));
            break;
        case core::MessageArgument::Kind::Message:
            parts.push_back(translatedBytes(*argument.message));
            break;
        }
    }
    return core::filled(QCoreApplication::translate(kMessageContext, message.text().c_str()).toStdString(), parts);
}

} // namespace

QString translated(const core::Message& message)
{
    const char* const marked = kInEnglish.text().data();
    const QString mark = QCoreApplication::translate(kMessageContext, marked);
    if (message.isEmpty() || mark == QLatin1String(marked)) {
        return QString::fromStdString(message.english()); // English window
    }
    const QString text = QString::fromStdString(translatedBytes(message));
    return message.isTranslatable() ? text : QString(mark).replace(QStringLiteral("%1"), text);
}

} // namespace palpate::ui

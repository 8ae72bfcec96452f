// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/Translated.h"

#include <palpate/core/Numbers.h>

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

std::string translatedBytes(const core::Message& message);

std::string translatedBytes(const core::MessageArgument& argument)
{
    switch (argument.kind) {
    case core::MessageArgument::Kind::Name:
        return argument.english;
    case core::MessageArgument::Kind::Number:
        return localized(argument.english);
    case core::MessageArgument::Kind::Message:
        break;
    }
    return translatedBytes(*argument.message);
}

std::string translatedBytes(const core::Message& message)
{
    std::vector<std::string> parts;
    for (const core::MessageArgument& argument : message.arguments()) {
        parts.push_back(translatedBytes(argument));
    }
    return core::filled(QCoreApplication::translate(kMessageContext, message.text().c_str()).toStdString(), parts);
}

/// Text that marks an English sentence in another language; empty in an English window.
QString englishMark()
{
    const char* const marked = kInEnglish.text().data();
    const QString mark = QCoreApplication::translate(kMessageContext, marked);
    return mark == QLatin1String(marked) ? QString() : mark;
}

} // namespace

QString translated(const core::Message& message)
{
    const QString mark = englishMark();
    if (message.isEmpty() || mark.isEmpty()) {
        return QString::fromStdString(message.english()); // English window
    }
    const QString text = QString::fromStdString(translatedBytes(message));
    return message.isTranslatable() ? text : QString(mark).replace(QStringLiteral("%1"), text);
}

QString translated(const core::MessageArgument& argument)
{
    if (argument.kind == core::MessageArgument::Kind::Message) {
        return translated(*argument.message);
    }
    return QString::fromStdString(englishMark().isEmpty() ? argument.english : translatedBytes(argument));
}

QString numberText(double value, int digits)
{
    return QString::fromStdString(localized(core::shortNumber(value, digits)));
}

} // namespace palpate::ui

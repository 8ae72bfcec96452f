// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QList>
#include <QObject>
#include <QString>

#include <functional>

class QMenu;

namespace palpate::app {

/// A language that the window can speak.
struct Language
{
    QString code;   ///< as locales have it: "en", "de", "fr"
    QString native; ///< its name in itself
};

/// English, and what resources/translations has a catalogue for.
[[nodiscard]] const QList<Language>& languages();

/// Lets all windows made from now on speak what was chosen (settings: `language`), else the system's language where it
/// is among `languages()`, else English; numbers are shown with that language's decimal sign. Call once, before the
/// first window.
void speakChosenLanguage();

/// A menu that chooses the language. Windows that are open keep theirs: `said` is told the line to show.
void addLanguageMenu(QMenu& menu, QObject& context, const std::function<void(const QString&)>& said);

} // namespace palpate::app

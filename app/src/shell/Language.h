// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QList>
#include <QObject>
#include <QString>

#include <functional>

class QMenu;

namespace palpate::app {

/// Language of the window.
struct Language
{
    QString code;   ///< ISO 639-1 code as in locale names: "en", "de", "fr"
    QString native; ///< native name of the language
};

/// Available languages: English and those with a catalogue in resources/translations.
[[nodiscard]] const QList<Language>& languages();

/// Sets the language of all windows created later: the user's choice (setting `language`), otherwise the first system
/// language in `languages()`, otherwise English. Also sets the decimal separator. Call once before creating a window.
void applyChosenLanguage();

/// Adds a menu to choose the language. Open windows do not change; `said` gets a message to show.
void addLanguageMenu(QMenu& menu, QObject& context, const std::function<void(const QString&)>& said);

} // namespace palpate::app

// SPDX-License-Identifier: BSD-3-Clause
#include "shell/Language.h"

#include <QAction>
#include <QActionGroup>
#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QMenu>
#include <QSettings>
#include <QTranslator>

#include <algorithm>

namespace palpate::app {

namespace {

const QString kSetting = QStringLiteral("language");

struct LanguageTexts
{
    Q_DECLARE_TR_FUNCTIONS(palpate::app::Language)
};

/// First of the system's languages, in order of preference, that is available.
QString systemLanguage()
{
    for (const QString& locale : QLocale::system().uiLanguages()) {
        const QString code = locale.section(QLatin1Char('-'), 0, 0);
        if (std::any_of(languages().begin(), languages().end(),
                        [&](const Language& one) { return one.code == code; })) {
            return code;
        }
    }
    return QStringLiteral("en");
}

void install(const QString& name, const QString& folder)
{
    auto* translator = new QTranslator(QCoreApplication::instance());
    if (translator->load(name, folder)) {
        QCoreApplication::installTranslator(translator);
    } else {
        delete translator; // these texts stay English
    }
}

} // namespace

const QList<Language>& languages()
{
    static const QList<Language> all{{QStringLiteral("en"), QStringLiteral("English")},
                                     {QStringLiteral("de"), QStringLiteral("Deutsch (Entwurf)")},
                                     {QStringLiteral("fr"), QStringLiteral("Français (ébauche)")}};
    return all;
}

void applyChosenLanguage()
{
    const QString chosen = QSettings().value(kSetting).toString();
    const QString code = chosen.isEmpty() ? systemLanguage() : chosen;
    // The language of the window determines the number format, not the system locale, unless both have the same
    // language: regional formats, such as the decimal point in Swiss German, are kept. Files are written
    // independently of the locale.
    const QLocale system = QLocale::system();
    QLocale::setDefault(system.language() == QLocale(code).language() ? system : QLocale(code));
    // Buttons of Qt's own dialogs, if the system has Qt's catalogue. The English catalogue of the window has the texts
    // with singular and plural.
    install(QStringLiteral("qtbase_") + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    install(QStringLiteral("palpate_") + code, QStringLiteral(":/translations"));
}

void addLanguageMenu(QMenu& menu, QObject& context, const std::function<void(const QString&)>& said)
{
    QMenu* choices = menu.addMenu(LanguageTexts::tr("Language"));
    auto* group = new QActionGroup(choices);
    const QString chosen = QSettings().value(kSetting).toString();
    const auto add = [&](const QString& code, const QString& text) {
        QAction* action = choices->addAction(text);
        action->setCheckable(true);
        action->setChecked(code == chosen);
        group->addAction(action);
        QObject::connect(action, &QAction::triggered, &context, [code, said] {
            QSettings().setValue(kSetting, code);
            said(QCoreApplication::translate("palpate::app::Language",
                                             "The new language takes effect when Palpate is restarted."));
        });
    };
    add({}, LanguageTexts::tr("Same as system"));
    for (const Language& one : languages()) {
        add(one.code, one.native);
    }
}

} // namespace palpate::app

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/Looks.h"

#include <QAction>
#include <QActionGroup>
#include <QEvent>
#include <QLocale>
#include <QSettings>
#include <QWidget>

#include <algorithm>

namespace palpate::ui {

namespace {

const QString kThemeSetting = QStringLiteral("look/appearance");
const QString kSizeSetting = QStringLiteral("look/text_percent");

} // namespace

Looks::Looks(ActionList& actions, QWidget* window)
    : QObject(window)
{
    addThemes(actions);
    addTextSizes(actions);
    window->installEventFilter(this);
}

void Looks::addThemes(ActionList& actions)
{
    struct Choice
    {
        Theme theme;
        const char* id; ///< command id; the settings store the part after the dash
        QString text, tip;
    };
    const Choice choices[] = {
        {Theme::System, "appearance-system", tr("Same as system"), tr("Light or dark, following the system")},
        {Theme::Light, "appearance-light", tr("Light"), tr("Dark text on light panels")},
        {Theme::Dark, "appearance-dark", tr("Dark"), tr("Light text on dark panels, for a dark room")},
        {Theme::ContrastOnBlack, "appearance-contrast-black", tr("High contrast, on black"),
         tr("White text on black, with visible edges")},
        {Theme::ContrastOnWhite, "appearance-contrast-white", tr("High contrast, on white"),
         tr("Black text on white, with visible edges")},
    };
    const QString kept = QSettings().value(kThemeSetting).toString();
    auto* group = new QActionGroup(this);
    for (const Choice& one : choices) {
        const QString name = QString::fromLatin1(one.id).section(QLatin1Char('-'), 1);
        QAction* action = actions.add(one.id, ActionGroup::Appearance, one.text, one.tip);
        action->setCheckable(true);
        group->addAction(action);
        if (name == kept || one.theme == Theme::System) { // invalid settings fall back to the system theme
            action->setChecked(true);
            m_theme = one.theme;
        }
        connect(action, &QAction::triggered, this, [this, name, theme = one.theme] {
            QSettings().setValue(kThemeSetting, name);
            use(theme);
        });
    }
    applyTheme(m_theme);
}

void Looks::addTextSizes(ActionList& actions)
{
    const int kept = QSettings().value(kSizeSetting, 100).toInt();
    const bool isThere = std::find(std::begin(kTextSizes), std::end(kTextSizes), kept) != std::end(kTextSizes);
    const int now = isThere ? kept : 100;
    auto* group = new QActionGroup(this);
    for (const int percent : kTextSizes) {
        const QByteArray id = "text-size-" + QByteArray::number(percent);
        QAction* action =
            actions.add(id.constData(), ActionGroup::TextSize, tr("%1 %").arg(QLocale().toString(percent)),
                        percent == 100 ? tr("Text size of the system") : tr("Text size in panels and in the view"));
        action->setCheckable(true);
        action->setChecked(percent == now);
        group->addAction(action);
        connect(action, &QAction::triggered, this, [this, percent] {
            QSettings().setValue(kSizeSetting, percent);
            const double before = textSize_percent();
            applyTextSize(percent);
            Q_EMIT textSizeChanged(percent / before);
        });
    }
    applyTextSize(now);
}

void Looks::use(Theme theme)
{
    m_theme = theme;
    applyTheme(theme);
}

bool Looks::eventFilter(QObject* watched, QEvent* event)
{
    const bool isAsked = event->type() == QEvent::ThemeChange;
    if ((isAsked || event->type() == QEvent::ApplicationPaletteChange) && noteSystemPalette(isAsked)) {
        // Queued: widgets are still being notified of the palette that is about to be replaced.
        QMetaObject::invokeMethod(
            this, [this] { applyTheme(m_theme); }, Qt::QueuedConnection);
    }
    return QObject::eventFilter(watched, event);
}

} // namespace palpate::ui

#include "palpate/ui/moc_Looks.cpp"

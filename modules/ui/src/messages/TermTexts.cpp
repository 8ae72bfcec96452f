// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/TermTexts.h"

#include <QCoreApplication>

#include <string>

namespace palpate::ui {

QString termText(std::string_view text)
{
    return text.empty() ? QString() : QCoreApplication::translate("palpate::ui::Terms", std::string(text).c_str());
}

std::span<const char* const> termTexts() noexcept
{
    static constexpr const char* kTexts[] = {
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Stiffness"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "force for each mm pressed in"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "newton per millimetre"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Resists fast movement"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "force against each mm/s of movement"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "newton seconds per millimetre"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Friction at rest"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "share of the normal force that holds"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Friction sliding"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "share of the normal force that drags while it slides"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Drag"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "force against each mm/s of sliding"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Stiffness at first touch"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Growth with depth"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Greatest stiffness"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Young's modulus"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Radius of the ball"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Thickness of the layer"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Bonded to what is below"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Stiffness before the click"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Force at which it gives way"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Force that it falls to"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Depth over which it falls"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Stiffness after the click"),
    };
    return kTexts;
}

} // namespace palpate::ui

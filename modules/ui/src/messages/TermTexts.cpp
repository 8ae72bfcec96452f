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
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "force per millimetre of depth"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "newton per millimetre"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Damping"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "resisting force per mm/s of movement"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "newton seconds per millimetre"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Static friction"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms",
                          "tangential force that starts sliding, as a fraction of the normal force"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Sliding friction"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "tangential force while sliding, as a fraction of the normal force"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Drag"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "resisting force per mm/s of sliding"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Initial stiffness"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Growth with depth"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Maximum stiffness"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Young's modulus"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Ball radius"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Layer thickness"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Bonded to the layer below"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Stiffness before the click"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Force at the click"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Force after the click"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Depth of the force drop"),
        QT_TRANSLATE_NOOP("palpate::ui::Terms", "Stiffness after the click"),
    };
    return kTexts;
}

} // namespace palpate::ui

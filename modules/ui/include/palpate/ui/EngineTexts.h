// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/Translated.h"

#include <palpate/core/Status.h>

#include <QString>

#include <string_view>

namespace palpate::ui {

/// A line of the engine, which speaks English alone, in the window's language: a status, a loss or a note. Sentences of
/// ordinary work are known, by the places that names and numbers have in them; one that is not stays as it is and says
/// which language it is in. In English every line stays as it is. Any thread but the servo's.
[[nodiscard]] QString engineText(std::string_view line);
[[nodiscard]] inline QString engineText(const core::Status& status)
{
    return status.text().isTranslatable() ? translated(status.text()) : engineText(status.message());
}
[[nodiscard]] inline QString engineText(const core::Message& message)
{
    return message.isTranslatable() ? translated(message) : engineText(message.english());
}

} // namespace palpate::ui

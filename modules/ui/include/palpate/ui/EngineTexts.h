// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/Translated.h"

#include <palpate/core/Export.h>
#include <palpate/core/Status.h>

#include <QString>

#include <string_view>

namespace palpate::ui {

/// Translates an English line of the engine (status, loss or note) for the window. Known sentences are matched against
/// templates with places for names and numbers. An unknown sentence is returned unchanged with a note that the text is
/// English. An English window returns every line unchanged.
///
/// @par Thread Any thread except the servo thread.
[[nodiscard]] PALPATE_EXPORT QString engineText(std::string_view line);
[[nodiscard]] inline QString engineText(const core::Status& status)
{
    return status.text().isTranslatable() ? translated(status.text()) : engineText(status.message());
}
[[nodiscard]] inline QString engineText(const core::Message& message)
{
    return message.isTranslatable() ? translated(message) : engineText(message.english());
}

} // namespace palpate::ui

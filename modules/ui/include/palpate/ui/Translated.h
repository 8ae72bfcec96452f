// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Message.h>
#include <palpate/core/Status.h>

#include <QString>

namespace palpate::ui {

/// Translates an engine message: text and parts from the catalogue, numbers with the decimal point and digit separators
/// of `QLocale()`. Third-party sentences (`Message::untranslated`) are kept and marked as English. In an English window
/// the result equals `message.english()`.
///
/// @par Thread Any thread except the servo thread.
[[nodiscard]] PALPATE_EXPORT QString translated(const core::Message& message);
/// Same for a name, a number or a message.
[[nodiscard]] PALPATE_EXPORT QString translated(const core::MessageArgument& argument);
/// Same for the message of a status.
[[nodiscard]] inline QString translated(const core::Status& status)
{
    return translated(status.text());
}
/// Writes a number with at most `digits` significant digits (1 to 17) and without an exponent, as `core::shortNumber`,
/// with the decimal point of `QLocale()`.
[[nodiscard]] PALPATE_EXPORT QString numberText(double value, int digits = 6);

} // namespace palpate::ui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Message.h>

#include <QString>

namespace palpate::ui {

/// A message of the engine in the window's language: its text and its parts are looked up in the catalogue, its numbers
/// get the decimal point and the digit separators of `QLocale()`. A sentence that is not ours (`Message::untranslated`)
/// stays as it is and is marked as English. In an English window the result is `message.english()`.
/// Thread: any but the servo's.
[[nodiscard]] QString translated(const core::Message& message);

} // namespace palpate::ui

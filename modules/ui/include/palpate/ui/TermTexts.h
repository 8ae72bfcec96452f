// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

#include <span>
#include <string_view>

namespace palpate::ui {

/// A text of `core::TissueTerm` or `core::LawTerm` in the window's language.
[[nodiscard]] QString termText(std::string_view text);

/// All texts of those terms, as the catalogues have them: core itself knows no languages.
[[nodiscard]] std::span<const char* const> termTexts() noexcept;

} // namespace palpate::ui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

#include <span>
#include <string_view>

namespace palpate::ui {

/// Translates a text of `core::TissueTerm` or `core::LawParameter`.
[[nodiscard]] QString termText(std::string_view text);

/// All texts of these terms, for the translation catalogues; the core module has no translations.
[[nodiscard]] std::span<const char* const> termTexts() noexcept;

} // namespace palpate::ui

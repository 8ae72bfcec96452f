// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

#include <string>

namespace palpate::app {

/// Converts UTF-8 to QString.
[[nodiscard]] inline QString text(const std::string& utf8)
{
    return QString::fromStdString(utf8);
}

} // namespace palpate::app

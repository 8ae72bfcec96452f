// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace palpate::session::internal {

extern const char* const kVersion;
extern const char* const kBuildId;

} // namespace palpate::session::internal

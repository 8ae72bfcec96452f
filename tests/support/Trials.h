// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace palpate::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kIsSanitized = true;
#else
inline constexpr bool kIsSanitized = false;
#endif

/// Number of random trials of a test: a quarter of `count` under a sanitizer, where a trial takes some fifteen times as
/// long. A sanitizer looks for errors of memory and arithmetic, which do not need as many trials as rare geometry does.
constexpr int trials(int count)
{
    return kIsSanitized ? count / 4 : count;
}

} // namespace palpate::test

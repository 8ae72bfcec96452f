// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

namespace palpate::meshio::internal {

/// Calls `work(i, isCaller)` for each i below `count`, in order of i as far as starts go, on the calling thread and on
/// one more. `isCaller` is true on the calling thread. An exception of either is thrown again here.
void onTwoThreads(std::size_t count, const std::function<void(std::size_t, bool)>& work);

} // namespace palpate::meshio::internal

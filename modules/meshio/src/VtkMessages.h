// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace palpate::meshio::internal {

/// Collects what VTK says on this thread while it lives, instead of letting it reach the console or a window. Other
/// threads' messages go where they went before.
class VtkMessages
{
  public:
    VtkMessages();
    ~VtkMessages();
    VtkMessages(const VtkMessages&) = delete;
    VtkMessages& operator=(const VtkMessages&) = delete;

    /// The first error, in one line without its source file; empty when there was none.
    [[nodiscard]] const std::string& firstError() const noexcept { return m_firstError; }
    void addError(const char* text);

  private:
    VtkMessages* m_outer;
    std::string m_firstError;
};

} // namespace palpate::meshio::internal

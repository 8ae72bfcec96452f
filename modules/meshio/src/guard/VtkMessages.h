// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace palpate::meshio::internal {

/// Collects VTK's messages of this thread during the lifetime of the object, instead of printing them to the console
/// or a window. Messages of other threads are unaffected.
class VtkMessages
{
  public:
    VtkMessages();
    ~VtkMessages();
    VtkMessages(const VtkMessages&) = delete;
    VtkMessages& operator=(const VtkMessages&) = delete;

    /// First error as one line without the source file; empty if no error occurred.
    [[nodiscard]] const std::string& firstError() const noexcept { return m_firstError; }
    void addError(const char* text);

  private:
    VtkMessages* m_outer;
    std::string m_firstError;
};

} // namespace palpate::meshio::internal

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Message.h>
#include <palpate/core/Status.h>

#include <pybind11/pybind11.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace palpate::python {

namespace py = pybind11;

/// Exception `palpate.Error` with the engine's message and the name of the code.
class EngineError
{
  public:
    explicit EngineError(core::Status status)
        : m_status(std::move(status))
    {
    }
    [[nodiscard]] const core::Status& status() const noexcept { return m_status; }

  private:
    core::Status m_status;
};

/// Throws EngineError unless the status is Ok.
void throwUnlessOk(const core::Status& status);

/// Returns the value of a result or throws EngineError.
template<class T>
T valueOf(core::Result<T> result)
{
    throwUnlessOk(result.status());
    return std::move(result).value();
}

/// Converts UTF-8. Invalid bytes, as of a file name in another encoding, become replacement characters.
[[nodiscard]] py::str toPython(std::string_view text);
[[nodiscard]] py::list toPython(const std::vector<core::Message>& messages);

/// Formats a number for a message.
[[nodiscard]] std::string numberText(double number);

/// Parses JSON of the engine to dictionaries and lists.
[[nodiscard]] py::object parsedJson(std::string_view json);

/// Adds `Error` to the module.
void bindErrors(py::module_& module);

} // namespace palpate::python

// SPDX-License-Identifier: BSD-3-Clause
#include "Errors.h"

#include <array>
#include <exception>

namespace palpate::python {

namespace {

/// Names in the order of core::StatusCode.
constexpr std::array<const char*, 14> kCodeNames{
    "Ok",    "BadCommandLine", "NotFound",    "Unreadable", "BadFormat", "NonFinite",  "OutOfRange",
    "Empty", "Mismatch",       "Unsupported", "NoSpace",    "Cancelled", "DeviceLost", "Internal"};
static_assert(kCodeNames.size() == static_cast<std::size_t>(core::StatusCode::Internal) + 1);

PyObject* errorType = nullptr; // lives as long as the interpreter

void setError(const core::Status& status)
{
    py::object error = py::reinterpret_borrow<py::object>(errorType)(toPython(status.message()));
    error.attr("code") = kCodeNames[static_cast<std::size_t>(status.code())];
    PyErr_SetObject(errorType, error.ptr());
}

} // namespace

void throwUnlessOk(const core::Status& status)
{
    if (!status.isOk()) {
        throw EngineError(status);
    }
}

py::str toPython(std::string_view text)
{
    PyObject* const out = PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace");
    if (out == nullptr) {
        throw py::error_already_set();
    }
    return py::reinterpret_steal<py::str>(out);
}

py::list toPython(const std::vector<core::Message>& messages)
{
    py::list out;
    for (const core::Message& message : messages) {
        out.append(toPython(message.english()));
    }
    return out;
}

std::string numberText(double number)
{
    return core::MessageArgument(number).english;
}

py::object parsedJson(std::string_view json)
{
    return py::module_::import("json").attr("loads")(toPython(json));
}

void bindErrors(py::module_& module)
{
    errorType = PyErr_NewExceptionWithDoc(
        "palpate.Error",
        "Error of the engine. The text names the place, what was found and what was expected.\n\n"
        "`code` is the cause: BadCommandLine, NotFound, Unreadable, BadFormat, NonFinite, OutOfRange, Empty,\n"
        "Mismatch, Unsupported, NoSpace, Cancelled, DeviceLost or Internal.",
        PyExc_ValueError, nullptr);
    if (errorType == nullptr) {
        throw py::error_already_set();
    }
    module.add_object("Error", py::reinterpret_borrow<py::object>(errorType));
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) {
                std::rethrow_exception(thrown);
            }
        } catch (const EngineError& error) {
            setError(error.status());
        }
    });
}

} // namespace palpate::python

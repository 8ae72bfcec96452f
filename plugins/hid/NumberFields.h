// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <span>
#include <string>

class QJsonObject;

namespace palpate::hid {

/// Numeric field of a device's settings.
struct NumberField
{
    const char* name;
    double* value;
    double least;
    double most;
};

/// Reads the fields that are present; the others keep their values.
/// @param file  prefix of the error message
/// @return OutOfRange with one line that names the first field that is not a number from `least` to `most`
[[nodiscard]] core::Status readNumbers(const QJsonObject& object, std::span<const NumberField> fields,
                                       const std::string& file);

} // namespace palpate::hid

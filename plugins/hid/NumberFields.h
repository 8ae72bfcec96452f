// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>

#include <span>
#include <string>

class QJsonObject;

namespace palpate::hid {

/// A number in the settings of a device.
struct NumberField
{
    const char* name;
    double* value;
    double least;
    double most;
};

/// Reads the fields that are there into their values; the others keep theirs.
/// @param file  begins the message
/// @return OutOfRange with one line that names the first field that is no number from `least` to `most`
[[nodiscard]] core::Status readNumbers(const QJsonObject& object, std::span<const NumberField> fields,
                                       const std::string& file);

} // namespace palpate::hid

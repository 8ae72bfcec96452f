// SPDX-License-Identifier: BSD-3-Clause
#include "NumberFields.h"

#include <QJsonObject>

#include <cmath>

namespace palpate::hid {

core::Status readNumbers(const QJsonObject& object, std::span<const NumberField> fields, const std::string& file)
{
    for (const NumberField& field : fields) {
        const QJsonValue value = object.value(QLatin1String(field.name));
        if (value.isUndefined()) {
            continue;
        }
        const double found = value.toDouble(std::nan(""));
        if (!(found >= field.least && found <= field.most)) {
            return {core::StatusCode::OutOfRange,
                    PALPATE_TEXT("%1: %2: found %3, expected %4 to %5"),
                    file,
                    field.name,
                    value.isDouble() ? core::MessageArgument(found) : core::Message(PALPATE_TEXT("no number")),
                    field.least,
                    field.most};
        }
        *field.value = found;
    }
    return {};
}

} // namespace palpate::hid

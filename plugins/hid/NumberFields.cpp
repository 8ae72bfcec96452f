// SPDX-License-Identifier: BSD-3-Clause
#include "NumberFields.h"

#include <QByteArray>
#include <QJsonObject>

#include <cmath>

namespace palpate::hid {

namespace {

std::string number(double value)
{
    return QByteArray::number(value, 'g', 6).toStdString();
}

} // namespace

core::Status readNumbers(const QJsonObject& object, std::span<const NumberField> fields, const std::string& file)
{
    for (const NumberField& field : fields) {
        const QJsonValue value = object.value(QLatin1String(field.name));
        if (value.isUndefined()) {
            continue;
        }
        const double found = value.toDouble(std::nan(""));
        if (!(found >= field.least && found <= field.most)) {
            return {core::StatusCode::OutOfRange, file + ": " + field.name + ": found " +
                                                      (value.isDouble() ? number(found) : "no number") + ", expected " +
                                                      number(field.least) + " to " + number(field.most)};
        }
        *field.value = found;
    }
    return {};
}

} // namespace palpate::hid

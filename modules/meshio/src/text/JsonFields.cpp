// SPDX-License-Identifier: BSD-3-Clause
#include "text/JsonFields.h"

#include "text/Fault.h"

#include <palpate/core/Numbers.h>

#include <QJsonDocument>

namespace palpate::meshio::internal {

std::string brief(double value)
{
    return QByteArray::number(value, 'g', 12).toStdString();
}

namespace {

std::string range(double low, double high)
{
    return brief(low) + " to " + brief(high);
}

/// @return a short description of a value for messages
std::string shown(const QJsonValue& value)
{
    switch (value.type()) {
    case QJsonValue::Bool:
        return value.toBool() ? "true" : "false";
    case QJsonValue::Double:
        return brief(value.toDouble());
    case QJsonValue::String:
        return inQuotes(value.toString().toStdString());
    case QJsonValue::Array:
        return "an array of " + std::to_string(value.toArray().size());
    case QJsonValue::Object:
        return "an object";
    default:
        return "null";
    }
}

} // namespace

JsonFields::JsonFields(const QJsonObject& object, std::string file, std::string path, core::Status& status)
    : m_object(object)
    , m_unknown(object)
    , m_file(std::move(file))
    , m_path(std::move(path))
    , m_status(status)
{
}

std::string JsonFields::pathOf(const char* name) const
{
    return m_path.empty() ? name : m_path + "." + name;
}

void JsonFields::fail(const char* name, const std::string& found, const std::string& expected)
{
    if (m_status.isOk()) {
        m_status = {core::StatusCode::BadFormat,
                    m_file + ": " + pathOf(name) + ": found " + found + ", expected " + expected};
    }
}

void JsonFields::refuse(const char* name, const core::Status& why)
{
    if (m_status.isOk()) {
        m_status = {why.code(), m_file + ": " + pathOf(name) + ": " + why.message()};
    }
}

void JsonFields::failType(const char* name, const QJsonValue& value, const std::string& expected)
{
    fail(name, shown(value), expected);
}

void JsonFields::keepUnknown(const char* name, const std::string& fields)
{
    if (!fields.empty()) {
        m_unknown[QLatin1String(name)] = QJsonDocument::fromJson(QByteArray::fromStdString(fields)).object();
    }
}

QJsonValue JsonFields::take(const char* name)
{
    const QLatin1String key(name);
    m_unknown.remove(key);
    return m_object.value(key);
}

void JsonFields::read(const char* name, std::string& value)
{
    const QJsonValue found = take(name);
    if (found.isString() && found.toString().contains(QChar::Null)) {
        failType(name, found, "a text without the character U+0000"); // C strings end there
    } else if (found.isString()) {
        value = found.toString().toStdString();
    } else if (!found.isUndefined()) {
        failType(name, found, "a text");
    }
}

void JsonFields::read(const char* name, bool& value)
{
    const QJsonValue found = take(name);
    if (found.isBool()) {
        value = found.toBool();
    } else if (!found.isUndefined()) {
        failType(name, found, "true or false");
    }
}

void JsonFields::read(const char* name, double& value, double low, double high)
{
    const QJsonValue found = take(name);
    if (found.isUndefined()) {
        return;
    }
    if (!found.isDouble() || !(found.toDouble() >= low && found.toDouble() <= high)) {
        failType(name, found, range(low, high));
        return;
    }
    value = found.toDouble();
}

std::optional<std::vector<double>> JsonFields::numbers(const char* name, std::size_t count, double low, double high)
{
    const QJsonValue found = take(name);
    if (found.isUndefined()) {
        return std::nullopt;
    }
    const QJsonArray array = found.toArray();
    if (!found.isArray() || static_cast<std::size_t>(array.size()) != count) {
        failType(name, found, std::to_string(count) + " numbers");
        return std::nullopt;
    }
    std::vector<double> values;
    for (const QJsonValue& entry : array) {
        if (!entry.isDouble() || !(entry.toDouble() >= low && entry.toDouble() <= high)) {
            const std::string element = std::string(name) + "[" + std::to_string(values.size()) + "]";
            failType(element.c_str(), entry, range(low, high));
            return std::nullopt;
        }
        values.push_back(entry.toDouble());
    }
    return values;
}

std::vector<JsonFields> JsonFields::listOf(const char* name)
{
    std::vector<JsonFields> list;
    for (const QJsonObject& entry : objects(name)) {
        list.emplace_back(entry, m_file, pathOf(name) + "[" + std::to_string(list.size()) + "]", m_status);
    }
    return list;
}

std::vector<std::array<double, 2>> JsonFields::pairs(const char* name, std::size_t most)
{
    const QJsonValue found = take(name);
    const QJsonArray array = found.toArray();
    if (!found.isArray() || static_cast<std::size_t>(array.size()) > most) {
        if (!found.isUndefined()) {
            failType(name, found, "at most " + std::to_string(most) + " pairs of numbers");
        }
        return {};
    }
    std::vector<std::array<double, 2>> values;
    for (const QJsonValue& entry : array) {
        const QJsonArray pair = entry.toArray();
        if (pair.size() != 2 || !pair[0].isDouble() || !pair[1].isDouble()) {
            const std::string element = std::string(name) + "[" + std::to_string(values.size()) + "]";
            failType(element.c_str(), entry, "two numbers");
            return {};
        }
        values.push_back({pair[0].toDouble(), pair[1].toDouble()});
    }
    return values;
}

std::optional<JsonFields> JsonFields::fieldsOf(const char* name)
{
    const auto found = object(name);
    return found ? std::optional(JsonFields(*found, m_file, pathOf(name), m_status)) : std::nullopt;
}

std::optional<QJsonObject> JsonFields::object(const char* name)
{
    const QJsonValue found = take(name);
    if (found.isUndefined()) {
        return std::nullopt;
    }
    if (!found.isObject()) {
        failType(name, found, "an object");
        return std::nullopt;
    }
    return found.toObject();
}

std::vector<QJsonObject> JsonFields::objects(const char* name)
{
    const QJsonValue found = take(name);
    std::vector<QJsonObject> out;
    if (found.isUndefined()) {
        return out;
    }
    if (!found.isArray()) {
        failType(name, found, "an array");
        return out;
    }
    for (const QJsonValue& entry : found.toArray()) {
        if (!entry.isObject()) {
            const std::string element = std::string(name) + "[" + std::to_string(out.size()) + "]";
            failType(element.c_str(), entry, "an object");
            return out;
        }
        out.push_back(entry.toObject());
    }
    return out;
}

std::string JsonFields::unknown() const
{
    return m_unknown.isEmpty() ? std::string() : QJsonDocument(m_unknown).toJson(QJsonDocument::Compact).toStdString();
}

} // namespace palpate::meshio::internal

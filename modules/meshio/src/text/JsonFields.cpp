// SPDX-License-Identifier: BSD-3-Clause
#include "text/JsonFields.h"

#include "text/Fault.h"

#include <QJsonDocument>

namespace palpate::meshio::internal {

namespace {

core::Message range(double low, double high)
{
    return {PALPATE_TEXT("%1 to %2"), exactNumber(low), exactNumber(high)};
}

/// @return a short description of a value for messages
core::Message shown(const QJsonValue& value)
{
    switch (value.type()) {
    case QJsonValue::Bool:
        return {PALPATE_TEXT("%1"), value.toBool() ? "true" : "false"};
    case QJsonValue::Double:
        return {PALPATE_TEXT("%1"), exactNumber(value.toDouble())};
    case QJsonValue::String:
        return {PALPATE_TEXT("%1"), inQuotes(value.toString().toStdString())};
    case QJsonValue::Array:
        return {PALPATE_TEXT("an array of %1"), value.toArray().size()};
    case QJsonValue::Object:
        return {PALPATE_TEXT("an object")};
    default:
        return {PALPATE_TEXT("%1"), "null"};
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

void JsonFields::fail(const char* name, const core::Message& found, const core::Message& expected)
{
    if (m_status.isOk()) {
        m_status = {core::StatusCode::BadFormat,
                    PALPATE_TEXT("%1: %2: found %3, expected %4"),
                    m_file,
                    pathOf(name),
                    found,
                    expected};
    }
}

void JsonFields::refuse(const char* name, const core::Status& why)
{
    if (m_status.isOk()) {
        m_status = why.at(pathOf(name)).at(m_file);
    }
}

void JsonFields::failType(const char* name, const QJsonValue& value, const core::Message& expected)
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
        failType(name, found, {PALPATE_TEXT("a text without the character U+0000")}); // C strings end there
    } else if (found.isString()) {
        value = found.toString().toStdString();
    } else if (!found.isUndefined()) {
        failType(name, found, {PALPATE_TEXT("a text")});
    }
}

void JsonFields::read(const char* name, bool& value)
{
    const QJsonValue found = take(name);
    if (found.isBool()) {
        value = found.toBool();
    } else if (!found.isUndefined()) {
        failType(name, found, {PALPATE_TEXT("true or false")});
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

std::vector<std::string> JsonFields::texts(const char* name, std::size_t most)
{
    const QJsonValue found = take(name);
    std::vector<std::string> texts;
    if (found.isUndefined()) {
        return texts;
    }
    const QJsonArray array = found.toArray();
    if (!found.isArray() || static_cast<std::size_t>(array.size()) > most) {
        failType(name, found, {PALPATE_TEXT("at most %1 texts"), most});
        return texts;
    }
    for (const QJsonValue& entry : array) {
        if (!entry.isString() || entry.toString().isEmpty() || entry.toString().contains(QChar::Null)) {
            const std::string element = std::string(name) + "[" + std::to_string(texts.size()) + "]";
            failType(element.c_str(), entry, {PALPATE_TEXT("a text")});
            return {};
        }
        texts.push_back(entry.toString().toStdString());
    }
    return texts;
}

std::optional<std::vector<double>> JsonFields::numbers(const char* name, std::size_t count, double low, double high)
{
    const QJsonValue found = take(name);
    if (found.isUndefined()) {
        return std::nullopt;
    }
    const QJsonArray array = found.toArray();
    if (!found.isArray() || static_cast<std::size_t>(array.size()) != count) {
        failType(name, found, {PALPATE_TEXT("%1 numbers"), count});
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
            failType(name, found, {PALPATE_TEXT("at most %1 pairs of numbers"), most});
        }
        return {};
    }
    std::vector<std::array<double, 2>> values;
    for (const QJsonValue& entry : array) {
        const QJsonArray pair = entry.toArray();
        if (pair.size() != 2 || !pair[0].isDouble() || !pair[1].isDouble()) {
            const std::string element = std::string(name) + "[" + std::to_string(values.size()) + "]";
            failType(element.c_str(), entry, {PALPATE_TEXT("two numbers")});
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
        failType(name, found, {PALPATE_TEXT("an object")});
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
        failType(name, found, {PALPATE_TEXT("an array")});
        return out;
    }
    for (const QJsonValue& entry : found.toArray()) {
        if (!entry.isObject()) {
            const std::string element = std::string(name) + "[" + std::to_string(out.size()) + "]";
            failType(element.c_str(), entry, {PALPATE_TEXT("an object")});
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

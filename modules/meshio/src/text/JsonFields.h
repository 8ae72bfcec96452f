// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Message.h>
#include <palpate/core/Status.h>

#include <QJsonArray>
#include <QJsonObject>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace palpate::meshio::internal {

/// @return a number for messages with up to twelve significant digits
[[nodiscard]] inline core::Rounded exactNumber(double value)
{
    return {value, 12};
}

/// Reads one JSON object field by field. The first invalid field is kept as the error, with the path
/// in the document. Fields that no call has read are unknown fields.
class JsonFields
{
  public:
    /// @param path  of this object, "structures[2]"; empty for the document
    JsonFields(const QJsonObject& object, std::string file, std::string path, core::Status& status);

    void read(const char* name, std::string& value);
    void read(const char* name, bool& value);
    void read(const char* name, double& value, double low, double high);
    /// Reads exactly `count` numbers. @return nothing when the field is absent or wrong
    std::optional<std::vector<double>> numbers(const char* name, std::size_t count, double low, double high);
    /// Reads an array of at most `most` pairs of numbers; empty when the field is absent or wrong.
    std::vector<std::array<double, 2>> pairs(const char* name, std::size_t most);
    /// Reads an array of at most `most` non-empty texts; empty when the field is absent or wrong.
    std::vector<std::string> texts(const char* name, std::size_t most);
    std::optional<QJsonObject> object(const char* name);
    /// The fields of an object; empty if absent or invalid.
    std::optional<JsonFields> fieldsOf(const char* name);
    /// The objects of an array; empty when the field is absent.
    std::vector<QJsonObject> objects(const char* name);
    /// The fields of each object in an array.
    std::vector<JsonFields> listOf(const char* name);

    /// Adds the unread fields of an object to the unknown fields of this one. @param fields  from `unknown`
    void keepUnknown(const char* name, const std::string& fields);

    [[nodiscard]] bool has(const char* name) const { return m_object.contains(QLatin1String(name)); }
    /// Fields not read so far, as JSON text; empty if all were read.
    [[nodiscard]] std::string unknown() const;
    /// @return "structures[2].opacity"
    [[nodiscard]] std::string pathOf(const char* name) const;
    /// Keeps an error of a field: "scene.json: structures[2].opacity: found 7, expected 0 to 1".
    void fail(const char* name, const core::Message& found, const core::Message& expected);
    /// Keeps the error of a field. @param why  not ok
    void refuse(const char* name, const core::Status& why);

  private:
    QJsonValue take(const char* name);
    void failType(const char* name, const QJsonValue& value, const core::Message& expected);

    QJsonObject m_object;
    QJsonObject m_unknown;
    std::string m_file;
    std::string m_path;
    core::Status& m_status;
};

} // namespace palpate::meshio::internal

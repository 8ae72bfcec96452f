// SPDX-License-Identifier: BSD-3-Clause
#include "text/RepeatedField.h"

#include <QByteArray>
#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <cstddef>
#include <set>
#include <vector>

namespace palpate::meshio::internal {

namespace {

/// An object or array that the scan is inside of.
struct Level
{
    bool isObject;
    std::size_t element = 0;     ///< current index in an array
    std::set<std::string> names; ///< field names of an object so far
    std::string name;            ///< current field of an object
};

/// @return the position after the string that begins with the quotation mark at `begin`
std::size_t endOfString(std::string_view json, std::size_t begin)
{
    std::size_t at = begin + 1;
    while (at < json.size() && json[at] != '"') {
        at += json[at] == '\\' ? 2 : 1;
    }
    return at + 1;
}

/// Resolves the escape sequences of a string. @param quoted  including the quotation marks
std::string unescaped(std::string_view quoted)
{
    if (quoted.find('\\') == std::string_view::npos) {
        return std::string(quoted.substr(1, quoted.size() - 2));
    }
    const QByteArray array = '[' + QByteArray(quoted.data(), static_cast<qsizetype>(quoted.size())) + ']';
    return QJsonDocument::fromJson(array).array().at(0).toString().toStdString();
}

std::string pathOf(const std::vector<Level>& levels)
{
    std::string path;
    for (const Level& level : levels) {
        if (level.isObject) {
            path += (path.empty() ? "" : ".") + level.name;
        } else {
            path += '[' + std::to_string(level.element) + ']';
        }
    }
    return path;
}

} // namespace

std::optional<std::string> repeatedField(std::string_view json)
{
    std::vector<Level> levels;
    bool isName = false; // the next string is a field's name
    for (std::size_t at = 0; at < json.size(); ++at) {
        switch (json[at]) {
        case '{':
        case '[':
            isName = json[at] == '{';
            levels.push_back({isName, 0, {}, {}});
            break;
        case '}':
        case ']':
            if (!levels.empty()) {
                levels.pop_back();
            }
            isName = false;
            break;
        case ',':
            isName = !levels.empty() && levels.back().isObject;
            if (!levels.empty()) {
                ++levels.back().element;
            }
            break;
        case '"': {
            const std::size_t end = std::min(endOfString(json, at), json.size());
            if (isName && !levels.empty()) {
                levels.back().name = unescaped(json.substr(at, end - at));
                if (!levels.back().names.insert(levels.back().name).second) {
                    return pathOf(levels);
                }
                isName = false;
            }
            at = end - 1;
            break;
        }
        default:
            break;
        }
    }
    return std::nullopt;
}

} // namespace palpate::meshio::internal

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/meshio/SceneFile.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>

namespace palpate::meshio {

namespace {

/// Objects that only keep the unknown fields.
constexpr std::array kGroups{"friction", "law", "camera", "recording", "motion", "pulse"};

/// @param path  of the object, with a trailing dot; empty for the document
void addFields(const QJsonObject& extra, const std::string& path, std::vector<std::string>& out)
{
    for (auto field = extra.begin(); field != extra.end(); ++field) {
        const std::string name = field.key().toStdString();
        const bool isGroup = std::find(kGroups.begin(), kGroups.end(), name) != kGroups.end();
        if (isGroup && field.value().isObject()) {
            addFields(field.value().toObject(), path + name + ".", out);
        } else {
            out.push_back(path + name);
        }
    }
}

void addFields(const std::string& extra, const std::string& path, std::vector<std::string>& out)
{
    addFields(QJsonDocument::fromJson(QByteArray::fromStdString(extra)).object(), path, out);
}

} // namespace

std::vector<std::string> unknownFields(const SceneFile& scene)
{
    std::vector<std::string> out;
    addFields(scene.extra, "", out);
    for (std::size_t i = 0; i < scene.structures.size(); ++i) {
        addFields(scene.structures[i].extra, "structures[" + std::to_string(i) + "].", out);
    }
    if (scene.camera) {
        addFields(scene.camera->extra, "camera.", out);
    }
    if (scene.section) {
        addFields(scene.section->extra, "section.", out);
    }
    if (scene.exercise) {
        addFields(scene.exercise->extra, "exercise.", out);
    }
    for (std::size_t i = 0; i < scene.findings.size(); ++i) {
        addFields(scene.findings[i].extra, "findings[" + std::to_string(i) + "].", out);
    }
    for (std::size_t i = 0; i < scene.tapes.size(); ++i) {
        addFields(scene.tapes[i].extra, "tapes[" + std::to_string(i) + "].", out);
    }
    return out;
}

} // namespace palpate::meshio

// SPDX-License-Identifier: BSD-3-Clause
#include "Settings.h"

#include <hid/NumberFields.h>
#include <hid/SettingsFile.h>

#include <QJsonObject>

#include <cstddef>
#include <tuple>

namespace palpate::openigtlink {

using core::Status;
using core::StatusCode;

namespace {

/// Reads a text field if it is present. @param most  longest text [bytes]
Status readText(const QJsonObject& object, const char* name, std::size_t most, const std::filesystem::path& file,
                std::string& text)
{
    const QJsonValue value = object.value(QLatin1String(name));
    if (value.isUndefined()) {
        return {};
    }
    const std::string found = value.toString().toStdString();
    if (!value.isString() || found.size() > most) {
        return {StatusCode::BadFormat, PALPATE_TEXT("%1: %2: expected a text of at most %3 bytes in quotes"), file,
                name, most};
    }
    text = found;
    return {};
}

} // namespace

core::Result<Settings> readSettings(const std::vector<std::filesystem::path>& folders)
{
    const auto file =
        hid::readSettingsFile(folders, "openigtlink.json", "{\"host\": \"192.168.0.10\", \"tool\": \"Stylus\"}");
    if (!file.isOk()) {
        return file.status();
    }
    Settings settings;
    settings.isFromFile = !file.value().path.empty();
    double port = settings.port;
    double request_ms = settings.requestEvery_ms;
    const hid::NumberField fields[] = {{"port", &port, 1.0, 65535.0},
                                       {"max_force_N", &settings.maxForce_N, 0.1, 20.0},
                                       {"max_stiffness_N_per_mm", &settings.maxStiffness_N_per_mm, 0.001, 5.0},
                                       {"workspace_radius_mm", &settings.workspaceRadius_mm, 0.0, 5000.0},
                                       {"stale_after_s", &settings.staleAfter_s, 0.02, 2.0},
                                       {"request_every_ms", &request_ms, 0.0, 1000.0}};
    const QJsonObject& object = file.value().object;
    const std::filesystem::path& path = file.value().path;
    Status status = hid::readNumbers(object, fields, path.string());
    constexpr std::size_t kLongestHost = 64;
    std::string frame = "RAS";
    for (const auto& [name, most, text] :
         {std::tuple("host", kLongestHost, &settings.host), std::tuple("tool", igtl::kNameLength, &settings.tool),
          std::tuple("frame", igtl::kNameLength, &frame), std::tuple("force", igtl::kNameLength, &settings.force)}) {
        if (status.isOk()) {
            status = readText(object, name, most, path, *text);
        }
    }
    if (status.isOk() && frame != "RAS" && frame != "LPS") {
        status = Status(StatusCode::BadFormat, PALPATE_TEXT("%1: %2: found \"%3\", expected \"RAS\" or \"LPS\""), path,
                        "frame", frame);
    }
    if (!status.isOk()) {
        return status;
    }
    settings.port = static_cast<std::uint16_t>(port);
    settings.requestEvery_ms = static_cast<std::uint32_t>(request_ms);
    settings.isRas = frame == "RAS";
    return settings;
}

} // namespace palpate::openigtlink

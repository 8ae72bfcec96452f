// SPDX-License-Identifier: BSD-3-Clause
#include "Messages.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace palpate::haply {

using core::Quaternion;
using core::Vec3;

namespace {

constexpr double kFarthest_m = 0.6; // from the mounting plate; an Inverse3 reaches 0.38 m along an axis
constexpr double kTolerance = 1e-6; // of axes, which the service states in single precision
constexpr const char* kGripArrays[] = {"verse_grip", "wireless_verse_grip", "custom_verse_grip"};
constexpr const char* kButtonNames[][2] = {{"a", "button_0"}, {"b", "button_1"}, {"c", "button_2"}, {"d", "button_3"}};

/// Reads a message. Qt bounds the nesting, refuses invalid UTF-8 and reads numbers independently of the locale; the
/// size is bounded by the connection.
std::optional<QJsonObject> objectOf(std::string_view json)
{
    const QJsonDocument document =
        QJsonDocument::fromJson(QByteArray::fromRawData(json.data(), static_cast<qsizetype>(json.size())));
    return document.isObject() ? std::optional(document.object()) : std::nullopt;
}

/// Numbers of an object, in the order of `names`. @return nothing: one is missing, or not finite
template<std::size_t count>
std::optional<std::array<double, count>> numbers(const QJsonValue& value, const char* const (&names)[count])
{
    const QJsonObject object = value.toObject();
    std::array<double, count> found{};
    for (std::size_t i = 0; i < count; ++i) {
        found[i] = object.value(QLatin1String(names[i])).toDouble(std::nan(""));
        if (!std::isfinite(found[i])) {
            return std::nullopt;
        }
    }
    return found;
}

std::optional<Vec3> vectorOf(const QJsonValue& value)
{
    const auto found = numbers(value, {"x", "y", "z"});
    return found ? std::optional(Vec3(found->data())) : std::nullopt;
}

std::optional<Quaternion> rotationOf(const QJsonValue& value)
{
    const auto found = numbers(value, {"w", "x", "y", "z"});
    if (!found) {
        return std::nullopt;
    }
    const Quaternion q((*found)[0], (*found)[1], (*found)[2], (*found)[3]);
    const double length = q.norm();
    return length > 0.5 && length < 2.0 ? std::optional(q.normalized()) : std::nullopt;
}

DeviceStatus statusOf(const QJsonObject& device)
{
    const QJsonObject status = device.value(QLatin1String("status")).toObject();
    const DeviceStatus usual;
    return {status.value(QLatin1String("power_supply")).toBool(usual.hasPower),
            status.value(QLatin1String("calibrated")).toBool(usual.isCalibrated),
            status.value(QLatin1String("ready")).toBool(usual.isReady),
            status.value(QLatin1String("in_use")).toBool(usual.isInUse)};
}

std::string idOf(const QJsonObject& device)
{
    return device.value(QLatin1String("device_id")).toString().toStdString();
}

/// Whether a transform is none. The service leaves out parts that are.
bool isIdentity(const QJsonObject& transform, bool mayMove)
{
    const auto position = vectorOf(transform.value(QLatin1String("position")));
    const auto rotation = rotationOf(transform.value(QLatin1String("rotation")));
    const auto scale = vectorOf(transform.value(QLatin1String("scale")));
    return (mayMove || !position || position->norm() < kTolerance) &&
           (!rotation || rotation->vec().norm() < kTolerance) &&
           (!scale || (*scale - Vec3::Ones()).norm() < kTolerance);
}

Axes axesOf(const QJsonObject& device, bool isCentred)
{
    const QJsonObject config = device.value(QLatin1String("config")).toObject();
    const QJsonObject transform =
        device.value(QLatin1String("state")).toObject().value(QLatin1String("transform")).toObject();
    if (!isIdentity(transform, false)) {
        return Axes::Other;
    }
    if (config.isEmpty()) {
        return Axes::Unstated;
    }
    const QString permutation =
        config.value(QLatin1String("basis")).toObject().value(QLatin1String("permutation")).toString();
    QJsonObject mount = config.value(QLatin1String("mount")).toObject();
    if (mount.value(QLatin1String("transform")).isObject()) {
        mount = mount.value(QLatin1String("transform")).toObject();
    }
    const bool isDefault =
        (permutation.isEmpty() || permutation == QLatin1String("XYZ")) && isIdentity(mount, isCentred);
    return isDefault ? Axes::Default : Axes::Other;
}

std::optional<std::uint32_t> buttonsOf(const QJsonObject& state)
{
    const QJsonValue wired = state.value(QLatin1String("button"));
    const QJsonValue wireless = state.value(QLatin1String("buttons"));
    if (wired.isBool()) {
        return wired.toBool() ? 1U : 0U;
    }
    if (!wireless.isObject()) {
        return std::nullopt;
    }
    const QJsonObject buttons = wireless.toObject();
    std::uint32_t mask = 0;
    for (std::size_t i = 0; i < std::size(kButtonNames); ++i) {
        for (const char* const name : kButtonNames[i]) {
            mask |= buttons.value(QLatin1String(name)).toBool() ? 1U << i : 0U;
        }
    }
    return mask;
}

void appendNumber(std::string& text, double value)
{
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr; // whatever the locale
    text.append(digits.data(), end);
}

/// An identifier as JSON. It comes from the service, and may contain anything.
std::string quoted(std::string_view id)
{
    const QByteArray json = QJsonDocument(QJsonArray{QString::fromUtf8(id.data(), static_cast<qsizetype>(id.size()))})
                                .toJson(QJsonDocument::Compact);
    return json.sliced(1, json.size() - 2).toStdString();
}

void appendForce(std::string& text, const Vec3& f_N, ForceKey key)
{
    text += R"("commands":{"set_cursor_force":{")";
    text += key == ForceKey::Vector ? "vector" : "values";
    constexpr const char* kAxes[] = {R"(":{"x":)", R"(,"y":)", R"(,"z":)"};
    for (int i = 0; i < 3; ++i) {
        text += kAxes[i];
        appendNumber(text, f_N[i]);
    }
    text += "}}}";
}

} // namespace

std::optional<Version> readVersion(std::string_view json)
{
    const std::optional<QJsonObject> page = objectOf(json);
    if (!page) {
        return std::nullopt;
    }
    const QJsonObject data = page->value(QLatin1String("data")).toObject(*page); // with or without an envelope
    const std::string text = data.value(QLatin1String("project_version")).toString().toStdString();
    const char* const end = text.data() + text.size();
    Version version;
    const auto major = std::from_chars(text.data(), end, version.major);
    if (major.ec != std::errc() || major.ptr == end || *major.ptr != '.' ||
        std::from_chars(major.ptr + 1, end, version.minor).ec != std::errc()) {
        return std::nullopt;
    }
    return version;
}

std::optional<Inventory> readInventory(std::string_view json)
{
    const std::optional<QJsonObject> message = objectOf(json);
    if (!message) {
        return std::nullopt;
    }
    Inventory inventory;
    inventory.isNew = message->contains(QLatin1String("session_id"));
    for (const QJsonValue value : message->value(QLatin1String("inverse3")).toArray()) {
        const QJsonObject device = value.toObject();
        const QJsonObject config = device.value(QLatin1String("config")).toObject();
        const QJsonObject info = config.value(QLatin1String("device_info")).toObject();
        Inventory::Device found;
        found.id = idOf(device);
        found.type = info.value(QLatin1String("device_type"))
                         .toString(config.value(QLatin1String("type")).toString())
                         .toLower()
                         .toStdString();
        found.status = statusOf(device);
        if (!found.id.empty()) {
            inventory.devices.push_back(std::move(found));
        }
    }
    for (const char* const name : kGripArrays) {
        for (const QJsonValue value : message->value(QLatin1String(name)).toArray()) {
            const std::string id = idOf(value.toObject());
            if (!id.empty()) {
                inventory.grips.push_back(id);
            }
        }
    }
    return inventory;
}

Reading readUpdate(std::string_view json, std::string_view deviceId, std::string_view gripId, bool isCentred,
                   Update& update)
{
    const std::optional<QJsonObject> message = objectOf(json);
    if (!message) {
        return Reading::Refused;
    }
    std::optional<QJsonObject> device;
    for (const QJsonValue value : message->value(QLatin1String("inverse3")).toArray()) {
        if (idOf(value.toObject()) == deviceId) {
            device = value.toObject();
            break;
        }
    }
    if (!device) {
        return Reading::Absent;
    }
    const QJsonObject state = device->value(QLatin1String("state")).toObject();
    const std::optional<Vec3> p_m = vectorOf(state.value(QLatin1String("cursor_position")));
    if (!p_m || p_m->cwiseAbs().maxCoeff() > kFarthest_m) {
        return Reading::Refused;
    }
    update.p_m = *p_m;
    update.f_N = vectorOf(state.value(QLatin1String("current_cursor_force")));
    update.status = statusOf(*device);
    update.axes = axesOf(*device, isCentred);
    update.q.reset();
    update.buttons.reset();
    if (!gripId.empty()) {
        for (const char* const name : kGripArrays) {
            for (const QJsonValue value : message->value(QLatin1String(name)).toArray()) {
                const QJsonObject grip = value.toObject();
                if (idOf(grip) == gripId) {
                    const QJsonObject gripState = grip.value(QLatin1String("state")).toObject();
                    update.q = rotationOf(gripState.value(QLatin1String("orientation")));
                    update.buttons = buttonsOf(gripState);
                }
            }
        }
    }
    return Reading::Valid;
}

std::string forceCommand(std::string_view deviceId, const Vec3& f_N, ForceKey key)
{
    std::string text = R"({"inverse3":[{"device_id":)" + quoted(deviceId) + ',';
    appendForce(text, f_N, key);
    return text + "}]}";
}

std::string firstCommand(std::string_view deviceId, ForceKey key, bool isCentred)
{
    std::string text =
        R"({"session":{"configure":{"profile":{"name":"org.palpate.palpate:touch"}}},"inverse3":[{"device_id":)" +
        quoted(deviceId) + R"(,"configure":{"basis":{"permutation":"XYZ"},)";
    // The service refuses a message with both.
    text += isCentred ? R"("preset":{"preset":"arm_front_centered"}},)"
                      : R"("mount":{"transform":{"position":{"x":0.0,"y":0.0,"z":0.0},)"
                        R"("rotation":{"w":1.0,"x":0.0,"y":0.0,"z":0.0},"scale":{"x":1.0,"y":1.0,"z":1.0}}}},)";
    appendForce(text, Vec3::Zero(), key);
    return text + "}]}";
}

std::string fullStateRequest()
{
    return R"({"session":{"force_render_full_state":{}}})";
}

} // namespace palpate::haply

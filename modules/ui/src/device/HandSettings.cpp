// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/HandSettings.h"

#include <palpate/device/DevicePresets.h>

#include <QSettings>

#include <algorithm>

namespace palpate::ui {

namespace {

constexpr double kLump_mm = 10.0;
constexpr double kRoom = 1.2; // size of the workspace relative to the filled region

QString key(const QString& id, const char* what)
{
    return QStringLiteral("devices/%1/%2").arg(id, QLatin1String(what));
}

int numberBelow(const QSettings& store, const QString& name, int fallback, int end)
{
    bool isNumber = false;
    const int value = store.value(name, fallback).toInt(&isNumber);
    return isNumber && value >= 0 && value < end ? value : fallback;
}

} // namespace

HandSettings HandSettings::load(const QSettings& store, const QString& id)
{
    HandSettings out;
    out.turn = static_cast<MapTurn>(numberBelow(store, key(id, "turn"), static_cast<int>(out.turn), 3));
    out.fill = static_cast<MapFill>(numberBelow(store, key(id, "fill"), static_cast<int>(out.fill), 4));
    bool isNumber = false;
    const double scale = store.value(key(id, "scale"), out.scale).toDouble();
    out.scale = scale >= 0.01 && scale <= 100.0 ? scale : 1.0;
    const int rate_kHz = store.value(key(id, "rate_kHz"), out.rate_kHz).toInt();
    out.rate_kHz = rate_kHz == 2 || rate_kHz == 4 ? rate_kHz : 1;
    out.cpu = store.value(key(id, "cpu"), out.cpu).toInt(&isNumber);
    out.cpu = isNumber && out.cpu >= 0 ? out.cpu : -1;
    out.isLeftHanded = store.value(key(id, "leftHanded"), false).toBool();
    out.isByEffort = store.value(key(id, "byEffort"), false).toBool();
    const double effort_N = store.value(key(id, "effort_N"), out.effort_N).toDouble();
    out.effort_N = effort_N >= Effort::kLeast_N && effort_N <= Effort::kMost_N ? effort_N : Effort::kUsual_N;
    out.preset = store.value(key(id, "preset"), QString::fromStdString(out.preset)).toString().toStdString();
    if (device::findDevicePreset(out.preset) == nullptr) {
        out.preset = HandSettings().preset;
    }
    for (int i = 0; i < kButtons; ++i) {
        ButtonUse& use = out.buttons[static_cast<std::size_t>(i)];
        use = static_cast<ButtonUse>(
            numberBelow(store, key(id, "button") + QString::number(i), static_cast<int>(use), 3));
    }
    return out;
}

void HandSettings::save(QSettings& store, const QString& id) const
{
    store.setValue(key(id, "turn"), static_cast<int>(turn));
    store.setValue(key(id, "fill"), static_cast<int>(fill == MapFill::Scale ? MapFill::Scale : MapFill::Scene));
    store.setValue(key(id, "scale"), scale);
    store.setValue(key(id, "rate_kHz"), rate_kHz);
    store.setValue(key(id, "cpu"), cpu);
    store.setValue(key(id, "leftHanded"), isLeftHanded);
    store.setValue(key(id, "byEffort"), isByEffort);
    store.setValue(key(id, "effort_N"), effort_N);
    store.setValue(key(id, "preset"), QString::fromStdString(preset));
    for (int i = 0; i < kButtons; ++i) {
        store.setValue(key(id, "button") + QString::number(i), static_cast<int>(buttons[static_cast<std::size_t>(i)]));
    }
}

std::uint32_t HandSettings::buttonsFor(ButtonUse use) const
{
    std::uint32_t bits = 0;
    for (std::uint32_t i = 0; i < kButtons; ++i) {
        const std::uint32_t bit = isLeftHanded && i < 2 ? 1 - i : i;
        bits |= buttons[i] == use ? 1U << bit : 0U;
    }
    return bits;
}

core::Box lumpAt(const core::Vec3& p_W)
{
    const core::Vec3 half = core::Vec3::Constant(0.5 * kLump_mm);
    return {p_W - half, p_W + half};
}

servo::MapSettings mapFor(const HandSettings& settings, const device::DeviceInfo& info, const HandPlace& place)
{
    servo::MapSettings map;
    const double edge_mm = servo::edgeOf(info);
    map.isDirect = !(edge_mm > 0.0) || settings.turn == MapTurn::None;
    if (map.isDirect) {
        return map;
    }
    Eigen::Matrix3d R_WU; // U: user frame, x right, y up, z towards the user
    if (settings.turn == MapTurn::Camera) {
        R_WU.col(0) = place.right_W;
        R_WU.col(1) = place.up_W;
        R_WU.col(2) = place.right_W.cross(place.up_W);
    } else {
        R_WU << 1, 0, 0, 0, 0, -1, 0, 1, 0; // patient's left, head, front in LPS
    }
    map.q_WD = (core::Quaternion(R_WU) * info.q_UD).normalized();
    if (settings.fill == MapFill::Scale) {
        map.scale = settings.scale;
    }
    if (!place.filled.isEmpty()) {
        const core::Vec3 size = place.filled.sizes();
        map.centre_W = place.filled.center();
        if (settings.fill != MapFill::Scale) {
            // The hand starts in front of the region and needs twice the range to reach its far side.
            const double way = info.isRateControlled ? 2.0 : 1.0;
            map.scale = servo::scaleToFill(way * kRoom * size.maxCoeff(), edge_mm);
        }
        if (info.isRateControlled) {
            const core::Vec3 towards = R_WU.col(2);
            map.centre_W += 0.5 * (size.dot(towards.cwiseAbs()) + (kRoom - 1.0) * size.maxCoeff()) * towards;
        }
    }
    map.edge_mm = info.isRateControlled ? 0.0 : edge_mm;
    map.clutchButtons = settings.buttonsFor(ButtonUse::Clutch);
    return map;
}

} // namespace palpate::ui

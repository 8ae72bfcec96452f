// SPDX-License-Identifier: BSD-3-Clause
#include "tables/MetaTable.h"

#include "database/Bounds.h"
#include "tables/Packing.h"

#include <palpate/core/Numbers.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

namespace palpate::session::internal {

namespace {

std::string text(double value)
{
    std::string out;
    core::appendNumber(out, value);
    return out;
}

/// Keys present only in recordings to which they apply.
constexpr std::pair<const char*, std::string RecordingInfo::*> kOptional[] = {
    {"scene_beside", &RecordingInfo::sceneBeside},
    {"scene_sha256", &RecordingInfo::sceneSha256},
    {"looks", &RecordingInfo::looks}};

/// Present only in a copy with ticks of an older version.
constexpr const char* kTickVersion = "tick_version";

/// Reads values from the table and keeps the first error.
class MetaReader
{
  public:
    explicit MetaReader(const MetaTable& meta)
        : m_meta(meta)
    {
    }

    const std::string& string(const char* key)
    {
        static const std::string kEmpty;
        const auto found = m_meta.find(key);
        if (found == m_meta.end()) {
            complain(core::Message(PALPATE_TEXT("meta has no value \"%1\""), key));
            return kEmpty;
        }
        return found->second;
    }

    double number(const char* key, double least, double most)
    {
        const auto value = core::parseNumber(string(key));
        if (!value || !(*value >= least && *value <= most)) {
            complain(core::Message(PALPATE_TEXT("meta value \"%1\" is not a valid number, expected %2 to %3"), key,
                                   least, most));
            return least;
        }
        return *value;
    }

    std::int64_t integer(const char* key, std::int64_t least, std::int64_t most)
    {
        const std::string& digits = string(key);
        std::int64_t value = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error != std::errc{} || end != digits.data() + digits.size()) {
            complain(core::Message(PALPATE_TEXT("meta value \"%1\" is not a whole number"), key));
        } else if (value < least || value > most) {
            complain(
                core::Message(PALPATE_TEXT("meta value \"%1\" is %2, expected %3 to %4"), key, value, least, most));
        }
        return std::clamp(value, least, most);
    }

    void complain(const core::Message& what)
    {
        if (m_complaint.isEmpty()) {
            m_complaint = what;
        }
    }

    const core::Message& complaint() const { return m_complaint; }

  private:
    const MetaTable& m_meta;
    core::Message m_complaint;
};

} // namespace

MetaTable toMeta(const RecordingInfo& info)
{
    MetaTable meta{
        {"palpate", info.palpate},
        {"build", info.build},
        {"started_utc", info.startedUtc},
        {"scene", info.scene},
        {"frame", "LPS"},
        {"unit", "mm"},
        {"rate_Hz", text(info.rate_Hz)},
        {"dt_s", text(info.dt_s)},
        {"device_id", info.device.id},
        {"device_name", info.device.name},
        {"device_buttons", std::to_string(info.device.buttons)},
        {"device_actuated_axes", std::to_string(info.device.actuatedAxes)},
        {"device_senses_orientation", info.device.sensesOrientation ? "1" : "0"},
        {"device_max_force_N", text(info.device.maxForce_N)},
        {"device_max_stiffness_N_per_mm", text(info.device.maxStiffness_N_per_mm)},
        {"device_max_damping_Ns_per_mm", text(info.device.maxDamping_Ns_per_mm)},
        {"device_workspace_radius_mm", text(info.device.workspaceRadius_mm)},
        {"device_rate_Hz", text(info.device.rate_Hz)},
        {"first_tick", std::to_string(info.firstTick)},
        {"first_generation", std::to_string(info.firstGeneration)},
        {"start", packState(info.start)},
    };
    for (const auto& [key, member] : kOptional) {
        if (!(info.*member).empty()) {
            meta[key] = info.*member;
        }
    }
    if (info.tickVersion < kRecordingVersion) {
        meta[kTickVersion] = std::to_string(info.tickVersion);
    }
    return meta;
}

bool isPeriodOf(double dt_s, double rate_Hz)
{
    constexpr double kRounding = 1e-9; // of a quotient with 17 digits
    return dt_s >= kMinPeriod_s && dt_s <= kMaxPeriod_s && std::abs(dt_s * rate_Hz - 1.0) <= kRounding;
}

core::Result<RecordingInfo> fromMeta(const MetaTable& meta)
{
    constexpr std::int64_t kMostNumber = 1'000'000; // of a device's buttons or axes
    MetaReader in(meta);
    RecordingInfo info;
    info.palpate = in.string("palpate");
    info.build = in.string("build");
    info.startedUtc = in.string("started_utc");
    info.scene = in.string("scene");
    for (const auto& [key, member] : kOptional) {
        if (const auto found = meta.find(key); found != meta.end()) {
            info.*member = found->second;
        }
    }
    if (meta.contains(kTickVersion)) {
        info.tickVersion = static_cast<int>(in.integer(kTickVersion, 1, kRecordingVersion));
    }
    info.rate_Hz = in.number("rate_Hz", 1.0 / kMaxPeriod_s, 1.0 / kMinPeriod_s);
    info.dt_s = in.number("dt_s", kMinPeriod_s, kMaxPeriod_s);
    if (!isPeriodOf(info.dt_s, info.rate_Hz)) {
        in.complain(core::Message(PALPATE_TEXT("meta value \"dt_s\" is not one period of \"rate_Hz\"")));
    }
    info.device.id = in.string("device_id");
    info.device.name = in.string("device_name");
    info.device.buttons = static_cast<int>(in.integer("device_buttons", 0, kMostNumber));
    info.device.actuatedAxes = static_cast<int>(in.integer("device_actuated_axes", 0, kMostNumber));
    info.device.sensesOrientation = in.string("device_senses_orientation") == "1";
    info.device.maxForce_N = in.number("device_max_force_N", 0.0, kMaxDeviceNumber);
    info.device.maxStiffness_N_per_mm = in.number("device_max_stiffness_N_per_mm", 0.0, kMaxDeviceNumber);
    info.device.maxDamping_Ns_per_mm = in.number("device_max_damping_Ns_per_mm", 0.0, kMaxDeviceNumber);
    info.device.workspaceRadius_mm = in.number("device_workspace_radius_mm", 0.0, kMaxDeviceNumber);
    info.device.rate_Hz = in.number("device_rate_Hz", 0.0, kMaxDeviceNumber);
    info.firstTick = in.integer("first_tick", -1, kMaxTick);
    info.firstGeneration =
        static_cast<std::uint32_t>(in.integer("first_generation", 0, std::numeric_limits<std::uint32_t>::max()));
    if (const auto state = unpackState(in.string("start"))) {
        info.start = *state;
    } else {
        in.complain(core::Message(PALPATE_TEXT("meta value \"start\" is not a state of this version")));
    }
    if (!in.complaint().isEmpty()) {
        return core::Status(core::StatusCode::BadFormat, in.complaint());
    }
    return info;
}

std::vector<std::pair<std::string, std::string>> hashedPairs(const MetaTable& meta)
{
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const auto& pair : meta) {
        if (pair.first != kComplete) {
            pairs.emplace_back(pair);
        }
    }
    return pairs;
}

std::string poseText(const StructureSource& source)
{
    std::string out;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column) {
            out += out.empty() ? "" : " ";
            core::appendNumber(out, source.X_WM(row, column));
        }
    }
    if (source.frame != core::FileFrame::Untagged) {
        out.append(" ").append(core::axesOf(source.frame));
    }
    return out;
}

void parsePose(std::string_view text, StructureSource& source)
{
    source.X_WM = core::Transform::Identity();
    source.frame = core::FileFrame::Untagged;
    const bool isCut = text.ends_with(' ');
    core::Transform X_WM = core::Transform::Identity();
    const auto takeWord = [&text] {
        const std::string_view word = text.substr(0, text.find(' '));
        text.remove_prefix(std::min(word.size() + 1, text.size()));
        return word;
    };
    for (int i = 0; i < 12; ++i) {
        const auto value = core::parseNumber(takeWord());
        if (!value) {
            return;
        }
        X_WM(i / 4, i % 4) = *value;
    }
    const auto frame = text.empty() ? core::FileFrame::Untagged : core::frameNamed(text);
    if (frame && !isCut) {
        source.X_WM = X_WM;
        source.frame = *frame;
    }
}

} // namespace palpate::session::internal

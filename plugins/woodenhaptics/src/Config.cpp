// SPDX-License-Identifier: BSD-3-Clause
#include "Config.h"

#include <hid/NumberFields.h>

#include <QJsonDocument>
#include <QJsonObject>

#include <fstream>
#include <iterator>

namespace palpate::woodenhaptics {

using core::Status;
using core::StatusCode;

namespace {

constexpr std::uintmax_t kLargestFile = 64 * 1024;

/// Blanks a trailing comma before a closing brace. Safe because the file contains no strings in which such a comma
/// could occur.
QByteArray withoutLastComma(std::string_view text)
{
    QByteArray out(text.data(), static_cast<qsizetype>(text.size()));
    qsizetype comma = -1;
    for (qsizetype i = 0; i < out.size(); ++i) {
        const char c = out[i];
        if (c == ',') {
            comma = i;
        } else if (c == '}' && comma >= 0) {
            out[comma] = ' ';
        } else if (c != ' ' && c != '\t' && c != '\r' && c != '\n') {
            comma = -1;
        }
    }
    return out;
}

} // namespace

core::Result<Config> parseConfig(std::string_view text, const std::string& name)
{
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(withoutLastComma(text), &error);
    if (!document.isObject()) {
        return Status(
            StatusCode::BadFormat,
            PALPATE_TEXT("%1: at byte %2: %3, expected an object of numbers, {\"length_body_a\": 0.080, ...}"), name,
            error.offset, error.errorString().toStdString());
    }
    Config c;
    double variant = 0.0;
    constexpr double kSmall = 1e-4; // lower bound for lengths used as divisors
    const hid::NumberField fields[] = {
        {"variant", &variant, 0, 1},
        {"diameter_capstan_a", &c.capstanDiameter_m[0], kSmall, 0.2},
        {"diameter_capstan_b", &c.capstanDiameter_m[1], kSmall, 0.2},
        {"diameter_capstan_c", &c.capstanDiameter_m[2], kSmall, 0.2},
        {"length_body_a", &c.linkLength_m[0], 0, 2},
        {"length_body_b", &c.linkLength_m[1], kSmall, 2},
        {"length_body_c", &c.linkLength_m[2], kSmall, 2},
        {"diameter_body_a", &c.bodyDiameter_m[0], kSmall, 2},
        {"diameter_body_b", &c.bodyDiameter_m[1], kSmall, 2},
        {"diameter_body_c", &c.bodyDiameter_m[2], kSmall, 2},
        {"workspace_origin_x", &c.origin_m[0], -2, 2},
        {"workspace_origin_y", &c.origin_m[1], -2, 2},
        {"workspace_origin_z", &c.origin_m[2], -2, 2},
        {"workspace_radius", &c.workspaceRadius_m, kSmall, 2},
        {"torque_constant_motor_a", &c.torqueConstant_Nm_per_A[0], kSmall, 10},
        {"torque_constant_motor_b", &c.torqueConstant_Nm_per_A[1], kSmall, 10},
        {"torque_constant_motor_c", &c.torqueConstant_Nm_per_A[2], kSmall, 10},
        {"current_for_10_v_signal", &c.fullScale_A, 0, 30},
        {"cpr_encoder_a", &c.countsPerTurn[0], 1, 1e6},
        {"cpr_encoder_b", &c.countsPerTurn[1], 1, 1e6},
        {"cpr_encoder_c", &c.countsPerTurn[2], 1, 1e6},
        {"max_linear_force", &c.maxForce_N, 0, 100},
        {"max_linear_stiffness", &c.maxStiffness_N_per_m, 0, 1e5},
        {"max_linear_damping", &c.maxDamping_Ns_per_m, 0, 1e3},
        {"mass_body_b", &c.massB_kg, 0, 10},
        {"mass_body_c", &c.massC_kg, 0, 10},
        {"length_cm_body_b", &c.centreB_m, -2, 2},
        {"length_cm_body_c", &c.centreC_m, -2, 2},
        {"g_constant", &c.gravity_m_per_s2, -20, 20},
        {"calibrate_enc_a", &c.calibrationCounts[0], -32768, 32767},
        {"calibrate_enc_b", &c.calibrationCounts[1], -32768, 32767},
        {"calibrate_enc_c", &c.calibrationCounts[2], -32768, 32767},
        {"calibrate_enc_d", &c.calibrationCounts[3], -32768, 32767},
        {"calibrate_enc_e", &c.calibrationCounts[4], -32768, 32767},
        {"calibrate_enc_f", &c.calibrationCounts[5], -32768, 32767},
    };
    if (Status status = hid::readNumbers(document.object(), fields, name); !status.isOk()) {
        return status;
    }
    c.variant = static_cast<int>(variant);
    return c;
}

core::Result<Config> readConfig(const std::filesystem::path& file)
{
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error || size > kLargestFile) {
        return Status(StatusCode::Unreadable, PALPATE_TEXT("%1: %2"), file,
                      error ? core::systemError(error.value())
                            : core::Message(PALPATE_TEXT("too large for a device's configuration")));
    }
    std::ifstream stream(file, std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    if (!stream) {
        return Status(StatusCode::Unreadable, PALPATE_TEXT("%1: could not be read"), file);
    }
    return parseConfig(text, file.string());
}

} // namespace palpate::woodenhaptics

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/FeltFile.h"

#include <palpate/meshio/VtpFile.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace palpate::study {

namespace {

using buried::FeltSurface;

QString text(std::string_view value)
{
    return QString::fromUtf8(value.data(), static_cast<qsizetype>(value.size()));
}

QJsonObject pressJson(const FeltSurface& felt, const FeltSurface::LumpPress& press, double press_mm)
{
    const bool isJudged = press.best.has_value();
    QJsonObject out;
    out["press_mm"] = press_mm;
    if (isJudged) {
        const core::Vec3& p_W = felt.surface.vertices[*press.best];
        out["best_p_mm"] = QJsonArray{p_W.x(), p_W.y(), p_W.z()};
    } else {
        out["best_p_mm"] = QJsonValue();
    }
    out["ratio"] = isJudged ? QJsonValue(press.felt.estimate) : QJsonValue();
    out["low"] = isJudged ? QJsonValue(press.felt.low) : QJsonValue();
    out["high"] = isJudged ? QJsonValue(press.felt.high) : QJsonValue();
    for (std::size_t i = 0; i < press.area_mm2.size(); ++i) {
        out[QStringLiteral("area_over_%1_mm2").arg(buried::kTold_percent[i])] = press.area_mm2[i];
    }
    out["verdict"] = text(buried::kVerdictNames[static_cast<std::size_t>(press.verdict)]);
    return out;
}

} // namespace

std::string feltJson(const meshio::LoadedScene& scene, std::span<const FeltOrgan> organs)
{
    QJsonArray lumps, notes;
    for (const FeltOrgan& one : organs) {
        for (const FeltSurface::Lump& lump : one.felt.lumps) {
            QJsonArray presses;
            for (std::size_t i = 0; i < lump.press.size(); ++i) {
                presses.append(pressJson(one.felt, lump.press[i], one.felt.press[i].press_mm));
            }
            const LumpOf& of = one.organ.lumps[lump.given];
            lumps.append(QJsonObject{
                {"name", text(lump.name)},
                {"inside", text(scene.structures[one.organ.organ].description.name)},
                {"young_ratio", lump.ratio},
                {"ratio_source", text(sourceText(of.source))},
                {"least_cover_mm", lump.leastCover_mm},
                {"press", presses},
            });
        }
        for (const std::string& note : one.felt.notes) {
            notes.append(text(note));
        }
    }
    const QJsonObject all{
        {"version", 1},
        {"radius_mm", organs.empty() ? QJsonValue() : QJsonValue(organs.front().felt.radius_mm)},
        {"lumps", lumps},
        {"notes", notes},
        {"warning", "estimate for research and rehearsal, not for diagnosis"},
    };
    return QJsonDocument(all).toJson().toStdString();
}

core::Result<std::string> feltVtp(std::span<const FeltOrgan> organs)
{
    meshio::VtpFile out;
    std::vector<double> ratio, low, high, cover;
    std::vector<std::int32_t> number, notJudged;
    std::int32_t lumpsBefore = 0;
    for (const FeltOrgan& one : organs) {
        const FeltSurface& felt = one.felt;
        const auto first = static_cast<std::uint32_t>(out.points.size());
        out.points.insert(out.points.end(), felt.surface.vertices.begin(), felt.surface.vertices.end());
        for (const geometry::Triangle& t : felt.surface.triangles) {
            out.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
        }
        const FeltSurface::Press& press = felt.press.front();
        ratio.insert(ratio.end(), press.ratio.begin(), press.ratio.end());
        low.insert(low.end(), press.low.begin(), press.low.end());
        high.insert(high.end(), press.high.begin(), press.high.end());
        cover.insert(cover.end(), felt.cover_mm.begin(), felt.cover_mm.end());
        for (const std::uint8_t lump : felt.lump) {
            number.push_back(lump == 0 ? 0 : lumpsBefore + lump);
        }
        notJudged.insert(notJudged.end(), felt.notJudged.begin(), felt.notJudged.end());
        lumpsBefore += static_cast<std::int32_t>(felt.lumps.size());
    }
    out.pointArrays.push_back({"FeltRatio", std::move(ratio)});
    out.pointArrays.push_back({"FeltRatioLow", std::move(low)});
    out.pointArrays.push_back({"FeltRatioHigh", std::move(high)});
    out.pointArrays.push_back({"Cover_mm", std::move(cover)});
    out.pointArrays.push_back({"Lump", std::move(number)});
    out.pointArrays.push_back({"NotJudged", std::move(notJudged)});
    return meshio::vtpBytes(out);
}

std::string lumpSentence(const FeltSurface::Lump& lump, const LumpOf& of)
{
    char out[160];
    std::snprintf(out, sizeof out, " (%.3g times as stiff, %s), %s", lump.ratio, sourceText(of.source).data(),
                  lump.leastCover_mm > 0.0 ? "" : "sticks out of the surface");
    std::string sentence = lump.name + out;
    if (lump.leastCover_mm > 0.0) {
        std::snprintf(out, sizeof out, "%.1f mm below at least", lump.leastCover_mm);
        sentence += out;
    }
    return sentence;
}

} // namespace palpate::study

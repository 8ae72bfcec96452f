// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/FeltFile.h"

#include <palpate/core/Numbers.h>
#include <palpate/meshio/VtpFile.h>

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
        out[QStringLiteral("area_over_%1_mm2").arg(buried::kDetectableChange_percent[i])] = press.area_mm2[i];
    }
    const auto verdict = [](buried::Verdict of) {
        return of == buried::Verdict::NotKnown ? QJsonValue()
                                               : QJsonValue(text(buried::kVerdictNames[static_cast<std::size_t>(of)]));
    };
    out["verdict"] = verdict(press.verdict);
    out["verdict_at_low_ratio"] = verdict(press.verdictAtLow);
    out["verdict_at_high_ratio"] = verdict(press.verdictAtHigh);
    return out;
}

QJsonValue ratioOrNull(const std::optional<StiffnessRatio>& ratio, double StiffnessRatio::*member)
{
    return ratio ? QJsonValue((*ratio).*member) : QJsonValue();
}

/// Calls `take` with the organ, the lump and the known ratio of each lump.
template<typename Take>
void forEachLump(std::span<const OrganPalpability> organs, const Take& take)
{
    for (const OrganPalpability& one : organs) {
        for (const FeltSurface::Lump& lump : one.felt.lumps) {
            take(one, lump, one.organ.lumps[lump.given]);
        }
    }
}

} // namespace

QJsonArray lumpsJson(const meshio::LoadedScene& scene, std::span<const OrganPalpability> organs)
{
    QJsonArray lumps;
    forEachLump(organs, [&](const OrganPalpability& one, const FeltSurface::Lump& lump, const SceneLump& of) {
        QJsonArray presses;
        for (std::size_t i = 0; i < lump.press.size(); ++i) {
            presses.append(pressJson(one.felt, lump.press[i], one.felt.press[i].press_mm));
        }
        lumps.append(QJsonObject{
            {"name", text(lump.name)},
            {"inside", text(scene.structures[one.organ.organ].description.name)},
            {"young_ratio", ratioOrNull(of.ratio, &StiffnessRatio::typical)},
            {"young_ratio_low", ratioOrNull(of.ratio, &StiffnessRatio::low)},
            {"young_ratio_high", ratioOrNull(of.ratio, &StiffnessRatio::high)},
            {"ratio_source", of.ratio ? QJsonValue(text(sourceText(of.ratio->source))) : QJsonValue()},
            {"ratio_citation", of.ratio ? text(of.ratio->citation) : QString()},
            {"least_cover_mm", lump.minCover_mm},
            {"press", presses},
        });
    });
    return lumps;
}

std::vector<core::Message> ratioQuestions(const meshio::LoadedScene& scene, std::span<const OrganPalpability> organs)
{
    std::vector<core::Message> questions;
    forEachLump(organs, [&](const OrganPalpability& one, const FeltSurface::Lump& lump, const SceneLump& of) {
        if (!of.ratio) {
            questions.push_back(ratioQuestion(lump.name, scene.structures[one.organ.organ].description.name));
        }
    });
    return questions;
}

std::string ratioText(const std::optional<StiffnessRatio>& ratio)
{
    if (!ratio) {
        return "stiffness ratio not known";
    }
    const std::string range = ratio->isRange()
                                  ? " (" + core::shortNumber(ratio->low) + " to " + core::shortNumber(ratio->high) + ")"
                                  : std::string();
    return core::shortNumber(ratio->typical, 3) + range + " times as stiff, " + std::string(sourceText(ratio->source));
}

std::vector<std::string> lumpLines(const meshio::LoadedScene& scene, std::span<const OrganPalpability> organs)
{
    std::vector<std::string> lines;
    forEachLump(organs, [&](const OrganPalpability& one, const FeltSurface::Lump& lump, const SceneLump& of) {
        std::string line =
            lump.name + " in " + scene.structures[one.organ.organ].description.name + ": " + ratioText(of.ratio);
        for (std::size_t i = 0; of.ratio && i < lump.press.size(); ++i) {
            const double press_mm = one.felt.press[i].press_mm;
            line += (press_mm > 0.0 ? "; pressed " + core::shortNumber(press_mm) + " mm: "
                                    : std::string("; touched lightly: ")) +
                    buried::verdictText(lump.press[i], lump.ratio);
        }
        lines.push_back(std::move(line));
    });
    return lines;
}

std::string feltJson(const meshio::LoadedScene& scene, std::span<const OrganPalpability> organs)
{
    QJsonArray notes;
    for (const OrganPalpability& one : organs) {
        for (const core::Message& note : one.felt.notes) {
            notes.append(text(note.english()));
        }
    }
    for (const core::Message& question : ratioQuestions(scene, organs)) {
        notes.append(text(question.english()));
    }
    const QJsonObject all{
        {"version", 1},
        {"radius_mm", organs.empty() ? QJsonValue() : QJsonValue(organs.front().felt.radius_mm)},
        {"lumps", lumpsJson(scene, organs)},
        {"notes", notes},
        {"warning", "estimate for research and rehearsal, not for diagnosis"},
    };
    return QJsonDocument(all).toJson().toStdString();
}

core::Result<std::string> feltVtp(std::span<const OrganPalpability> organs)
{
    meshio::VtpFile out;
    std::vector<double> ratio, low, high, cover;
    std::vector<std::int32_t> number, notJudged;
    std::int32_t lumpsBefore = 0;
    for (const OrganPalpability& one : organs) {
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

std::string lumpSentence(const FeltSurface::Lump& lump, const SceneLump& of)
{
    std::string cover = "sticks out of the surface";
    if (lump.minCover_mm > 0.0) {
        char out[64];
        std::snprintf(out, sizeof out, "%.1f mm below at least", lump.minCover_mm);
        cover = out;
    }
    const std::string citation =
        of.ratio && !of.ratio->citation.empty() ? " [" + std::string(of.ratio->citation) + "]" : std::string();
    return lump.name + " (" + ratioText(of.ratio) + citation + "), " + cover;
}

} // namespace palpate::study

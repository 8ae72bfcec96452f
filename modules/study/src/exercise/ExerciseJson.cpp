// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/ExerciseScore.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace palpate::study {

namespace {

QJsonValue numberOrNull(const std::optional<double>& value)
{
    return value ? QJsonValue(*value) : QJsonValue();
}

QString utf8(const std::string& value)
{
    return QString::fromStdString(value);
}

QJsonObject targetJson(const ScoredTarget& one)
{
    const core::Vec3& c = one.ball.centre_W;
    return {{"name", utf8(one.name)},
            {"center_mm", QJsonArray{c.x(), c.y(), c.z()}},
            {"radius_mm", one.ball.radius_mm},
            {"found", one.found_s.has_value()},
            {"found_s", numberOrNull(one.found_s)},
            {"distance_mm", numberOrNull(one.distance_mm)}};
}

} // namespace

std::string exerciseJson(const ExerciseScore& score)
{
    QJsonArray targets, findings, unmeasured, damaged;
    for (const ScoredTarget& one : score.targets) {
        targets.append(targetJson(one));
    }
    for (const ScoredFinding& one : score.findings) {
        findings.append(
            QJsonObject{{"id", utf8(one.finding.id)},
                        {"name", utf8(one.finding.name)},
                        {"marked_s", one.marked_s},
                        {"verdict", nameOf(one.verdict)},
                        {"target", one.target ? QJsonValue(utf8(score.targets[*one.target].name)) : QJsonValue()}});
    }
    for (const std::string& name : score.unmeasured) {
        unmeasured.append(utf8(name));
    }
    for (const core::Message& fault : score.damaged) {
        damaged.append(utf8(fault.english()));
    }
    const auto count = [&score](FindingVerdict verdict) { return static_cast<qint64>(score.count(verdict)); };
    const auto above = score.above.value_or(ForceAbove{});
    return QJsonDocument(QJsonObject{
                             {"time_limit_s", numberOrNull(score.exercise.time_s)},
                             {"force_ceiling_N", numberOrNull(score.exercise.force_ceiling_N)},
                             {"coverage_goal", numberOrNull(score.exercise.coverage_goal)},
                             {"within_mm", score.within_mm},
                             {"coverage_distance_mm", score.coverageDistance_mm},
                             {"duration_s", score.duration_s},
                             {"targets", targets},
                             {"findings", findings},
                             {"found", static_cast<qint64>(score.found())},
                             {"missed", static_cast<qint64>(score.targets.size() - score.found())},
                             {"false_alarms", count(FindingVerdict::FalseAlarm)},
                             {"found_again", count(FindingVerdict::Again)},
                             {"late", count(FindingVerdict::Late)},
                             {"searched_mm2", score.searched_mm2},
                             {"covered_mm2", score.covered_mm2},
                             {"coverage", numberOrNull(score.coverage())},
                             {"peak_force_N", score.peakForce_N},
                             {"time_above_s", score.above ? QJsonValue(above.time_s) : QJsonValue()},
                             {"impulse_above_Ns", score.above ? QJsonValue(above.impulse_Ns) : QJsonValue()},
                             {"lost_ticks", static_cast<qint64>(score.lostTicks)},
                             {"unmeasured", unmeasured},
                             {"damaged", damaged},
                         })
        .toJson()
        .toStdString();
}

} // namespace palpate::study

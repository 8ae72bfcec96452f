// SPDX-License-Identifier: BSD-3-Clause
#include "scene/SceneLaw.h"

#include "text/Fault.h"

#include "palpate/meshio/CurveFile.h"

namespace palpate::meshio::internal {

namespace {

using core::ForceLaw;
using core::LawKind;

void readKind(JsonFields& fields, LawKind& kind)
{
    std::string name, known;
    fields.read("kind", name);
    for (const LawKind one : core::kLawKinds) {
        if (name == core::lawName(one)) {
            kind = one;
            return;
        }
        known += (known.empty() ? "" : ", ") + std::string(core::lawName(one));
    }
    fields.fail("kind",
                fields.has("kind") ? core::Message(PALPATE_TEXT("%1"), inQuotes(name))
                                   : core::Message(PALPATE_TEXT("nothing")),
                {PALPATE_TEXT("one of %1"), known});
}

void readPoints(JsonFields& fields, const std::filesystem::path& folder, ForceLaw& law)
{
    std::string file;
    fields.read("file", file);
    if (file.empty() == !fields.has("points")) {
        fields.fail("points",
                    file.empty() ? core::Message(PALPATE_TEXT("nothing"))
                                 : core::Message(PALPATE_TEXT("both `points` and `file`")),
                    {PALPATE_TEXT("points [[depth_mm, force_N], …] or the file of a curve")});
        return;
    }
    if (file.empty()) {
        law.points = fields.pairs("points", ForceLaw::kMaxPoints);
        return;
    }
    auto points = readCurve((folder / std::filesystem::path(file)).lexically_normal());
    if (points.isOk()) {
        law.points = std::move(points).value();
    } else {
        fields.refuse("file", points.status());
    }
}

} // namespace

void readLaw(JsonFields& structure, const std::filesystem::path& folder, ForceLaw& law)
{
    auto fields = structure.fieldsOf("law");
    if (!fields) {
        return;
    }
    readKind(*fields, law.kind);
    law = core::usualLaw(law.kind);
    std::size_t i = 0;
    for (const core::LawParameter& term : core::lawParameters(law.kind)) {
        double& number = law.numbers[i++];
        if (term.isSwitch) {
            bool isOn = number != 0.0;
            fields->read(term.key.data(), isOn);
            number = isOn ? 1.0 : 0.0;
        } else {
            fields->read(term.key.data(), number, term.least, term.most);
        }
    }
    if (law.kind == LawKind::Points) {
        readPoints(*fields, folder, law);
    }
    if (const core::Status fault = core::check(law); !fault.isOk()) {
        structure.refuse("law", fault);
    }
    structure.keepUnknown("law", fields->unknown());
}

void writeLaw(const ForceLaw& law, QJsonObject& structure)
{
    QJsonObject out = structure.value("law").toObject();
    if (law.kind == LawKind::Linear && out.isEmpty()) {
        return;
    }
    out["kind"] = QLatin1String(core::lawName(law.kind).data());
    std::size_t i = 0;
    for (const core::LawParameter& term : core::lawParameters(law.kind)) {
        const double number = law.numbers[i++];
        out[term.key.data()] = term.isSwitch ? QJsonValue(number != 0.0) : QJsonValue(number);
    }
    if (law.kind == LawKind::Points) {
        QJsonArray points;
        for (const auto& [depth_mm, force_N] : law.points) {
            points.append(QJsonArray{depth_mm, force_N});
        }
        out["points"] = points;
    }
    structure["law"] = out;
}

} // namespace palpate::meshio::internal

// SPDX-License-Identifier: BSD-3-Clause
#include "Arrays.h"
#include "Bindings.h"
#include "Errors.h"
#include "LongCall.h"
#include "Scene.h"

#include <palpate/buried/FeltSurface.h>
#include <palpate/study/BuriedLumps.h>
#include <palpate/study/FeltFile.h>

#include <pybind11/stl.h>

#include <QJsonDocument>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace palpate::python {

namespace {

using Felt = std::vector<study::OrganPalpability>;

/// Returns an array with one row for each press. Copies, since the rows are separate in memory.
py::array rowsOf(const buried::FeltSurface& felt, std::vector<float> buried::FeltSurface::Press::*member)
{
    const std::size_t points = felt.surface.vertices.size();
    py::array_t<float> out({felt.press.size(), points});
    for (std::size_t i = 0; i < felt.press.size(); ++i) {
        const std::vector<float>& row = felt.press[i].*member;
        std::copy(row.begin(), row.end(), out.mutable_data(static_cast<py::ssize_t>(i), 0));
    }
    return out;
}

py::dict mapOf(const meshio::LoadedScene& scene, const std::shared_ptr<const Felt>& all, std::size_t number)
{
    const study::OrganPalpability& one = (*all)[number];
    const buried::FeltSurface& felt = one.felt;
    const py::capsule owner = ownerOf(all);
    std::vector<double> press_mm;
    for (const buried::FeltSurface::Press& press : felt.press) {
        press_mm.push_back(press.press_mm);
    }
    py::dict out;
    out["organ"] = toPython(scene.structures[one.organ.organ].description.name);
    out["radius_mm"] = felt.radius_mm;
    out["points"] = viewOf(felt.surface.vertices, owner);
    out["triangles"] = viewOf(felt.surface.triangles, owner);
    out["press_mm"] = py::array_t<double>(static_cast<py::ssize_t>(press_mm.size()), press_mm.data());
    out["ratio"] = rowsOf(felt, &buried::FeltSurface::Press::ratio);
    out["ratio_low"] = rowsOf(felt, &buried::FeltSurface::Press::low);
    out["ratio_high"] = rowsOf(felt, &buried::FeltSurface::Press::high);
    out["cover_mm"] = viewOf(felt.cover_mm, owner);
    out["lump"] = viewOf(felt.lump, owner);
    out["not_judged"] = viewOf(felt.notJudged, owner);
    out["lumps"] =
        parsedJson(QJsonDocument(study::lumpsJson(scene, {&one, 1})).toJson(QJsonDocument::Compact).toStdString());
    out["notes"] = toPython(felt.notes);
    return out;
}

py::list felt(const Scene& scene, const std::vector<double>& press_mm, std::optional<double> radius_mm,
              const std::map<std::string, double>& ratios)
{
    const meshio::LoadedScene& loaded = scene.loaded();
    auto all = valueOf(longCall([&](const std::atomic<bool>& isCancelled) -> core::Result<Felt> {
        const auto organs = study::organsWithLumps(loaded, ratios);
        if (!organs.isOk()) {
            return organs.status();
        }
        Felt out;
        for (const study::OrganWithLumps& organ : organs.value()) {
            buried::FeltOptions options;
            options.press_mm = press_mm;
            options.radius_mm = radius_mm.value_or(organ.radius_mm);
            options.progress = [&isCancelled](double) { return !isCancelled; };
            auto one = study::feltSurface(loaded, organ, options);
            if (!one.isOk()) {
                return one.status();
            }
            out.push_back({organ, std::move(one).value()});
        }
        return out;
    }));
    const auto shared = std::make_shared<const Felt>(std::move(all));
    py::list maps;
    for (std::size_t i = 0; i < shared->size(); ++i) {
        maps.append(mapOf(loaded, shared, i));
    }
    return maps;
}

} // namespace

void bindFelt(py::module_& module)
{
    using py::arg;
    module.def(
        "felt", &felt, arg("scene"), py::kw_only(), arg("press_mm") = std::vector<double>{0.0, 2.0, 4.0, 8.0},
        arg("radius_mm") = py::none(), arg("ratios") = std::map<std::string, double>(),
        "Compute how lumps change the stiffness of their organ's surface, as `palpate felt` does.\n\n"
        "press_mm: depths of the finger, ascending, at most 8 [mm]. radius_mm: contact radius of the finger,\n"
        "above 0 to 30 [mm]; None: as the scene says, else 5. ratios: Young's modulus of lumps over that of their\n"
        "organ, by name.\n"
        "Returns one dictionary for each organ: organ, radius_mm, points (n, 3) [mm] and triangles (m, 3) of the\n"
        "refined surface, press_mm (p,), ratio, ratio_low and ratio_high (p, n): stiffness over that without lumps,\n"
        "cover_mm (n,): depth of the lump below, NaN without one, lump (n,): number of the lump from 1, 0: none,\n"
        "not_judged (n,): sum of 1 too curved, 2 too thin, 4 lumps overlap, lumps: as in `palpate felt --json`,\n"
        "and notes. Points, triangles, cover_mm, lump and not_judged are read-only views without a copy.");
}

} // namespace palpate::python

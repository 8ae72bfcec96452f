// SPDX-License-Identifier: BSD-3-Clause
// Tests the effective map: values, units, the stability limit of the device, and the value at a position.
#include "TestRunner.h"

#include <palpate/study/FeltMap.h>

#include <cmath>
#include <limits>

using namespace palpate;
using core::MappedQuantity;
using core::MapUnit;

namespace {

constexpr float kUnsaid = std::numeric_limits<float>::quiet_NaN();

meshio::SurfaceMap mapOf(MappedQuantity quantity, MapUnit unit, std::vector<float> values)
{
    core::TissueMapping mapping;
    mapping.quantity = quantity;
    mapping.unit = unit;
    mapping.array = "a";
    return {mapping, false, std::move(values)};
}

core::Tissue tissueOf(double stiffness_N_per_mm)
{
    core::Tissue tissue;
    tissue.stiffness_N_per_mm = stiffness_N_per_mm;
    return tissue;
}

} // namespace

class FeltMap : public QObject
{
    Q_OBJECT
  private Q_SLOTS:
    void aScaleIsTimesTheTissuesOwn()
    {
        const auto map = mapOf(MappedQuantity::Stiffness, MapUnit::Scale, {0.5F, 2.0F, kUnsaid});
        const study::FeltMap felt = study::feltMap(map, tissueOf(0.4));
        QVERIFY(felt.unit == "N/mm" && std::abs(felt.values[0] - 0.2F) < 1e-6F && std::isnan(felt.values[2]));
        QVERIFY(std::abs(felt.least - 0.2) < 1e-6 && std::abs(felt.greatest - 0.8) < 1e-6);
        QCOMPARE(felt.own, 0.4);
        QVERIFY(std::abs(study::feltMap(map, tissueOf(0.4), 0.6).greatest - 0.6) < 1e-6); // limit of the device
    }
    void anotherLawIsScaledAndHasNoOneStiffness()
    {
        core::Tissue tissue = tissueOf(0.4);
        tissue.law = core::usualLaw(core::LawKind::Exponential);
        const study::FeltMap felt = study::feltMap(mapOf(MappedQuantity::Stiffness, MapUnit::NPerMm, {0.8F}), tissue);
        QVERIFY(felt.unit == "times the tissue's own" && std::abs(felt.values[0] - 2.0F) < 1e-6F);
        QCOMPARE(felt.own, 1.0);
    }
    void dampingAndFrictionHaveTheirUnits()
    {
        const auto damping = mapOf(MappedQuantity::Damping, MapUnit::NsPerMm, {0.001F});
        QVERIFY(study::feltMap(damping, tissueOf(0.4)).unit == "N·s/mm");
        const auto friction = mapOf(MappedQuantity::Friction, MapUnit::Scale, {3.0F});
        QCOMPARE(study::feltMap(friction, tissueOf(0.4)).greatest, 3.0);
    }
    void aPlaceIsBetweenTheCorners()
    {
        geometry::TriangleMesh mesh;
        mesh.vertices = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 0}, {0, 0, 0}, {4, 4, 0}};
        mesh.triangles = {{3, 4, 0}, {0, 1, 2}, {1, 5, 2}}; // the first triangle is degenerate and skipped
        meshio::LoadedStructure structure;
        structure.surface = std::make_shared<const geometry::RepairedMesh>(geometry::repair(mesh));
        std::vector<float> values;
        for (const core::Vec3& p : structure.surface->mesh.vertices) {
            values.push_back(static_cast<float>(1.0 + p.x() + 10.0 * p.y()));
        }
        const geometry::RepairedMesh& surface = *structure.surface;
        QVERIFY(std::abs(study::valueAt(surface, values, false, 0, {1, 0.5, 0}) - 7.0) < 1e-6);
        QVERIFY(std::abs(study::valueAt(surface, values, false, 1, {3, 2, 0}) - 24.0) < 1e-6);
        QVERIFY(std::isnan(study::valueAt(surface, {kUnsaid, kUnsaid, kUnsaid, kUnsaid}, false, 0, {1, 1, 0})));
        QCOMPARE(study::valueAt(surface, {2.0F, 3.0F}, true, 1, {3, 2, 0}), 3.0);
    }
};

PALPATE_TEST(FeltMap)
#include "tst_FeltMap.moc"

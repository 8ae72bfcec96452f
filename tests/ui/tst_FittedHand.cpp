// SPDX-License-Identifier: BSD-3-Clause
// The phantom under a mapped hand: for any fitting, rotation, clutching or centring while pressing, no force step
// exceeds the bound of the safety gate, and no change moves the hand through the liver's surface.
#include "TestRunner.h"

#include <palpate/device/DevicePresets.h>
#include <palpate/geometry/Inside.h>
#include <palpate/meshio/LoadScene.h>
#include <palpate/servo/PassivityController.h>
#include <palpate/servo/ServoCore.h>
#include <palpate/ui/HandSettings.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/view/SurfaceMesh.h>

#include <numbers>
#include <random>

using namespace palpate;
using core::Vec3;

namespace {

core::Box boxOf(vtkPolyData& picture)
{
    const double* b = picture.GetBounds();
    return {Vec3(b[0], b[2], b[4]), Vec3(b[1], b[3], b[5])};
}

} // namespace

class FittedHand : public QObject
{
    Q_OBJECT

    ui::StructureModel m_model;
    core::Box m_all;

    /// Builds the scene as the window does after a change of the mapping.
    std::shared_ptr<const haptics::HapticScene> sceneFor(const device::DeviceInfo& info, double scale) const
    {
        haptics::Tissue greatest = core::unbounded();
        greatest.stiffness_N_per_mm = servo::heldStiffness_N_per_mm(info, 1000.0, true) / scale;
        greatest.damping_Ns_per_mm = info.maxDamping_Ns_per_mm;
        return m_model.hapticScene(greatest);
    }

    /// Randomly changed settings and position of a hand.
    struct Changing
    {
        ui::HandSettings settings; // defaults for an unknown device
        ui::HandPlace place;
        std::mt19937 random{29};

        double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); }
    };
    /// @param lumpAt_W  position of the lump to fit, if any [mm]
    void change(Changing& hand, const Vec3& lumpAt_W) const
    {
        hand.settings.turn = hand.random() % 4 == 0 ? ui::MapTurn::Patient : ui::MapTurn::Camera;
        const double angle = hand.between(-0.6, 0.6);
        hand.place.right_W = Vec3(std::cos(angle), std::sin(angle), 0.0);
        switch (hand.random() % 4) {
        case 0:
            hand.settings.fill = ui::MapFill::Scene;
            hand.place.filled = m_all;
            break;
        case 1:
            hand.settings.fill = ui::MapFill::Organ;
            hand.place.filled = boxOf(*m_model.picture(0));
            break;
        case 2:
            hand.settings.fill = ui::MapFill::Lump;
            hand.place.filled = ui::lumpAt(lumpAt_W);
            break;
        default:
            hand.settings.fill = ui::MapFill::Scale;
            hand.settings.scale = hand.between(0.2, 3.0);
        }
    }

  private Q_SLOTS:
    void initTestCase()
    {
        auto loaded = meshio::loadScene(PALPATE_PHANTOM);
        QVERIFY2(loaded.isOk(), loaded.status().message().c_str());
        std::vector<ui::StructureRow> rows;
        for (meshio::LoadedStructure& one : loaded.value().structures) {
            ui::StructureRow row;
            row.loaded = std::move(one);
            row.picture = view::makeSurface(*row.loaded.surface);
            if (row.loaded.description.palpable) {
                row.touch =
                    std::make_shared<const geometry::SurfaceIndex>(geometry::SurfaceIndex::build(*row.loaded.surface));
            }
            m_all.extend(boxOf(*row.picture));
            rows.push_back(std::move(row));
        }
        QCOMPARE(rows.front().loaded.description.name, std::string("liver"));
        m_model.setRows(std::move(rows));
    }

    void changesUnderAPressingHandNeitherStepTheForceNorPullItThrough_data()
    {
        QTest::addColumn<QByteArray>("preset");
        for (const char* preset : {"woodenhaptics", "touch", "omega"}) {
            QTest::newRow(preset) << QByteArray(preset);
        }
    }
    void changesUnderAPressingHandNeitherStepTheForceNorPullItThrough()
    {
        QFETCH(const QByteArray, preset);
        const auto* found = device::findDevicePreset(preset.constData());
        QVERIFY(found != nullptr);
        const device::DeviceInfo info = device::deviceInfo(*found);
        const servo::GateLimits limits = servo::GateLimits::forDevice(info);
        const double bound_N = limits.maxForceRate_N_per_s * 0.001 * (1.0 + 1e-9);
        const geometry::SurfaceIndex& liver = *m_model.rows().front().touch;

        Changing hand;
        hand.place.right_W = Vec3::UnitX();
        hand.place.up_W = Vec3::UnitZ(); // from the front
        hand.place.filled = m_all;
        servo::ServoCore core(limits, 1000.0, servo::PassivityLimits::forDevice(info));
        servo::MapSettings map = ui::mapFor(hand.settings, info, hand.place);
        QVERIFY(!map.isDirect);
        core.setMap(map);
        std::uint32_t generation = 1;
        auto scene = sceneFor(info, map.scale);
        core.borrowScene(scene.get(), generation);

        int touched = 0, changes = 0, freed = 0;
        double mostStep_N = 0.0, most_N = 0.0;
        bool wasOut = false;
        Vec3 last_D = Vec3::Zero();
        Vec3 p_W = Vec3::Zero(), g_W = Vec3::Zero();
        bool isTouching = false;
        const double radius = servo::edgeOf(info);
        for (int i = 0; i < 40'000; ++i) {
            // Towards the user and back, about the middle, and occasionally beyond the edge.
            const double t = 0.001 * i;
            const Vec3 p_U(0.2 * radius * std::sin(0.7 * t), 0.2 * radius * std::cos(0.9 * t),
                           radius * (0.45 + 0.6 * std::cos(1.3 * t)));
            const Vec3 p_D = info.q_UD.conjugate() * p_U;
            if (i > 600 && hand.random() % 150 == 0) {
                ++changes;
                change(hand, isTouching ? g_W : p_W);
                const std::uint32_t before = map.centreRequest;
                map = ui::mapFor(hand.settings, info, hand.place);
                map.centreRequest = before + (!isTouching || hand.random() % 8 == 0 ? 1 : 0);
                map.isClutched = hand.random() % 10 == 0;
                core.setMap(map);
                auto next = sceneFor(info, map.scale); // kept alive until the core takes over
                core.borrowScene(next.get(), ++generation);
                scene = std::move(next);
            }
            device::DeviceState state;
            state.isPresent = true;
            state.p_D = p_D;
            state.time_ns = 1'000'000'000 + std::int64_t{i} * 1'000'000;
            const servo::TickRecord tick = core.tick(state, state.time_ns);
            const Vec3 f_D = core.forceForDevice();
            const double step_N = (f_D - last_D).norm();
            // A contact by motion of the hand causes force in the same tick; a change must not.
            QVERIFY2(step_N <= bound_N || last_D.norm() <= bound_N,
                     qPrintable(QStringLiteral("tick %1: %2 N").arg(i).arg(step_N)));
            mostStep_N = std::max(mostStep_N, last_D.norm() > bound_N ? step_N : 0.0);
            most_N = std::max(most_N, f_D.norm());
            last_D = f_D;
            p_W = tick.p_WH;
            g_W = tick.felt.p_WG;
            isTouching = tick.felt.structure >= 0;
            touched += isTouching ? 1 : 0;
            // outside the liver's constraint
            const bool isIn = tick.felt.structure != 0 && geometry::isInside(liver, p_W);
            if ((tick.flags & servo::kReset) != 0) {
                wasOut = false; // restarted, possibly inside: released
                freed += isIn ? 1 : 0;
            } else {
                QVERIFY2(!(wasOut && isIn), qPrintable(QStringLiteral("tick %1: through the surface").arg(i)));
            }
            wasOut = wasOut || !isIn;
        }
        qInfo("%s: %d changes, in contact in %d ticks, begun inside %d times, at most %.2f N, largest step %.3f N of "
              "%.3f N",
              preset.constData(), changes, touched, freed, most_N, mostStep_N, bound_N);
        QVERIFY(changes > 150 && touched > 4000 && freed > 0 && most_N > 0.3);
    }
};

PALPATE_TEST(FittedHand)
#include "tst_FittedHand.moc"

// SPDX-License-Identifier: BSD-3-Clause
// Tables of force laws compared with the laws in long double, and rejected input.
#include "Shapes.h"
#include "TestRunner.h"

#include <palpate/haptics/ForceTable.h>
#include <palpate/haptics/HapticScene.h>

#include <cmath>
#include <functional>
#include <random>

using namespace palpate;
using namespace palpate::test;
using core::ForceLaw;
using core::LawKind;
using haptics::ForceTable;

namespace {

using Real = long double;
using Table = std::shared_ptr<const ForceTable>;
using Formula = std::function<Real(Real)>;

constexpr int kDepths = 10000;
constexpr double kShare = 1e-7; // of the greatest force or energy that a table may be wrong by

haptics::Tissue tissueOf(LawKind kind, std::array<double, 5> numbers, std::vector<ForceLaw::Point> points = {})
{
    haptics::Tissue tissue;
    tissue.law = {kind, numbers, std::move(points)};
    return tissue;
}

/// A law's force and energy as its source has them.
struct Known
{
    const char* name;
    haptics::Tissue tissue;
    Formula force, energy;
};

Known exponential(const char* name, double k0, double beta, double most)
{
    const Real end = std::log(Real(most) / k0) / beta;
    const auto force = [=](Real d) { return k0 / Real(beta) * std::expm1(beta * d); };
    const auto energy = [=](Real d) { return k0 / (Real(beta) * beta) * (std::expm1(beta * d) - beta * d); };
    return {
        name, tissueOf(LawKind::Exponential, {k0, beta, most}),
        [=](Real d) { return d <= end ? force(d) : force(end) + most * (d - end); },
        [=](Real d) { return d <= end ? energy(d) : energy(end) + (d - end) * (force(end) + most * (d - end) / 2); }};
}

/// Hertz's law where the thickness is 0.
Known ball(const char* name, double young_kPa, double radius_mm, double thickness_mm, bool isBonded)
{
    const std::array<Real, 5> a = thickness_mm == 0.0 ? std::array<Real, 5>{1}
                                  : isBonded          ? std::array<Real, 5>{1, 1.133L, 1.283L, 0.769L, 0.0975L}
                                                      : std::array<Real, 5>{1, 0.884L, 0.781L, 0.386L, 0.0048L};
    // E* = E / (1 - 1/4) = 4/3 E, and F = 4/3 E* sqrt(R) d^1.5.
    const Real effective = Real(young_kPa) / 1000 / (1 - Real(0.25)), root = std::sqrt(Real(radius_mm));
    const Real perDepth = thickness_mm == 0.0 ? 0 : root / thickness_mm;
    const auto sum = [=](Real d, bool isEnergy) {
        Real total = 0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            const Real power = Real(1.5) + Real(i) / 2;
            const Real one = a[i] * std::pow(perDepth, Real(i)) * std::pow(d, power);
            total += isEnergy ? one * d / (power + 1) : one;
        }
        return Real(4) / 3 * effective * root * total;
    };
    return {name,
            thickness_mm == 0.0 ? tissueOf(LawKind::Hertz, {young_kPa, radius_mm})
                                : tissueOf(LawKind::Layer, {young_kPa, radius_mm, thickness_mm, isBonded ? 1.0 : 0.0}),
            [=](Real d) { return sum(d, false); }, [=](Real d) { return sum(d, true); }};
}

Known click(const char* name, double k1, double F1, double F2, double fall_mm, double k3)
{
    const Real top = Real(F1) / k1, foot = top + fall_mm, fall = (Real(F1) - F2) / fall_mm;
    return {name, tissueOf(LawKind::Click, {k1, F1, F2, fall_mm, k3}),
            [=](Real d) { return d <= top    ? k1 * d
                                 : d <= foot ? F1 - fall * (d - top)
                                             : F2 + k3 * (d - foot); },
            [=](Real d) {
                const Real rise = k1 * std::min(d, top) * std::min(d, top) / 2;
                const Real a = std::clamp(d - top, Real(0), Real(fall_mm)), b = std::max(d - foot, Real(0));
                return rise + a * (F1 - fall * a / 2) + b * (F2 + k3 * b / 2);
            }};
}

std::vector<Known> knownLaws()
{
    return {exponential("exponential", 0.1, 0.35, 2.0),
            exponential("exponential, straight at once", 0.5, 0.35, 0.5),
            exponential("exponential, never straight", 0.01, 0.05, 1000.0),
            exponential("exponential, as wide as it may be", 1e-6, 0.82, 1000.0),
            exponential("exponential, as steep as it may be", 1e-6, 10.0, 1000.0),
            ball("hertz", 10.0, 8.0, 0.0, true),
            ball("hertz, soft and sharp", 0.1, 0.01, 0.0, true),
            ball("hertz, stiff", 1000.0, 50.0, 0.0, true),
            ball("layer, bonded", 10.0, 8.0, 20.0, true),
            ball("layer, loose", 10.0, 8.0, 20.0, false),
            ball("layer, thin", 1.0, 8.0, 2.0, true),
            click("click", 0.5, 1.0, 0.6, 1.0, 0.5),
            click("click, steep", 1000.0, 1e-3, 0.0, 1e-3, 1e-6),
            click("click, deeper than the reach", 0.01, 1.0, 0.6, 1.0, 0.5)};
}

/// Forces that only rise, at uneven depths.
haptics::Tissue rising()
{
    return tissueOf(LawKind::Points, {},
                    {{0, 0}, {0.5, 0}, {0.502, 0.2}, {2, 0.3}, {2.2, 0.3}, {5, 4.0}, {12, 4.1}, {13, 40.0}});
}

Table tableOf(const haptics::Tissue& tissue)
{
    return ForceTable::build(tissue);
}

std::vector<Table> allTables()
{
    std::vector<Table> tables{tableOf(rising())};
    for (const Known& known : knownLaws()) {
        tables.push_back(tableOf(known.tissue));
    }
    return tables;
}

double depthAt(int i)
{
    return 1.2 * ForceTable::kReach_mm * (i / double(kDepths)) * (i / double(kDepths));
}

} // namespace

class ForceLaws : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void aTableIsItsLaw_data()
    {
        QTest::addColumn<int>("law");
        const std::vector<Known> laws = knownLaws();
        for (std::size_t i = 0; i < laws.size(); ++i) {
            QTest::newRow(laws[i].name) << static_cast<int>(i);
        }
    }
    void aTableIsItsLaw()
    {
        QFETCH(int, law);
        const Known known = knownLaws()[static_cast<std::size_t>(law)];
        const Table table = tableOf(known.tissue);
        QVERIFY(table != nullptr);
        const Real most_N = known.force(ForceTable::kReach_mm), most_mJ = known.energy(ForceTable::kReach_mm);
        Real worst_N = 0, worst_mJ = 0;
        for (int i = 0; i <= kDepths; ++i) {
            const double depth_mm = ForceTable::kReach_mm * i / kDepths;
            const ForceTable::Value value = table->at(depth_mm);
            QCOMPARE(table->force(depth_mm), value.force_N);
            worst_N = std::max(worst_N, std::abs(value.force_N - known.force(depth_mm)) / most_N);
            worst_mJ = std::max(worst_mJ, std::abs(value.energy_mJ - known.energy(depth_mm)) / most_mJ);
        }
        qInfo("%s: force %.1e, energy %.1e of the greatest; %zu knots", known.name, double(worst_N), double(worst_mJ),
              table->knots().size());
        QVERIFY(worst_N < kShare);
        QVERIFY(worst_mJ < kShare);
    }

    void theForceIsTheSlopeOfTheEnergy()
    {
        std::mt19937 random(4);
        std::uniform_real_distribution<double> share(0.0, 1.0);
        for (const Table& table : allTables()) {
            const double most_mJ = table->energy(ForceTable::kReach_mm);
            for (std::size_t i = 0; i + 1 < table->knots().size(); ++i) {
                const double from = table->knots()[i].depth_mm, length = table->knots()[i + 1].depth_mm - from;
                const double a = from + share(random) * length, b = from + share(random) * length;
                const double half = 0.5 * (b - a), middle = 0.5 * (a + b), node = half / std::sqrt(3.0);
                const double work_mJ =
                    half * (table->force(middle - node) + table->force(middle + node)); // Gauss: exact
                QVERIFY(std::abs(table->energy(b) - table->energy(a) - work_mJ) <= 1e-9 * most_mJ);
            }
        }
    }

    void whatRisesInMeasurementsRisesInTheTable()
    {
        const Table table = tableOf(rising());
        for (const ForceLaw::Point& point : rising().law.points) {
            QVERIFY(std::abs(table->force(point[0]) - point[1]) <= 1e-14 * 40.0);
        }
        double before = 0.0;
        for (int i = 0; i <= kDepths; ++i) {
            const double now = table->force(depthAt(i));
            QVERIFY(now >= before - 1e-12);
            before = now;
        }
        QVERIFY(table->force(0.4) == 0.0);
        QVERIFY(std::abs(table->force(2.1) - 0.3) < 1e-14);
    }

    void pointsOnALineAreTheLine()
    {
        const Table table = tableOf(tissueOf(LawKind::Points, {}, {{0, 0}, {1, 0.5}, {4, 2.0}, {5, 2.5}}));
        for (const double depth_mm : {0.3, 1.0, 3.9, 4.6, 5.0, 24.0, 400.0}) {
            QVERIFY(std::abs(table->force(depth_mm) - 0.5 * depth_mm) <= 1e-13 * depth_mm);
        }
        QVERIFY(std::abs(table->greatestSlope_N_per_mm() - 0.5) < 1e-12);
    }

    void itBeginsAtNothingAndNeverPullsIn()
    {
        const Table falling = tableOf(tissueOf(LawKind::Points, {}, {{0, 0}, {2, 2}, {3, 0.1}, {4, 0.05}}));
        QCOMPARE(falling->force(1000.0), falling->force(4.0)); // falling at the last measured point
        std::vector<Table> tables = allTables();
        tables.push_back(falling);
        for (const Table& table : tables) {
            for (const double none : {0.0, -0.0, -1.0, std::nan("")}) {
                QCOMPARE(table->at(none).force_N, 0.0);
                QCOMPARE(table->at(none).energy_mJ, 0.0);
            }
            QVERIFY(table->at(1e-300).force_N >= 0.0);
            for (int i = 0; i <= kDepths; ++i) {
                QVERIFY(table->force(depthAt(i)) >= 0.0);
            }
        }
    }

    void theGreatestSlopeIsAsGreatAsAny()
    {
        for (const Table& table : allTables()) {
            double found = 0.0;
            for (int i = 0; i <= kDepths; ++i) {
                found = std::max(found, table->slope(depthAt(i)));
                const double d = depthAt(i), step = 1e-4;
                found = std::max(found, (table->force(d + step) - table->force(d)) / step - 1e-9);
            }
            for (std::size_t i = 0; i + 1 < table->knots().size(); ++i) {
                const ForceTable::Knot &from = table->knots()[i], &to = table->knots()[i + 1];
                found = std::max({found, from.slopeAfter, to.slopeAfter});
                for (double share = 0.05; share < 1.0; share += 0.05) {
                    found = std::max(found, table->slope(from.depth_mm + share * (to.depth_mm - from.depth_mm)));
                }
            }
            const double told = table->greatestSlope_N_per_mm();
            QVERIFY2(found <= told * (1.0 + 1e-9), qPrintable(QString("%1 > %2").arg(found).arg(told)));
            QVERIFY2(found >= 0.999 * told, qPrintable(QString("%1 < %2").arg(found).arg(told)));
        }
    }

    void bytesGiveTheSameTable()
    {
        for (const Table& table : allTables()) {
            const auto again = ForceTable::fromBytes(table->bytes());
            QVERIFY(again.isOk());
            QVERIFY(*again.value() == *table);
            for (int i = 0; i <= kDepths; i += 7) {
                QCOMPARE(again.value()->force(depthAt(i)), table->force(depthAt(i)));
                QCOMPARE(again.value()->energy(depthAt(i)), table->energy(depthAt(i)));
            }
        }
        QVERIFY(!(*tableOf(rising()) == *tableOf(knownLaws()[0].tissue)));
    }

    void knotsThatAreNoLawAreRefused_data()
    {
        using Knots = std::vector<ForceTable::Knot>;
        const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
        QTest::addColumn<QVector<double>>("numbers");
        QTest::addColumn<QString>("word");
        const auto row = [](const char* name, const Knots& knots, const char* word) {
            QVector<double> numbers;
            for (const ForceTable::Knot& k : knots) {
                numbers << k.depth_mm << k.force_N << k.slopeBefore << k.slopeAfter;
            }
            QTest::newRow(name) << numbers << QString(word);
        };
        row("nothing", {}, "0 knots");
        row("too many", Knots(1025), "bytes");
        row("a force at the surface", {{0, 0.1, 1, 1}}, "knot 1 of 1");
        row("begins in the air", {{0.1, 0, 1, 1}}, "knot 1 of 1");
        row("no number", {{0, 0, 1, 1}, {1, nan, 1, 1}}, "knot 2 of 2");
        row("no number as a slope", {{0, 0, 1, nan}}, "not finite");
        row("infinite", {{0, 0, 1, 1}, {inf, 1, 1, 1}}, "not finite");
        row("back up", {{0, 0, 1, 1}, {1, 1, 1, 1}, {0.5, 1, 1, 1}}, "knot 3 of 3");
        row("twice the same depth", {{0, 0, 1, 1}, {0, 0, 1, 1}}, "not deeper");
        row("a negative force", {{0, 0, 1, 1}, {1, -1, 1, 1}}, "below 0");
        row("a negative force between", {{0, 0, 1, -1000}, {1, 0, 1, 1}}, "below 0");
        row("a cliff", {{0, 0, 1, 1}, {1, 1e4, 1, 1}}, "steeper");
        row("steep at a knot", {{0, 0, 1, 1e5}, {1, 1, 1, 1}}, "steeper");
        row("an end that pulls in", {{0, 0, 1, 1}, {1, 1, 1, -0.1}}, "ends");
        row("an end too steep", {{0, 0, 1, 1e9}}, "ends");
        row("as deep as the earth", {{0, 0, 0, 0}, {1e10, 1, 0, 0}}, "ends");
    }
    void knotsThatAreNoLawAreRefused()
    {
        QFETCH(QVector<double>, numbers);
        QFETCH(QString, word);
        const auto table =
            ForceTable::fromBytes(std::as_bytes(std::span(numbers.constData(), std::size_t(numbers.size()))));
        QVERIFY(!table.isOk());
        QVERIFY2(QString::fromStdString(table.status().message()).contains(word), table.status().message().c_str());
    }

    void bytesWithErrorsNeverGiveAForceWithoutBound()
    {
        std::mt19937 random(13);
        const std::vector<Table> tables = allTables();
        int taken = 0;
        for (int round = 0; round < 20000; ++round) {
            std::vector<std::byte> bytes = tables[static_cast<std::size_t>(round) % tables.size()]->bytes();
            for (unsigned i = 0; i <= random() % 3; ++i) {
                bytes[random() % bytes.size()] ^= std::byte(1U << random() % 8);
            }
            bytes.resize(bytes.size() - (round % 10 == 0 ? random() % bytes.size() : 0));
            const auto table = ForceTable::fromBytes(bytes);
            if (!table.isOk()) {
                continue;
            }
            ++taken;
            for (int i = 0; i <= kDepths; i += 501) {
                const double force_N = table.value()->force(depthAt(i)), most = 2.0 * ForceTable::kMaxSlope;
                QVERIFY(force_N >= -1e-6 && force_N <= most * depthAt(i));
                QVERIFY(std::isfinite(table.value()->energy(depthAt(i))));
            }
        }
        QVERIFY(taken > 1000);
    }

    void aDeviceThatHoldsLessFeelsTheLawAsFarAsItCan()
    {
        QVERIFY(ForceTable::bounded(nullptr, 1.0) == nullptr);
        for (const Table& table : allTables()) {
            QVERIFY(ForceTable::bounded(table, table->greatestSlope_N_per_mm()) == table);
            for (const double most : {0.9 * table->greatestSlope_N_per_mm(), 0.4, 0.01, 1e-5}) {
                const Table flat = ForceTable::bounded(table, most);
                QVERIFY2(flat->greatestSlope_N_per_mm() <= most * (1.0 + 1e-5) + 1e-6,
                         qPrintable(QString("%1 > %2").arg(flat->greatestSlope_N_per_mm()).arg(most)));
                QVERIFY(ForceTable::fromBytes(flat->bytes()).isOk());
                // The largest force below the law that rises no faster, step by step: a step behind at most.
                const double step = 0.01;
                double most_N = 0.0;
                for (double d = 0.0; d < 60.0; d += step) {
                    most_N = std::min(most_N + most * step, table->force(d));
                    const double found = flat->force(d);
                    QVERIFY2(found <= table->force(d) + 1e-7 && found >= 0.0, qPrintable(QString::number(d)));
                    QVERIFY2(std::abs(found - most_N) <= 2.0 * most * step + 1e-7, qPrintable(QString::number(d)));
                    most_N = std::max(most_N, 0.0);
                }
            }
        }
    }

    void aSceneMakesTheTablesThatItNeeds()
    {
        const auto surface = indexed(sphere(8, 20.0));
        const Table own = tableOf(rising());
        std::vector<haptics::HapticStructure> structures{{"linear", surface, {}, 0},
                                                         {"hertz", surface, knownLaws()[5].tissue, 0},
                                                         {"recorded", surface, knownLaws()[5].tissue, 0}};
        structures[2].law = own;
        const haptics::HapticScene scene(std::move(structures));
        QVERIFY(scene.structures()[0].law == nullptr);
        QVERIFY(*scene.structures()[1].law == *tableOf(knownLaws()[5].tissue));
        QVERIFY(scene.structures()[2].law == own);
    }

    void numbersThatAreNoLawAreRefused_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addColumn<QVector<double>>("numbers");
        QTest::addColumn<QString>("word");
        const auto row = [](const char* name, LawKind kind, const QVector<double>& numbers, const char* word) {
            QTest::newRow(name) << static_cast<int>(kind) << numbers << QString(word);
        };
        row("a negative stiffness", LawKind::Exponential, {-1, 0.35, 2}, "k0_N_per_mm: found -1");
        row("no number", LawKind::Exponential, {0.1, std::nan(""), 2}, "beta_per_mm: found nan");
        row("infinite", LawKind::Hertz, {std::numeric_limits<double>::infinity(), 8}, "young_kPa: found inf");
        row("steeper at the start than it may get", LawKind::Exponential, {3, 0.35, 2},
            "expected at most 2 (k_max_N_per_mm)");
        row("no radius", LawKind::Hertz, {10, 0}, "radius_mm: found 0");
        row("no thickness", LawKind::Layer, {10, 8, 0, 1}, "thickness_mm: found 0");
        row("falls upwards", LawKind::Click, {0.5, 1, 1.5, 1, 0.5}, "F2_N: found 1.5, expected at most 1 (F1_N)");
        row("falls off a cliff", LawKind::Click, {0.5, 20, 1, 0.001, 0.5}, "falls by 19000 N/mm");
        row("one point", LawKind::Points, {0, 0}, "found 1 points, expected 2 to 64");
        row("65 points", LawKind::Points, QVector<double>(130), "found more points, expected 2 to 64");
        row("a force at the surface", LawKind::Points, {0, 0.1, 1, 1}, "point 1 of 2: found (0 mm, 0.1 N)");
        row("back up", LawKind::Points, {0, 0, 2, 1, 1, 2},
            "point 3 of 3: found (1 mm, 2 N), expected a depth of 2.001 to 1000 mm");
        row("twice the same depth", LawKind::Points, {0, 0, 1, 1, 1, 1}, "point 3 of 3");
        row("a negative force", LawKind::Points, {0, 0, 1, -0.5}, "point 2 of 2: found (1 mm, -0.5 N)");
        row("a point that is no number", LawKind::Points, {0, 0, 1, std::nan("")}, "point 2 of 2: found (1 mm, nan N)");
        row("too steep", LawKind::Points, {0, 0, 1, 1001}, "a slope of 1001 N/mm");
        row("too steep down", LawKind::Points, {0, 0, 2, 2000, 3, 0}, "a slope of -2000 N/mm");
    }
    void numbersThatAreNoLawAreRefused()
    {
        QFETCH(int, kind);
        QFETCH(QVector<double>, numbers);
        QFETCH(QString, word);
        haptics::Tissue tissue;
        tissue.law.kind = static_cast<LawKind>(kind);
        if (tissue.law.kind == LawKind::Points) {
            for (int i = 0; i < numbers.size(); i += 2) {
                tissue.law.points.push_back({numbers[i], numbers[i + 1]});
            }
        } else {
            std::copy(numbers.begin(), numbers.end(), tissue.law.numbers.begin());
        }
        const core::Status found = core::check(tissue.law);
        QVERIFY(!found.isOk());
        QVERIFY2(QString::fromStdString(found.message()).contains(word), found.message().c_str());
        QVERIFY(tableOf(tissue) == nullptr);
    }

    void whatALawUsuallyIsIsALaw()
    {
        for (const LawKind kind : core::kLawKinds) {
            haptics::Tissue tissue;
            tissue.law = core::usualLaw(kind);
            QVERIFY2(core::check(tissue.law).isOk(), core::check(tissue.law).message().c_str());
            QCOMPARE(tableOf(tissue) == nullptr, kind == LawKind::Linear);
        }
    }
};

PALPATE_TEST(ForceLaws)
#include "tst_ForceLaws.moc"

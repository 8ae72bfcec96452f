// SPDX-License-Identifier: BSD-3-Clause
// Random scenes and hands against the engine, with independent checks in every tick. The line of a failure starts with
// the command to repeat the case: adversary FAMILY SEED.
#include "Game.h"
#include "TestRunner.h"

using namespace palpate::adversary;

namespace {

// Allowed fraction of ticks at the work bound. Balls have ten times as many: they start deep, among hundreds of
// structures, where a ball searches its room and moves in small steps, and are up to the size of the scene.
constexpr double kMostAtBound = 1e-4;
constexpr double kMostOfBallsAtBound = 1e-3;

/// @param first  seed; PALPATE_SEED overrides the value
void checkFamily(Family family, std::uint64_t first, std::int64_t ticks)
{
    bool isGiven = false;
    const qulonglong given = qEnvironmentVariable("PALPATE_SEED").toULongLong(&isGiven);
    first = isGiven ? given : first;
    qInfo("%s, seeds from %llu", nameOf(family), static_cast<unsigned long long>(first));
    const Tally tally = playMany(family, first, ticks);
    for (const std::string& line : tally.lines) {
        qWarning("%s", line.c_str());
    }
    qInfo("%s", tally.summary().c_str());
    QVERIFY(tally.inContact > tally.ticks / 5); // the hand is in contact often enough
    QVERIFY2(tally.lines.empty(), tally.summary().c_str());
    const bool hasBalls = family == Family::Balls || family == Family::Moving || family == Family::RoughBalls;
    const double most = hasBalls ? kMostOfBallsAtBound : kMostAtBound;
    QVERIFY2(static_cast<double>(tally.atBound) < most * static_cast<double>(tally.ticks), tally.summary().c_str());
}

} // namespace

/// 2.7 million ticks in total.
class Adversary : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void closed() { checkFamily(Family::Closed, 1, 300000); }
    void open() { checkFamily(Family::Open, 1, 300000); }
    void layers() { checkFamily(Family::Layers, 1, 200000); }
    void balls() { checkFamily(Family::Balls, 1, 200000); }
    void rough() { checkFamily(Family::Rough, 1, 1200000); }
    void roughballs() { checkFamily(Family::RoughBalls, 1, 400000); }
    void moving() { checkFamily(Family::Moving, 1, 60000); }
};

/// Seeds of earlier failures, up to the failing tick.
class FoundSeeds : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void stayRight_data()
    {
        QTest::addColumn<Family>("family");
        QTest::addColumn<quint64>("seed");
        QTest::addColumn<int>("ticks");
        const auto row = [](const char* what, Family family, quint64 seed, int lastTick) {
            QTest::addRow("%s: %s %llu", what, nameOf(family), static_cast<unsigned long long>(seed))
                << family << seed << lastTick + 1;
        };
        row("a free way shorter than rounding ends beside the HIP", Family::Closed, 1000731, 713);
        row("planes at shallow angles lead away from the HIP", Family::Closed, 1001218, 788);
        row("planes at shallow angles lead away from the HIP", Family::Closed, 1007036, 211);
        row("a facet stops a move in its plane far before it", Family::Layers, 1003802, 233);
        row("a contact is lost to the rounding of a larger structure", Family::Rough, 5249, 3724);
        row("a facet holds a ball that came around its rim", Family::RoughBalls, 201, 2579);
        row("a facet holds a ball that came around its rim", Family::RoughBalls, 286, 149);
        row("a facet holds a ball that came around its rim", Family::RoughBalls, 313, 2213);
        row("a facet holds a ball that came around its rim", Family::Balls, 50251, 3537);
        row("a facet holds a ball that came around its rim", Family::Balls, 50355, 3481);
        row("a facet is met late by a move in its plane", Family::Closed, 3102114, 1857);
        row("a facet is met by a move in its plane that stays beside it", Family::Layers, 1003111, 399);
        row("two planes, one to rounding, cross far beside their edge", Family::Closed, 3100175, 1315);
        row("of facets that hold in turn one is told to friction", Family::Rough, 3100098, 401);
        row("of facets that hold in turn one is told to friction", Family::Rough, 3100599, 846);
        row("of facets that hold in turn one is told to friction", Family::Rough, 3102136, 98);
        row("of facets that hold in turn one is told to friction", Family::Rough, 3102177, 1484);
        row("of facets that hold in turn one is told to friction", Family::Rough, 5101501, 1814);
        row("a ball rests short of a contact with a small structure", Family::RoughBalls, 4100280, 2097);
        row("a ball rests short of a contact with a small structure", Family::RoughBalls, 4101469, 1618);
        row("a small ball's normal is rounded far from the origin", Family::RoughBalls, 4102172, 2344);
        row("a contact reached but for the last slight gain is dropped", Family::RoughBalls, 4100782, 1240);
        row("it lags behind on what does not drag", Family::Rough, 3101374, 2218);
        row("judged by a map's slope on a sliver", Family::Rough, 9237, 1060);
        row("judged by a map's slope on a sliver", Family::Rough, 20069, 15);
        row("judged by a map's slope on a sliver", Family::Rough, 700031, 1728);
        row("motions of one shape swap their god-objects", Family::Moving, 7, 1056);
        row("motions of one shape swap their god-objects", Family::Moving, 18, 462);
    }
    void stayRight()
    {
        QFETCH(const Family, family);
        QFETCH(const quint64, seed);
        QFETCH(const int, ticks);
        Tally tally;
        play(family, seed, ticks, tally);
        QVERIFY(tally.inContact > 0);
        QVERIFY2(tally.lines.empty(), tally.lines.empty() ? "" : tally.lines.front().c_str());
    }
};

/// 140 million ticks in total, from other seeds.
class LongAdversary : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void closed() { checkFamily(Family::Closed, 1000001, 30000000); }
    void open() { checkFamily(Family::Open, 1000001, 30000000); }
    void layers() { checkFamily(Family::Layers, 1000001, 20000000); }
    void balls() { checkFamily(Family::Balls, 1000001, 20000000); }
    void rough() { checkFamily(Family::Rough, 1000001, 20000000); }
    void roughballs() { checkFamily(Family::RoughBalls, 1000001, 10000000); }
    void moving() { checkFamily(Family::Moving, 1000001, 10000000); }
};

/// Few enough ticks for the sanitizers; the other classes check the engine's behaviour.
class ShortAdversary : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void runs()
    {
        for (int family = 0; family < kFamilies; ++family) {
            const Tally tally = playMany(static_cast<Family>(family), 1, kTicksOfSeed);
            QVERIFY(tally.ticks > 0 && tally.inContact > 0);
        }
    }
    void aSeedGivesTheSameTwice()
    {
        Tally first, second;
        play(Family::Layers, 7, 2000, first);
        play(Family::Layers, 7, 2000, second);
        QCOMPARE(first.summary(), second.summary());
        QVERIFY(first.lines == second.lines);
    }
};

PALPATE_TEST(Adversary)
PALPATE_TEST(LongAdversary)
PALPATE_TEST(FoundSeeds)
PALPATE_TEST(ShortAdversary)
#include "tst_Adversary.moc"

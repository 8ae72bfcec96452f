// SPDX-License-Identifier: BSD-3-Clause
// Ticks that end at the work bound must end at the same position whatever is cached: the work charged depends only on
// the scene, the god-object and the HIP. A small fraction of the usual work makes such ticks frequent.
#include "RandomHand.h"
#include "SameBits.h"
#include "TestRunner.h"

#include <palpate/haptics/Palpator.h>

using namespace palpate::adversary;
using palpate::haptics::Fingertips;
using palpate::haptics::GodObjectLimits;
using palpate::haptics::Palpator;
using palpate::haptics::TickResult;
using palpate::haptics::TickStatus;

namespace {

constexpr int kTicks = 2000, kEach = 5; // per seed; between two restores
constexpr double kTick_s = 1e-3;

struct Compared
{
    std::int64_t ticks = 0, atBound = 0, restored = 0, differ = 0;
    QString first; ///< first difference
};

void compare(Family family, std::uint64_t seed, Compared& tally)
{
    Chance chance(seed);
    const RandomScene scene = randomScene(family, chance);
    const auto built = scene.build((1u << scene.layers) - 1);
    RandomHand hand(scene, chance.is(0.5), chance.bits());
    const auto work = static_cast<std::uint32_t>(chance.magnitude(300.0, 5000.0));
    const GodObjectLimits limits{.work = work, .ballWork = work};
    Palpator palpator(Fingertips::Any, limits), restored(Fingertips::Any, limits);
    palpator.borrowScene(built.get());
    restored.borrowScene(built.get());
    for (int tick = 0; tick < kTicks; ++tick) {
        if (tick % kEach == 0) {
            restored.restore(palpator.state());
            ++tally.restored;
        }
        const palpate::core::Vec3 hip = hand.next();
        const TickResult a = palpator.step(hip, kTick_s), b = restored.step(hip, kTick_s);
        ++tally.ticks;
        tally.atBound += a.status == TickStatus::IterationLimit ? 1 : 0;
        if (!sameBits(a, b) && tally.differ++ == 0) {
            tally.first = QString("%1 %2, tick %3, %4 units, %5: %6 mm apart, %7 and %8 moves, status %9 and %10")
                              .arg(nameOf(family))
                              .arg(seed)
                              .arg(tick)
                              .arg(work)
                              .arg(scene.name.c_str())
                              .arg((a.p_WG - b.p_WG).norm())
                              .arg(a.iterations)
                              .arg(b.iterations)
                              .arg(static_cast<int>(a.status))
                              .arg(static_cast<int>(b.status));
        }
    }
}

} // namespace

class EarlyEnds : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void areTheSameWhateverIsHeld_data()
    {
        QTest::addColumn<Family>("family");
        QTest::addColumn<quint64>("first");
        QTest::addColumn<int>("seeds");
        bool isGiven = false;
        const qulonglong given = qEnvironmentVariable("PALPATE_SEED").toULongLong(&isGiven);
        const int seeds = qEnvironmentVariableIntValue("PALPATE_SEEDS");
        for (int family = 0; family < kFamilies; ++family) {
            QTest::addRow("%s", nameOf(static_cast<Family>(family)))
                << static_cast<Family>(family) << quint64{isGiven ? given : 1} << (seeds > 0 ? seeds : 20);
        }
        QTest::newRow("a walk goes back over the edge that it came to") << Family::Open << quint64{1653} << 1;
        QTest::newRow("friction has seen more of the way than was made") << Family::Rough << quint64{104350} << 1;
    }
    void areTheSameWhateverIsHeld()
    {
        QFETCH(const Family, family);
        QFETCH(const quint64, first);
        QFETCH(const int, seeds);
        Compared tally;
        for (std::uint64_t seed = first; seed < first + static_cast<std::uint64_t>(seeds); ++seed) {
            compare(family, seed, tally);
        }
        qInfo("%s", qPrintable(QString("%1 ticks, %2 at the bound, restored %3 times, %4 differ; %5")
                                   .arg(tally.ticks)
                                   .arg(tally.atBound)
                                   .arg(tally.restored)
                                   .arg(tally.differ)
                                   .arg(tally.first)));
        QVERIFY(seeds == 1 || tally.atBound > tally.ticks / 1000); // the bound was reached often enough
        QVERIFY2(tally.differ == 0, qPrintable(tally.first));
    }
};

PALPATE_TEST(EarlyEnds)
#include "tst_EarlyEnds.moc"

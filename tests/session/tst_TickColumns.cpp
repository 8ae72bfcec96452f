// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"
#include "tables/Contacts.h"
#include "tables/Packing.h"
#include "tables/TickColumns.h"
#include "tables/TickTable.h"

#include <QFile>
#include <QTest>

using namespace palpate;
using namespace palpate::session::internal;

/// Checks the list of tick columns against all other places that list them.
class TickColumns : public QObject
{
    Q_OBJECT
  private Q_SLOTS:
    void pageTellsEachColumnInItsOrder()
    {
        QFile page(QStringLiteral(PALPATE_SOURCE_DIR "/resources/docs/recording.md"));
        QVERIFY(page.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(page.readAll());
        for (const bool isStored : {true, false}) {
            QString table;
            for (const TickColumn& column : kTickColumns) {
                if (column.isStored() == isStored) {
                    QStringList names;
                    for (const std::string& name : columnNames(column)) {
                        names << QString::fromStdString(name);
                    }
                    table += QStringLiteral("| %1 | %2 |\n")
                                 .arg(names.join(QStringLiteral(", ")),
                                      QString::fromUtf8(column.meaning.data(), qsizetype(column.meaning.size())));
                }
            }
            QVERIFY2(text.contains("|---|---|\n" + table + '\n'), qPrintable("expected the table:\n" + table));
        }
    }

    void pageTellsEachColumnThatOnlyTheCsvHas()
    {
        QFile page(QStringLiteral(PALPATE_SOURCE_DIR "/resources/docs/recording.md"));
        QVERIFY(page.open(QIODevice::ReadOnly));
        QString table;
        for (const CsvColumn& column : kCsvColumns) {
            table += QStringLiteral("| %1 | %2 |\n")
                         .arg(QString::fromUtf8(column.name.data(), qsizetype(column.name.size())),
                              QString::fromUtf8(column.meaning.data(), qsizetype(column.meaning.size())));
        }
        QVERIFY2(QString::fromUtf8(page.readAll()).contains("|---|---|\n" + table + '\n'), qPrintable(table));
    }

    void eachBitOfWhatIsStoredCountsInTheChecksum()
    {
        servo::TickRecord tick;
        tick.felt.structure = 2; // in contact: no column is omitted
        tick.felt.contactCount = 2;
        tick.felt.contacts.fill(ownContact(tick));
        std::string before;
        packTick(before, tick);
        int stored = 0;
        for (const TickColumn& column : kTickColumns) {
            servo::TickRecord other = tick;
            useValue(column, other, []<class Value>(Value& value) {
                if constexpr (std::is_same_v<Value, core::Vec3>) {
                    value.z() = -0.0;
                } else if constexpr (std::is_same_v<Value, haptics::TickResult>) {
                    value.contacts[1].friction = haptics::Friction::Holds;
                } else {
                    value = Value(value + 1);
                }
            });
            std::string after;
            packTick(after, other);
            QCOMPARE(after != before, column.isStored());
            QCOMPARE(after.size(), before.size());
            stored += column.isStored() ? int(columnNames(column).size()) : 0;
        }
        QCOMPARE(std::size_t(stored), tickColumnCount());
    }

    void theTablesAreThoseOfTheirVersions()
    {
        const std::string version2 =
            "CREATE TABLE ticks(tick INTEGER PRIMARY KEY, time_ns, hip_x, hip_y, hip_z, god_x, god_y, "
            "god_z, force_x, force_y, force_z, sent_x, sent_y, sent_z, structure, triangle, "
            "constraints, scene, buttons, solve_ns, iterations, flags";
        QCOMPARE(createTicks(1), version2 + ");\n");
        QCOMPARE(createTicks(2), version2 + ");\n");
        const std::string version3 = version2 + ", normal_x, normal_y, normal_z, layers";
        QCOMPARE(createTicks(3), version3 + ");\n");
        QCOMPARE(createTicks(4), version3 + ", velocity_x, velocity_y, velocity_z);\n");
    }
};

PALPATE_TEST(TickColumns)
#include "tst_TickColumns.moc"

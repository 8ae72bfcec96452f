// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/device/OtherDevices.h>

#include <QTemporaryDir>

#include <fstream>

using namespace palpate;

class OtherDevices : public QObject
{
    Q_OBJECT

  private Q_SLOTS:
    void recognisesByIdsOrByName_data()
    {
        QTest::addColumn<QString>("vendor");
        QTest::addColumn<QString>("product");
        QTest::addColumn<QString>("manufacturer");
        QTest::addColumn<QString>("name");
        QTest::newRow("Touch") << "2988"
                               << "0302"
                               << "3D Systems"
                               << "3D Systems Touch";
        QTest::newRow("Touch by its name") << "0301"
                                           << "0001"
                                           << "3D Systems"
                                           << "3D Systems Touch";
        QTest::newRow("Falcon") << "0403"
                                << "cb48"
                                << "Novint"
                                << "Novint Falcon";
        QTest::newRow("Inverse3") << "16c0"
                                  << "0483"
                                  << "Haply Robotics"
                                  << "Haply Inverse3";
        QTest::newRow("omega") << "1451"
                               << "0402"
                               << ""
                               << "Force Dimension";
        QTest::newRow("any other FTDI chip") << "0403"
                                             << "6001"
                                             << "FTDI"
                                             << "";
        QTest::newRow("a keyboard") << "046d"
                                    << "c31c"
                                    << "Logitech"
                                    << "";
    }

    void recognisesByIdsOrByName()
    {
        QFETCH(const QString, vendor);
        QFETCH(const QString, product);
        QFETCH(const QString, manufacturer);
        QFETCH(const QString, name);
        QTemporaryDir bus;
        const std::filesystem::path folder = std::filesystem::path(bus.path().toStdString()) / "1-2";
        std::filesystem::create_directories(folder);
        std::filesystem::create_directories(folder.parent_path() / "1-2:1.0"); // an interface has no ids
        std::ofstream(folder / "idVendor") << vendor.toStdString() << '\n';
        std::ofstream(folder / "idProduct") << product.toStdString() << '\n';
        std::ofstream(folder / "manufacturer") << manufacturer.toStdString() << '\n';
        const auto found = device::recogniseOtherDevices(folder.parent_path());
        QCOMPARE(found.size(), name.isEmpty() ? std::size_t{0} : std::size_t{1});
        if (!found.empty()) {
            QCOMPARE(found.front().name, name.toStdString());
            QVERIFY(found.front().needs.size() > 20);
            QCOMPARE(found.front().plugin.empty(), name != QLatin1String("Force Dimension") &&
                                                       name != QLatin1String("3D Systems Touch") &&
                                                       name != QLatin1String("Haply Inverse3"));
        }
    }

    void findsNothingWithoutABus() { QVERIFY(device::recogniseOtherDevices("/nowhere").empty()); }
};

PALPATE_TEST(OtherDevices)
#include "tst_OtherDevices.moc"

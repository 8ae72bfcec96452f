// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/view/ColourMap.h>

#include <limits>

using palpate::view::cividis;
using palpate::view::Colour;

class ColourMap : public QObject
{
    Q_OBJECT
  private Q_SLOTS:
    void lightnessRisesWithForce()
    {
        double before = -1.0;
        for (int i = 0; i <= 100; ++i) {
            const Colour c = cividis(i / 100.0);
            const double lightness = 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
            QVERIFY2(lightness > before, qPrintable(QString::number(i)));
            before = lightness;
        }
    }
    void endsAreDarkBlueAndYellow()
    {
        QVERIFY(cividis(0.0)[2] > cividis(0.0)[0]);
        QVERIFY(cividis(1.0)[0] > 0.9 && cividis(1.0)[2] < 0.4);
    }
    void clampsWhatIsOutside()
    {
        QCOMPARE(cividis(-3.0), cividis(0.0));
        QCOMPARE(cividis(7.0), cividis(1.0));
        QCOMPARE(cividis(std::numeric_limits<double>::quiet_NaN()), cividis(0.0));
    }
};

PALPATE_TEST(ColourMap)
#include "tst_ColourMap.moc"

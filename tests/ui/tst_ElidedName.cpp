// SPDX-License-Identifier: BSD-3-Clause
#include "TestRunner.h"

#include <palpate/ui/ElidedName.h>

#include <QFont>

using namespace palpate;

/// Tests that shortened names can be told apart.
class ElidedName : public QObject
{
    Q_OBJECT

    QFontMetrics m_metrics{QFont()};

    QString shortened(const QString& name, int letters, const QStringList& others = {})
    {
        const int width = letters * m_metrics.horizontalAdvance(QLatin1Char('n'));
        const QString text = ui::elidedName(name, m_metrics, width, others);
        if (m_metrics.horizontalAdvance(text) > width) {
            return QStringLiteral("too wide: ") + text;
        }
        return text;
    }

  private Q_SLOTS:
    void aNameThatFitsIsWhole() { QCOMPARE(shortened("liver", 30, {"liver", "spleen"}), QStringLiteral("liver")); }

    void startAndEndStay()
    {
        const QString text = shortened("capsule of the liver segment IVa", 16);
        QVERIFY2(text.startsWith("cap") && text.endsWith("IVa") && text.contains(QChar(0x2026)), qPrintable(text));
    }

    /// Names with equal starts and ends keep the part in between.
    void whatDiffersStays()
    {
        const QStringList names{"surface of the left hepatic vein, smoothed twice",
                                "surface of the right hepatic vein, smoothed twice",
                                "surface of the middle hepatic vein, smoothed twice"};
        QStringList texts;
        for (const QString& name : names) {
            texts << shortened(name, 14, names);
        }
        QVERIFY2(texts[0].contains("left") && texts[1].contains("right") && texts[2].contains("middle"),
                 qPrintable(texts.join(" | ")));
    }

    void equalNamesStayEqual()
    {
        const QString name("capsule of the liver segment IVa");
        QCOMPARE(shortened(name, 12, {name, name}), shortened(name, 12));
    }
};

PALPATE_TEST(ElidedName)
#include "tst_ElidedName.moc"

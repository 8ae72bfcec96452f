// SPDX-License-Identifier: BSD-3-Clause
#include "Desk.h"
#include "Shapes.h"
#include "TestRunner.h"
#include "scene/SceneFiles.h"

#include <palpate/ui/MessageBar.h>
#include <palpate/ui/StructureModel.h>

#include <QPushButton>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

using namespace palpate;

/// Tests the messages about files that cannot be opened, and the next steps that they name or offer.
class DamagedFiles : public QObject
{
    Q_OBJECT

    std::unique_ptr<test::Desk> m_desk;

    ui::MessageBar& messages() const { return *m_desk->window().findChild<ui::MessageBar*>(); }
    std::filesystem::path write(const char* name, const std::string& bytes) const
    {
        std::ofstream(m_desk->folder() / name, std::ios::binary) << bytes;
        return m_desk->folder() / name;
    }
    QPushButton* button(const char* text) const
    {
        const auto buttons = messages().findChildren<QPushButton*>();
        const auto found = std::find_if(buttons.begin(), buttons.end(), [&](const QPushButton* one) {
            return one->isVisible() && one->text() == QLatin1String(text);
        });
        return found == buttons.end() ? nullptr : *found;
    }

  private Q_SLOTS:
    void initTestCase()
    {
        if (!test::Desk::hasDisplay()) {
            QSKIP(test::Desk::kNoDisplay);
        }
        m_desk = std::make_unique<test::Desk>();
    }
    void init() { QVERIFY(m_desk->show()); }
    void cleanupTestCase() { m_desk.reset(); }

    /// A recording whose first bytes are lost is a recording by its name.
    void damagedRecordingNamesItsRecovery_data()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("usual") << "r.palpate";
        QTest::newRow("capitals") << "R.PALPATE";
    }
    void damagedRecordingNamesItsRecovery()
    {
        QFETCH(const QString, name);
        m_desk->window().open({write(qPrintable(name), std::string(5000, 'x'))});
        PALPATE_TRY_VERIFY2(messages().text().contains("palpate session recover"), qPrintable(messages().text()));
        QVERIFY2(!messages().text().contains("mesh format"), qPrintable(messages().text()));
    }

    /// The command line advises an option, the window has a button.
    void truncatedMeshOffersItsPart()
    {
        const std::filesystem::path whole = m_desk->writeStl("whole.stl", test::sphere(10, 60.0));
        const auto size = std::filesystem::file_size(whole);
        std::filesystem::resize_file(whole, size / 2);
        m_desk->window().open({whole});
        PALPATE_TRY_VERIFY(button("Open the part that is there") != nullptr);
        QVERIFY2(messages().text().contains("cut off"), qPrintable(messages().text()));
        QVERIFY2(!messages().text().contains("--partial"), qPrintable(messages().text()));
        QTest::mouseClick(button("Open the part that is there"), Qt::LeftButton);
        PALPATE_TRY_COMPARE(m_desk->window().model().rowCount(), 1);
    }

    /// A refused segmentation that is shown as an image is no longer an error.
    void errorGoesOnceTheFileIsShown()
    {
        std::string image = "NRRD0004\ntype: short\ndimension: 3\nsizes: 20 20 20\nencoding: raw\nendian: little\n\n";
        for (int i = 0; i < 20 * 20 * 20; ++i) {
            const int value = (i * 7919) % 4001 - 2000;
            image += static_cast<char>(value & 0xff);
            image += static_cast<char>((value >> 8) & 0xff);
        }
        const std::filesystem::path ct = write("ct.nrrd", image);
        QVERIFY(m_desk->open({m_desk->writeStl("liver.stl", test::sphere(10, 60.0))}));
        m_desk->window().open({ct});
        PALPATE_TRY_VERIFY(button("Open the segmentation") != nullptr);
        QTest::mouseClick(button("Open the segmentation"), Qt::LeftButton);
        PALPATE_TRY_VERIFY2(messages().text().contains("not labels"), qPrintable(messages().text()));
        QVERIFY(messages().text().contains("Show an image…"));
        QVERIFY(messages().text().contains("TotalSegmentator"));
        Q_EMIT m_desk->window().findChild<app::SceneFiles*>()->imageWanted(ct);
        PALPATE_TRY_VERIFY2(!messages().text().contains("not labels"), qPrintable(messages().text()));
    }
};

PALPATE_TEST(DamagedFiles)
#include "tst_DamagedFiles.moc"

// SPDX-License-Identifier: BSD-3-Clause
// Tests the map editor of the panel: maps found by name or set by hand, units, immediate effect, messages and undo.
#include "Rows.h"
#include "TestRunner.h"

#include <palpate/meshio/SurfaceMaps.h>
#include <palpate/ui/MapDisplay.h>
#include <palpate/ui/MapEditor.h>
#include <palpate/ui/SceneLoader.h>
#include <palpate/ui/StructurePanel.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLocale>
#include <QSettings>
#include <QTemporaryDir>

#include <cmath>
#include <fstream>
#include <limits>

using namespace palpate;
using core::MappedQuantity;
using core::MapUnit;

namespace {

/// Returns a ball whose right half is twice as stiff by a recognised array name, plus an elastogram with an
/// unrecognised name and 12 unknown values; and a ball without arrays.
std::vector<ui::StructureRow> mappedRows()
{
    std::vector<ui::StructureRow> rows;
    geometry::TriangleMesh ball = test::ball(50.0, 3);
    geometry::MeshArray scale{"StiffnessScale", false, {}}, mre{"mre", false, {}};
    for (const core::Vec3& p : ball.vertices) {
        scale.values.push_back(p.x() < 0.0 ? 1.0F : 2.0F);
        mre.values.push_back(p.x() < 0.0 ? 2.3F : 10.1F);
    }
    std::fill_n(mre.values.begin(), 12, std::numeric_limits<float>::quiet_NaN());
    ball.arrays = {scale, mre};
    rows.push_back(test::row("liver", ball));
    rows.push_back(test::row("lump", test::ball(8.0, 2)));
    std::vector<core::Message> warnings, losses;
    meshio::resolveMaps(rows[0].loaded, warnings, losses);
    return rows;
}

struct MapPanel
{
    ui::StructureModel model;
    ui::StructurePanel panel{model};
    MapPanel()
    {
        model.setRows(mappedRows());
        panel.resize(300, 1100);
        panel.show();
        panel.select(0);
    }
    [[nodiscard]] QComboBox* box(const char* name) const
    {
        for (QComboBox* one : panel.findChildren<QComboBox*>()) {
            if (one->accessibleName() == QLatin1String(name)) {
                return one;
            }
        }
        qFatal("no such box");
    }
    void choose(const char* name, const char* text) const
    {
        QComboBox* one = box(name);
        const int at = one->findText(QString::fromUtf8(text));
        if (at < 0 || !one->isVisible()) {
            qFatal("%s has no %s", name, text);
        }
        one->setCurrentIndex(at);
        Q_EMIT one->activated(at);
    }
    [[nodiscard]] const std::optional<std::vector<core::TissueMapping>>& maps() const
    {
        return model.structure(0).maps;
    }
    /// Returns the smallest and largest stiffness of the first structure [N/mm].
    [[nodiscard]] std::pair<double, double> felt(double holds = std::numeric_limits<double>::infinity()) const
    {
        haptics::Tissue greatest = core::unbounded();
        greatest.stiffness_N_per_mm = holds;
        const haptics::HapticStructure one = model.hapticStructures(greatest)[0];
        if (one.maps.stiffness.isEmpty()) {
            return {one.tissue.stiffness_N_per_mm, one.tissue.stiffness_N_per_mm};
        }
        double least = 1e9;
        for (const auto& corner : *one.maps.stiffness.corners) {
            least = std::min(least, one.maps.stiffness.factor * double{corner[0]} * one.tissue.stiffness_N_per_mm);
        }
        return {least, one.maps.stiffness.greatest() * one.tissue.stiffness_N_per_mm};
    }
    [[nodiscard]] bool isSaid(const char* text) const
    {
        for (const QLabel* one : panel.findChildren<QLabel*>()) {
            if (one->isVisible() && one->text().contains(QString::fromUtf8(text))) {
                return true;
            }
        }
        return false;
    }
    void keep(const char* name) const
    {
        if (const QByteArray to = qgetenv("PALPATE_MAP_PICTURES"); !to.isEmpty()) {
            QTest::qWait(50);
            const_cast<ui::StructurePanel&>(panel).grab().save(
                QString::fromLocal8Bit(to + "/" + QByteArray(name) + ".png")); // for visual inspection
        }
    }
};

bool isFeltAs(double a, double b)
{
    return std::abs(a - b) < 1e-6 * std::abs(b);
}

} // namespace

class MapEditor : public QObject
{
    Q_OBJECT
  private Q_SLOTS:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        QSettings().setValue(QStringLiteral("properties/advanced"), true); // the group of the map is folded at first
    }
    void cleanupTestCase() { QSettings().remove(QStringLiteral("properties/advanced")); }

    void aNameThatSaysItIsFeltAtOnce()
    {
        MapPanel p;
        QCOMPARE(p.box("Map")->currentText(), QStringLiteral("By name"));
        QVERIFY(p.isSaid("Stiffness varies by StiffnessScale."));
        QVERIFY(isFeltAs(p.felt().first, 0.5) && isFeltAs(p.felt().second, 1.0));
        p.keep("panel-by-name");
        p.choose("Map", "None");
        QVERIFY(p.maps() && p.maps()->empty());
        QVERIFY(isFeltAs(p.felt().second, 0.5));
        p.model.undoStack().undo();
        QVERIFY(!p.maps());
        QVERIFY(isFeltAs(p.felt().second, 1.0));
        QCOMPARE(p.box("Map")->currentText(), QStringLiteral("By name"));
        p.panel.select(1);
        QVERIFY(!p.box("Show")->isVisible()); // no array to colour by
    }
    void aModulusIsShearOrYoungsByThePersonsWord()
    {
        MapPanel p;
        p.choose("Map", "Manual");
        QCOMPARE(p.maps()->size(), std::size_t{1}); // continues from the map found by name
        p.choose("Source", "mre");
        QVERIFY2(p.isSaid("Choose the unit of mre: shear modulus and Young's modulus differ by a factor of three."),
                 "asked");
        QCOMPARE(p.box("Unit")->currentIndex(), -1);
        QVERIFY(p.maps()->at(0).array == "StiffnessScale"); // no guess
        p.keep("panel-asked");
        p.choose("Unit", "Shear modulus, kPa");
        QVERIFY(p.maps()->at(0).array == "mre" && p.maps()->at(0).unit == MapUnit::ShearKPa);
        QVERIFY(isFeltAs(p.felt().first, 8.0 * 5.0 * 2.3e-3));
        QVERIFY(isFeltAs(p.felt().second, 0.5)); // the tissue's own stiffness where values are missing
        QVERIFY(p.isSaid("mre: 12 of 642 places have no value. The tissue value is used there."));
        p.keep("panel-shear");
        p.choose("Unit", "Young's modulus, kPa");
        QVERIFY(isFeltAs(p.felt().first, 8.0 / 3.0 * 5.0 * 2.3e-3));
        for (QDoubleSpinBox* one : p.panel.findChildren<QDoubleSpinBox*>()) {
            if (one->accessibleName().startsWith(QLatin1String("Contact radius"))) {
                one->setValue(10.0);
            }
        }
        QCOMPARE(p.maps()->at(0).contactRadius_mm, 10.0);
        for (QCheckBox* one : p.panel.findChildren<QCheckBox*>()) {
            if (one->text() == QLatin1String("Limit the values")) {
                one->setChecked(true);
            }
        }
        QVERIFY(p.maps()->at(0).clamp.has_value());
        QVERIFY(std::abs((*p.maps()->at(0).clamp)[1] - 10.1) < 1e-3);
        p.choose("Source", "Nothing");
        QVERIFY(p.maps()->empty());
    }
    void frictionAndDampingNeedNoWord()
    {
        MapPanel p;
        p.choose("Map", "Manual");
        p.choose("Property", "Friction");
        p.choose("Source", "mre");
        QCOMPARE(p.maps()->size(), std::size_t{2});
        QVERIFY(p.maps()->at(1).quantity == MappedQuantity::Friction && p.maps()->at(1).unit == MapUnit::Scale);
        p.choose("Property", "Damping");
        QCOMPARE(p.box("Source")->currentText(), QStringLiteral("Nothing"));
        p.choose("Source", "mre");
        QVERIFY(p.maps()->at(2).unit == MapUnit::NsPerMm);
    }
    void whatTheDeviceHoldsBoundsItAndIsSaid()
    {
        MapPanel p;
        haptics::Tissue greatest = core::unbounded();
        greatest.stiffness_N_per_mm = 0.8;
        p.panel.setGreatest(greatest, QStringLiteral("The test's device holds at most 0.8 N/mm."));
        QVERIFY(p.isSaid("limited to at most 0.8 N/mm: the device can render 0.8 N/mm in total"));
        QVERIFY(std::abs(p.felt(0.8).second - 0.8) < 1e-6);
        const auto felt = p.model.hapticStructures(greatest);
        const auto shown =
            ui::surfaceFields(p.model.rows()[0].loaded, QStringLiteral("felt:stiffness"), felt[0]); // the colour values
        QVERIFY(std::abs(*std::max_element(shown.values.begin(), shown.values.end()) - 0.8F) < 1e-6F);
        // A map that is softer than the tissue everywhere must not be reported as limited by the device.
        meshio::SceneStructure soft = p.model.structure(0);
        soft.maps = std::vector<core::TissueMapping>{{MappedQuantity::Stiffness, MapUnit::Scale, "StiffnessScale", ""}};
        soft.maps->at(0).clamp = {0.1, 0.2};
        p.model.edit(0, soft);
        QVERIFY(isFeltAs(p.felt(0.8).second, 0.1));
        QVERIFY(!p.isSaid("the device can render"));
    }
    void whatCanBeShownHasItsUnit()
    {
        MapPanel p;
        QComboBox* show = p.box("Show");
        QStringList titles;
        for (int i = 0; i < show->count(); ++i) {
            titles << show->itemText(i);
        }
        QCOMPARE(titles, (QStringList{"Own colour", "felt stiffness, N/mm", "StiffnessScale", "mre"}));
        QSignalSpy chosen(&p.panel, &ui::StructurePanel::colourChosen);
        p.choose("Show", "mre");
        QCOMPARE(chosen.count(), 1);
        QCOMPARE(chosen[0][1].toString(), QStringLiteral("array:mre"));
        p.choose("Map", "Manual");
        p.choose("Source", "mre");
        p.choose("Unit", "Shear modulus, kPa");
        QCOMPARE(p.box("Show")->currentText(), QStringLiteral("mre: shear modulus, kPa")); // still the chosen array
    }
    void aVolumeIsReadOffTheWindowsThread()
    {
        QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath(QStringLiteral("mre.mha")).toStdString();
        {
            std::ofstream out(file, std::ios::binary);
            out << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
                   "CompressedData = False\nTransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = -80 -80 -80\n"
                   "ElementSpacing = 16 16 16\nDimSize = 11 11 11\nElementType = MET_FLOAT\nElementDataFile = LOCAL\n";
            const std::vector<float> kPa(11 * 11 * 11, 4.0F);
            out.write(reinterpret_cast<const char*>(kPa.data()), static_cast<std::streamsize>(4 * kPa.size()));
        }
        MapPanel p;
        ui::SceneLoader loader;
        int asked = 0;
        connect(&p.model, &ui::StructureModel::mapsWanted, &loader, [&](int row) {
            ++asked;
            loader.buildMaps(row, p.model.rows()[static_cast<std::size_t>(row)].loaded);
        });
        connect(&loader, &ui::SceneLoader::mapsBuilt, &p.model,
                [&](int row, const std::shared_ptr<meshio::LoadedStructure>& found,
                    const std::vector<core::Message>& problems) {
                    p.model.setMaps(row, found->description.maps, found->maps, problems);
                });
        auto* editor = p.panel.findChild<ui::MapEditor*>();
        p.choose("Map", "Manual");
        editor->load(file);
        QCOMPARE(asked, 0); // the unit is unknown
        p.choose("Unit", "Shear modulus, kPa");
        QCOMPARE(asked, 1);
        PALPATE_TRY_VERIFY(std::abs(p.felt().second - 8.0 * 5.0 * 4e-3) < 1e-6);
        QCOMPARE(p.box("Source")->currentText(), QStringLiteral("mre.mha"));
        p.model.undoStack().undo(); // quick successive steps undo together
        QVERIFY(isFeltAs(p.felt().second, 1.0));
        // After a cancelled load there is a message, and the tissue's own stiffness applies.
        p.choose("Map", "Manual");
        editor->load(file);
        p.choose("Unit", "Shear modulus, kPa");
        QVERIFY(loader.isBuildingMaps());
        loader.cancel();
        PALPATE_TRY_VERIFY(p.isSaid("mre.mha: reading was cancelled"));
        QVERIFY(isFeltAs(p.felt().second, 0.5) && !loader.isBuildingMaps());
        p.model.undoStack().undo();
        QVERIFY(isFeltAs(p.felt().second, 1.0));
        // A missing file gives a message, and the previous map stays off.
        p.choose("Map", "Manual");
        editor->load(file.parent_path() / "gone.mha");
        p.choose("Unit", "Shear modulus, kPa");
        PALPATE_TRY_VERIFY(p.isSaid("gone.mha: no such file"));
        QVERIFY(isFeltAs(p.felt().second, 0.5));
    }
};

PALPATE_TEST(MapEditor)
#include "tst_MapEditor.moc"

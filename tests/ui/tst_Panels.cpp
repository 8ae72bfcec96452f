// SPDX-License-Identifier: BSD-3-Clause
#include "Rows.h"
#include "TestRunner.h"

#include <palpate/meshio/MeshFormats.h>
#include <palpate/ui/Pieces.h>
#include <palpate/ui/StructurePanel.h>
#include <palpate/ui/Theme.h>
#include <palpate/ui/TouchChart.h>
#include <palpate/ui/TouchPanel.h>
#include <palpate/view/TextStyle.h>

#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QSignalSpy>
#include <QTreeView>

#include <algorithm>
#include <cmath>

using namespace palpate;

namespace {

bool says(const QWidget& widget, const QString& text)
{
    for (const QLabel* label : widget.findChildren<QLabel*>()) {
        if (label->text() == text) {
            return true;
        }
    }
    return false;
}

double luminance(const QColor& colour)
{
    const auto linear = [](double c) { return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

double contrast(const QColor& a, const QColor& b)
{
    const double light = std::max(luminance(a), luminance(b));
    const double dark = std::min(luminance(a), luminance(b));
    return (light + 0.05) / (dark + 0.05);
}

} // namespace

class Panels : public QObject
{
    Q_OBJECT
  private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }
    void cleanupTestCase() { ui::applyTheme(ui::Theme::System); }

    void forceHasSensibleDigits()
    {
        QCOMPARE(ui::forceText(2.3149), QStringLiteral("2.31"));
        QCOMPARE(ui::forceText(9.996), QStringLiteral("10.0"));
        QCOMPARE(ui::forceText(123.4), QStringLiteral("123"));
    }
    void touchShowsNumbersWithUnits()
    {
        ui::TouchPanel panel;
        panel.setForceLimit(10.0);
        panel.show(ui::TouchReading{1.0, 2.314, 4.62, QStringLiteral("liver"), 0.5, 1});
        QVERIFY(says(panel, QStringLiteral("2.31")));
        QVERIFY(says(panel, QStringLiteral("liver")));
        QVERIFY(says(panel, QStringLiteral("4.6 mm deep · 0.50 N/mm")));
        QVERIFY(!says(panel, QStringLiteral("very fine mesh here: force delayed")));
        QVERIFY(std::abs(panel.findChild<ui::ForceBar*>()->share() - 0.2314) < 1e-12);
    }
    /// Highlights the structure in contact: the innermost layer, or the buried lump, with its own numbers.
    void whatIsFeltIsNamedBeforeItsOrgan()
    {
        ui::TouchReading reading{1.0, 6.0, 12.4, QStringLiteral("liver"), 0.8, 1};
        QCOMPARE(ui::whereText(ui::palpatedStructure(reading)), QStringLiteral("liver"));
        reading.lump = QStringLiteral("tumour");
        reading.lumpRatio = 1.09; // below the threshold of a trained hand
        QCOMPARE(ui::whereText(ui::palpatedStructure(reading)), QStringLiteral("liver"));
        reading.lumpRatio = 1.55;
        QCOMPARE(ui::whereText(ui::palpatedStructure(reading)), QStringLiteral("tumour in liver"));
        QCOMPARE(ui::palpatedStructure(reading).force_N, 6.0);
        ui::TouchPanel panel;
        panel.resize(900, 500);
        panel.show(reading);
        QStringList spoken;
        for (const QLabel* label : panel.findChildren<QLabel*>()) {
            spoken << label->accessibleName();
        }
        QVERIFY2(spoken.contains(QStringLiteral("over tumour: +55 %, plainly felt")),
                 qPrintable(spoken.join(QLatin1Char(0x7c))));
        reading.lump.clear();
        reading.layers = {{QStringLiteral("liver"), {}, 2.5, 2.4, 12.4}, {QStringLiteral("lump"), {}, 3.7, 3.6, 5.8}};
        const ui::PalpatedStructure felt = ui::palpatedStructure(reading);
        QCOMPARE(ui::whereText(felt), QStringLiteral("lump in liver"));
        QVERIFY(felt.force_N == 3.6 && felt.depth_mm == 5.8);
    }
    /// The displayed parts add up to the force, also if the layers push in different directions.
    void layersAddUpToTheForce()
    {
        servo::TickRecord tick;
        tick.felt.structure = 0;
        tick.felt.contactCount = 2;
        tick.felt.contacts[0] = {
            core::Vec3::Zero(), core::Vec3::UnitZ(), core::Vec3(0.6, 0.0, 0.8), 3.0, 1.0, 0, 0, 0, {}};
        tick.felt.contacts[1] = {
            core::Vec3::Zero(), core::Vec3::UnitZ(), core::Vec3(-1.0, 0.5, 4.26), 3.4, 1.0, 1, 0, 1, {}};
        tick.felt.f_W = tick.felt.contacts[0].f_W + tick.felt.contacts[1].f_W;
        const auto layers = ui::layerShares(tick, tick.felt.f_W.norm(), [](std::uint32_t number) {
            return ui::LayerStyle{QString::number(number), {}};
        });
        QVERIFY(layers[0].force_N + layers[1].force_N > tick.felt.f_W.norm() + 0.1); // magnitudes alone do not
        const QString text = ui::layersText(layers);
        double shown = 0.0;
        for (const QString& layer : text.split(QStringLiteral(" · "))) {
            shown += layer.split(QLatin1Char(' '))[1].toDouble();
        }
        QVERIFY2(std::abs(shown - tick.felt.f_W.norm()) < 0.0101, qPrintable(text));
    }
    void eachLayerIsNamedWithItsShare()
    {
        ui::TouchPanel panel;
        panel.resize(300, 500);
        ui::TouchReading reading{1.0, 6.0, 12.4, QStringLiteral("liver"), 0.8, 1};
        reading.layers = {{QStringLiteral("liver"), QColor(221, 130, 101), 2.5, 2.5, 12.4},
                          {QStringLiteral("lump <20 mm>"), QColor(144, 238, 144), 3.5, 3.5, 5.83}};
        QCOMPARE(ui::layersText(reading.layers),
                 QStringLiteral("liver 2.50 N · lump <20 mm> 3.50 N, pressed in 5.8 mm"));
        panel.show(reading);
        QVERIFY(says(panel, QStringLiteral("liver · lump <20 mm>")));
        QVERIFY(says(panel, QStringLiteral("12.4 mm deep · 0.80 N/mm")));
        QVERIFY(says(panel, ui::layersMarkup(reading.layers)));
        QVERIFY(ui::layersMarkup(reading.layers)
                    .contains(QStringLiteral("lump &lt;20 mm&gt;</b> 3.50 N, pressed in 5.8 mm")));
        const int height = panel.findChild<ui::TouchChart*>()->height();
        reading.layers.pop_back();
        panel.show(reading);
        QVERIFY(says(panel, QStringLiteral("liver")));
        QVERIFY(!says(panel, QStringLiteral("liver · lump <20 mm>")));
        QCOMPARE(panel.findChild<ui::TouchChart*>()->height(), height); // the layout stays stable
    }

    void frictionIsSaidAndShown()
    {
        servo::TickRecord tick;
        tick.p_WH = {0, 0, -3};
        tick.felt.p_WG = {-0.6, 0, 0};
        tick.felt.n_W = {0, 0, 1};
        tick.felt.f_W = {-0.3, 0, 1.5};
        tick.felt.structure = 0;
        tick.felt.constraints = tick.felt.contactCount = 1;
        tick.felt.contacts[0] = {tick.felt.p_WG,           tick.felt.n_W, tick.felt.f_W, 3.06, 1.0, 0, 0, 0,
                                 haptics::Friction::Slides};
        const auto look = [](std::uint32_t) { return ui::LayerStyle{QStringLiteral("liver"), Qt::red}; };
        const auto layers = ui::layerShares(tick, tick.felt.f_W.norm(), look);
        QCOMPARE(ui::layersText(layers), QStringLiteral("liver 1.53 N, slides 0.30 N"));
        core::Tissue tissue;
        tissue.friction_static = 0.5;
        tissue.friction_dynamic = 0.2;
        view::TouchState state;
        ui::showFriction(tick, tissue, state);
        QVERIFY(state.friction.p_W.isApprox(core::Vec3(0, 0, 0)) || state.friction.p_W.norm() < 1e-12);
        QVERIFY(std::abs(state.friction.radius_mm - 0.6) < 1e-12);
        tick.felt.contacts[0].friction = haptics::Friction::Holds;
        ui::showFriction(tick, tissue, state);
        QVERIFY(std::abs(state.friction.radius_mm - 1.5) < 1e-12);
        tick.felt.contacts[0].friction = haptics::Friction::None;
        ui::showFriction(tick, tissue, state);
        QCOMPARE(state.friction.radius_mm, 0.0);
        QCOMPARE(ui::layersText(ui::layerShares(tick, tick.felt.f_W.norm(), look)), QStringLiteral("liver"));
    }
    /// The height of each area is the layer's part of the force, in the colour of the structure.
    void chartStacksTheLayers()
    {
        const QColor outer(221, 130, 101);
        const QColor inner(144, 238, 144);
        const auto count = [](const ui::TouchHistory& history, const QColor& colour) {
            ui::TouchChart chart(history);
            chart.resize(400, 300);
            const QImage image = chart.grab().toImage();
            int pixels = 0;
            for (int y = 0; y < image.height(); ++y) {
                for (int x = 0; x < image.width(); ++x) {
                    pixels += image.pixelColor(x, y).rgb() == colour.rgb() ? 1 : 0;
                }
            }
            return pixels;
        };
        ui::TouchHistory layered;
        ui::TouchHistory plain;
        for (int i = 0; i <= 100; ++i) {
            layered.add({0.1 * i, 4.0, 10.0, {{outer, 3.0}, {inner, 1.0}}});
            plain.add({0.1 * i, 4.0, 10.0, {{outer, 4.0}}});
        }
        QVERIFY(layered.hasLayers() && !plain.hasLayers());
        const int below = count(layered, outer);
        const int above = count(layered, inner); // minus the hatching
        QVERIFY2(below > 5000 && above > 500, qPrintable(QStringLiteral("%1 %2").arg(below).arg(above)));
        QVERIFY2(above < 0.36 * below, qPrintable(QStringLiteral("%1 %2").arg(below).arg(above)));
        QCOMPARE(count(plain, outer), 0); // one layer: unchanged
    }
    void aTickThatStoppedAtItsBoundSaysSo()
    {
        ui::TouchPanel panel;
        ui::TouchReading reading{1.0, 2.3, 4.6, QStringLiteral("fan"), 0.5, 1};
        reading.isAtIterationLimit = true;
        panel.show(reading);
        QVERIFY(says(panel, QStringLiteral("very fine mesh here: force delayed")));
        reading.isAtIterationLimit = false;
        panel.show(reading);
        QVERIFY(!says(panel, QStringLiteral("very fine mesh here: force delayed")));
    }
    void freeSpaceSaysSo()
    {
        ui::TouchPanel panel;
        panel.show(ui::TouchReading{1.0, 0.0, 0.0, {}, 0.0, 0});
        QVERIFY(says(panel, QStringLiteral("Not touching")));
        QVERIFY(says(panel, QStringLiteral("the hand is free")));
        panel.showNoHand();
        QVERIFY(says(panel, QStringLiteral("Not touching")));
        QVERIFY(says(panel, QStringLiteral("press on a structure to feel it")));
        QCOMPARE(panel.findChild<ui::ForceBar*>()->share(), 0.0);
    }
    /// Shortened names are complete again in a wider panel.
    void namesAreWholeInAWiderPanel()
    {
        const QString name = QStringLiteral("right posterior segmental branch");
        ui::TouchReading reading;
        reading.structure = name;
        ui::TouchPanel touch;
        ui::StructureModel model;
        std::vector<ui::StructureRow> rows;
        rows.push_back(test::row(name.toStdString(), test::ball(50.0, 4)));
        model.setRows(std::move(rows));
        ui::StructurePanel panel(model);
        for (QWidget* one : {static_cast<QWidget*>(&touch), static_cast<QWidget*>(&panel)}) {
            one->resize(150, 700);
            one->show();
        }
        touch.show(reading);
        panel.select(0);
        QVERIFY(!says(touch, name));
        QVERIFY(!says(panel, name));
        touch.resize(700, 700);
        panel.resize(700, 700);
        QVERIFY(says(touch, name));
        QVERIFY(says(panel, name));
    }
    void barEndsAtTheLimit()
    {
        ui::ForceBar bar;
        bar.setLimit(5.0);
        bar.setForce(50.0);
        QCOMPARE(bar.share(), 1.0);
        bar.setLimit(0.0); // unknown limit: keeps the previous limit
        QCOMPARE(bar.limit_N(), 5.0);
    }
    void tissueFieldsEditTheSelection()
    {
        ui::StructureModel model;
        ui::StructurePanel panel(model);
        model.setRows(test::twoRows());
        panel.select(1);
        auto* stiffness = panel.findChildren<QDoubleSpinBox*>().first();
        QVERIFY(stiffness->suffix().contains(QStringLiteral("N/mm")));
        stiffness->setValue(1.1);
        QCOMPARE(model.structure(1).tissue.stiffness_N_per_mm, 1.1);
        QCOMPARE(model.structure(0).tissue.stiffness_N_per_mm, 0.5);
        panel.select(0);
        QCOMPARE(stiffness->value(), 0.5);
        QCOMPARE(model.structure(1).tissue.stiffness_N_per_mm, 1.1); // display without an edit
    }
    void stifferThanTheDeviceHoldsIsRefusedInWords()
    {
        ui::StructureModel model;
        ui::StructurePanel panel(model);
        model.setRows(test::twoRows());
        panel.select(0);
        panel.setGreatest({0.8, 0.004}, QStringLiteral("The arm holds 0.8 N/mm."));
        QLabel* refusal = nullptr;
        for (QLabel* label : panel.findChildren<QLabel*>()) {
            refusal = label->accessibleDescription().contains(QStringLiteral("rejecting")) ? label : refusal;
        }
        QVERIFY(refusal != nullptr && refusal->isHidden());
        auto* stiffness = panel.findChildren<QDoubleSpinBox*>().first();
        stiffness->setFocus();
        stiffness->selectAll();
        QTest::keyClicks(stiffness, QLocale().toString(1.75));
        QCOMPARE(model.structure(0).tissue.stiffness_N_per_mm, 0.5); // no change while typing
        QTest::keyClick(stiffness, Qt::Key_Return);
        QCOMPARE(model.structure(0).tissue.stiffness_N_per_mm, 0.5);
        QCOMPARE(stiffness->value(), 0.5);
        QVERIFY(!refusal->isHidden());
        for (const char* part : {"1.75", "The arm holds 0.8 N/mm.", "0.80 N/mm or less"}) {
            QVERIFY2(refusal->text().contains(QLatin1String(part)), qPrintable(refusal->text()));
        }
        stiffness->setValue(0.7);
        QCOMPARE(model.structure(0).tissue.stiffness_N_per_mm, 0.7);
        QVERIFY(refusal->isHidden());
        auto* presets = panel.findChild<QComboBox*>();
        presets->setCurrentIndex(6); // bone
        Q_EMIT presets->activated(6);
        QCOMPARE(model.structure(0).tissue.stiffness_N_per_mm, 0.7);
        QCOMPARE(presets->currentIndex(), 0);
        QVERIFY(!refusal->isHidden());
        panel.select(1);
        QVERIFY(refusal->isHidden());
        // The initial values of a scene stay, and can be made softer or given other damping.
        panel.setGreatest({0.3, 0.004}, {});
        panel.select(0);
        QCOMPARE(stiffness->value(), 0.7);
        const auto fields = panel.findChildren<QDoubleSpinBox*>();
        const auto damping = std::find_if(fields.begin(), fields.end(), [](const QDoubleSpinBox* field) {
            return field->accessibleName().startsWith(QLatin1String("Damping"));
        });
        QVERIFY(damping != fields.end());
        (*damping)->setValue(0.001);
        QCOMPARE(model.structure(0).tissue.damping_Ns_per_mm, 0.001);
        QCOMPARE(model.structure(0).tissue.stiffness_N_per_mm, 0.7);
        stiffness->setValue(0.6);
        QCOMPARE(model.structure(0).tissue.stiffness_N_per_mm, 0.6);
    }
    void aLayerTakesOfWhatTheDeviceHolds()
    {
        ui::StructureModel model;
        ui::StructurePanel panel(model);
        model.setRows(test::twoRows());
        panel.setGreatest({1.2, 0.004}, QStringLiteral("The arm holds 1.2 N/mm."));
        const auto label = [&panel](const char* name) {
            for (QLabel* one : panel.findChildren<QLabel*>()) {
                if (one->accessibleDescription().contains(QLatin1String(name))) {
                    return one;
                }
            }
            return static_cast<QLabel*>(nullptr);
        };
        QLabel* const bound = label("Effective stiffness");
        QLabel* const refusal = label("rejecting the value");
        for (const int row : {0, 1}) {
            meshio::SceneStructure one = model.structure(row);
            one.tissue.stiffness_N_per_mm = 0.8;
            model.edit(row, one);
        }
        panel.select(1);
        QVERIFY(bound->isHidden()); // side by side
        model.setLayers({0, 1}, {});
        QVERIFY(!bound->isHidden());
        QCOMPARE(
            bound->text(),
            QStringLiteral("limited to 0.4 N/mm: the device can render 1.2 N/mm in total, liver capsule uses 0.8"));
        panel.select(0);
        QVERIFY(bound->isHidden()); // the outer layer is unchanged
        panel.select(1);
        auto* stiffness = panel.findChildren<QDoubleSpinBox*>().first();
        stiffness->setValue(0.9);
        QCOMPARE(model.structure(1).tissue.stiffness_N_per_mm, 0.8);
        for (const char* part : {"0.9 N/mm is too stiff", "liver capsule uses 0.8", "0.40 N/mm or less"}) {
            QVERIFY2(refusal->text().contains(QLatin1String(part)), qPrintable(refusal->text()));
        }
        stiffness->setValue(0.4);
        QCOMPARE(model.structure(1).tissue.stiffness_N_per_mm, 0.4);
        QVERIFY(bound->isHidden() && refusal->isHidden());
    }
    void keysInTheListMoveALayerInAndOut()
    {
        ui::StructureModel model;
        ui::StructurePanel panel(model);
        std::vector<ui::StructureRow> rows = test::twoRows();
        rows[1].in = 0;
        model.setRows(std::move(rows));
        panel.select(1);
        auto* list = panel.findChild<QTreeView*>();
        auto* layer = test::boxNamed(panel, "Depth order, from outside");
        QCOMPARE(layer->currentText(), QStringLiteral("own surface, outermost"));
        QTest::keyClick(list, Qt::Key_Up, Qt::ControlModifier); // already outermost
        QVERIFY(!model.undoStack().canUndo());
        const QStringList texts{"as a layer, below liver capsule", "as a layer, 2 below surface",
                                "as a layer, 3 below surface", "as a layer, 3 below surface"};
        for (int i = 0; i < 4; ++i) {
            QTest::keyClick(list, Qt::Key_Down, Qt::ControlModifier);
            QCOMPARE(model.structure(1).layer, static_cast<std::uint32_t>(std::min(i + 1, 3)));
            QCOMPARE(layer->currentText(), texts[i]);
        }
        QCOMPARE(panel.currentRow(), 1);
        QTest::keyClick(list, Qt::Key_Up, Qt::ControlModifier);
        QCOMPARE(layer->currentText(), texts[1]);
        const QModelIndex name = model.index(1, ui::StructureModel::Name);
        QCOMPARE(name.data(ui::StructureModel::kLayerRole).toUInt(), 2u);
        QVERIFY(name.data(Qt::AccessibleTextRole).toString().contains(QStringLiteral(", 2 below surface")));
        model.undoStack().undo(); // each key press is a separate undo step
        QCOMPARE(model.structure(1).layer, 3u);
        layer->setCurrentIndex(1);
        Q_EMIT layer->activated(1);
        QCOMPARE(model.structure(1).layer, 1u);
        QCOMPARE(model.structure(0).layer, 0u);
    }
    void presetSetsItsTissue()
    {
        ui::StructureModel model;
        ui::StructurePanel panel(model);
        model.setRows(test::twoRows());
        panel.select(0);
        auto* presets = panel.findChild<QComboBox*>();
        presets->setCurrentIndex(5);
        Q_EMIT presets->activated(5);
        QCOMPARE(model.structure(0).tissue.stiffness_N_per_mm, ui::tissuePresets()[4].tissue.stiffness_N_per_mm);
        QCOMPARE(presets->currentIndex(), 5);
        panel.findChildren<QDoubleSpinBox*>().first()->setValue(0.77);
        QCOMPARE(presets->currentIndex(), 0); // custom values
    }
    void keysInTheListShowAndFeel()
    {
        ui::StructureModel model;
        ui::StructurePanel panel(model);
        model.setRows(test::twoRows());
        panel.select(1);
        auto* list = panel.findChild<QTreeView*>();
        QTest::keyClick(list, Qt::Key_E, Qt::ControlModifier);
        QVERIFY(!model.structure(1).visible);
        QTest::keyClick(list, Qt::Key_H, Qt::ControlModifier);
        QVERIFY(!model.structure(1).palpable);
        QVERIFY(model.structure(0).visible && model.structure(0).palpable);
    }
    void messageStaysUntilItIsClosed()
    {
        QWidget window;
        ui::Messages messages;
        ui::MessageBar bar(messages, &window);
        window.show();
        QVERIFY(!bar.isVisible());
        bar.showError(QStringLiteral("liver.stl: no triangle"));
        QVERIFY(bar.isVisible());
        QCOMPARE(bar.text(), QStringLiteral("liver.stl: no triangle"));
    }
    void messagesOfABatchAreInsertedAtOnce()
    {
        ui::Messages messages;
        QSignalSpy inserted(&messages, &QAbstractItemModel::rowsInserted);
        messages.add(ui::Messages::Kind::Warning, QStringList{"a", "b", "b", "", "c"});
        QCOMPARE(inserted.count(), 1);
        QCOMPARE(messages.rowCount(), 3);
        messages.add(ui::Messages::Kind::Told, QStringLiteral("c"));
        QCOMPARE(messages.rowCount(), 3); // repeated
        QStringList many;
        for (int i = 0; i < ui::Messages::kMost + 10; ++i) {
            many << QString::number(i);
        }
        messages.add(ui::Messages::Kind::Told, many.mid(0, ui::Messages::kMost - 1));
        QCOMPARE(messages.rowCount(), ui::Messages::kMost);
        QCOMPARE(messages.text(0), QStringLiteral("c"));
        messages.add(ui::Messages::Kind::Told, many);
        QCOMPARE(messages.rowCount(), ui::Messages::kMost);
        QCOMPARE(messages.text(ui::Messages::kMost - 1), many.back());
        QCOMPARE(messages.text(0), QStringLiteral("10"));
    }
    void offerDoesWhatItsButtonSays()
    {
        QWidget window;
        ui::Messages messages;
        ui::MessageBar bar(messages, &window);
        window.show();
        int done = 0;
        bar.offer(QStringLiteral("0.3 mm across"), QStringLiteral("Read as metres"), [&] { ++done; });
        bar.findChild<ui::MessageRow*>()->findChild<QPushButton*>()->click();
        QCOMPARE(done, 1);
        QVERIFY(!bar.isVisible());
        bar.showError(QStringLiteral("something else"));
        const auto* button = bar.findChild<ui::MessageRow*>()->findChild<QPushButton*>();
        QVERIFY(button == nullptr);
    }
    void emptyChipIsNotShown()
    {
        QWidget window;
        ui::Chip chip(QStringLiteral("rate"), &window);
        window.show();
        QVERIFY(!chip.isVisible());
        chip.say(QStringLiteral("1.00 kHz"));
        QVERIFY(chip.isVisible());
        chip.say({});
        QVERIFY(!chip.isVisible());
    }
    void welcomeOffersWhatIsThere()
    {
        ui::WelcomePage page;
        bool isHinted = false;
        for (const QLabel* label : page.findChildren<QLabel*>()) {
            isHinted = isHinted || label->text().endsWith(QString::fromStdString(meshio::meshFormatNames("or")));
        }
        QVERIFY(isHinted);
        page.setChoices(true, {QStringLiteral("/a/liver.stl")});
        page.show();
        QSignalSpy recent(&page, &ui::WelcomePage::recentWanted);
        for (auto* button : page.findChildren<QPushButton*>()) {
            if (button->text().contains(QStringLiteral("liver.stl"))) {
                button->click();
            }
        }
        QCOMPARE(recent.count(), 1);
        QCOMPARE(recent.first().first().toString(), QStringLiteral("/a/liver.stl"));
    }
    void textReadsInEachTheme_data()
    {
        QTest::addColumn<ui::Theme>("theme");
        QTest::addColumn<bool>("isDark");
        QTest::addColumn<double>("least");
        QTest::newRow("light") << ui::Theme::Light << false << 4.5;
        QTest::newRow("dark") << ui::Theme::Dark << true << 4.5;
        QTest::newRow("high contrast on black") << ui::Theme::ContrastOnBlack << true << 7.0;
        QTest::newRow("high contrast on white") << ui::Theme::ContrastOnWhite << false << 7.0;
    }
    void textReadsInEachTheme()
    {
        QFETCH(ui::Theme, theme);
        QFETCH(bool, isDark);
        QFETCH(double, least);
        ui::applyTheme(theme);
        QCOMPARE(ui::isDarkTheme(), isDark);
        QCOMPARE(ui::isHighContrast(), least > 4.5);
        const QPalette palette = QApplication::palette();
        QCOMPARE(palette.color(QPalette::BrightText), ui::warningColour());
        for (const auto ground : {QPalette::Window, QPalette::Base, QPalette::AlternateBase, QPalette::Button}) {
            const QColor behind = palette.color(ground);
            for (const QColor& ink : {palette.color(QPalette::Text), palette.color(QPalette::ButtonText),
                                      palette.color(QPalette::Link), ui::mutedColour(), ui::forceColour(),
                                      ui::depthColour(), ui::warningColour(), ui::recordColour(), ui::goodColour()}) {
                QVERIFY2(contrast(ink, behind) >= least,
                         qPrintable(ink.name() + QStringLiteral(" on ") + behind.name()));
            }
        }
        QVERIFY(contrast(palette.color(QPalette::HighlightedText), palette.color(QPalette::Highlight)) >= least);
        if (theme == ui::Theme::ContrastOnBlack || theme == ui::Theme::ContrastOnWhite) {
            const QColor disabled = palette.color(QPalette::Disabled, QPalette::Text);
            QVERIFY(contrast(disabled, palette.color(QPalette::Window)) >= least);
            QCOMPARE(palette.color(QPalette::Window), isDark ? QColor(Qt::black) : QColor(Qt::white));
        }
    }
    void symbolsReadInEachTheme_data() { textReadsInEachTheme_data(); }
    void symbolsReadInEachTheme()
    {
        QFETCH(ui::Theme, theme);
        QFETCH(double, least);
        ui::applyTheme(theme);
        for (int i = 0; i <= static_cast<int>(ui::Symbol::Keys); ++i) {
            for (const auto ground : {QPalette::Window, QPalette::Base}) {
                QImage picture(64, 64, QImage::Format_RGB32);
                picture.fill(QApplication::palette().color(ground));
                QPainter painter(&picture);
                ui::icon(static_cast<ui::Symbol>(i)).paint(&painter, picture.rect());
                painter.end();
                double best = 0.0;
                for (int at = 0; at < 64 * 64; ++at) {
                    best = std::max(best, contrast(picture.pixelColor(at % 64, at / 64), picture.pixelColor(0, 0)));
                }
                QVERIFY2(best >= least, qPrintable(QStringLiteral("symbol %1: %2").arg(i).arg(best)));
            }
        }
    }
    /// Texts in the view have a translucent background over tissue of any colour.
    void textsOnTissueRead()
    {
        const auto over = [](const view::Colour& tissue, double opacity) {
            view::Colour seen{};
            for (std::size_t i = 0; i < seen.size(); ++i) {
                seen[i] = opacity * view::kTextGround[i] + (1.0 - opacity) * tissue[i];
            }
            return QColor::fromRgbF(static_cast<float>(seen[0]), static_cast<float>(seen[1]),
                                    static_cast<float>(seen[2]));
        };
        const auto colour = [](const view::Colour& c) {
            return QColor::fromRgbF(static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2]));
        };
        const view::Colour white{1.0, 1.0, 1.0}, black{0.0, 0.0, 0.0};
        for (const view::Colour& ink :
             {view::kTextColour, view::textColourOf(black), view::textColourOf({1.0, 0.0, 0.0})}) {
            for (const view::Colour& tissue : {white, black}) {
                QVERIFY(contrast(colour(ink), over(tissue, view::TextStyle().groundOpacity)) >= 4.5);
                QVERIFY(contrast(colour(ink), over(tissue, 1.0)) >= 7.0); // opaque in high contrast
            }
        }
    }
    void warningsFollowTheTheme()
    {
        ui::applyTheme(ui::Theme::Light);
        ui::StructureModel model;
        ui::StructurePanel panel(model);
        const auto warning = [&panel] {
            for (const QLabel* one : panel.findChildren<QLabel*>()) {
                if (one->accessibleDescription().contains(QLatin1String("rejecting"))) {
                    return one->palette().color(one->foregroundRole());
                }
            }
            return QColor();
        };
        const QColor light = ui::warningColour();
        QCOMPARE(warning(), light);
        ui::applyTheme(ui::Theme::ContrastOnBlack);
        QCOMPARE(warning(), ui::warningColour());
        QVERIFY(warning() != light);
    }
    void bigNumbersGrowWithTheText()
    {
        ui::TouchPanel panel;
        panel.show(ui::TouchReading{1.0, 2.314, 4.62, QStringLiteral("liver"), 0.5, 1});
        panel.setVisible(true);
        const auto height = [&panel](const QString& text) {
            for (const QLabel* label : panel.findChildren<QLabel*>()) {
                if (label->text() == text) {
                    return label->fontMetrics().height();
                }
            }
            return 0;
        };
        const int force = height(QStringLiteral("2.31")), unit = height(QStringLiteral("N"));
        const int bar = panel.findChild<ui::ForceBar*>()->sizeHint().height();
        ui::applyTextSize(200);
        PALPATE_TRY_VERIFY(height(QStringLiteral("2.31")) > 1.8 * force);
        PALPATE_TRY_VERIFY(height(QStringLiteral("N")) > 1.8 * unit);
        QVERIFY(panel.findChild<ui::ForceBar*>()->sizeHint().height() > bar);
        ui::applyTextSize(100);
        PALPATE_TRY_COMPARE(height(QStringLiteral("2.31")), force);
    }
    void systemsPaletteIsSeen()
    {
        ui::applyTheme(ui::Theme::System);
        QVERIFY(!ui::noteSystemPalette(false)); // set by the application
        const bool wasDark = ui::isDarkTheme();
        QPalette other;
        other.setColor(QPalette::Window, wasDark ? Qt::white : Qt::black);
        other.setColor(QPalette::WindowText, wasDark ? Qt::black : Qt::white);
        QApplication::setPalette(other);
        QVERIFY(ui::noteSystemPalette(false));
        ui::applyTheme(ui::Theme::System);
        QCOMPARE(ui::isDarkTheme(), !wasDark);
        QVERIFY(!ui::noteSystemPalette(false));
        QVERIFY(ui::noteSystemPalette(true)); // same as before the test
        ui::applyTheme(ui::Theme::System);
        QCOMPARE(ui::isDarkTheme(), wasDark);
    }
};

PALPATE_TEST(Panels)
#include "tst_Panels.moc"

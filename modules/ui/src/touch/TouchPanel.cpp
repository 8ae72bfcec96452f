// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/TouchPanel.h"

#include "palpate/ui/FeltWords.h"
#include "palpate/ui/Theme.h"
#include "palpate/ui/TouchChart.h"

#include <QEvent>
#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>

#include <algorithm>

namespace palpate::ui {

namespace {

constexpr double kRows = 1.1;                      // font size of the layer rows relative to the panel
constexpr double kNumber = 3.6, kLowNumber = 2.2;  // font size of the force
constexpr int kSpacing_px = 6, kLowSpacing_px = 2; // between the rows
constexpr double kFlatPeriod_s = 0.2;              // between repaints of the chart while nothing is touched

/// QWidget::setForegroundRole repaints even without a change.
void setRole(QLabel& label, QPalette::ColorRole role)
{
    if (label.foregroundRole() != role) {
        label.setForegroundRole(role);
    }
}

} // namespace

QString forceText(double force_N)
{
    const int decimals = force_N < 9.995 ? 2 : force_N < 99.95 ? 1 : 0;
    return QLocale().toString(force_N, 'f', decimals);
}

QString depthText(double depth_mm)
{
    return QLocale().toString(depth_mm, 'f', depth_mm < 0.95 ? 2 : 1);
}

PalpatedStructure palpatedStructure(const TouchReading& reading)
{
    const bool isTold = buried::verdictOf(reading.lumpRatio) != buried::Verdict::NotByHand;
    if (reading.layers.size() > 1) {
        const LayerShare& inner = reading.layers.back();
        return {inner.name, reading.structure, inner.along_N, inner.depth_mm, {}};
    }
    if (!reading.lump.isEmpty() && isTold) {
        return {reading.lump, reading.structure, reading.force_N, reading.depth_mm, reading.lumpRatio};
    }
    return {reading.structure, {}, reading.force_N, reading.depth_mm, {}};
}

QString overLumpText(const TouchReading& reading)
{
    return reading.lump.isEmpty()
               ? QString()
               : TouchPanel::tr("over %1: %2").arg(reading.lump, responseChangeText(reading.lumpRatio));
}

QString lumpText(const TouchReading& reading)
{
    return reading.lump.isEmpty()
               ? QString()
               : TouchPanel::tr("over %1: %2, %3")
                     .arg(reading.lump, responseChangeText(reading.lumpRatio), verdictPhrase(reading.lumpRatio));
}

std::vector<LayerForce> chartForces(const TouchReading& reading)
{
    std::vector<LayerForce> forces = layerForces(reading.layers);
    if (forces.size() == 1 && !reading.lump.isEmpty() && reading.lumpRatio > 1.0) {
        const double organ_N = forces.front().force_N / reading.lumpRatio;
        forces.push_back({reading.lumpColour, forces.front().force_N - organ_N});
        forces.front().force_N = organ_N;
    }
    return forces;
}

QString whereText(const PalpatedStructure& felt)
{
    return felt.inside.isEmpty() ? felt.name : TouchPanel::tr("%1 in %2").arg(felt.name, felt.inside);
}

QString touchText(const TouchReading& reading)
{
    return TouchPanel::tr("%1 N, %2 mm deep").arg(forceText(reading.force_N), depthText(reading.depth_mm));
}

QString detailText(const TouchReading& reading)
{
    if (reading.isSlidOff) {
        return TouchPanel::tr("%1 mm deep · slid aside").arg(depthText(reading.depth_mm));
    }
    return TouchPanel::tr("%1 mm deep · %2 N/mm")
        .arg(depthText(reading.depth_mm), QLocale().toString(reading.stiffness_N_per_mm, 'f', 2));
}

TouchPanel::TouchPanel(QWidget* parent)
    : QWidget(parent)
    , m_source(new QLabel(this))
    , m_force(new QLabel(this))
    , m_forceUnit(new QLabel(tr("N"), this))
    , m_structure(new QLabel(this))
    , m_layers(new QLabel(this))
    , m_detail(new QLabel(this))
    , m_late(new QLabel(this))
    , m_bar(new ForceBar(this))
    , m_chart(new TouchChart(m_history, this))
{
    m_source->setObjectName(QStringLiteral("touchSource"));
    m_source->setAccessibleDescription(tr("Source of the values: the live hand or the recording"));
    keepFont(*m_force, kNumber, QFont::DemiBold);
    m_force->setAccessibleDescription(tr("Force in newtons"));
    m_force->setToolTip(tr("Force on the hand [N]"));
    keepFont(*m_forceUnit, 1.8, QFont::Normal);
    keepFont(*m_structure, 1.25, QFont::DemiBold);
    m_structure->setTextFormat(Qt::PlainText);
    m_structure->setAccessibleDescription(tr("Touched structure"));
    m_structure->setMinimumWidth(10);
    m_layers->setTextFormat(Qt::RichText);
    m_layers->setAccessibleDescription(tr("Touched structures from outside in, with forces and depths"));
    m_layers->setToolTip(tr("Touched layers from outside in: share of the total force [N], measured along\n"
                            "the total force, and depth of the hand in each layer [mm]"));
    m_layers->setMinimumWidth(10);
    m_layers->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    keepFont(*m_layers, kRows, QFont::Normal);
    keepFont(*m_detail, 1.25, QFont::Normal);
    m_detail->setWordWrap(true); // for large texts in a narrow panel
    m_detail->setAccessibleDescription(tr("Depth and stiffness"));
    m_detail->setToolTip(
        tr("Depth of the hand below the outermost surface [mm]; stiffness of all touched layers together [N/mm]"));
    m_late->setWordWrap(true);
    m_late->hide();
    m_late->setToolTip(tr("The mesh has more triangles here than can be evaluated in time"));

    auto* number = new QHBoxLayout;
    number->setSpacing(6);
    number->addWidget(m_force, 0, Qt::AlignBaseline);
    number->addWidget(m_forceUnit, 0, Qt::AlignBaseline);
    number->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(14, 6, 14, 10);
    layout->setSpacing(kSpacing_px);
    layout->addWidget(m_source);
    layout->addLayout(number);
    layout->addWidget(m_bar);
    layout->addSpacing(4);
    layout->addWidget(m_structure);
    layout->addWidget(m_detail);
    layout->addWidget(m_layers);
    layout->addSpacing(6);
    layout->addWidget(m_chart, 1);
    layout->addWidget(m_late);
    m_bar->setLimit(m_bar->limit_N());
    fitFont();
    showNoHand();
}

void TouchPanel::fitFont()
{
    // Reserves two rows, so that the layout does not jump when a second layer is reached.
    QFont rows = font();
    rows.setPointSizeF(kRows * font().pointSizeF());
    m_layers->setMinimumHeight((m_isLow ? 1 : 2) * QFontMetrics(rows).lineSpacing() + 2);
}

/// Height that the sizes of a low panel save. [px]
int TouchPanel::savedHeight() const
{
    const auto lineOf = [this](double ratio) {
        QFont scaled = font();
        scaled.setPointSizeF(ratio * font().pointSizeF());
        return QFontMetrics(scaled).lineSpacing();
    };
    const int gaps = layout()->count() - 1;
    return lineOf(kNumber) - lineOf(kLowNumber) + lineOf(kRows) + gaps * (kSpacing_px - kLowSpacing_px) +
           TouchChart::kLowSaves_px;
}

int TouchPanel::heightForWidth(int width) const
{
    return layout()->minimumHeightForWidth(width) - (m_isLow ? 0 : savedHeight());
}

/// Changes to or from the sizes of a low panel.
void TouchPanel::setLow(bool isLow)
{
    m_isLow = isLow;
    keepFont(*m_force, isLow ? kLowNumber : kNumber, QFont::DemiBold);
    layout()->setSpacing(isLow ? kLowSpacing_px : kSpacing_px);
    m_chart->setLow(isLow);
    fitFont();
}

void TouchPanel::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::FontChange) {
        fitFont();
    }
    QWidget::changeEvent(event);
}

void TouchPanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    const int usual_px = heightForWidth(width()) + savedHeight();
    if (const bool isLow = height() < usual_px; isLow != m_isLow) {
        setLow(isLow);
    }
    setLine(m_structure->toolTip(), m_detail->text()); // elides the name for the new width
}

double TouchPanel::forceLimit_N() const
{
    return m_bar->limit_N();
}

void TouchPanel::setForceLimit(double force_N)
{
    m_bar->setLimit(force_N);
}

void TouchPanel::setLine(const QString& structure, const QString& detail)
{
    const QString shown =
        m_structure->fontMetrics().elidedText(structure, Qt::ElideMiddle, std::max(100, width() - 28));
    if (m_structure->text() != shown) {
        m_structure->setText(shown);
    }
    m_structure->setToolTip(structure);
    m_detail->setText(detail);
}

void TouchPanel::setLayers(std::vector<LayerShare> layers)
{
    const bool hasFriction = !layers.empty() && layers.front().friction != haptics::Friction::None;
    if (layers.size() < 2 && !hasFriction) { // name and force are already shown above
        m_layers->setText({});               // unlike clear(), does not repaint without a change
        m_layers->setAccessibleName({});
        return;
    }
    m_layers->setAccessibleName(layersText(layers)); // the label's text is markup
    for (LayerShare& layer : layers) {
        layer.name = m_layers->fontMetrics().elidedText(layer.name, Qt::ElideMiddle, std::max(80, width() - 160));
    }
    m_layers->setText(layersMarkup(layers));
}

/// Shows the transmitted lump at the contact in place of the layers.
void TouchPanel::showLump(const TouchReading& reading)
{
    const QString change = responseChangeText(reading.lumpRatio);
    const QString verdict = verdictPhrase(reading.lumpRatio);
    m_layers->setAccessibleName(lumpText(reading));
    const QString name = m_layers->fontMetrics().elidedText(reading.lump, Qt::ElideMiddle, std::max(80, width() - 160));
    m_layers->setText(QStringLiteral("<p style='white-space:pre'>%1<br>%2</p>")
                          .arg(tr("over %1: %2").arg(name.toHtmlEscaped(), change), verdict));
}

void TouchPanel::show(const TouchReading& reading)
{
    const bool wasTouching = !m_reading.structure.isEmpty();
    m_reading = reading;
    const bool isTouching = !reading.structure.isEmpty();
    showSource(reading.recorded_s);
    m_force->setText(forceText(reading.force_N));
    setRole(*m_force, QPalette::WindowText);
    m_bar->setForce(reading.force_N);
    QStringList names{reading.structure};
    for (std::size_t i = 1; i < reading.layers.size(); ++i) {
        names << reading.layers[i].name;
    }
    setLine(isTouching ? names.join(QStringLiteral(" · ")) : tr("Not touching"), isTouching ? detailText(reading)
                                                                                 : reading.isSlidOff
                                                                                     ? tr("slid aside")
                                                                                     : tr("the hand is free"));
    setLayers(reading.layers);
    if (!reading.lump.isEmpty() && reading.layers.size() < 2) {
        showLump(reading);
    }
    m_late->setText(reading.isAtIterationLimit ? tr("very fine mesh here: force delayed") : QString());
    m_late->setVisible(reading.isAtIterationLimit);
    double along_N = 0.0;
    for (const LayerShare& layer : reading.layers) {
        along_N += layer.friction != haptics::Friction::None ? layer.sideways_N : 0.0;
    }
    m_history.add(
        {reading.time_s, reading.force_N, reading.depth_mm, chartForces(reading), along_N, overLumpText(reading)});
    // Repainting any widget composes the whole window again, which without a GPU takes a processor core at every frame.
    if (isTouching || wasTouching || reading.time_s < m_drawn_s || reading.time_s - m_drawn_s >= kFlatPeriod_s) {
        m_drawn_s = reading.time_s;
        m_chart->update();
    }
    Q_EMIT changed();
}

/// Names the source of the values, because after a recording the same panel shows either. The line always has the same
/// height; values of a recording have a tinted ground.
void TouchPanel::showSource(const std::optional<double>& recorded_s)
{
    m_source->setText(recorded_s ? tr("Recording, %1 s").arg(QLocale().toString(*recorded_s, 'f', 1))
                                 : tr("Live hand"));
    if (m_source->autoFillBackground() != recorded_s.has_value()) {
        m_source->setAutoFillBackground(recorded_s.has_value());
        m_source->setBackgroundRole(recorded_s ? QPalette::Highlight : QPalette::Window);
    }
    setRole(*m_source, recorded_s ? QPalette::HighlightedText : QPalette::WindowText);
}

void TouchPanel::showNoHand()
{
    m_reading = {};
    m_source->setText(QStringLiteral(" ")); // keeps the height
    m_source->setAutoFillBackground(false);
    m_force->setText(forceText(0.0));
    m_force->setForegroundRole(QPalette::PlaceholderText);
    m_bar->setForce(0.0);
    setLine(tr("Not touching"), tr("press on a structure to feel it"));
    setLayers({});
    m_late->clear();
    m_late->hide();
    Q_EMIT changed();
}

void TouchPanel::clearHistory()
{
    m_history.clear();
    m_chart->update();
}

} // namespace palpate::ui

#include "palpate/ui/moc_TouchPanel.cpp"

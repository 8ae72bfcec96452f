// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/SectionBar.h"

#include "palpate/ui/VtkViewport.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

namespace palpate::ui {

namespace {

constexpr int kBarMargin_px = 8;   // from the edges of the view
constexpr double kLargest = 1.0e6; // of positions [mm] and numbers of an image

QToolButton* makeBarButton(const QString& text, const QString& tip, QWidget* parent)
{
    auto* button = new QToolButton(parent);
    button->setText(text);
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    button->setAutoRaise(true);
    return button;
}

} // namespace

SectionBar::SectionBar(VtkViewport& viewport)
    : QFrame(&viewport)
    , m_direction(new QComboBox(this))
    , m_position(new QDoubleSpinBox(this))
    , m_line(new QLabel(this))
{
    setObjectName(QStringLiteral("sectionBar"));
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setCursor(Qt::ArrowCursor);
    m_direction->addItems({tr("Axial"), tr("Coronal"), tr("Sagittal"), tr("Free")});
    m_direction->setAccessibleName(tr("Direction of the section"));
    m_direction->setToolTip(tr("Direction of the section; Free faces the viewer when chosen"));
    m_position->setRange(-kLargest, kLargest);
    m_position->setDecimals(1);
    m_position->setSuffix(tr(" mm"));
    m_position->setKeyboardTracking(false);
    m_position->setAccessibleName(tr("Position of the section"));
    m_position->setToolTip(tr("Position from the origin of the coordinates towards left, back or head. Shift and the "
                              "wheel over the view move the section"));
    QToolButton* side = makeBarButton(QStringLiteral("⇄"), tr("Show the other side of the section"), this);
    QToolButton* close = makeBarButton(QStringLiteral("✕"), tr("End the section"), this);
    m_line->setTextFormat(Qt::PlainText);
    m_line->setObjectName(QStringLiteral("sectionLine"));
    auto* row = new QHBoxLayout;
    for (QWidget* one : std::initializer_list<QWidget*>{m_direction, m_position, side, close}) {
        row->addWidget(one);
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 4, 6, 4);
    layout->setSpacing(2);
    layout->addLayout(row);
    addImageRow(*layout);
    layout->addWidget(m_line);
    hide();
    connect(m_direction, &QComboBox::activated, this,
            [this](int i) { Q_EMIT directionChosen(static_cast<meshio::SectionDirection>(i)); });
    connect(m_position, &QDoubleSpinBox::valueChanged, this, &SectionBar::positionChosen);
    connect(side, &QToolButton::clicked, this, &SectionBar::otherSideWanted);
    connect(close, &QToolButton::clicked, this, &SectionBar::closeWanted);
    viewport.installEventFilter(this);
    connect(&viewport, &VtkViewport::coveredAboveChanged, this, &SectionBar::place);
}

void SectionBar::setSection(meshio::SectionDirection direction, double position_mm, double step_mm, const QString& line)
{
    const QSignalBlocker quietDirection(m_direction), quietPosition(m_position);
    m_direction->setCurrentIndex(static_cast<int>(direction));
    m_position->setSingleStep(step_mm);
    m_position->setValue(position_mm);
    m_line->setText(line);
    m_line->setMinimumWidth(qMax(m_line->minimumWidth(), m_line->sizeHint().width())); // the bar must not jump
    place();
}

void SectionBar::addImageRow(QVBoxLayout& layout)
{
    m_imageRow = new QWidget(this);
    m_image = new QCheckBox(tr("Image"), m_imageRow);
    m_image->setChecked(true);
    m_width = new QDoubleSpinBox(m_imageRow);
    m_level = new QDoubleSpinBox(m_imageRow);
    auto* row = new QHBoxLayout(m_imageRow);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_image);
    const auto add = [&](QDoubleSpinBox& field, const QString& name, const QString& tip, double least) {
        auto* label = new QLabel(name, m_imageRow);
        label->setBuddy(&field);
        field.setRange(least, kLargest);
        field.setKeyboardTracking(false);
        field.setAccessibleName(name);
        field.setToolTip(tip);
        row->addWidget(label);
        row->addWidget(&field);
        connect(&field, &QDoubleSpinBox::valueChanged, this,
                [this] { Q_EMIT windowChosen(m_width->value(), m_level->value()); });
    };
    add(*m_width, tr("Window"), tr("Range of numbers from black to white"), 1e-3);
    add(*m_level, tr("Level"), tr("Number shown in medium grey"), -kLargest);
    connect(m_image, &QCheckBox::toggled, this, &SectionBar::imageToggled);
    m_imageRow->hide();
    layout.addWidget(m_imageRow);
}

void SectionBar::setImage(const QString& name, double width, double level)
{
    // As many digits and as large steps as the range needs: HU in whole numbers, a parameter map of 0 to 1 in
    // hundredths.
    const int decimals = width >= 50.0 ? 0 : width >= 0.5 ? 2 : 4;
    for (QDoubleSpinBox* field : {m_width, m_level}) {
        const QSignalBlocker quiet(field); // fewer decimals round the value
        field->setDecimals(decimals);
        field->setSingleStep(width >= 50.0 ? 10.0 : width / 20.0);
    }
    setWindow(width, level);
    m_image->setToolTip(name);
    m_imageRow->setVisible(!name.isEmpty());
    place();
}

void SectionBar::setWindow(double width, double level)
{
    const QSignalBlocker quietWidth(m_width), quietLevel(m_level);
    m_width->setValue(width);
    m_level->setValue(level);
}

bool SectionBar::isImageShown() const
{
    return m_image->isChecked();
}

QString SectionBar::line() const
{
    return m_line->text();
}

bool SectionBar::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize && watched == parent()) {
        place();
    }
    return QFrame::eventFilter(watched, event);
}

void SectionBar::showEvent(QShowEvent* event)
{
    QFrame::showEvent(event);
    place();
}

void SectionBar::place()
{
    adjustSize();
    const int top_px = static_cast<const VtkViewport*>(parentWidget())->coveredAbove_px() + kBarMargin_px;
    move(qMax(0, parentWidget()->width() - width() - kBarMargin_px), top_px);
    raise();
}

} // namespace palpate::ui

#include "palpate/ui/moc_SectionBar.cpp"

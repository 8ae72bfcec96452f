// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/LawEditor.h"

#include "palpate/ui/Translated.h"
#include "tissue/LawPlot.h"
#include "widgets/ShownComboBox.h"

#include <palpate/meshio/CurveFile.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include <algorithm>
#include <cmath>

namespace palpate::ui {

namespace {

/// Initial parameters of a newly selected law. The exponential law is limited to the device's slope, and measured
/// points sample the current law, so that the force changes as little as possible. Other laws start with their
/// defaults.
/// @param greatest  largest stable slope of the device [N/mm]
core::ForceLaw startingLaw(core::LawKind kind, const core::Tissue& tissue, double greatest)
{
    core::ForceLaw law = core::usualLaw(kind);
    if (kind == core::LawKind::Exponential) {
        law.numbers[2] = std::min(law.numbers[2], std::max(0.01, std::floor(100.0 * greatest) / 100.0));
        law.numbers[0] = std::min(law.numbers[0], law.numbers[2]);
    }
    if (kind == core::LawKind::Points) {
        const auto table = haptics::ForceTable::build(tissue);
        law.points.clear();
        for (int i = 0; i <= 6; ++i) {
            const double depth_mm = 2.0 * i;
            law.points.push_back(
                {depth_mm, table == nullptr ? tissue.stiffness_N_per_mm * depth_mm : table->force(depth_mm)});
        }
    }
    return law;
}

} // namespace

LawEditor::LawEditor(QWidget* parent)
    : QWidget(parent)
    , m_form(new QFormLayout(this))
    , m_kind(new ShownComboBox(this))
    , m_switch(new QCheckBox(this))
    , m_load(new QPushButton(tr("Load points…"), this))
    , m_plot(new LawPlot(this))
{
    const std::array names{tr("Linear"), tr("Stiffer with depth"), tr("Ball on soft tissue"), tr("Thin layer"),
                           tr("Click"),  tr("Measured points")};
    static_assert(std::tuple_size_v<decltype(names)> == core::kLawKinds.size());
    for (const QString& name : names) {
        m_kind->addItem(name);
    }
    m_kind->setAccessibleName(tr("Force law"));
    m_kind->setToolTip(tr("How the force rises with depth"));
    m_load->setToolTip(tr("Load a measured curve from a CSV file with columns depth_mm and force_N"));
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setHorizontalSpacing(10);
    m_form->setVerticalSpacing(8);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    m_form->addRow(new BoxRow(tr("Force law"), m_kind, this));
    for (std::size_t i = 0; i < m_numbers.size(); ++i) {
        m_numbers[i] = new QDoubleSpinBox(this);
        m_numbers[i]->setKeyboardTracking(false);
        m_form->addRow(new QLabel(this), m_numbers[i]);
        connect(m_numbers[i], &QDoubleSpinBox::valueChanged, this, [this, i](double value) { editNumber(i, value); });
    }
    m_form->addRow(m_switch);
    m_form->addRow(m_load);
    m_form->addRow(m_plot);
    connect(m_kind, &QComboBox::activated, this,
            [this](int chosen) { choose(core::kLawKinds[static_cast<std::size_t>(chosen)]); });
    connect(m_switch, &QCheckBox::toggled, this, [this](bool isOn) {
        const auto terms = core::lawParameters(m_tissue.law.kind);
        for (std::size_t i = 0; i < terms.size(); ++i) {
            if (terms[i].isSwitch) {
                editNumber(i, isOn ? 1.0 : 0.0);
            }
        }
    });
    connect(m_load, &QPushButton::clicked, this, &LawEditor::askForFile);
    connect(m_plot, &LawPlot::moved, this, &LawEditor::edited);
    show(m_tissue, m_greatest);
}

void LawEditor::show(const core::Tissue& tissue, double greatest_N_per_mm)
{
    m_isShowing = true;
    m_tissue = tissue;
    m_greatest = greatest_N_per_mm;
    m_kind->setCurrentIndex(static_cast<int>(tissue.law.kind));
    const auto terms = core::lawParameters(tissue.law.kind);
    m_form->setRowVisible(m_switch, false);
    for (std::size_t i = 0; i < m_numbers.size(); ++i) {
        QDoubleSpinBox* field = m_numbers[i];
        const bool isField = i < terms.size() && !terms[i].isSwitch;
        m_form->setRowVisible(field, isField);
        if (isField) {
            const core::LawParameter& term = terms[i];
            const QString name = translated(core::Message(term.name)), unit = QString::fromUtf8(term.unit.data());
            static_cast<QLabel*>(m_form->labelForField(field))->setText(name);
            field->setRange(0.0, term.most); // too small values are rejected with a message instead
            field->setDecimals(term.usual < 1.0 ? 3 : 2);
            field->setSingleStep(0.1 * term.usual);
            field->setSuffix(QLatin1Char(' ') + unit);
            field->setAccessibleName(tr("%1 in %2").arg(name, unit));
            field->setToolTip(tr("%1 [%2]").arg(name, unit));
            field->setValue(tissue.law.numbers[i]);
        } else if (i < terms.size()) {
            m_form->setRowVisible(m_switch, true);
            m_switch->setText(translated(core::Message(terms[i].name)));
            m_switch->setChecked(tissue.law.numbers[i] != 0.0);
        }
    }
    m_form->setRowVisible(m_load, tissue.law.kind == core::LawKind::Points);
    m_plot->show(tissue, greatest_N_per_mm);
    m_isShowing = false;
}

void LawEditor::setTouch(double depth_mm, double scale)
{
    m_plot->setTouch(depth_mm, scale);
}

void LawEditor::choose(core::LawKind kind)
{
    if (kind != m_tissue.law.kind) {
        Q_EMIT edited(startingLaw(kind, m_tissue, m_greatest));
    }
}

void LawEditor::editNumber(std::size_t i, double value)
{
    if (!m_isShowing) { // fields round to fewer digits than the scene stores: take over only the edited one
        core::ForceLaw law = m_tissue.law;
        law.numbers[i] = value;
        Q_EMIT edited(law);
    }
}

void LawEditor::load(const std::filesystem::path& path)
{
    auto points = meshio::readCurve(path);
    if (points.isOk()) {
        Q_EMIT edited({core::LawKind::Points, {}, std::move(points).value()});
    } else {
        Q_EMIT refused(translated(points.status()));
    }
}

void LawEditor::askForFile()
{
    const QString file =
        QFileDialog::getOpenFileName(this, tr("Measured points"), QString(), tr("Tables (*.csv);;All files (*)"));
    if (!file.isEmpty()) {
        load(std::filesystem::path(file.toStdU16String()));
    }
}

} // namespace palpate::ui

#include "palpate/ui/moc_LawEditor.cpp"

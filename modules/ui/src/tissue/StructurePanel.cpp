// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/StructurePanel.h"

#include "structures/StructureList.h"
#include "widgets/FoldGroup.h"
#include "widgets/ShownComboBox.h"

#include "palpate/ui/Translated.h"

#include "palpate/ui/LawEditor.h"
#include "palpate/ui/MapEditor.h"
#include "palpate/ui/Theme.h"
#include "palpate/ui/TouchPanel.h"

#include <palpate/haptics/ForceTable.h>
#include <palpate/study/DeviceLimit.h>
#include <palpate/study/Distances.h>

#include <QColorDialog>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>

namespace palpate::ui {

namespace {

constexpr int kNameLetters = 16; // label width before wrapping to a second line

/// Half of the last displayed digit: a limit as displayed must be accepted as input.
double halfDigit(const core::TissueTerm& term)
{
    return 0.5 * std::pow(10.0, -term.decimals);
}

/// Scroll area with the height of its content that scrolls in low windows.
class FittingScroll final : public QScrollArea
{
  public:
    explicit FittingScroll(QWidget* parent)
        : QScrollArea(parent)
    {
        setWidgetResizable(true);
        setFrameShape(QFrame::NoFrame);
        setFocusPolicy(Qt::NoFocus); // the content takes the focus and is scrolled into view
        setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    }
    [[nodiscard]] QSize sizeHint() const override { return withBar(widget()->sizeHint()); }
    [[nodiscard]] QSize minimumSizeHint() const override
    {
        // With large texts the editor scrolls horizontally, so that the list above keeps its width.
        constexpr int kMostWidth_px = 240;
        return {std::min(kMostWidth_px, withBar(widget()->minimumSizeHint()).width()), 160};
    }

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (event->type() == QEvent::LayoutRequest) {
            updateGeometry();
        }
        return QScrollArea::eventFilter(watched, event);
    }

  private:
    /// Adds the width of the scroll bar.
    [[nodiscard]] QSize withBar(const QSize& size) const
    {
        return {size.width() + verticalScrollBar()->sizeHint().width(), size.height()};
    }
};

/// Hidden warning label. @param what  subject of the warning; screen readers read the text first
QLabel* makeWarning(const QString& what, QWidget* box)
{
    auto* label = new QLabel(box);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setAccessibleDescription(what);
    label->setForegroundRole(QPalette::BrightText); // warning colour, see Theme.h
    label->hide();
    return label;
}

} // namespace

StructurePanel::StructurePanel(StructureModel& model, QWidget* parent)
    : QWidget(parent)
    , m_model(model)
    , m_list(new StructureList(model, this))
{
    m_list->view().installEventFilter(this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_list, 1);
    m_tissue = makeTissueBox();
    auto* scrolled = new FittingScroll(this);
    scrolled->setWidget(m_tissue);
    layout->addWidget(scrolled);

    connect(&m_list->view(), &QTreeView::clicked, this, &StructurePanel::click);
    connect(&m_list->view(), &QWidget::customContextMenuRequested, this, &StructurePanel::openMenu);
    connect(m_list, &StructureList::selectionChanged, this, [this] {
        m_refusal->hide();
        showSelection();
        m_isChosen = m_isChosen || m_list->view().hasFocus();
        Q_EMIT highlighted(m_isChosen ? selectedRows() : std::vector<int>());
    });
    connect(&model, &QAbstractItemModel::dataChanged, this, &StructurePanel::showSelection);
    const auto showHealth = [this] {
        bool isAnyDefective = false;
        for (int row = 0; row < m_model.rowCount(); ++row) {
            isAnyDefective = isAnyDefective || m_model.isDefective(row);
        }
        m_list->view().setColumnHidden(StructureModel::Health, !isAnyDefective);
    };
    connect(&model, &QAbstractItemModel::rowsInserted, this, showHealth);
    connect(&model, &QAbstractItemModel::modelReset, this, [this, showHealth] {
        m_colouredRow = -1;
        m_isChosen = false;
        showHealth();
        select(0);
        showSelection();
    });
    showSelection();
}

void StructurePanel::addHead(QFormLayout& form, QWidget* box)
{
    m_colour = new QToolButton(box);
    m_colour->setAutoRaise(true);
    keepIconSize(*m_colour, 16);
    m_colour->setToolTip(tr("Colour of the structure"));
    m_colour->setAccessibleName(tr("Colour"));
    m_title = new QLabel(box);
    m_title->setTextFormat(Qt::PlainText);
    QFont bold = font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_title->setMinimumWidth(10);
    auto* head = new QHBoxLayout;
    head->addWidget(m_colour);
    head->addWidget(m_title, 1);
    form.addRow(head);
    m_findings = new QLabel(box);
    m_findings->setWordWrap(true);
    m_findings->setTextFormat(Qt::PlainText);
    m_findings->setForegroundRole(QPalette::PlaceholderText);
    form.addRow(m_findings);
    m_size = new QLabel(box);
    m_size->setObjectName(QStringLiteral("size"));
    m_size->setWordWrap(true);
    m_size->setTextFormat(Qt::PlainText);
    m_size->setForegroundRole(QPalette::PlaceholderText);
    m_size->setTextInteractionFlags(Qt::TextSelectableByMouse);
    form.addRow(m_size);
    // About rows of any group, so in none that may be folded.
    m_refusal = makeWarning(tr("Reason for rejecting the value"), box);
    form.addRow(m_refusal);
    m_mapWarning = makeWarning(tr("Stability warning for the map"), box);
    form.addRow(m_mapWarning);
    connect(m_colour, &QToolButton::clicked, this, &StructurePanel::chooseColour);
}

void StructurePanel::addOpacity(QFormLayout& form, QWidget* box)
{
    m_opacity = new QSlider(Qt::Horizontal, box);
    m_opacity->setRange(0, 100);
    m_opacity->setPageStep(10);
    m_opacity->setAccessibleName(tr("Opacity in per cent"));
    m_opacity->setToolTip(tr("Opacity [%]; at lower values, structures behind show through"));
    m_opacityText = new QLabel(box);
    m_opacityText->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("100 %")));
    m_opacityText->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    auto* opacity = new QHBoxLayout;
    opacity->addWidget(m_opacity, 1);
    opacity->addWidget(m_opacityText);
    form.addRow(tr("Opacity"), opacity);
    connect(m_opacity, &QSlider::valueChanged, this, &StructurePanel::editOpacity);
}

/// Input field of one tissue parameter.
QDoubleSpinBox* StructurePanel::makeField(const core::TissueTerm& term, QWidget* box)
{
    auto* field = new QDoubleSpinBox(box);
    // Allows values beyond any device, so that a too large value is rejected with a message instead of being cut off
    // while typing.
    field->setRange(0.0, term.most);
    field->setKeyboardTracking(false);
    field->setDecimals(term.decimals);
    field->setSingleStep(term.step);
    const QString name = translated(core::Message(term.name)), unit = QString::fromUtf8(term.unit.data());
    field->setSuffix(QLatin1Char(' ') + unit);
    field->setToolTip(tr("%1 [%2]: %3").arg(name, unit, translated(core::Message(term.meaning))));
    field->setAccessibleName(tr("%1 in %2").arg(name, translated(core::Message(term.accessibleUnit))));
    // Fields round to fewer digits than the scene stores: take over only the edited one.
    connect(field, &QDoubleSpinBox::valueChanged, this, [this, &term](double value) {
        changeTissue([&](haptics::Tissue& tissue) { tissue.*term.member = value; });
    });
    return field;
}

void StructurePanel::addPresets(QFormLayout& form, QWidget* box)
{
    m_preset = new ShownComboBox(box);
    m_preset->addItem(tr("Custom"));
    for (const TissuePreset& preset : tissuePresets()) {
        m_preset->addItem(tr(preset.name));
        m_preset->setItemData(m_preset->count() - 1, tr(preset.source), Qt::ToolTipRole);
    }
    m_preset->setAccessibleName(tr("Tissue"));
    m_preset->setToolTip(tr("Tissue preset"));
    form.addRow(new BoxRow(tr("Tissue"), m_preset, box));
    m_source = new QLabel(box);
    m_source->setWordWrap(true);
    m_source->setForegroundRole(QPalette::PlaceholderText);
    form.addRow(m_source);
    connect(m_preset, &QComboBox::activated, this, [this](int chosen) {
        if (chosen > 0) {
            const TissuePreset& preset = tissuePresets()[static_cast<std::size_t>(chosen - 1)];
            changeTissue([&](haptics::Tissue& tissue) { tissue = withPreset(tissue, preset); });
        }
    });
}

void StructurePanel::addLaw(QFormLayout& form, QWidget* box)
{
    m_law = new LawEditor(box);
    form.addRow(m_law);
    connect(m_law, &LawEditor::edited, this,
            [this](const core::ForceLaw& law) { changeTissue([&](haptics::Tissue& tissue) { tissue.law = law; }); });
    connect(m_law, &LawEditor::refused, this, &StructurePanel::refuse);
}

void StructurePanel::addMap(QFormLayout& form, QWidget* box)
{
    m_map = new MapEditor(box);
    form.addRow(m_map);
    connect(m_map, &MapEditor::edited, this, [this](const MapEditor::Maps& maps) {
        if (!m_isShowing && selectedRows().size() == 1) {
            meshio::SceneStructure changed = m_model.structure(currentRow());
            changed.maps = maps;
            m_refusal->hide();
            m_model.edit(currentRow(), changed);
        }
    });
    connect(m_map, &MapEditor::colourChosen, this, [this](const QString& what) {
        m_colouredRow = currentRow();
        m_coloured = what;
        Q_EMIT colourChosen(m_colouredRow, what);
    });
}

void StructurePanel::addFriction(QFormLayout& form, QWidget* box)
{
    m_friction = new ShownComboBox(box);
    for (const FrictionPreset& preset : frictionPresets()) {
        m_friction->addItem(tr(preset.name));
    }
    m_friction->addItem(tr("Custom"));
    m_friction->setAccessibleName(tr("Friction"));
    m_friction->setToolTip(tr("Friction preset"));
    form.addRow(new BoxRow(tr("Friction"), m_friction, box));
    connect(m_friction, &QComboBox::activated, this, [this](int chosen) {
        if (static_cast<std::size_t>(chosen) < frictionPresets().size()) {
            const double coefficient = frictionPresets()[static_cast<std::size_t>(chosen)].coefficient;
            changeTissue(
                [&](haptics::Tissue& tissue) { tissue.friction_static = tissue.friction_dynamic = coefficient; });
        }
        showFrictionTerms();
    });
}

/// Shows the friction coefficients for the manual setting.
void StructurePanel::showFrictionTerms()
{
    const bool isOwn = m_friction->currentIndex() == m_friction->count() - 1;
    for (std::size_t i = 0; i < m_terms.size(); ++i) {
        if (core::kTissueTerms[i].group == "friction") {
            setRowVisible(*m_terms[i], isOwn);
        }
    }
}

/// Adds the field of a tissue parameter. @param i  number in core::kTissueTerms
void StructurePanel::addTerm(std::size_t i, QFormLayout& form, QWidget* box)
{
    m_terms[i] = makeField(core::kTissueTerms[i], box);
    auto* name = new QLabel(translated(core::Message(core::kTissueTerms[i].name)), box);
    name->setWordWrap(true); // a long label must not widen the panel
    name->setFixedWidth(std::min(name->fontMetrics().horizontalAdvance(name->text()) + 2,
                                 kNameLetters * fontMetrics().averageCharWidth()));
    form.addRow(name, m_terms[i]);
}

/// Adds the stiffness, the most important number, with the messages on it.
void StructurePanel::addStiffness(QFormLayout& form, QWidget* box)
{
    static_assert(core::kTissueTerms.front().member == &haptics::Tissue::stiffness_N_per_mm);
    addTerm(0, form, box);
    m_bound = makeWarning(tr("Effective stiffness"), box);
    form.addRow(m_bound);
}

void StructurePanel::addOtherTerms(QFormLayout& form, QWidget* box)
{
    for (std::size_t i = 1; i < m_terms.size(); ++i) {
        if (core::kTissueTerms[i].member == &haptics::Tissue::friction_static) {
            addFriction(form, box);
        }
        addTerm(i, form, box);
    }
}

void StructurePanel::addLayer(QFormLayout& form, QWidget* box)
{
    m_layer = new ShownComboBox(box);
    m_layer->setAccessibleName(tr("Depth order, from outside"));
    m_layer->setToolTip(tr("Order in which a pressing hand meets the structures (Ctrl+Down, Ctrl+Up in the list)"));
    form.addRow(new BoxRow(tr("Depth order"), m_layer, box));
    connect(m_layer, &QComboBox::activated, this, [this](int chosen) { setLayer(m_layer->itemData(chosen)); });
}

void StructurePanel::addSurface(QFormLayout& form, QWidget* box)
{
    m_surface = new ShownComboBox(box);
    m_surface->addItem(tr("As in the file"), static_cast<int>(meshio::SurfaceKind::Facets));
    m_surface->addItem(tr("Smoothed"), static_cast<int>(meshio::SurfaceKind::Smoothed));
    m_surface->addItem(tr("Curved facets"), static_cast<int>(meshio::SurfaceKind::Smooth));
    m_surface->addItem(tr("Smoothed, curved facets"), static_cast<int>(meshio::SurfaceKind::SmoothedSmooth));
    m_surface->setAccessibleName(tr("Surface"));
    m_surface->setToolTip(tr("Smoothing removes voxel steps for display and touch, moving the surface by at most half "
                             "a voxel. Curved facets make coarse facets round; edges of more than 40° stay sharp. The "
                             "file is not changed."));
    m_surfaceRow = new BoxRow(tr("Surface"), m_surface, box);
    form.addRow(m_surfaceRow);
    m_smoothing = new QDoubleSpinBox(box);
    m_smoothing->setRange(0.0, 1.0);
    m_smoothing->setDecimals(2);
    m_smoothing->setSingleStep(0.1);
    m_smoothing->setKeyboardTracking(false);
    m_smoothing->setAccessibleName(tr("Smoothing factor"));
    m_smoothing->setToolTip(tr("Smoothing factor, from 0 (nearly none) to 1. A larger factor removes steps of thick "
                               "slices, and changes the shape more"));
    form.addRow(tr("Smoothing"), m_smoothing);
    m_surfaceCost = new QLabel(box);
    m_surfaceCost->setWordWrap(true);
    form.addRow(m_surfaceCost);
    connect(m_smoothing, &QDoubleSpinBox::valueChanged, this, &StructurePanel::setSmoothing);
    connect(m_surface, &QComboBox::activated, this, [this](int chosen) {
        const auto kind = static_cast<meshio::SurfaceKind>(m_surface->itemData(chosen).toInt());
        change(selectedRows(), [kind](meshio::SceneStructure& structure) { structure.surface = kind; });
    });
}

void StructurePanel::showSurface(const std::vector<int>& rows)
{
    setRowVisible(*m_surfaceRow, !rows.empty());
    m_surface->setEnabled(std::all_of(rows.begin(), rows.end(), [this](int row) { return m_model.isReshapable(row); }));
    std::size_t triangles = 0, bytes = 0;
    bool isCurved = false;
    for (const int row : rows) {
        const meshio::LoadedStructure& one = m_model.rows()[static_cast<std::size_t>(row)].loaded;
        const auto& touch = m_model.rows()[static_cast<std::size_t>(row)].touch;
        isCurved = isCurved || one.curving;
        triangles += one.surface != nullptr ? one.surface->mesh.triangles.size() : 0;
        bytes += touch != nullptr ? touch->byteSize() : 0;
    }
    if (!rows.empty()) {
        const meshio::SceneStructure& one = m_model.structure(currentRow());
        m_surface->setCurrentIndex(m_surface->findData(static_cast<int>(one.surface)));
        m_smoothing->setValue(one.smoothing);
        m_smoothing->setEnabled(m_surface->isEnabled());
        setRowVisible(*m_smoothing, meshio::isSmoothed(one.surface));
    }
    m_surfaceCost->setText(tr("%1 triangles, %2 MiB for touch")
                               .arg(QLocale().toString(static_cast<qulonglong>(triangles)),
                                    QLocale().toString(static_cast<double>(bytes) / (1 << 20), 'f', 1)));
    setRowVisible(*m_surfaceCost, isCurved);
}

/// Sets the factor of the selected structures that are smoothed.
void StructurePanel::setSmoothing(double factor)
{
    if (m_isShowing) {
        return;
    }
    std::vector<int> rows = selectedRows();
    std::erase_if(rows, [this](int row) { return !meshio::isSmoothed(m_model.structure(row).surface); });
    change(rows, [factor](meshio::SceneStructure& structure) { structure.smoothing = factor; });
}

QWidget* StructurePanel::makeTissueBox()
{
    auto* box = new QWidget(this);
    auto* head = new QWidget(box);
    auto* headForm = new QFormLayout(head);
    headForm->setContentsMargins(12, 10, 12, 4);
    headForm->setVerticalSpacing(6);
    auto* feel = new FoldGroup(tr("Feel"), QStringLiteral("properties/feel"), true, box);
    auto* look = new FoldGroup(tr("Appearance"), QStringLiteral("properties/appearance"), true, box);
    auto* advanced = new FoldGroup(tr("Advanced"), QStringLiteral("properties/advanced"), false, box);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 8);
    column->setSpacing(0);
    for (QWidget* part : std::initializer_list<QWidget*>{head, feel, look, advanced}) {
        column->addWidget(part);
    }
    column->addStretch(1);

    addHead(*headForm, head);
    addPresets(feel->form(), feel->content());
    addStiffness(feel->form(), feel->content());
    addLayer(feel->form(), feel->content());
    addOpacity(look->form(), look->content());
    addSurface(look->form(), look->content());
    addOtherTerms(advanced->form(), advanced->content());
    addLaw(advanced->form(), advanced->content());
    addMap(advanced->form(), advanced->content());
    setRowVisible(*m_smoothing, false); // until a smoothed structure is selected
    setRowVisible(*m_surfaceCost, false);
    return box;
}

void StructurePanel::setGreatest(const haptics::Tissue& greatest, const QString& why)
{
    m_greatest = greatest;
    m_limitReason = why;
    m_refusal->hide(); // the message refers to the previous limit
    showSelection();
}

void StructurePanel::setMapWarnings(const QStringList& lines)
{
    m_mapWarnings = lines;
    showMapWarning();
}

void StructurePanel::showMapWarning()
{
    const QString line = selectedRows().size() == 1 ? m_mapWarnings.value(currentRow()) : QString();
    m_mapWarning->setText(line);
    m_mapWarning->setVisible(!line.isEmpty());
}

int StructurePanel::currentRow() const
{
    return m_list->currentRow();
}

std::vector<int> StructurePanel::selectedRows() const
{
    return m_list->selectedRows();
}

void StructurePanel::select(int row)
{
    m_list->select(row);
}

void StructurePanel::choose(std::optional<std::size_t> row, bool adds)
{
    m_isChosen = row.has_value();
    if (row) {
        m_list->select(static_cast<int>(*row), adds);
    }
    Q_EMIT highlighted(row ? selectedRows() : std::vector<int>());
}

void StructurePanel::focusFilter()
{
    m_list->focusFilter();
}

void StructurePanel::removeSelected()
{
    const std::vector<int> rows = selectedRows();
    if (rows.empty()) {
        return;
    }
    const QModelIndex now = m_list->view().currentIndex();
    const int place = now.parent().isValid() ? -1 : now.row();
    m_model.removeRows(rows);
    const StructureTree& tree = m_list->tree();
    if (place >= 0 && tree.rowCount() > 0) { // select the row that moved up
        select(tree.rowOf(tree.index(std::min(place, tree.rowCount() - 1), StructureModel::Name)));
    }
}

void StructurePanel::renameCurrent()
{
    const QModelIndex index = currentRow() < 0 ? QModelIndex() : m_list->tree().indexOf(currentRow());
    if (index.isValid()) {
        m_list->view().setFocus();
        m_list->view().edit(index);
    }
}

/// Changes structures as one undo step. @param text  label of the undo step; empty: a generic label
void StructurePanel::change(const std::vector<int>& rows, const Change& change, const QString& text)
{
    std::vector<StructureModel::Edited> edits;
    for (const int row : rows) {
        edits.push_back({row, m_model.structure(row)});
        change(edits.back().description);
    }
    if (edits.size() == 1 && text.isEmpty()) {
        m_model.edit(edits.front().row, edits.front().description);
    } else {
        m_model.editAll(std::move(edits), text.isEmpty() ? tr("Change %1 structures").arg(rows.size()) : text);
    }
}

/// Changes the tissue of all selected structures. If any change is rejected, none is applied and a line gives the
/// reason.
void StructurePanel::changeTissue(const std::function<void(haptics::Tissue&)>& how)
{
    const std::vector<int> rows = selectedRows();
    if (m_isShowing || rows.empty()) {
        return;
    }
    for (const int row : rows) {
        const haptics::Tissue now = m_model.structure(row).tissue;
        haptics::Tissue asked = now;
        how(asked);
        if (const QString why = refusal(row, asked, now); !why.isEmpty()) {
            refuse(rows.size() == 1 ? why : tr("%1: %2").arg(readableName(m_model.structure(row).name), why));
            return;
        }
    }
    m_refusal->hide();
    change(rows, [&](meshio::SceneStructure& structure) { how(structure.tissue); });
}

/// Toggles visibility or palpability: off for all when any of the structures is on, otherwise on for all.
void StructurePanel::toggle(const std::vector<int>& rows, int column)
{
    if (rows.empty() || (column != StructureModel::Shown && column != StructureModel::Felt)) {
        return;
    }
    bool meshio::SceneStructure::*const what =
        column == StructureModel::Shown ? &meshio::SceneStructure::visible : &meshio::SceneStructure::palpable;
    const bool isOn = std::any_of(rows.begin(), rows.end(), [&](int row) { return m_model.structure(row).*what; });
    change(rows, [&](meshio::SceneStructure& structure) { structure.*what = !isOn; });
}

void StructurePanel::click(const QModelIndex& index)
{
    const std::vector<int> here = m_list->tree().rowsOf(index), all = selectedRows();
    const bool isSelected = !here.empty() && std::includes(all.begin(), all.end(), here.begin(), here.end());
    toggle(isSelected ? all : here, index.column());
}

/// Moves the selected structures by layers, inwards for steps > 0. A structure already at the limit stays.
void StructurePanel::moveLayers(int steps)
{
    std::vector<TouchMode> ways;
    for (const int row : selectedRows()) {
        const int layer = static_cast<int>(m_model.structure(row).layer) + steps;
        if (layer >= 0 && layer < static_cast<int>(haptics::kMaxLayers)) {
            ways.push_back({row, static_cast<std::uint32_t>(layer)});
        }
    }
    changeWays(ways);
}

void StructurePanel::changeWays(const std::vector<TouchMode>& ways)
{
    if (!ways.empty()) {
        feel(m_model, ways,
             ways.size() == 1 ? tr("Change %1").arg(readableName(m_model.structure(ways.front().row).name))
                              : tr("Change %1 structures").arg(ways.size()));
    }
}

bool StructurePanel::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete) {
        event->accept();
        return true;
    }
    if (event->type() == QEvent::KeyPress && currentRow() >= 0) {
        const auto* press = static_cast<QKeyEvent*>(event);
        const int key = press->key();
        const bool isCtrl = press->modifiers() == Qt::ControlModifier;
        if (isCtrl && (key == Qt::Key_E || key == Qt::Key_H)) {
            toggle(selectedRows(), key == Qt::Key_E ? StructureModel::Shown : StructureModel::Felt);
            return true;
        }
        if (key == Qt::Key_Delete) {
            removeSelected();
            return true;
        }
        if (isCtrl && (key == Qt::Key_Down || key == Qt::Key_Up)) {
            moveLayers(key == Qt::Key_Down ? 1 : -1);
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void StructurePanel::fitTitle()
{
    m_title->setText(
        m_title->fontMetrics().elidedText(m_title->toolTip(), Qt::ElideMiddle, std::max(120, width() - 70)));
}

void StructurePanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    if (!m_title->toolTip().isEmpty()) {
        fitTitle();
    }
}

void StructurePanel::showHead(const std::vector<int>& rows)
{
    const QString name =
        rows.size() > 1 ? tr("%1 structures").arg(rows.size()) : readableName(m_model.structure(rows.front()).name);
    m_title->setToolTip(name);
    fitTitle();
    const QStringList found = rows.size() > 1 ? QStringList() : m_model.defects(rows.front());
    m_findings->setVisible(!found.isEmpty());
    m_findings->setText(found.join(QLatin1Char('\n')));
    const meshio::LoadedStructure& one = m_model.rows()[static_cast<std::size_t>(rows.front())].loaded;
    m_size->setVisible(rows.size() == 1 && one.surface != nullptr);
    if (one.surface != nullptr) {
        m_size->setText(translated(study::sizeText(study::sizeOf({}, one.surface->report))));
    }
    m_findings->setToolTip(found.isEmpty() ? QString() : m_model.findings(rows.front()).join(QLatin1Char('\n')));
}

void StructurePanel::showSelection()
{
    const std::vector<int> rows = selectedRows();
    const int row = currentRow();
    const bool isAny = !rows.empty() && row >= 0 && row < m_model.rowCount();
    m_tissue->setEnabled(isAny);
    m_isShowing = true;
    if (isAny) {
        const meshio::SceneStructure& one = m_model.structure(row);
        showHead(rows);
        m_colour->setIcon(m_model.data(m_model.index(row, StructureModel::Name), Qt::DecorationRole).value<QIcon>());
        m_opacity->setValue(static_cast<int>(one.opacity * 100.0 + 0.5));
        m_opacityText->setText(tr("%1 %").arg(m_opacity->value()));
        showTissue(one.tissue);
        const bool isSecret = m_model.scene().hiddenTargets() > 0; // maps can show where a hidden target is
        m_map->setEnabled(rows.size() == 1 && !isSecret);          // arrays belong to a single surface
        m_map->setToolTip(isSecret ? tr("Maps are off until the exercise ends") : QString());
        m_map->show(m_model.rows()[static_cast<std::size_t>(row)], row == m_colouredRow ? m_coloured : QString());
        showMapWarning();
        showLayer(row);
        showSurface(rows);
        showBound(row);
    } else {
        m_bound->hide();
        m_mapWarning->hide();
        m_title->setToolTip({});
        m_title->setText(tr("No structure selected"));
        m_findings->hide();
        m_size->hide();
    }
    m_isShowing = false;
}

void StructurePanel::showTissue(const haptics::Tissue& tissue)
{
    for (std::size_t i = 0; i < m_terms.size(); ++i) {
        m_terms[i]->setValue(tissue.*core::kTissueTerms[i].member);
    }
    // Other laws have parameters of their own.
    setRowVisible(*m_terms.front(), tissue.law.kind == core::LawKind::Linear);
    m_law->show(tissue, m_greatest.stiffness_N_per_mm);
    const int preset = presetOf(tissue), friction = frictionPresetOf(tissue);
    m_preset->setCurrentIndex(preset + 1);
    setRowVisible(*m_source, preset >= 0);
    m_source->setText(preset < 0 ? QString()
                                 : tr("Source: %1").arg(tr(tissuePresets()[static_cast<std::size_t>(preset)].source)));
    m_friction->setCurrentIndex(friction < 0 ? m_friction->count() - 1 : friction);
    showFrictionTerms();
}

void StructurePanel::colourBy(const meshio::ShownMap& shown)
{
    for (int row = 0; row < m_model.rowCount(); ++row) {
        if (m_model.structure(row).name == shown.structure) {
            m_colouredRow = row;
            m_coloured = QString::fromStdString(shown.numbers);
            Q_EMIT colourChosen(row, m_coloured);
            showSelection();
            return;
        }
    }
}

void StructurePanel::showTouch(const TouchReading& reading)
{
    const QString name = currentRow() >= 0 ? readableName(m_model.structure(currentRow()).name) : QString();
    const auto here = std::find_if(reading.layers.begin(), reading.layers.end(),
                                   [&name](const LayerShare& layer) { return layer.name == name; });
    const bool isHere = here != reading.layers.end();
    m_law->setTouch(isHere ? here->depth_mm : 0.0, isHere ? here->stiffnessScale : 1.0);
}

void StructurePanel::showLayer(int row)
{
    const std::uint32_t layer = m_model.structure(row).layer;
    const std::optional<int> organ = transmittingOrgan(m_model, row);
    m_layer->clear();
    for (std::uint32_t i = 0; i < std::max<std::uint32_t>(haptics::kMaxLayers, layer + 1); ++i) {
        const QString text = m_model.touchOrderText(row, i);
        m_layer->addItem(!organ ? text : i == 0 ? tr("own surface, outermost") : tr("as a layer, %1").arg(text), i);
    }
    const bool isThrough = m_model.isTransmitted(row);
    if (organ || isThrough) {
        m_layer->addItem(isThrough
                             ? tr("%1 (felt from above)").arg(m_model.touchOrderText(row))
                             : tr("through %1 (felt from above)").arg(readableName(m_model.structure(*organ).name)));
    }
    m_layer->setCurrentIndex(isThrough ? m_layer->count() - 1 : static_cast<int>(layer));
}

/// Sets the layer. @param chosen  layer; invalid: transmitted through the surrounding organ
void StructurePanel::setLayer(const QVariant& chosen)
{
    if (m_isShowing) {
        return;
    }
    std::vector<TouchMode> ways;
    for (const int row : selectedRows()) {
        if (chosen.isValid()) {
            ways.push_back({row, chosen.toUInt()});
        } else if (transmittingOrgan(m_model, row)) {
            ways.push_back({row, std::nullopt});
        }
    }
    changeWays(ways);
}

/// Stiffness used by other layers: "liver takes 0.8" for each; empty without other layers.
QString StructurePanel::otherLayersText(const std::vector<haptics::HapticStructure>& felt, int row) const
{
    QStringList takers;
    for (const std::size_t by : study::usedByOtherLayers(felt, static_cast<std::size_t>(row)).by) {
        if (!m_model.isListed(static_cast<int>(by))) {
            continue;
        }
        takers << tr("%1 uses %2").arg(readableName(felt[by].name), numberText(study::maxStiffness(felt[by]), 3));
    }
    return takers.join(QStringLiteral(", "));
}

/// Shows the effective stiffness when the device limits it.
void StructurePanel::showBound(int row)
{
    const std::vector<haptics::HapticStructure> felt = m_model.hapticStructures(m_greatest);
    const auto at = static_cast<std::size_t>(row);
    const bool isMapped = !felt[at].maps.stiffness.isEmpty();
    const double own = isMapped ? study::maxStiffness(m_model.hapticStructures(core::unbounded())[at])
                                : haptics::maxStiffness(m_model.structure(row).tissue);
    const double is = study::maxStiffness(felt[at]);
    m_bound->setVisible(own > is + halfDigit(core::kTissueTerms.front()));
    const QString takers = otherLayersText(felt, row);
    m_bound->setText((isMapped ? tr("limited to at most %1 N/mm: the device can render %2 N/mm in total%3")
                               : tr("limited to %1 N/mm: the device can render %2 N/mm in total%3"))
                         .arg(numberText(is, 3), numberText(m_greatest.stiffness_N_per_mm, 3),
                              takers.isEmpty() ? takers : QStringLiteral(", ") + takers));
}

/// Reason for rejecting a tissue; empty if acceptable.
QString StructurePanel::refusal(int row, const haptics::Tissue& asked, const haptics::Tissue& now) const
{
    if (const core::Status law = core::check(asked.law); !law.isOk()) {
        QString why = translated(law);
        // Label of the field instead of the file's key.
        for (const core::LawParameter& term : core::lawParameters(asked.law.kind)) {
            why.replace(QLatin1String(term.key.data()), translated(core::Message(term.name)));
        }
        return tr("Invalid force law: %1.").arg(why);
    }
    const std::vector<haptics::HapticStructure> felt = m_model.hapticStructures(m_greatest);
    const haptics::Tissue taken = study::usedByOtherLayers(felt, static_cast<std::size_t>(row)).tissue;
    for (const core::TissueTerm& term : core::kTissueTerms) {
        const bool isStiffness = term.member == &haptics::Tissue::stiffness_N_per_mm;
        const double value = isStiffness ? haptics::maxStiffness(asked) : asked.*term.member;
        const double before = isStiffness ? haptics::maxStiffness(now) : now.*term.member;
        const double most = std::max(0.0, m_greatest.*term.member - taken.*term.member);
        if (!(value > most + halfDigit(term)) || !(value > before)) {
            continue; // within the limit, or a reduction of a value that already exceeds the limit
        }
        const QLocale locale;
        if (!isStiffness) {
            return tr("%1 N·s/mm is too much: the device can render at most %2 N·s/mm. Enter %2 N·s/mm or less.")
                .arg(numberText(value, 4), locale.toString(most, 'f', 4));
        }
        const QString takers = otherLayersText(felt, row);
        const QString why = takers.isEmpty() ? m_limitReason : tr("%1 Of this, %2.").arg(m_limitReason, takers);
        const QString found = numberText(value, 4);
        const QString allowed = locale.toString(std::floor(100.0 * most + 1e-6) / 100.0, 'f', 2);
        return asked.law.kind == core::LawKind::Linear
                   ? tr("%1 N/mm is too stiff. %2 Enter %3 N/mm or less.").arg(found, why, allowed)
                   : tr("The force law is too steep: up to %1 N/mm. %2 Enter values with a slope of at most %3 N/mm.")
                         .arg(found, why, allowed);
    }
    return {};
}

void StructurePanel::refuse(const QString& line)
{
    showSelection();
    m_refusal->setText(line);
    m_refusal->show();
}

void StructurePanel::editOpacity(int percent)
{
    if (!m_isShowing) {
        change(selectedRows(), [percent](meshio::SceneStructure& structure) { structure.opacity = percent / 100.0; });
    }
}

void StructurePanel::chooseColour()
{
    const std::vector<int> rows = selectedRows();
    if (rows.empty()) {
        return;
    }
    const QColor now = colourOf(m_model.structure(currentRow()));
    const QString what =
        rows.size() == 1 ? readableName(m_model.structure(rows.front()).name) : tr("%1 structures").arg(rows.size());
    const QColor chosen = QColorDialog::getColor(now, this, tr("Colour of %1").arg(what));
    if (chosen.isValid()) {
        change(rows, [&](meshio::SceneStructure& structure) {
            structure.colour = {chosen.redF(), chosen.greenF(), chosen.blueF()};
        });
    }
}

/// Adds the commands for the holes of the selection.
void StructurePanel::addHoleActions(QMenu& menu, const std::vector<int>& rows)
{
    const auto isOpen = [this](int row) {
        const meshio::LoadedStructure& one = m_model.rows()[static_cast<std::size_t>(row)].loaded;
        return m_model.isReshapable(row) && one.surface->report.openEdges > 0;
    };
    if (std::any_of(rows.begin(), rows.end(), isOpen)) {
        const std::vector<geometry::Hole> holes =
            rows.size() == 1 ? m_model.holes(rows.front()) : std::vector<geometry::Hole>();
        const QString size = holes.empty() ? QString() : numberText(holes.front().across_mm, 3);
        menu.addAction(holes.empty()       ? tr("Close the holes")
                       : holes.size() == 1 ? tr("Close the hole of %1 mm").arg(size)
                                           : tr("Close %1 holes of up to %2 mm").arg(holes.size()).arg(size),
                       this, [this, rows] { m_model.closeHoles(rows); });
    }
    if (std::any_of(rows.begin(), rows.end(), [this](int row) { return m_model.structure(row).closeHoles_mm > 0.0; })) {
        menu.addAction(tr("Reopen the holes"), this, [this, rows] { m_model.reopenHoles(rows); });
    }
}

void StructurePanel::openMenu(const QPoint& place)
{
    const std::vector<int> rows = selectedRows();
    const auto setOnly = [this](bool meshio::SceneStructure::*what, const std::vector<int>& only, const QString& text) {
        std::vector<StructureModel::Edited> edits;
        for (int row = 0; row < m_model.rowCount(); ++row) {
            const bool isOn = only.empty() || std::binary_search(only.begin(), only.end(), row);
            if (m_model.structure(row).*what != isOn && m_model.isListed(row)) {
                edits.push_back({row, m_model.structure(row)});
                edits.back().description.*what = isOn;
            }
        }
        m_model.editAll(std::move(edits), text);
    };
    QMenu menu(this);
    const auto add = [&](const QString& text, bool meshio::SceneStructure::*what, const std::vector<int>& only) {
        menu.addAction(text, this, [=] { setOnly(what, only, text); });
    };
    if (!rows.empty()) {
        add(tr("Show only the selection"), &meshio::SceneStructure::visible, rows);
        add(tr("Make only the selection palpable"), &meshio::SceneStructure::palpable, rows);
    }
    add(tr("Show all"), &meshio::SceneStructure::visible, {});
    add(tr("Make all palpable"), &meshio::SceneStructure::palpable, {});
    std::vector<int> insideOut;
    const std::vector<int> all = m_model.insideOutRows();
    std::set_intersection(rows.begin(), rows.end(), all.begin(), all.end(), std::back_inserter(insideOut));
    if (!insideOut.empty()) {
        menu.addSeparator();
        menu.addAction(tr("Turn around"), this, [this, insideOut] { m_model.turnOutwards(insideOut); });
    }
    addHoleActions(menu, rows);
    if (!rows.empty()) {
        menu.addSeparator();
        menu.addAction(tr("Rename…"), this, &StructurePanel::renameCurrent);
        menu.addAction(tr("Remove from the scene"), this, &StructurePanel::removeSelected);
    }
    menu.exec(m_list->view().viewport()->mapToGlobal(place));
}

} // namespace palpate::ui

#include "palpate/ui/moc_StructurePanel.cpp"

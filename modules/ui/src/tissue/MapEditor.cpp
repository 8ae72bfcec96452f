// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/MapEditor.h"

#include "palpate/ui/MapDisplay.h"
#include "palpate/ui/Theme.h"

#include "palpate/ui/Translated.h"
#include "widgets/ShownComboBox.h"

#include <palpate/meshio/SurfaceMaps.h>
#include <palpate/view/SurfaceColours.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate::ui {

namespace {

enum How
{
    ByName,
    None,
    ByHand
};

constexpr int kNothing = 0;                  ///< index of "no source"; the arrays follow
constexpr double kMostRadius_mm = 30.0;      // a palm
constexpr double kMostOfArray = 1e9;         // range of the clamp fields
const QString kVolume = QStringLiteral("?"); ///< item data of the entry that opens a file dialog

bool isModulus(core::MapUnit unit)
{
    return unit == core::MapUnit::YoungKPa || unit == core::MapUnit::ShearKPa;
}

QDoubleSpinBox* makeField(const QString& name, double most, int decimals, QWidget* parent)
{
    auto* field = new QDoubleSpinBox(parent);
    field->setRange(0.0, most);
    field->setDecimals(decimals);
    field->setKeyboardTracking(false);
    field->setAccessibleName(name);
    return field;
}

QString fileName(const std::string& path)
{
    return QString::fromStdString(std::filesystem::path(path).filename().string());
}

} // namespace

MapEditor::MapEditor(QWidget* parent)
    : QWidget(parent)
    , m_form(new QFormLayout(this))
{
    m_form->setContentsMargins(0, 0, 0, 0);
    m_form->setHorizontalSpacing(10);
    m_form->setVerticalSpacing(8);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    makeFields();
    connectFields();
    refresh();
}

void MapEditor::makeFields()
{
    const auto makeBox = [this](const QString& name, const QString& tip) {
        auto* box = new ShownComboBox(this);
        box->setAccessibleName(name);
        box->setToolTip(tip);
        m_form->addRow(new BoxRow(name, box, this));
        return box;
    };
    m_how = makeBox(tr("Map"), tr("Variation of the tissue over the surface"));
    m_how->addItems({tr("By name"), tr("None"), tr("Manual")});
    m_how->setItemData(ByName, tr("Mesh arrays with a known name, such as StiffnessScale"), Qt::ToolTipRole);
    m_quantity = makeBox(tr("Property"), tr("Tissue property that varies"));
    m_quantity->addItems({tr("Stiffness"), tr("Damping"), tr("Friction")});
    m_source = makeBox(tr("Source"), tr("Mesh array or volume with the values"));
    m_unit = makeBox(tr("Unit"), tr("Meaning of the numbers. Shear modulus and Young's modulus differ by a factor of "
                                    "three; check the scanner manual"));
    m_unit->setPlaceholderText(tr("choose…"));
    m_unit->addItem(tr("Relative to the tissue"), static_cast<int>(core::MapUnit::Scale));
    m_unit->addItem(tr("Stiffness, N/mm"), static_cast<int>(core::MapUnit::NPerMm));
    m_unit->addItem(tr("Shear modulus, kPa"), static_cast<int>(core::MapUnit::ShearKPa));
    m_unit->addItem(tr("Young's modulus, kPa"), static_cast<int>(core::MapUnit::YoungKPa));
    m_radius = makeField(tr("Contact radius in mm"), kMostRadius_mm, 1, this);
    m_radius->setMinimum(0.1);
    m_radius->setSuffix(tr(" mm"));
    m_radius->setToolTip(tr("Radius of the finger contact; stiffness = 8 × radius × shear modulus"));
    m_form->addRow(tr("Contact radius"), m_radius);
    m_clamp = new QCheckBox(tr("Limit the values"), this);
    m_clamp->setToolTip(tr("Values outside the range are set to the nearest limit"));
    m_form->addRow(m_clamp);
    m_low = makeField(tr("Minimum"), kMostOfArray, 3, this);
    m_high = makeField(tr("Maximum"), kMostOfArray, 3, this);
    auto* limits = new QHBoxLayout;
    limits->addWidget(m_low);
    limits->addWidget(new QLabel(tr("to"), this));
    limits->addWidget(m_high);
    auto* pair = new QWidget(this);
    limits->setContentsMargins(0, 0, 0, 0);
    pair->setLayout(limits);
    m_form->addRow(pair);
    m_note = new QLabel(this);
    m_note->setWordWrap(true);
    m_note->setTextFormat(Qt::PlainText);
    m_note->setAccessibleDescription(tr("Map status"));
    m_form->addRow(m_note);
    m_colours = makeBox(tr("Show"), tr("Colours the structure by value, with a legend"));
}

void MapEditor::connectFields()
{
    connect(m_how, &QComboBox::activated, this, &MapEditor::chooseHow);
    connect(m_quantity, &QComboBox::activated, this, [this] {
        m_unitless.reset();
        refresh();
    });
    connect(m_source, &QComboBox::activated, this, &MapEditor::chooseSource);
    connect(m_unit, &QComboBox::activated, this,
            [this](int chosen) { setUnit(static_cast<core::MapUnit>(m_unit->itemData(chosen).toInt())); });
    for (QDoubleSpinBox* field : {m_radius, m_low, m_high}) {
        connect(field, &QDoubleSpinBox::valueChanged, this, &MapEditor::editNumbers);
    }
    connect(m_clamp, &QCheckBox::toggled, this, &MapEditor::editNumbers);
    connect(m_colours, &QComboBox::activated, this,
            [this](int chosen) { Q_EMIT colourChosen(m_colours->itemData(chosen).toString()); });
}

void MapEditor::show(const study::OpenStructure& row, const QString& coloured)
{
    if (row.loaded.surface != m_structure.surface) {
        m_isByHand = false;
        m_unitless.reset();
        m_quantity->setCurrentIndex(0);
    }
    m_structure = row.loaded;
    m_problems.clear();
    for (const core::Message& problem : row.mapProblems) {
        m_problems << translated(problem);
    }
    refresh();
    refreshColours(coloured);
}

core::MappedQuantity MapEditor::quantity() const
{
    return static_cast<core::MappedQuantity>(std::max(0, m_quantity->currentIndex()));
}

/// Mappings of the description, or inferred from array names.
std::vector<core::TissueMapping> MapEditor::mappings() const
{
    if (m_structure.description.maps) {
        return *m_structure.description.maps;
    }
    return m_structure.surface == nullptr ? std::vector<core::TissueMapping>()
                                          : meshio::knownMappings(m_structure.surface->mesh);
}

/// Mapping of the selected quantity; null: unmapped.
const core::TissueMapping* MapEditor::current() const
{
    if (m_unitless) {
        return &*m_unitless;
    }
    const core::TissueMapping* found = nullptr; // the last mapping of a quantity takes effect
    for (const core::TissueMapping& one : m_mappings) {
        found = one.quantity == quantity() ? &one : found;
    }
    return found;
}

void MapEditor::chooseHow(int how)
{
    m_unitless.reset();
    m_isByHand = how == ByHand;
    if (how == ByName) {
        Q_EMIT edited(std::nullopt);
    } else if (how == None) {
        Q_EMIT edited(std::vector<core::TissueMapping>());
    } else if (!m_mappings.empty()) {
        Q_EMIT edited(m_mappings); // starts from the inferred mappings
    }
    refresh();
}

void MapEditor::chooseSource(int source)
{
    if (source == kNothing) {
        m_unitless.reset();
        std::vector<core::TissueMapping> left = m_mappings;
        std::erase_if(left, [this](const core::TissueMapping& one) { return one.quantity == quantity(); });
        Q_EMIT edited(left);
        return;
    }
    if (m_source->itemData(source).toString() == kVolume) {
        askForVolume();
        return;
    }
    core::TissueMapping mapping;
    mapping.quantity = quantity();
    mapping.array = m_source->itemText(source).toStdString();
    put(mapping);
}

void MapEditor::load(const std::filesystem::path& volume)
{
    core::TissueMapping mapping;
    mapping.quantity = quantity();
    mapping.file = std::filesystem::absolute(volume).string();
    put(mapping);
}

void MapEditor::askForVolume()
{
    const QString file = QFileDialog::getOpenFileName(
        this, tr("Volume"), QString(), tr("Volumes (*.vti *.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz);;All files (*)"));
    if (file.isEmpty()) {
        refresh();
    } else {
        load(std::filesystem::path(file.toStdU16String()));
    }
}

/// Uses a new source with the unit given by its name or quantity; otherwise the user must choose a unit.
void MapEditor::put(const core::TissueMapping& mapping)
{
    m_unitless = mapping;
    for (const core::KnownMap& known : core::kKnownMaps) {
        if (known.array == mapping.array && known.quantity == mapping.quantity) {
            setUnit(known.unit);
            return;
        }
    }
    if (mapping.quantity == core::MappedQuantity::Stiffness) {
        refresh();
    } else {
        setUnit(core::traitsOf(mapping.quantity).unit);
    }
}

void MapEditor::setUnit(core::MapUnit unit)
{
    if (const core::TissueMapping* now = current(); now != nullptr) {
        core::TissueMapping changed = *now;
        changed.unit = unit;
        m_unitless.reset();
        change(changed);
    }
}

void MapEditor::editNumbers()
{
    const core::TissueMapping* now = current();
    if (m_isShowing || now == nullptr) {
        return;
    }
    core::TissueMapping changed = *now;
    if (sender() == m_radius) { // fields round to fewer digits than the scene stores: take over only the edited one
        changed.contactRadius_mm = m_radius->value();
    } else if (!m_clamp->isChecked()) {
        changed.clamp.reset();
    } else {
        changed.clamp = {std::min(m_low->value(), m_high->value()), std::max(m_low->value(), m_high->value())};
    }
    if (m_unitless) {
        m_unitless = changed;
        refresh();
    } else {
        change(changed);
    }
}

/// Replaces the mapping of the same quantity.
void MapEditor::change(const core::TissueMapping& mapping)
{
    std::vector<core::TissueMapping> all = m_mappings;
    std::erase_if(all, [&](const core::TissueMapping& one) { return one.quantity == mapping.quantity; });
    all.push_back(mapping);
    m_isByHand = true;
    Q_EMIT edited(all);
}

void MapEditor::refresh()
{
    m_isShowing = true;
    m_mappings = mappings();
    const auto& said = m_structure.description.maps;
    const bool isByHand = m_isByHand || (said && !said->empty());
    m_how->setCurrentIndex(isByHand ? ByHand : said ? None : ByName);
    const core::TissueMapping* now = current();
    m_form->setRowVisible(m_quantity->parentWidget(), isByHand);
    m_form->setRowVisible(m_source->parentWidget(), isByHand);
    refreshSources(now);
    refreshNumbers(isByHand ? now : nullptr);
    const QString line = note();
    m_note->setText(line);
    m_note->setVisible(!line.isEmpty());
    m_isShowing = false;
}

void MapEditor::refreshSources(const core::TissueMapping* now)
{
    m_source->clear();
    m_source->addItem(tr("Nothing"));
    if (m_structure.surface != nullptr) {
        for (const geometry::MeshArray& array : m_structure.surface->mesh.arrays) {
            m_source->addItem(QString::fromStdString(array.name));
        }
    }
    if (now != nullptr) {
        const QString name = now->array.empty() ? fileName(now->file) : QString::fromStdString(now->array);
        int at = m_source->findText(name);
        if (at <= kNothing) {
            at = m_source->count();
            m_source->addItem(name); // a volume, or a missing array
        }
        m_source->setCurrentIndex(at);
    }
    m_source->addItem(tr("Volume…"), kVolume);
}

/// Updates the fields of a mapping. @param now  null disables the fields
void MapEditor::refreshNumbers(const core::TissueMapping* now)
{
    const bool isStiffness = now != nullptr && now->quantity == core::MappedQuantity::Stiffness;
    m_form->setRowVisible(m_unit->parentWidget(), isStiffness);
    const int unit = isStiffness && !m_unitless ? m_unit->findData(static_cast<int>(now->unit)) : -1;
    m_unit->setCurrentIndex(unit);
    const bool hasRadius = now != nullptr && !m_unitless && (isModulus(now->unit) || now->array.empty());
    m_form->setRowVisible(m_radius, hasRadius);
    const bool isWhole = now != nullptr && !m_unitless;
    m_form->setRowVisible(m_clamp, isWhole);
    m_form->setRowVisible(m_low->parentWidget(), isWhole && now->clamp);
    if (!isWhole) {
        return;
    }
    m_radius->setValue(now->contactRadius_mm);
    m_clamp->setChecked(now->clamp.has_value());
    std::array<double, 2> limits{0.0, 1.0};
    for (const geometry::MeshArray& array : m_structure.surface->mesh.arrays) {
        if (array.name == now->array) {
            const view::ColourRange range = view::colourRange(array.values);
            limits = {range.low, range.high};
        }
    }
    limits = now->clamp.value_or(limits);
    m_low->setValue(limits[0]);
    m_high->setValue(limits[1]);
}

void MapEditor::refreshColours(const QString& coloured)
{
    m_colours->clear();
    m_colours->addItem(tr("Own colour"), QString());
    for (const SurfaceField& numbers : surfaceFields(m_structure)) {
        m_colours->addItem(numbers.title, numbers.what);
    }
    m_colours->setCurrentIndex(std::max(0, m_colours->findData(coloured)));
    m_form->setRowVisible(m_colours->parentWidget(), m_colours->count() > 1);
}

/// Notes on the maps: open questions, errors, missing data and inferred mappings.
QString MapEditor::note() const
{
    if (m_unitless) {
        return tr("Choose the unit of %1: shear modulus and Young's modulus differ by a factor of three.")
            .arg(m_unitless->array.empty() ? fileName(m_unitless->file) : QString::fromStdString(m_unitless->array));
    }
    QStringList lines = m_problems;
    for (const meshio::SurfaceMap& map : m_structure.maps) {
        const QString name =
            map.mapping.array.empty() ? fileName(map.mapping.file) : QString::fromStdString(map.mapping.array);
        if (m_how->currentIndex() == ByName) {
            lines << tr("%1 varies by %2.").arg(m_quantity->itemText(static_cast<int>(map.mapping.quantity)), name);
        }
        if (const std::size_t missing = meshio::missingValues(map); missing > 0) {
            lines << tr("%1: %2 of %3 places have no value. The tissue value is used there.")
                         .arg(name, QLocale().toString(static_cast<qulonglong>(missing)),
                              QLocale().toString(static_cast<qulonglong>(map.values.size())));
        }
    }
    return lines.join(QLatin1Char('\n'));
}

} // namespace palpate::ui

#include "palpate/ui/moc_MapEditor.cpp"

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/FeltWay.h"
#include "palpate/ui/StructureModel.h"
#include "palpate/ui/TissuePresets.h"

#include <QWidget>

#include <array>
#include <functional>
#include <optional>
#include <vector>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QSlider;
class QToolButton;

namespace palpate::ui {

class LawEditor;
class MapEditor;
class StructureList;
struct TouchReading;

/// The list of structures, and look and feel of the selected ones: what is edited is edited of all of them, as one step
/// to undo.
class StructurePanel : public QWidget
{
    Q_OBJECT
  public:
    explicit StructurePanel(StructureModel& model, QWidget* parent = nullptr);

    /// Says what the device holds. An edit beyond it is refused: the value stays, and a line by the field says why.
    /// @param why  the device, its limit and what sets it, for a person
    void setGreatest(const haptics::Tissue& greatest, const QString& why);
    /// Says by rows what there is to warn of with their maps; see MapWarnings.
    void setMapWarnings(const QStringList& lines);
    [[nodiscard]] int currentRow() const;
    [[nodiscard]] std::vector<int> selectedRows() const;
    void select(int row);
    /// Selects what a person pointed at in the view, which then shows it; nothing: ends that.
    /// @param adds  to what is selected, or takes it out when it is selected already
    void choose(std::optional<std::size_t> row, bool adds);
    /// Puts the cursor into the filter's field.
    void focusFilter();
    /// Takes the selected structures out of the scene.
    void removeSelected();
    /// Lets a person write another name in the list.
    void renameCurrent();
    /// Shows in the curve of the selected structure's law how deep the hand is in it.
    void showTouch(const TouchReading& reading);

    /// Colours a structure by numbers, where it has them, as a scene file says.
    void colourBy(const meshio::ShownMap& shown);

  Q_SIGNALS:
    /// A structure is to be coloured by numbers, and no other. @param what  a `SurfaceNumbers::what`; empty: by none
    void colourChosen(int row, const QString& what);
    /// A person selected these, in the list or the view: the picture shows which they are.
    void highlighted(const std::vector<int>& rows);

  protected:
    /// In the list: Ctrl+E shows or hides the selected structures, Ctrl+H makes them felt or not, Ctrl+Down and Ctrl+Up
    /// have them felt a layer deeper or farther out; Del takes them out, Esc selects none.
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    using Change = std::function<void(meshio::SceneStructure&)>;
    void change(const std::vector<int>& rows, const Change& change, const QString& text = {});
    void changeTissue(const std::function<void(haptics::Tissue&)>& change);
    void click(const QModelIndex& index);
    void toggle(const std::vector<int>& rows, int column);
    void moveLayers(int steps);
    void showSelection();
    void showHead(const std::vector<int>& rows);
    void fitTitle();
    void refuse(const QString& line);
    [[nodiscard]] QString refusal(int row, const haptics::Tissue& asked, const haptics::Tissue& now) const;
    void setLayer(const QVariant& chosen);
    void changeWays(const std::vector<FeltWay>& ways);
    void showLayer(int row);
    void showBound(int row);
    void showMapWarning();
    [[nodiscard]] QString whoTakes(const std::vector<haptics::HapticStructure>& felt, int row) const;
    void editOpacity(int percent);
    void chooseColour();
    void openMenu(const QPoint& place);
    QWidget* makeTissueBox();
    void addHead(QFormLayout& form, QWidget* box);
    void addOpacity(QFormLayout& form, QWidget* box);
    void addLayer(QFormLayout& form, int place, QWidget* box);
    void addSurface(QFormLayout& form, int place, QWidget* box);
    void showSurface(const std::vector<int>& rows);
    void addTerms(QFormLayout& form, QWidget* box);
    void addPresets(QFormLayout& form, QWidget* box);
    void addLaw(QFormLayout& form, QWidget* box);
    void addMap(QFormLayout& form, int place, QWidget* box);
    void showFrictionTerms();
    void addFriction(QFormLayout& form, QWidget* box);
    void showTissue(const haptics::Tissue& tissue);
    QDoubleSpinBox* makeField(const core::TissueTerm& term, QWidget* box);

    StructureModel& m_model;
    StructureList* m_list = nullptr;
    QLabel* m_title = nullptr;
    QLabel* m_findings = nullptr;
    QToolButton* m_colour = nullptr;
    QSlider* m_opacity = nullptr;
    QLabel* m_opacityText = nullptr;
    QComboBox* m_preset = nullptr;
    QLabel* m_source = nullptr; ///< of the preset's numbers
    LawEditor* m_law = nullptr;
    MapEditor* m_map = nullptr;
    QLabel* m_mapWarning = nullptr; ///< of the map
    QStringList m_mapWarnings;      ///< by rows
    int m_colouredRow = -1;
    QString m_coloured; ///< by which numbers
    QComboBox* m_friction = nullptr;
    QFormLayout* m_form = nullptr;
    std::array<QDoubleSpinBox*, core::kTissueTerms.size()> m_terms{};
    QComboBox* m_surface = nullptr; ///< items: as in the file, smoothed
    QWidget* m_surfaceRow = nullptr;
    QComboBox* m_layer = nullptr; ///< data: the layer; none: through the organ around it
    QLabel* m_bound = nullptr;    ///< what is felt of the values, where the device holds less
    QLabel* m_refusal = nullptr;
    haptics::Tissue m_greatest = core::unbounded(); ///< until a device says its own
    QString m_why;
    QWidget* m_tissue = nullptr;
    bool m_isShowing = false;
    bool m_isChosen = false; ///< what is selected was selected by a person
};

} // namespace palpate::ui

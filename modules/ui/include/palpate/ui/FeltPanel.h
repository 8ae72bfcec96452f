// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/FeltOverlay.h"

#include <QWidget>

#include <optional>
#include <vector>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace palpate::ui {

/// The table of lumps that lie in organs: how much stiffer, how deep, how much of it a hand feels at which press, and
/// whether it finds it. Flies to the best place; changes how stiff a lump is.
/// @par Thread The GUI's.
class FeltPanel : public QWidget
{
    Q_OBJECT
  public:
    enum Column
    {
        Lump,
        Ratio,
        Cover,
        FirstPress ///< and one column for each of FeltOverlay::kPress_mm
    };
    /// Both must outlive this.
    FeltPanel(FeltOverlay& overlay, StructureModel& model, QWidget* parent = nullptr);

  protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    /// Entries of the choice of where a ratio comes from, before the presets.
    enum Source
    {
        Typed,
        Moduli,
        Automatic, ///< by tissues or names
        FirstPublished
    };
    /// A lump in the table.
    struct Row
    {
        std::size_t organ = 0, lump = 0; ///< numbers in FeltOverlay::organs(), and of its lumps
        int lumpRow = 0, organRow = 0;   ///< of the structures
    };
    QWidget* makeChoices();
    void makeTable();
    void fitRows();
    void fitColumns();
    void setBrief(bool isBrief);
    void fill();
    void addRow(const Row& row);
    void showChosen();
    [[nodiscard]] std::optional<Row> chosen() const;
    void setRatio(std::optional<double> ratio);
    void setModuli(double lump_kPa, double organ_kPa);
    void chooseSource(int index);
    void showBestPlace();

    FeltOverlay& m_overlay;
    StructureModel& m_model;
    std::vector<Row> m_rows;
    QLabel* m_notice = nullptr;
    QLabel* m_status = nullptr;
    QTableWidget* m_table = nullptr;
    QComboBox* m_press = nullptr;
    QPushButton* m_best = nullptr;
    QLabel* m_ratioLabel = nullptr;
    QDoubleSpinBox* m_ratio = nullptr;
    QComboBox* m_source = nullptr;
    QWidget* m_moduli = nullptr;
    QDoubleSpinBox* m_lump_kPa = nullptr;
    QDoubleSpinBox* m_organ_kPa = nullptr;
};

} // namespace palpate::ui

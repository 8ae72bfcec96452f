// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/FeltOverlay.h"

#include <palpate/core/Export.h>

#include <QWidget>

#include <optional>
#include <vector>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace palpate::ui {

/// Table of buried lumps: stiffness ratio, depth, change of response per penetration depth and the verdict whether a
/// hand detects the lump. Moves the camera to the best place and edits a lump's stiffness.
///
/// @par Thread GUI thread only.
class PALPATE_EXPORT FeltPanel : public QWidget
{
    Q_OBJECT
  public:
    enum Column
    {
        Lump,
        Ratio,
        Cover,
        FirstPress ///< first of one column for each FeltOverlay::kPress_mm
    };
    /// Both references must outlive this object.
    FeltPanel(FeltOverlay& overlay, StructureModel& model, QWidget* parent = nullptr);

  protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    /// Sources of a stiffness ratio, in the order of the combo box; published presets follow.
    enum Source
    {
        Typed,
        Moduli,
        Automatic, ///< by tissue or name
        FirstPublished
    };
    /// Lump in the table.
    struct Row
    {
        std::size_t organ = 0, lump = 0; ///< index in FeltOverlay::organs() and index of the organ's lump
        int lumpRow = 0, organRow = 0;   ///< rows in StructureModel
    };
    QWidget* makeChoices();
    void makeTable();
    void fitRows(bool isBrief);
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

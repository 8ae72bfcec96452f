// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/MarginOverlay.h"
#include "palpate/ui/SceneDistances.h"
#include "palpate/ui/TapesModel.h"

#include <palpate/core/Export.h>

#include <QWidget>

#include <optional>
#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;
class QTableWidget;

namespace palpate::ui {

/// Table of the distances from each lump, or from a chosen structure, to the other structures with the shares of the
/// margin in each band, and the list of tapes. The chosen row is shown in the view.
///
/// @par Thread GUI thread only.
class PALPATE_EXPORT DistancesPanel : public QWidget
{
    Q_OBJECT
  public:
    enum Column
    {
        From,
        To,
        Distance,
        FirstBand ///< first of one column for each band
    };
    static constexpr std::size_t kMostLimits = 4; ///< borders of bands that fit into the legend

    /// All references must outlive this object.
    DistancesPanel(SceneDistances& distances, MarginOverlay& overlay, TapesModel& tapes, const StructureModel& model,
                   QWidget* parent = nullptr);

    /// Parses borders of bands as typed: ascending millimetres above 0, separated by semicolons or spaces, or by
    /// commas unless the comma is the decimal sign. @return empty if they are not
    [[nodiscard]] static std::optional<std::vector<double>> limitsFrom(const QString& text);

  private:
    QWidget* makeTop();
    QWidget* makeTapes();
    void makeTable();
    void fill();
    void fillChoice();
    void addRow(std::size_t pair);
    void showChosen();
    void takeLimits();
    void copy() const;
    [[nodiscard]] std::optional<std::size_t> chosen() const;
    [[nodiscard]] QString textOf(std::size_t pair) const;

    SceneDistances& m_distances;
    MarginOverlay& m_overlay;
    TapesModel& m_tapes;
    const StructureModel& m_model;
    std::vector<std::size_t> m_rows; ///< pair of each row of the table
    QComboBox* m_from = nullptr;     ///< item data: row of StructureModel; invalid: lumps
    QLineEdit* m_bands = nullptr;
    QLabel* m_status = nullptr;
    QTableWidget* m_table = nullptr;
    QLabel* m_detail = nullptr;
    QTableView* m_tapeTable = nullptr;
};

} // namespace palpate::ui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/TouchHistory.h"
#include "palpate/ui/TouchReading.h"

#include <palpate/core/Export.h>

#include <QString>
#include <QWidget>

#include <optional>

class QLabel;

namespace palpate::ui {

class ForceBar;
class TouchChart;

/// Innermost structure under the hand: the innermost layer, with a transmitted lump before the organ.
struct PalpatedStructure
{
    QString name, inside; ///< `inside` is the surrounding organ; empty: unknown
    double force_N = 0.0; ///< component along the force on the hand
    double depth_mm = 0.0;
    std::optional<double> stiffnessRatio{}; ///< of a transmitted lump
};
[[nodiscard]] PALPATE_EXPORT PalpatedStructure palpatedStructure(const TouchReading& reading);
/// Lump under the contact with the change of stiffness: "over lump 20 mm: +55 %"; empty without a lump.
[[nodiscard]] PALPATE_EXPORT QString overLumpText(const TouchReading& reading);
/// The same with the verdict: "over lump 20 mm: +55 %, plainly felt".
[[nodiscard]] PALPATE_EXPORT QString lumpText(const TouchReading& reading);
/// Shares of the force for the chart: of the layers in contact or, over a lump that stiffens its organ, of the organ
/// as it would be without the lump and of what the lump adds.
[[nodiscard]] PALPATE_EXPORT std::vector<LayerForce> chartForces(const TouchReading& reading);
/// Location: "lump 20 mm in liver".
[[nodiscard]] PALPATE_EXPORT QString whereText(const PalpatedStructure& felt);

/// Current touch in digits that are readable at arm's length, with the chart of the last ten seconds.
class PALPATE_EXPORT TouchPanel : public QWidget
{
    Q_OBJECT
  public:
    explicit TouchPanel(QWidget* parent = nullptr);

    /// Sets the end of the bar. @param force_N  force limit of the device
    void setForceLimit(double force_N);
    [[nodiscard]] double forceLimit_N() const;
    /// Least height, which fits a low panel: there the number and the lanes of the chart are smaller.
    [[nodiscard]] int heightForWidth(int width) const override;
    void show(const TouchReading& reading);
    /// Last displayed reading; free space without a hand.
    [[nodiscard]] const TouchReading& reading() const noexcept { return m_reading; }
    /// Shows dashes instead of numbers while no hand is present. The chart stays.
    void showNoHand();
    void clearHistory();

  Q_SIGNALS:
    /// Emitted when `reading` changed.
    void changed();

  protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void fitFont();
    void setLow(bool isLow);
    [[nodiscard]] int savedHeight() const;
    void setLine(const QString& structure, const QString& detail);
    void showSource(const std::optional<double>& recorded_s);
    void setLayers(std::vector<LayerShare> layers);
    void showLump(const TouchReading& reading);

    TouchReading m_reading;
    double m_drawn_s = 0.0; ///< time of the newest reading in the painted chart
    TouchHistory m_history;
    QLabel* m_source = nullptr; ///< live hand or recording
    QLabel* m_force = nullptr;
    QLabel* m_forceUnit = nullptr;
    QLabel* m_structure = nullptr;
    QLabel* m_layers = nullptr;
    QLabel* m_detail = nullptr;
    QLabel* m_late = nullptr; ///< notice while the force lags
    ForceBar* m_bar = nullptr;
    TouchChart* m_chart = nullptr;
    bool m_isLow = false; ///< too low for the usual sizes
};

/// Force with three significant digits: "2.31", "12.3", "123".
[[nodiscard]] PALPATE_EXPORT QString forceText(double force_N);
/// Depth with more digits for small values: "4.6". [mm]
[[nodiscard]] PALPATE_EXPORT QString depthText(double depth_mm);
/// Text for screen readers: "2.31 N, 4.6 mm deep".
[[nodiscard]] PALPATE_EXPORT QString touchText(const TouchReading& reading);
/// Detail line without the structure's name: "4.6 mm deep · 0.50 N/mm".
[[nodiscard]] PALPATE_EXPORT QString detailText(const TouchReading& reading);

} // namespace palpate::ui

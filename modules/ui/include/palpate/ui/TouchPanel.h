// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/FeltLayers.h"
#include "palpate/ui/TouchHistory.h"

#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

class QLabel;

namespace palpate::ui {

class ForceBar;
class TouchChart;

/// One moment of touch as the panel shows it.
struct TouchReading
{
    double time_s = 0.0;
    double force_N = 0.0; ///< on the hand; of the model where the device does not push
    double depth_mm = 0.0;
    QString structure;               ///< of the outermost layer; empty in free space
    double stiffness_N_per_mm = 0.0; ///< of all layers that are touched together
    double stiffnessRatio = 1.0;     ///< that by the outermost tissue's alone [1]
    int constraints = 0;             ///< active ones of the outermost layer; the engineering panel has them
    bool isSlidOff = false;          ///< pressed, but the surface has given way to the side
    bool isAtBound = false;          ///< the solver stopped at its bound: the force is that of where it got to
    std::vector<FeltLayer> layers{}; ///< outermost first
    QString lump{};                  ///< that is felt through `structure` here; empty: none
    double lumpRatio = 1.0;          ///< stiffness here by that without the lump [1]
};

/// What is felt under the hand, of all that is touched: the innermost layer, a lump before the organ that it is felt
/// through.
struct FeltStructure
{
    QString name, inside; ///< `inside` is the organ around it; empty: none
    double force_N = 0.0; ///< its share along the force on the hand
    double depth_mm = 0.0;
    std::optional<double> stiffnessRatio{}; ///< of a lump that is felt through its organ
};
[[nodiscard]] FeltStructure feltStructure(const TouchReading& reading);
/// "lump 20 mm in liver"
[[nodiscard]] QString whereText(const FeltStructure& felt);

/// What the hand feels, in numbers large enough for arm's length, and its last ten seconds.
class TouchPanel : public QWidget
{
    Q_OBJECT
  public:
    explicit TouchPanel(QWidget* parent = nullptr);

    /// @param force_N  the device's limit: the end of the bar
    void setForceLimit(double force_N);
    [[nodiscard]] double forceLimit_N() const;
    void show(const TouchReading& reading);
    /// What was shown last; that of free space without a hand.
    [[nodiscard]] const TouchReading& reading() const noexcept { return m_reading; }
    /// Without a hand: the numbers become a dash, the chart stays.
    void showNoHand();
    void clearHistory();

  Q_SIGNALS:
    /// `reading` is another one.
    void changed();

  protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void fitFont();
    void setLine(const QString& structure, const QString& detail);
    void setLayers(std::vector<FeltLayer> layers);
    void showLump(const TouchReading& reading);

    TouchReading m_reading;
    TouchHistory m_history;
    QLabel* m_force = nullptr;
    QLabel* m_forceUnit = nullptr;
    QLabel* m_structure = nullptr;
    QLabel* m_layers = nullptr;
    QLabel* m_detail = nullptr;
    QLabel* m_late = nullptr; ///< that the force lags; shown while it does
    ForceBar* m_bar = nullptr;
    TouchChart* m_chart = nullptr;
};

/// "2.31", or with fewer digits where they would not be read: 12.3, 123.
[[nodiscard]] QString forceText(double force_N);
/// "4.6", with a digit more where it is little. [mm]
[[nodiscard]] QString depthText(double depth_mm);
/// "2.31 N, 4.6 mm deep": what a screen reader says of a touch.
[[nodiscard]] QString touchText(const TouchReading& reading);
/// "4.6 mm deep · liver · 0.50 N/mm" without the structure's name.
[[nodiscard]] QString detailText(const TouchReading& reading);

} // namespace palpate::ui

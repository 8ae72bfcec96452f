// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/core/Tissue.h>

#include <QWidget>

#include <array>
#include <filesystem>
#include <limits>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QPushButton;

namespace palpate::ui {

class LawPlot;

/// Editor of a tissue's force law: kind, parameters and curve.
class PALPATE_EXPORT LawEditor : public QWidget
{
    Q_OBJECT
  public:
    explicit LawEditor(QWidget* parent = nullptr);

    /// Shows a tissue. @param greatest_N_per_mm  largest stable slope of the device; infinite: unknown
    void show(const core::Tissue& tissue, double greatest_N_per_mm);
    /// Shows the live contact in the plot.
    /// @param depth_mm  penetration depth in this tissue; 0: no contact
    /// @param scale  scale of the law at the contact, from maps and buried lumps [1]
    void setTouch(double depth_mm, double scale);
    /// Loads the points of a measured curve from a CSV file. Emits `refused` with the reason on failure.
    void load(const std::filesystem::path& path);

  Q_SIGNALS:
    void edited(const core::ForceLaw& law);
    void refused(const QString& why);

  private:
    void choose(core::LawKind kind);
    void editNumber(std::size_t i, double value);
    void askForFile();

    core::Tissue m_tissue;
    double m_greatest = std::numeric_limits<double>::infinity();
    bool m_isShowing = false;
    QFormLayout* m_form = nullptr;
    QComboBox* m_kind = nullptr;
    std::array<QDoubleSpinBox*, core::ForceLaw::kMaxParameters> m_numbers{};
    QCheckBox* m_switch = nullptr;
    QPushButton* m_load = nullptr;
    LawPlot* m_plot = nullptr;
};

} // namespace palpate::ui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

/// By what law a tissue's force rises with the depth: its name, its numbers, and its curve.
class LawEditor : public QWidget
{
    Q_OBJECT
  public:
    explicit LawEditor(QWidget* parent = nullptr);

    /// @param greatest_N_per_mm  the largest slope that the device holds; infinite: nothing is known
    void show(const core::Tissue& tissue, double greatest_N_per_mm);
    /// @param depth_mm  of the hand in this tissue; 0: it does not touch
    /// @param scale  by which maps and lumps below scale the law where it touches [1]
    void setTouch(double depth_mm, double scale);
    /// Takes the points of a measured curve from a CSV file, or says why not.
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
    std::array<QDoubleSpinBox*, core::ForceLaw::kMostNumbers> m_numbers{};
    QCheckBox* m_switch = nullptr;
    QPushButton* m_load = nullptr;
    LawPlot* m_plot = nullptr;
};

} // namespace palpate::ui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/meshio/SceneFile.h>

#include <QFrame>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QVBoxLayout;

namespace palpate::ui {

class VtkViewport;

/// Controls of the section in the upper right corner of the view: direction, position, other side, close, and a line
/// with the place in words.
///
/// @par Thread GUI thread only.
class PALPATE_EXPORT SectionBar : public QFrame
{
    Q_OBJECT
  public:
    /// @param viewport  shows the bar; must outlive it
    explicit SectionBar(VtkViewport& viewport);

    /// Updates the controls. @param line  place in words; @param step_mm  step of the position
    void setSection(meshio::SectionDirection direction, double position_mm, double step_mm, const QString& line);
    [[nodiscard]] QString line() const;
    /// Shows the controls of an image, with digits and steps for its usual window. @param name  empty: hides them
    void setImage(const QString& name, double width, double level);
    /// Shows another window of the same image.
    void setWindow(double width, double level);
    [[nodiscard]] bool isImageShown() const;

  Q_SIGNALS:
    void directionChosen(palpate::meshio::SectionDirection direction);
    void positionChosen(double position_mm);
    void otherSideWanted();
    void closeWanted();
    void imageToggled(bool isShown);
    /// @param width  from black to white, > 0; @param level  medium grey; in the unit of the image
    void windowChosen(double width, double level);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

  private:
    void place();

    QComboBox* m_direction = nullptr;
    QDoubleSpinBox* m_position = nullptr;
    void addImageRow(QVBoxLayout& layout);

    QLabel* m_line = nullptr;
    QWidget* m_imageRow = nullptr;
    QCheckBox* m_image = nullptr;
    QDoubleSpinBox* m_width = nullptr;
    QDoubleSpinBox* m_level = nullptr;
};

} // namespace palpate::ui

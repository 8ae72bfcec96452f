// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>
#include <palpate/view/SceneView.h>

#include <QImage>
#include <QOpenGLWidget>
#include <QSurfaceFormat>
#include <QTimer>

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include <array>

class vtkGenericRenderWindowInteractor;

namespace palpate::ui {

/// 3D view as a Qt widget. Draws a SceneView into Qt's framebuffer and converts mouse, pen and wheel input to camera
/// motion or, in palpation mode, to rays for the hand.
///
/// Draws on request (`update()`) and on camera motion, without a continuous render loop. Ambient occlusion is enabled
/// when the first frames show a sufficiently fast graphics card. On slow systems the sorting of translucent folds is
/// delayed until the picture is still; colours are the same in motion.
class PALPATE_EXPORT VtkViewport : public QOpenGLWidget
{
    Q_OBJECT
  public:
    enum class Mode
    {
        Camera, ///< left orbits, middle pans, right zooms, the wheel zooms
        Palpate ///< left presses, the wheel sets the depth; middle pans and right orbits
    };

    /// Required OpenGL format. Set as the default before constructing the application object.
    [[nodiscard]] static QSurfaceFormat surfaceFormat();

    explicit VtkViewport(QWidget* parent = nullptr);
    ~VtkViewport() override;

    [[nodiscard]] view::SceneView& view() noexcept { return m_view; }
    void setMode(Mode mode);
    [[nodiscard]] Mode mode() const noexcept { return m_mode; }
    /// Ray under the pointer; empty when the pointer is outside.
    [[nodiscard]] std::optional<view::Ray> pointerRay();
    /// Ray through a place of the widget. @param place  logical pixels from the upper left corner
    [[nodiscard]] view::Ray rayAt(const QPointF& place);
    /// Projects a scene point to logical pixels from the widget's upper left corner. @param p_W  [mm]
    [[nodiscard]] QPointF placeOf(const core::Vec3& p_W);
    /// Place near the middle of the view that shows a palpable structure; empty if no palpable structure is visible.
    [[nodiscard]] std::optional<QPointF> palpablePlace();
    /// Renders the next frame at full quality, e.g. for a snapshot.
    void refineNext();
    /// Renders a picture at full quality in a larger size, with texts and marks scaled alike.
    /// @param scale  > 0, relative to the widget; reduced where the graphics card has no frame of that size
    /// @return null before the first frame
    [[nodiscard]] QImage picture(double scale);
    /// Rendering time of the newest frame. [ms]
    [[nodiscard]] double frame_ms() const noexcept { return m_frame_ms; }

    /// Sets the height of the widgets that cover the upper edge, so that legend and section bar stay below. [logical
    /// px]
    void setCoveredAbove(int height_px);
    [[nodiscard]] int coveredAbove_px() const noexcept { return m_covered_px; }
    /// Sets the height of the widgets that cover the lower edge, so that orientation cube, scale bar and legend stay
    /// above. [logical px]
    void setCoveredBelow(int height_px);
    /// Legend at a place of the widget, or the sign that closes it. @param place  logical pixels from the upper left
    /// corner
    [[nodiscard]] bool isOnLegend(const QPointF& place) const;
    [[nodiscard]] bool isOnLegendClose(const QPointF& place) const;
    /// Lets the left button click in palpation mode, too: a press that ends where it began then is a press of the hand
    /// and a click. Forgets a click in progress.
    void setClicksWhilePalpating(bool isOn);
    /// Returns false while the keyboard focus is in a bar of the view: keys are not for the view then, not even those
    /// that the bar leaves unused.
    [[nodiscard]] bool takesKeys() const;

  Q_SIGNALS:
    /// Pointer motion over the view, or view motion under the pointer. Palpation mode only, as the next signals.
    void pointerMoved();
    void pointerPressed();
    void pointerReleased();
    void pointerLeft();
    /// @param steps  wheel notches, positive away from the user
    void depthTurned(double steps);
    /// Wheel with Shift while a section is shown: move it, positive away from the user.
    void sectionMoved(double steps);
    /// Pen with pressure in contact or just lifted. @param pressure  0 to 1
    void penPressed(double pressure);
    /// Space bar pressed or released: palpation mode while held.
    void spaceHeld(bool isDown);
    /// G pressed, or released; also released when the view loses the focus.
    void peekHeld(bool isDown);
    /// Both modes: pointer motion without a pressed button.
    void hovered(const QPointF& place);
    /// The pointer left the view or a button was pressed.
    void hoverEnded();
    /// Left click without motion: in camera mode, see also setClicksWhilePalpating.
    void clicked(const QPointF& place, Qt::KeyboardModifiers modifiers);
    /// Both modes: request to centre on this place.
    void centreWanted(const QPointF& place);
    void coveredAboveChanged();

  protected:
    void initializeGL() override;
    void paintGL() override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void tabletEvent(QTabletEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;
    void childEvent(QChildEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void applyStyle();
    void letGoOfContext();
    void fitSize();
    void moveCamera(const QPointF& place, unsigned long event, Qt::KeyboardModifiers modifiers);
    void blitToWidget();
    void setPeeking(bool isPeeking);
    void judgeSpeed();
    bool hasTurned();
    void leave();
    void passCovers();
    [[nodiscard]] Eigen::Vector2d fromCentre(const QPointF& place) const;

    view::SceneView m_view;
    vtkNew<vtkGenericOpenGLRenderWindow> m_window;
    vtkNew<vtkGenericRenderWindowInteractor> m_interactor;
    QPointF m_pointer;
    QPointF m_pressedAt;
    bool m_hasMoved = false; ///< since the button was pressed
    Mode m_mode = Mode::Camera;
    Qt::MouseButton m_cameraButton = Qt::NoButton;
    bool m_isPointerInside = false;
    bool m_clicksWhilePalpating = false;
    bool m_isClick = false; ///< the press of the left button in palpation mode may become a click
    bool m_isPressed = false;
    bool m_isPeeking = false; ///< G is held
    bool m_isReady = false;
    double m_frame_ms = 0.0;
    double m_slowest_ms = 0.0; ///< slowest of the first frames, without the warm-up
    int m_frames = 0;
    int m_covered_px = 0;
    QTimer m_still;
    bool m_isSlow = false;
    std::array<core::Vec3, 3> m_cameraBefore{core::Vec3::Zero(), core::Vec3::Zero(), core::Vec3::Zero()};
    bool m_isStill = false; ///< the current frame is drawn because the picture has been still
};

} // namespace palpate::ui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/view/SceneView.h>

#include <QOpenGLWidget>
#include <QSurfaceFormat>
#include <QTimer>

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

class vtkGenericRenderWindowInteractor;

namespace palpate::ui {

/// The 3D view as a Qt widget: draws a SceneView into Qt's framebuffer, and turns mouse, pen and wheel into camera
/// moves or, in palpate mode, into rays for the hand.
///
/// It draws when asked (`update()`) and when the camera moves, never by itself. Ambient occlusion is switched on when
/// the first frames show a graphics card that has the time for it; where frames are slow, the folds of translucent
/// tissue are sorted only once the picture stands still: its colours are the same in motion.
class VtkViewport : public QOpenGLWidget
{
    Q_OBJECT
  public:
    enum class Mode
    {
        Camera, ///< left rotates, middle pans, right zooms, the wheel zooms
        Palpate ///< left presses, the wheel sets the depth; middle pans and right rotates
    };

    /// What the view's OpenGL context needs; set it as the default before the application object is made.
    [[nodiscard]] static QSurfaceFormat surfaceFormat();

    explicit VtkViewport(QWidget* parent = nullptr);
    ~VtkViewport() override;

    [[nodiscard]] view::SceneView& view() noexcept { return m_view; }
    void setMode(Mode mode);
    /// The ray under the pointer; nothing when it is outside.
    [[nodiscard]] std::optional<view::Ray> pointerRay();
    /// The ray through a place of the widget, in logical pixels from its upper left.
    [[nodiscard]] view::Ray rayAt(const QPointF& place);
    /// Where a point of the scene is seen, in logical pixels from the widget's upper left. [mm]
    [[nodiscard]] QPointF placeOf(const core::Vec3& p_W);
    /// A place near the middle that shows something palpable; nothing when none is in view.
    [[nodiscard]] std::optional<QPointF> palpablePlace();
    /// Makes the next frame as good as a still one, for a picture that is kept.
    void refineNext();
    /// Time that the newest frame took to draw. [ms]
    [[nodiscard]] double frame_ms() const noexcept { return m_frame_ms; }

  Q_SIGNALS:
    /// The pointer moved over the view, or the view under the pointer. Palpate mode only, as the following.
    void pointerMoved();
    void pointerPressed();
    void pointerReleased();
    void pointerLeft();
    /// @param steps  notches of the wheel, away from the user > 0
    void depthTurned(double steps);
    /// A pen that tells its pressure is down, or was just lifted. @param pressure  0 … 1
    void penPressed(double pressure);
    /// The space bar went down or up: palpate while it is held.
    void spaceHeld(bool isDown);
    /// In both modes: the pointer moved with no button down.
    void hovered(const QPointF& place);
    /// It is elsewhere, or a button is down.
    void hoverEnded();
    /// Camera mode: the left button went down and up without a move.
    void clicked(const QPointF& place, Qt::KeyboardModifiers modifiers);
    /// In both modes: centre here.
    void centreWanted(const QPointF& place);

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

  private:
    void takeLook();
    void letGoOfContext();
    void fitSize();
    void moveCamera(const QPointF& place, unsigned long event, Qt::KeyboardModifiers modifiers);
    void blitToWidget();
    void judgeSpeed();

    view::SceneView m_view;
    vtkNew<vtkGenericOpenGLRenderWindow> m_window;
    vtkNew<vtkGenericRenderWindowInteractor> m_interactor;
    QPointF m_pointer;
    QPointF m_pressedAt;
    bool m_hasMoved = false; ///< since the button went down
    Mode m_mode = Mode::Camera;
    Qt::MouseButton m_cameraButton = Qt::NoButton;
    bool m_isPointerInside = false;
    bool m_isPressed = false;
    bool m_isReady = false;
    double m_frame_ms = 0.0;
    double m_slowest_ms = 0.0; ///< of the frames since the scene changed, without the first
    int m_frames = 0;
    QTimer m_still;
    bool m_isSlow = false;
    bool m_isStill = false; ///< the frame at hand is drawn because nothing moved for a while
};

} // namespace palpate::ui

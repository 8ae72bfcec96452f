// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/VtkViewport.h"

#include "palpate/ui/Theme.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QFontInfo>
#include <QInputDevice>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QPointingDevice>
#include <QTabletEvent>
#include <QWheelEvent>

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace palpate::ui {

namespace {

constexpr double kStill_px = 3.0; // tolerated pointer motion within a click
constexpr int kStill_ms = 350;    // time without a frame after which the picture counts as still
constexpr int kWarmUp = 2;        // the first frames upload meshes and compile shaders and do not represent the speed
constexpr double kSlow_ms = 40.0; // slower moving pictures omit the most expensive effects
constexpr int kJudged = 20;       // number of frames before the speed is evaluated
constexpr double kQuick_ms = 5.0; // frame time that leaves enough time for ambient occlusion

} // namespace

QSurfaceFormat VtkViewport::surfaceFormat()
{
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setSwapBehavior(QSurfaceFormat::DoubleBuffer);
    format.setRedBufferSize(8);
    format.setGreenBufferSize(8);
    format.setBlueBufferSize(8);
    format.setDepthBufferSize(24);
    format.setStencilBufferSize(8);
    format.setSamples(0);
    return format;
}

VtkViewport::VtkViewport(QWidget* parent)
    : QOpenGLWidget(parent)
{
    setFormat(surfaceFormat());
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(240, 180);
    applyStyle();

    m_window->SetOwnContext(0);           // the context belongs to Qt
    m_window->SetFrameBlitModeToNoBlit(); // blitToWidget copies the frame
    m_view.attach(*m_window);
    m_interactor->SetRenderWindow(m_window);
    m_interactor->EnableRenderOff(); // Qt schedules the drawing
    vtkNew<vtkInteractorStyleTrackballCamera> style;
    style->AutoAdjustCameraClippingRangeOff();
    style->SetDefaultRenderer(&m_view.renderer());
    m_interactor->SetInteractorStyle(style);
    m_interactor->Initialize();
    m_view.setSmoothEdges(true);
    m_still.setSingleShot(true);
    m_still.setInterval(kStill_ms);
    connect(&m_still, &QTimer::timeout, this, [this] {
        refineNext();
        update();
    });
}

void VtkViewport::applyStyle()
{
    if (isHighContrast()) {
        const view::Colour ground = isDarkTheme() ? view::Colour{0.0, 0.0, 0.0} : view::Colour{1.0, 1.0, 1.0};
        m_view.setBackground(ground, ground, isDarkTheme() ? view::Colour{1.0, 1.0, 1.0} : view::Colour{0.0, 0.0, 0.0});
    } else if (isDarkTheme()) {
        m_view.setBackground({0.07, 0.085, 0.10}, {0.20, 0.235, 0.27}, {0.93, 0.95, 0.97});
    } else {
        m_view.setBackground({0.33, 0.38, 0.44}, {0.60, 0.66, 0.72}, {1.0, 1.0, 1.0});
    }
    view::TextStyle text;
    text.size_px = QFontInfo(font()).pixelSize();
    text.decimalPoint = QLocale().decimalPoint().toStdString();
    text.fontFile = viewFont();
    text.groundOpacity = isHighContrast() ? 1.0 : text.groundOpacity;
    m_view.setTextStyle(text);
    update();
}

void VtkViewport::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        applyStyle();
    }
    QOpenGLWidget::changeEvent(event);
}

VtkViewport::~VtkViewport()
{
    if (context() != nullptr) {
        disconnect(context(), nullptr, this, nullptr);
    }
    letGoOfContext();
}

void VtkViewport::initializeGL()
{
    m_window->SetReadyForRendering(true);
    m_window->SetMapped(1);
    m_window->SetIsCurrent(true);
    m_window->InitializeFromCurrentContext();
    m_isReady = true;
    // Moving to another screen may replace the context: release its resources while it still exists.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &VtkViewport::letGoOfContext, Qt::UniqueConnection);
}

void VtkViewport::letGoOfContext()
{
    if (!m_isReady) {
        return;
    }
    makeCurrent();
    m_window->Finalize();
    m_window->SetReadyForRendering(false);
    m_isReady = false;
    doneCurrent();
}

void VtkViewport::fitSize()
{
    const double ratio = devicePixelRatioF();
    const int w = std::max(1, static_cast<int>(std::lround(width() * ratio)));
    const int h = std::max(1, static_cast<int>(std::lround(height() * ratio)));
    const int* size = m_window->GetSize();
    if (size[0] != w || size[1] != h) {
        m_window->SetSize(w, h);
        m_interactor->SetSize(w, h);
    }
}

void VtkViewport::paintGL()
{
    if (!m_isReady) {
        return;
    }
    QElapsedTimer timer;
    timer.start();
    fitSize();
    vtkOpenGLState* state = m_window->GetState();
    // Qt has modified the OpenGL state since the last frame, unknown to VTK.
    state->Reset();
    state->Push();
    // Qt leaves the default depth function GL_LESS, while VTK relies on GL_LEQUAL. With GL_LESS only the lowest of
    // coplanar layers would be visible, e.g. the background of the colour legend without its text.
    state->vtkglDepthFunc(GL_LEQUAL);
    m_window->SetReadyForRendering(true);
    m_window->SetIsCurrent(true);
    m_view.setCoarse(m_isSlow && !m_isStill && hasTurned());
    passCovers();
    m_view.prepareFrame(devicePixelRatioF());
    m_window->Render();
    blitToWidget();
    state->Pop();
    m_frame_ms = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
    judgeSpeed();
}

/// Returns true if the camera has moved since the last frame.
bool VtkViewport::hasTurned()
{
    vtkCamera& camera = m_view.camera();
    const std::array<core::Vec3, 3> now{core::Vec3(camera.GetPosition()), core::Vec3(camera.GetFocalPoint()),
                                        core::Vec3(camera.GetViewUp())};
    return std::exchange(m_cameraBefore, now) != now;
}

void VtkViewport::refineNext()
{
    m_isStill = true;
    m_view.setSortedTransparency(true);
}

QImage VtkViewport::picture(double scale)
{
    if (!m_isReady) {
        return {};
    }
    makeCurrent();
    QOpenGLExtraFunctions* gl = context()->extraFunctions();
    GLint most = 0;
    gl->glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    const double ratio = devicePixelRatioF();
    scale = std::min(scale, most / (ratio * std::max({width(), height(), 1})));
    const int w = std::max(1, static_cast<int>(std::lround(width() * ratio * scale)));
    const int h = std::max(1, static_cast<int>(std::lround(height() * ratio * scale)));
    vtkOpenGLState* state = m_window->GetState();
    state->Reset();
    state->Push();
    state->vtkglDepthFunc(GL_LEQUAL); // see paintGL
    m_window->SetSize(w, h);
    m_window->SetIsCurrent(true);
    m_view.setSortedTransparency(true);
    m_view.setCoarse(false);
    m_view.prepareFrame(ratio * scale);
    m_window->Render();
    QImage image(w, h, QImage::Format_RGBA8888);
    gl->glBindFramebuffer(GL_READ_FRAMEBUFFER, m_window->GetDisplayFramebuffer()->GetFBOIndex());
    gl->glReadBuffer(GL_COLOR_ATTACHMENT0);
    gl->glPixelStorei(GL_PACK_ALIGNMENT, 4);
    gl->glReadPixels(0, 0, w, h, GL_RGBA, GL_UNSIGNED_BYTE, image.bits());
    gl->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
    state->Pop();
    doneCurrent();
    fitSize();
    m_view.setSortedTransparency(!m_isSlow);
    update();
    return image.mirrored().convertToFormat(QImage::Format_RGB32); // OpenGL's rows start at the bottom
}

void VtkViewport::judgeSpeed()
{
    if (++m_frames > kWarmUp && m_frames <= kJudged) {
        m_slowest_ms = std::max(m_slowest_ms, m_frame_ms);
        if (m_frames == kJudged) {
            m_view.setAmbientOcclusion(m_slowest_ms < kQuick_ms);
        }
    }
    if (m_frames <= kWarmUp) {
        return;
    }
    // Frames without sorting do not show whether sorting would be fast enough: slow mode ends only with a fast still
    // frame, which is sorted.
    if (m_isStill) {
        m_isStill = false; // the next frame belongs to a moving picture again
        m_isSlow = m_frame_ms > kSlow_ms;
    } else if (m_isSlow || m_frame_ms > kSlow_ms) {
        m_isSlow = true;
        m_still.start();
    }
    m_view.setSortedTransparency(!m_isSlow);
}

void VtkViewport::blitToWidget()
{
    QOpenGLExtraFunctions* gl = context()->extraFunctions();
    const int* size = m_window->GetSize();
    gl->glBindFramebuffer(GL_READ_FRAMEBUFFER, m_window->GetDisplayFramebuffer()->GetFBOIndex());
    gl->glReadBuffer(GL_COLOR_ATTACHMENT0);
    gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
    gl->glDisable(GL_SCISSOR_TEST);
    gl->glBlitFramebuffer(0, 0, size[0], size[1], 0, 0, size[0], size[1], GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
    // Qt blends the widget into the window by alpha: make it opaque.
    gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    gl->glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    gl->glClear(GL_COLOR_BUFFER_BIT);
    gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void VtkViewport::setClicksWhilePalpating(bool isOn)
{
    m_clicksWhilePalpating = isOn;
    m_isClick = false;
}

void VtkViewport::setMode(Mode mode)
{
    m_mode = mode;
    setCursor(mode == Mode::Palpate ? Qt::CrossCursor : Qt::ArrowCursor);
}

view::Ray VtkViewport::rayAt(const QPointF& place)
{
    fitSize();
    const double ratio = devicePixelRatioF();
    return m_view.rayThrough(place.x() * ratio, (height() - place.y()) * ratio);
}

QPointF VtkViewport::placeOf(const core::Vec3& p_W)
{
    fitSize();
    const Eigen::Vector2d px = view::ViewFrame::of(m_view.renderer(), devicePixelRatioF()).pixelOf(p_W);
    return {0.5 * width() + px.x(), 0.5 * height() - px.y()};
}

std::optional<QPointF> VtkViewport::palpablePlace()
{
    // Rings around the centre, 2 % of the height apart, from the inside out.
    constexpr int kRings = 24, kSpokes = 12;
    const QPointF centre(0.5 * width(), 0.5 * height());
    for (int ring = 0; ring < kRings; ++ring) {
        for (int spoke = 0; spoke < kSpokes; ++spoke) {
            const double angle = 2.0 * std::numbers::pi * spoke / kSpokes;
            const QPointF place = centre + 0.02 * ring * height() * QPointF(std::cos(angle), std::sin(angle));
            if (rect().contains(place.toPoint()) && m_view.pick(rayAt(place))) {
                return place;
            }
        }
    }
    return std::nullopt;
}

std::optional<view::Ray> VtkViewport::pointerRay()
{
    return m_isPointerInside ? std::optional(rayAt(m_pointer)) : std::nullopt;
}

void VtkViewport::moveCamera(const QPointF& place, unsigned long event, Qt::KeyboardModifiers modifiers)
{
    fitSize();
    const double ratio = devicePixelRatioF();
    m_interactor->SetEventInformationFlipY(static_cast<int>(place.x() * ratio), static_cast<int>(place.y() * ratio),
                                           modifiers.testFlag(Qt::ControlModifier) ? 1 : 0,
                                           modifiers.testFlag(Qt::ShiftModifier) ? 1 : 0);
    m_interactor->InvokeEvent(event, nullptr);
    update();
}

void VtkViewport::mousePressEvent(QMouseEvent* event)
{
    m_pointer = event->position();
    m_isPointerInside = true;
    m_pressedAt = m_pointer;
    m_hasMoved = false;
    Q_EMIT hoverEnded();
    if (m_mode == Mode::Palpate && event->button() == Qt::LeftButton) {
        m_isPressed = true;
        m_isClick = m_clicksWhilePalpating;
        Q_EMIT pointerMoved();
        Q_EMIT pointerPressed();
        return;
    }
    if (m_cameraButton != Qt::NoButton) {
        return; // one camera motion at a time
    }
    m_cameraButton = event->button();
    const bool turns =
        event->button() == Qt::LeftButton || (m_mode == Mode::Palpate && event->button() == Qt::RightButton);
    moveCamera(m_pointer,
               turns                                 ? vtkCommand::LeftButtonPressEvent
               : event->button() == Qt::MiddleButton ? vtkCommand::MiddleButtonPressEvent
                                                     : vtkCommand::RightButtonPressEvent,
               event->modifiers());
}

void VtkViewport::mouseReleaseEvent(QMouseEvent* event)
{
    m_pointer = event->position();
    if (m_isPressed && event->button() == Qt::LeftButton) {
        m_isPressed = false;
        Q_EMIT pointerReleased();
        if (std::exchange(m_isClick, false) && !m_hasMoved) {
            Q_EMIT clicked(m_pointer, event->modifiers());
        }
        return;
    }
    if (event->button() != m_cameraButton) {
        return;
    }
    m_cameraButton = Qt::NoButton;
    if (event->button() == Qt::LeftButton && m_mode == Mode::Camera && !m_hasMoved) {
        Q_EMIT clicked(m_pointer, event->modifiers());
    }
    // The button is not known here: the style ends the active interaction and ignores the other events.
    for (const auto release : {vtkCommand::LeftButtonReleaseEvent, vtkCommand::MiddleButtonReleaseEvent,
                               vtkCommand::RightButtonReleaseEvent}) {
        moveCamera(m_pointer, release, event->modifiers());
    }
}

void VtkViewport::mouseMoveEvent(QMouseEvent* event)
{
    m_pointer = event->position();
    m_isPointerInside = true;
    m_hasMoved = m_hasMoved || (m_pointer - m_pressedAt).manhattanLength() > kStill_px;
    if (event->buttons() == Qt::NoButton) {
        Q_EMIT hovered(m_pointer);
    }
    if (m_cameraButton != Qt::NoButton) {
        moveCamera(m_pointer, vtkCommand::MouseMoveEvent, event->modifiers());
    }
    if (m_mode == Mode::Palpate) {
        Q_EMIT pointerMoved();
    }
}

void VtkViewport::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton && m_mode == Mode::Camera) {
        Q_EMIT centreWanted(event->position());
        return;
    }
    mousePressEvent(event);
}

void VtkViewport::tabletEvent(QTabletEvent* event)
{
    const bool tells = event->pointingDevice()->capabilities().testFlag(QInputDevice::Capability::Pressure);
    if (m_mode == Mode::Palpate && tells) {
        if (event->type() == QEvent::TabletRelease) {
            Q_EMIT penPressed(0.0);
        } else if (event->buttons().testFlag(Qt::LeftButton)) {
            Q_EMIT penPressed(event->pressure());
        }
    }
    event->ignore(); // ignored tablet events are delivered as mouse events
}

void VtkViewport::wheelEvent(QWheelEvent* event)
{
    const QPoint turned = event->angleDelta();
    const double steps = turned.y() / 120.0;
    if (m_view.section() && event->modifiers() == Qt::ShiftModifier) {
        // Some systems turn the wheel sideways with Shift.
        Q_EMIT sectionMoved(turned.y() != 0 ? steps : turned.x() / 120.0);
    } else if (m_mode == Mode::Palpate && !event->modifiers().testFlag(Qt::ControlModifier)) {
        Q_EMIT depthTurned(steps);
    } else if (steps != 0.0) {
        m_view.camera().Dolly(std::pow(1.12, steps));
        update();
        if (m_mode == Mode::Palpate) {
            Q_EMIT pointerMoved();
        }
    }
    event->accept();
}

void VtkViewport::setPeeking(bool isPeeking)
{
    if (m_isPeeking != isPeeking) {
        m_isPeeking = isPeeking;
        Q_EMIT peekHeld(isPeeking);
    }
}

bool VtkViewport::event(QEvent* event)
{
    if ((event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease) && takesKeys()) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool isDown = event->type() == QEvent::KeyPress;
        if (key->key() == Qt::Key_Space && key->modifiers() == Qt::NoModifier) {
            if (!key->isAutoRepeat()) {
                Q_EMIT spaceHeld(isDown);
            }
            return true;
        }
        if (key->key() == Qt::Key_G && (key->modifiers() == Qt::NoModifier || m_isPeeking)) {
            if (!key->isAutoRepeat()) {
                setPeeking(isDown);
            }
            return true;
        }
    } else if (event->type() == QEvent::FocusOut) {
        setPeeking(false); // the release would go elsewhere
    }
    return QOpenGLWidget::event(event);
}

bool VtkViewport::takesKeys() const
{
    // Qt passes a key that a widget ignores (a spin box Enter, for example) to the parents of the widget.
    const QWidget* focus = QApplication::focusWidget();
    return focus == nullptr || focus == this || !isAncestorOf(focus);
}

/// Qt sends no Leave to a widget when the pointer enters one of its children.
void VtkViewport::childEvent(QChildEvent* event)
{
    if (event->added() && event->child()->isWidgetType()) {
        event->child()->installEventFilter(this);
    }
    QOpenGLWidget::childEvent(event);
}

bool VtkViewport::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Enter && watched->parent() == this && !static_cast<QWidget*>(watched)->isWindow()) {
        leave();
    }
    return QOpenGLWidget::eventFilter(watched, event);
}

void VtkViewport::leaveEvent(QEvent* event)
{
    leave();
    QOpenGLWidget::leaveEvent(event);
}

void VtkViewport::leave()
{
    m_isPointerInside = m_isPressed; // a press grabs the mouse: motion events continue outside
    Q_EMIT hoverEnded();
    if (m_mode == Mode::Palpate && !m_isPressed) {
        Q_EMIT pointerLeft();
        update();
    }
}

void VtkViewport::setCoveredAbove(int height_px)
{
    m_covered_px = height_px;
    update();
    Q_EMIT coveredAboveChanged();
}

void VtkViewport::setCoveredBelow(int height_px)
{
    m_view.setCoveredBelow(height_px);
    update();
}

/// Passes on what covers the upper corners: the messages and the bars of the view below them. Tool tips and menus are
/// children, too, but windows with a place on the screen.
void VtkViewport::passCovers()
{
    std::array<int, 2> above_px{m_covered_px, m_covered_px};
    for (const QWidget* one : findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        const QRect place = one->geometry();
        if (one->isVisible() && !one->isWindow() && !one->testAttribute(Qt::WA_TransparentForMouseEvents) &&
            2 * place.top() < height()) {
            int& side_px = above_px[2 * place.center().x() < width() ? 0 : 1];
            side_px = std::max(side_px, place.bottom() + 1);
        }
    }
    m_view.setCoveredAbove(above_px[0], above_px[1]);
}

Eigen::Vector2d VtkViewport::fromCentre(const QPointF& place) const
{
    return {place.x() - 0.5 * width(), 0.5 * height() - place.y()};
}

bool VtkViewport::isOnLegend(const QPointF& place) const
{
    return m_view.legend().box().contains(fromCentre(place));
}

bool VtkViewport::isOnLegendClose(const QPointF& place) const
{
    return m_view.legend().closeBox().contains(fromCentre(place));
}

} // namespace palpate::ui

#include "palpate/ui/moc_VtkViewport.cpp"

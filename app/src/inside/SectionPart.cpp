// SPDX-License-Identifier: BSD-3-Clause
#include "inside/SectionPart.h"

#include "scene/SceneDocument.h"

#include <palpate/ui/ActionList.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/ui/VtkViewport.h>
#include <palpate/view/ScaleBar.h>

#include <QAction>
#include <QLocale>
#include <QMainWindow>

#include <vtkCamera.h>

#include <cmath>
#include <optional>

namespace palpate::app {

using core::Vec3;
using meshio::SectionDirection;
using ui::ActionGroup;

namespace {

constexpr double kSameDirection = 1e-9; // of two unit vectors, by rounding

/// Axis of a plane of the patient in LPS.
Vec3 patientAxis(SectionDirection direction)
{
    return direction == SectionDirection::Axial     ? Vec3::UnitZ()
           : direction == SectionDirection::Coronal ? Vec3::UnitY()
                                                    : Vec3::UnitX();
}

/// Rounded as shown, so that 0 has no side.
double rounded(double position_mm)
{
    return std::round(10.0 * position_mm) / 10.0 + 0.0;
}

/// Place of a section in words. @param position_mm  along the axis of increasing position
QString placeText(SectionDirection direction, double position_mm)
{
    const double shown = rounded(position_mm);
    const QString mm = QLocale().toString(std::abs(shown), 'f', 1);
    const auto either = [&](const QString& positive, const QString& negative) {
        return shown < 0.0 ? negative : positive;
    };
    switch (direction) {
    case SectionDirection::Axial:
        return either(SectionPart::tr("axial, %1 mm superior"), SectionPart::tr("axial, %1 mm inferior")).arg(mm);
    case SectionDirection::Coronal:
        return either(SectionPart::tr("coronal, %1 mm posterior"), SectionPart::tr("coronal, %1 mm anterior")).arg(mm);
    case SectionDirection::Sagittal:
        return either(SectionPart::tr("sagittal, %1 mm left"), SectionPart::tr("sagittal, %1 mm right")).arg(mm);
    case SectionDirection::Free:
        break;
    }
    return either(SectionPart::tr("free, %1 mm deeper"), SectionPart::tr("free, %1 mm nearer")).arg(mm);
}

} // namespace

SectionPart::SectionPart(const WindowCore& core, SceneDocument& document)
    : WindowPart(&core.window)
    , m_core(core)
    , m_document(document)
    , m_bar(new ui::SectionBar(core.viewport))
    , m_inset(new ui::FingerInset(core.viewport))
{
    connect(m_bar, &ui::SectionBar::directionChosen, this, qOverload<SectionDirection>(&SectionPart::setDirection));
    connect(m_bar, &ui::SectionBar::positionChosen, this, &SectionPart::moveTo);
    connect(m_bar, &ui::SectionBar::otherSideWanted, this, &SectionPart::turnOver);
    connect(m_bar, &ui::SectionBar::closeWanted, this, [this] { setShown(false); });
    connect(&document, &SceneDocument::sectionChanged, this, &SectionPart::take);
    connect(&core.model, &ui::StructureModel::edited, this, [this] {
        if (m_bar->isVisible()) {
            show(); // another structure may be visible now
        }
    });
    connect(&core.viewport, &ui::VtkViewport::sectionMoved, this, [this](double steps) { move(steps * step_mm()); });
}

SectionPart::~SectionPart()
{
    delete m_inset;
    delete m_bar;
}

void SectionPart::addActions()
{
    ui::ActionList& actions = m_core.actions;
    QAction* section = actions.add("section", ActionGroup::View, tr("Section"),
                                   tr("Cut the picture through the hand, the selected finding or the middle of the "
                                      "view; the hand still feels everything"),
                                   {QKeySequence(Qt::Key_X)});
    section->setCheckable(true);
    connect(section, &QAction::toggled, this, &SectionPart::setShown);
    QAction* finger = actions.add("finger-section", ActionGroup::View, tr("Section along the finger"),
                                  tr("Small picture of the hand and of what lies below, live and in playback"),
                                  {QKeySequence(Qt::ALT | Qt::Key_X)});
    finger->setCheckable(true);
    connect(finger, &QAction::toggled, m_inset, &QWidget::setVisible);
    connect(actions.add("section-direction", ActionGroup::Section, tr("Next direction of the section"),
                        tr("Axial, coronal, sagittal, or facing the viewer"), {QKeySequence(Qt::SHIFT | Qt::Key_X)}),
            &QAction::triggered, this,
            [this] { setDirection(static_cast<SectionDirection>((static_cast<int>(m_plane.direction) + 1) % 4)); });
    connect(actions.add("section-side", ActionGroup::Section, tr("Other side of the section"),
                        tr("Show the side that is hidden"), {QKeySequence(Qt::CTRL | Qt::Key_X)}),
            &QAction::triggered, this, &SectionPart::turnOver);
    connect(actions.add("section-here", ActionGroup::Section, tr("Section through the hand"),
                        tr("Move the section to the hand, the selected finding or the middle of the view"),
                        {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_X)}),
            &QAction::triggered, this, [this] { goThrough(wantedPlace()); });
    connect(actions.add("section-deeper", ActionGroup::Section, tr("Section deeper"),
                        tr("Move the section away from the viewer"), {QKeySequence(Qt::SHIFT | Qt::Key_PageDown)}),
            &QAction::triggered, this, [this] { move(step_mm()); });
    connect(actions.add("section-nearer", ActionGroup::Section, tr("Section nearer"),
                        tr("Move the section towards the viewer"), {QKeySequence(Qt::SHIFT | Qt::Key_PageUp)}),
            &QAction::triggered, this, [this] { move(-step_mm()); });
    actions.addGesture(ActionGroup::InView, tr("Shift+wheel"), tr("move the section"));
    actions.addSubmenu(ActionGroup::View, tr("Section plane"), ActionGroup::Section);
    actions.addSeparator(ActionGroup::View);
}

void SectionPart::showState(const WindowState& state)
{
    m_core.actions.setEnabled({"section", "finger-section"}, state.hasScene);
    const bool isOn = state.hasScene && m_core.actions.at("section").isChecked();
    m_core.actions.setEnabled({"section-direction", "section-side", "section-here", "section-deeper", "section-nearer"},
                              isOn);
}

void SectionPart::setShown(bool isShown)
{
    if (!isShown) {
        m_document.setSection(std::nullopt);
    } else if (m_document.section()) {
        take();
    } else {
        // The plane of the patient that faces the viewer most.
        Eigen::Index axis = 0;
        Vec3(m_core.viewport.view().camera().GetDirectionOfProjection()).cwiseAbs().maxCoeff(&axis);
        setDirection(static_cast<SectionDirection>(2 - axis), wantedPlace());
    }
}

/// Shows the section of the document, except while an exercise hides structures.
void SectionPart::take()
{
    const auto section = m_core.model.scene().hiddenTargets() == 0 ? m_document.section() : std::nullopt;
    if (section) {
        m_plane = *section;
        if (m_plane.direction != SectionDirection::Free) {
            m_axis_W = patientAxis(m_plane.direction);
            m_start_W.setZero();
        } else if (std::abs(m_axis_W.dot(m_plane.n_W)) < 1.0 - kSameDirection) { // of a file, or of another scene
            m_axis_W = -m_plane.n_W;
            m_start_W = m_plane.p_W;
        }
        show();
    } else {
        m_core.viewport.view().setSection(std::nullopt);
        m_core.viewport.update();
    }
    m_bar->setVisible(section.has_value());
    m_core.actions.at("section").setChecked(section.has_value());
    Q_EMIT stateChanged();
}

void SectionPart::setDirection(SectionDirection direction)
{
    setDirection(direction, m_plane.p_W);
}

void SectionPart::setDirection(SectionDirection direction, const Vec3& p_W)
{
    const Vec3 toViewer_W = -Vec3(m_core.viewport.view().camera().GetDirectionOfProjection());
    meshio::SceneSection section{direction, p_W, toViewer_W, {}};
    if (direction == SectionDirection::Free) {
        m_axis_W = -toViewer_W;
        m_start_W = p_W;
    } else {
        const Vec3 axis_W = patientAxis(direction);
        section.n_W = axis_W.dot(toViewer_W) < 0.0 ? Vec3(-axis_W) : axis_W;
    }
    m_document.setSection(section);
}

void SectionPart::goThrough(const Vec3& p_W)
{
    meshio::SceneSection section = m_plane;
    section.p_W = p_W;
    m_document.setSection(section);
}

/// @param deeper_mm  away from the hidden side
void SectionPart::move(double deeper_mm)
{
    goThrough(m_plane.p_W - deeper_mm * m_plane.n_W);
}

void SectionPart::moveTo(double position)
{
    goThrough(m_plane.p_W + (position - position_mm()) * m_axis_W);
}

void SectionPart::turnOver()
{
    meshio::SceneSection section = m_plane;
    section.n_W = -section.n_W;
    m_document.setSection(section);
}

void SectionPart::show()
{
    view::SceneView& view = m_core.viewport.view();
    view.setSection(geometry::SectionPlane::through(m_plane.p_W, m_plane.n_W));
    m_bar->setSection(m_plane.direction, position_mm(), step_mm(), lineOf(position_mm()));
    m_core.viewport.update();
}

/// The hand in contact, else the selected finding, else the middle of the view.
Vec3 SectionPart::wantedPlace() const
{
    view::SceneView& view = m_core.viewport.view();
    if (view.cursor().state().isPresent && view.cursor().state().isInContact) {
        return view.cursor().state().onSurface_W();
    }
    if (const auto finding = view.findings().selectedPlace()) {
        return *finding;
    }
    const core::Box box = view.bounds();
    const Vec3 focus_W(view.camera().GetFocalPoint());
    return box.isEmpty() || box.contains(focus_W) ? focus_W : Vec3(box.center());
}

/// A round number of mm, about 1/200 of the scene: 1 mm for an organ.
double SectionPart::step_mm() const
{
    return view::roundScaleLength(m_core.viewport.view().bounds().diagonal().norm() / 200.0);
}

double SectionPart::position_mm() const
{
    return m_axis_W.dot(m_plane.p_W - m_start_W);
}

QString SectionPart::lineOf(double position) const
{
    const QString place = placeText(m_plane.direction, position);
    return m_core.viewport.view().sectionPicture().isEmpty() ? tr("%1 · cuts no visible structure").arg(place)
                                                             : tr("%1 · the hand still feels everything").arg(place);
}

} // namespace palpate::app

#include "moc_SectionPart.cpp"

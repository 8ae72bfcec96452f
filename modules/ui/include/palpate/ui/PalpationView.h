// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/TouchReading.h"

#include <palpate/core/Export.h>
#include <palpate/core/Status.h>
#include <palpate/core/Tissue.h>
#include <palpate/device/HapticDevice.h>
#include <palpate/geometry/Repair.h>
#include <palpate/session/LiveSession.h>

#include <QString>
#include <QStringList>
#include <QWidget>

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

class vtkPolyData;

namespace palpate::ui {

using session::Embed;

/// A structure to be added to a PalpationView.
struct Organ
{
    std::string name;
    core::Tissue tissue{};                        ///< liver: stiffness 0.1 to 0.3 N/mm
    std::array<double, 3> colour{0.85, 0.6, 0.5}; ///< red, green, blue, 0 to 1
    double opacity = 1.0;                         ///< 0 to 1
    std::uint32_t layer = 0;                      ///< 0 is the outermost; inner layers are felt through outer ones
    double unit_mm = 1.0;                         ///< length of one unit of the data [mm]; 1000 for data in metres
};

/// Widget for palpation in a Qt program: 3D view, live touch by pointer or haptic device, and recording. The pointer
/// moves the camera; with `setPalpating`, or while Space is held, dragging presses into the tissue.
///
/// @code
/// palpate::ui::PalpationView::prepareApplication();
/// QApplication app(argc, argv);
/// palpate::ui::PalpationView view;
/// const auto liver = view.add(contour->GetOutput(), {.name = "liver", .tissue = {.stiffness_N_per_mm = 0.2}});
/// if (!liver.isOk()) {
///     qFatal("%s", qPrintable(view.text(liver.status())));
/// }
/// view.setPalpating(true);
/// view.show();
/// return app.exec();
/// @endcode
///
/// This header is stable: other headers of this module may change with each release.
/// @par Thread GUI thread only. The servo thread runs from the first `add` to the destructor.
class PALPATE_EXPORT PalpationView : public QWidget
{
    Q_OBJECT
  public:
    /// Sets the OpenGL format that all views need. Call before the constructor of QApplication.
    static void prepareApplication();

    explicit PalpationView(QWidget* parent = nullptr);
    ~PalpationView() override;

    /// Adds a surface, which is checked, repaired and turned outwards (vtk::surfaceOf), and shows the whole scene.
    /// @param surface  may be null, then an error; copied
    /// @return number of the structure; or the error of the surface or of the tissue (core::check)
    /// @par Cost O(n log n): about a second for a million triangles.
    core::Result<int> add(vtkPolyData* surface, const Organ& organ);
    /// Defects and changes of a structure's mesh, one sentence each. Worth showing: an open surface is felt from both
    /// sides, for example.
    [[nodiscard]] QStringList notes(int structure) const;
    /// The surface as it is felt, to carry results back with vtk::atPoints; null for an invalid number.
    [[nodiscard]] std::shared_ptr<const geometry::RepairedMesh> surface(int structure) const;
    /// Message of an error in the language of the application.
    [[nodiscard]] QString text(const core::Status& status) const;

    /// Changes a structure while it may be touched; the force follows smoothly.
    /// @return OutOfRange or NonFinite: no structure of this number, or an invalid value
    core::Status setStiffness(int structure, double stiffness_N_per_mm);
    core::Status setTissue(int structure, const core::Tissue& tissue);
    /// Shows or hides a structure. A hidden structure is not felt.
    core::Status setShown(int structure, bool isShown);
    /// Radius of the ball-shaped fingertip, 0: a point. [mm] Limited to HapticScene::kMostFingertip_mm.
    void setFingertip(double radius_mm);

    /// Switches between camera and palpation.
    void setPalpating(bool isPalpating);
    /// Uses another haptic device; null: the pointer. If the device does not start, the pointer is used and the error
    /// returned.
    core::Status useDevice(std::unique_ptr<device::HapticDevice> device);
    /// Restores the force after a fault, with a ramp.
    void rearm();

    /// Records the following ticks in a new file. @param embed  also stores the surfaces, so that the file is complete
    core::Status startRecording(const std::filesystem::path& path, Embed embed = Embed::No);
    /// Ends the recording. An error lists lost data.
    core::Status stopRecording();
    [[nodiscard]] bool isRecording() const;

  Q_SIGNALS:
    /// Emitted for new ticks with a hand, at most at display rate.
    void touched(const palpate::ui::TouchReading& reading);
    /// Emitted when the hand has left the view or the device.
    void handGone();
    /// Emitted when the force was switched off for safety. It stays off until `rearm`; devices without motors are
    /// rearmed automatically. @param line  cause and remedy, for the user
    void faulted(const QString& line);
    /// Emitted for a message to the user, for example that tissue is too stiff for the device.
    void notice(const QString& line);

  private:
    struct Private;
    std::unique_ptr<Private> m_d;
};

} // namespace palpate::ui

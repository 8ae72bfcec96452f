// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>

#include <memory>

namespace palpate::ui {

/// Lets touch be heard: as high as the place is stiff, as loud as the force (TouchTone). Off until it is switched on.
/// @par Threads the window's; samples are made on one of its own.
class TouchSound : public QObject
{
    Q_OBJECT
  public:
    explicit TouchSound(QObject* parent = nullptr);
    ~TouchSound() override;

    /// @return why nothing can be heard here, as a few words for a person; empty where it can
    [[nodiscard]] static QString whyNot();
    /// @return whether it is on now: false where `whyNot` says so
    bool setOn(bool isOn);
    /// @param ratio  stiffness felt by that of the touched tissue alone [1]; @param force_N  0 in air
    /// @param limit_N  the device's
    void setTouch(double ratio, double force_N, double limit_N);

  Q_SIGNALS:
    /// The loudspeaker has gone: it is off now.
    void ended();

  private:
    struct Output;
    std::unique_ptr<Output> m_output; ///< null: off
};

} // namespace palpate::ui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/device/AxisCheck.h>
#include <palpate/servo/SelfTestRun.h>

#include <QDialog>
#include <QElapsedTimer>
#include <QTimer>

#include <memory>
#include <optional>

class QLabel;
class QProgressBar;
class QPushButton;

namespace palpate::ui {
class LiveTouch;
}

namespace palpate::app {

/// Runs the self-test of the device and shows instructions, progress and results. While a test runs, the hand does not
/// touch the scene.
/// @par Thread GUI thread only.
class SelfTestDialog : public QDialog
{
    Q_OBJECT
  public:
    /// @param live  with a device; must outlive the dialog
    SelfTestDialog(ui::LiveTouch& live, QWidget* parent);
    ~SelfTestDialog() override; ///< ends a running test with zero force
    /// The result of the last test; empty before its end.
    [[nodiscard]] const std::optional<servo::SelfTestResult>& result() const noexcept { return m_result; }

  public Q_SLOTS:
    void done(int code) override;

  private:
    void toggle();
    void begin();
    void follow();
    void end();
    void save();

    ui::LiveTouch& m_live;
    std::unique_ptr<servo::SelfTestRun> m_run; ///< while a test runs
    std::optional<servo::SelfTestResult> m_result;
    QTimer m_poll;
    QLabel* m_text = nullptr;
    QProgressBar* m_progress = nullptr;
    QPushButton* m_start = nullptr;
    QPushButton* m_save = nullptr;
};

/// Guides through the check of axes with the positions of the running device.
/// @par Thread GUI thread only.
class AxisCheckDialog : public QDialog
{
    Q_OBJECT
  public:
    /// @param live  with a device; must outlive the dialog
    AxisCheckDialog(ui::LiveTouch& live, QWidget* parent);
    [[nodiscard]] const device::AxisCheck& check() const noexcept { return m_check; }
    /// The axes of this device have been checked before.
    [[nodiscard]] static bool wasDone(const device::DeviceInfo& info);

  private:
    void follow();

    ui::LiveTouch& m_live;
    device::AxisCheck m_check;
    QTimer m_poll;
    QElapsedTimer m_time;
    QLabel* m_text = nullptr;
};

} // namespace palpate::app

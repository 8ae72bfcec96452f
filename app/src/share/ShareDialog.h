// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/igtl/ShareServer.h>

#include <QDialog>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace palpate::app {

/// Settings and state of sharing by OpenIGTLink. Port and surfaces are remembered; the choice of the network is not, so
/// that nobody shares with a network without asking for it.
class ShareDialog : public QDialog
{
    Q_OBJECT
  public:
    explicit ShareDialog(QWidget* parent);

    [[nodiscard]] igtl::ShareOptions options() const;
    /// Shows the state of the server. @param perSecond  messages sent in the last second
    void showReport(const igtl::ShareReport& report, double perSecond);
    /// Shows why the server did not start.
    void showFailure(const QString& line);

  Q_SIGNALS:
    void startWanted();
    void stopWanted();

  private:
    void showWarning();
    void fitHeight();

    QComboBox* m_reach = nullptr;
    QLabel* m_warning = nullptr;
    QSpinBox* m_port = nullptr;
    QCheckBox* m_surfaces = nullptr;
    QLabel* m_state = nullptr;
    QPushButton* m_toggle = nullptr;
    bool m_isRunning = false;
};

} // namespace palpate::app

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/HandPanel.h"
#include "palpate/ui/LiveTouch.h"
#include "palpate/ui/StructurePanel.h"
#include "palpate/ui/VtkViewport.h"

#include <QObject>
#include <QTimer>

namespace palpate::ui {

/// Lays the device's workspace into the scene as the panel says, and keeps it there while the camera turns.
class HandControl : public QObject
{
    Q_OBJECT
  public:
    /// All must outlive this.
    HandControl(VtkViewport& viewport, LiveTouch& live, StructureModel& model, StructurePanel& structures,
                HandPanel& panel, QObject* parent = nullptr);

    /// The device in `live` is another one: its own settings apply.
    void takeDevice();
    /// By a key: the device moves, the hand in the scene stays.
    void setClutched(bool isClutched);
    /// Puts the middle of the workspace in the middle of what it reaches. The hand then begins anew there.
    void centre();

  private:
    void keep();
    void lay();
    void showStatus();

    VtkViewport& m_viewport;
    LiveTouch& m_live;
    StructureModel& m_model;
    StructurePanel& m_structures;
    HandPanel& m_panel;
    QTimer m_follow; ///< the camera says nothing when it turns
    std::uint32_t m_centreRequest = 0;
    std::uint32_t m_buttonsBefore = 0;
    bool m_isClutched = false;
};

} // namespace palpate::ui

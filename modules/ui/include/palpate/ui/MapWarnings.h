// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/LiveTouch.h"

#include <palpate/core/Export.h>
#include <palpate/study/MapEdges.h>

#include <QObject>
#include <QSet>
#include <QStringList>
#include <QThreadPool>
#include <QTimer>

#include <memory>
#include <vector>

namespace palpate::ui {

/// Checks the maps of the haptic scene for device stability. A map with a very sharp change of stiffness can keep a
/// device oscillating; the warning names the structure, the place and a remedy. The check runs on a worker thread
/// shortly after the latest change of map, tissue or device.
///
/// @par Thread All functions and signals on the GUI thread.
class PALPATE_EXPORT MapWarnings : public QObject
{
    Q_OBJECT
  public:
    /// @param live  source of scene and device; must outlive this object
    explicit MapWarnings(LiveTouch& live, QObject* parent = nullptr);
    ~MapWarnings() override; ///< waits for the running check

    /// Warnings indexed by row; empty strings for structures without a warning.
    [[nodiscard]] const QStringList& lines() const noexcept { return m_lines; }

  Q_SIGNALS:
    /// Emitted when `lines` changed.
    void changed();
    /// Emitted for a new warning or a warning at another place.
    void warned(const QString& line);

  private:
    void judge();
    void take(const std::shared_ptr<const haptics::HapticScene>& scene, const std::vector<study::MapEdge>& edges,
              const QString& device);

    LiveTouch& m_live;
    QThreadPool m_thread;
    QTimer m_wait;        ///< coalesces changes
    int m_job = 0;        ///< latest check; results of earlier checks are discarded
    QSet<QString> m_told; ///< structure, device and place of the emitted warnings
    QStringList m_lines;
};

} // namespace palpate::ui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/LiveTouch.h"

#include <palpate/study/MapEdges.h>

#include <QObject>
#include <QSet>
#include <QStringList>
#include <QThreadPool>
#include <QTimer>

#include <memory>
#include <vector>

namespace palpate::ui {

/// Judges the maps of what can be touched, each time that they, the tissue or the device change: says of a structure
/// whose map bends so sharply that the device can be kept swinging there where that is and what to do. Computed on a
/// thread of its own, a little after the newest change.
/// @par Thread All functions on the window's thread; the signals come there too.
class MapWarnings : public QObject
{
    Q_OBJECT
  public:
    /// @param live  what is touched, with which device; must outlive this
    explicit MapWarnings(LiveTouch& live, QObject* parent = nullptr);
    ~MapWarnings() override; ///< waits for what is being computed

    /// By the structures' rows: a line, empty where there is nothing to warn of.
    [[nodiscard]] const QStringList& lines() const noexcept { return m_lines; }

  Q_SIGNALS:
    /// `lines` are others.
    void changed();
    /// A structure is warned of that was not, or at another place than before.
    void warned(const QString& line);

  private:
    void judge();
    void take(const std::shared_ptr<const haptics::HapticScene>& scene, const std::vector<study::MapEdge>& edges,
              const QString& device);

    LiveTouch& m_live;
    QThreadPool m_thread;
    QTimer m_wait;        ///< gathers changes
    int m_job = 0;        ///< the newest; what older ones find is not taken
    QSet<QString> m_told; ///< structure, device and place of each line
    QStringList m_lines;
};

} // namespace palpate::ui

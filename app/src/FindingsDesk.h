// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SceneDocument.h"

#include <palpate/ui/CameraFlight.h>
#include <palpate/ui/FindingsPanel.h>
#include <palpate/ui/LiveTouch.h>
#include <palpate/ui/Playback.h>
#include <palpate/ui/TouchPanel.h>

#include <QObject>
#include <QTimer>

#include <filesystem>
#include <map>

/// What the window does with findings: marks places and writes notes, flies to them, plays the moment in which they
/// were marked, gives them to other programs and takes theirs.
class FindingsDesk : public QObject
{
    Q_OBJECT
  public:
    /// The parts of the window that it works with; all must outlive it.
    struct Parts
    {
        SceneDocument& document;
        palpate::ui::FindingsPanel& panel;
        palpate::ui::VtkViewport& viewport;
        palpate::ui::LiveTouch& live;
        palpate::ui::Playback& playback;
        palpate::ui::TouchPanel& touch;
    };
    FindingsDesk(const Parts& parts, QObject* parent);

    /// Marks the place that is touched, by the hand or in the recording that plays. The focus stays where it is.
    /// @return false when nothing is touched
    bool mark();
    /// Adds a note without a place. @param text  not empty
    void addNote(const QString& text);
    /// Goes to the next finding (1) or the one before (-1), round and round.
    void step(int by);
    void flyTo(int row);
    /// Plays the recording in which it was marked from a second before.
    void playFrom(int row);
    /// Writes all of them. @param path  a table when it ends in .csv, else markups
    void exportTo(const std::filesystem::path& path);
    /// Takes those of a file of markups, as one step to undo.
    void importFrom(const std::filesystem::path& path);
    /// Says in which file a recording is made from now on; and that it ended: what was marked in it knows its hash.
    void beginRecording(const std::filesystem::path& path) { m_recording = path; }
    void endRecording();
    /// Draws the scene's findings, and those of the recording that is open.
    void show();

  Q_SIGNALS:
    void said(const QString& line);
    void failed(const QString& lines);
    /// A recording is to be opened before it can be played.
    void recordingWanted(const std::filesystem::path& path);
    /// There are some, or none any more.
    void countChanged(std::size_t count);

  private:
    [[nodiscard]] const palpate::core::Finding& finding(int row) const;
    [[nodiscard]] palpate::core::Finding markedNow() const;
    [[nodiscard]] std::string hashOf(const std::filesystem::path& recording) const;

    Parts m_parts;
    palpate::ui::CameraFlight m_flight;
    QTimer m_show;                     ///< gathers changes of one event
    std::filesystem::path m_recording; ///< that is made now; empty: none
    mutable std::map<std::filesystem::path, std::string> m_hashes;
};

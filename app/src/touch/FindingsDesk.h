// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/SceneDocument.h"

#include <palpate/ui/CameraFlight.h>
#include <palpate/ui/FindingsPanel.h>
#include <palpate/ui/LiveTouch.h>
#include <palpate/ui/PalpationController.h>
#include <palpate/ui/Playback.h>
#include <palpate/ui/StructureModel.h>
#include <palpate/ui/TouchPanel.h>

#include <QObject>
#include <QTimer>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

/// Findings in the window: marks contacts, writes notes, moves the view to findings, plays the moment of marking,
/// exports and imports.
class FindingsDesk : public QObject
{
    Q_OBJECT
  public:
    /// Parts of the window; all must outlive this object.
    struct Parts
    {
        SceneDocument& document;
        palpate::ui::FindingsPanel& panel;
        palpate::ui::VtkViewport& viewport;
        palpate::ui::LiveTouch& live;
        palpate::ui::PalpationController& palpation;
        palpate::ui::Playback& playback;
        palpate::ui::TouchPanel& touch;
        const palpate::ui::StructureModel& structures;
    };
    FindingsDesk(const Parts& parts, QObject* parent);

    /// Marks the current contact of the hand or of the playing recording, or else the contact at the end of the last
    /// press of the pointer. The keyboard focus does not change.
    /// @return false without contact and without a last press
    bool mark();
    /// Adds a note without a position. @param text  not empty
    void addNote(const QString& text);
    /// Goes to the next (1) or previous (-1) finding, cyclically.
    void step(int by);
    void flyTo(int row);
    /// Plays the recording of a finding from one second before the moment of marking.
    void playFrom(int row);
    /// Exports all findings. @param path  a table if the name ends in .csv, otherwise Slicer markups
    void exportTo(const std::filesystem::path& path);
    /// Imports findings from a markups file as a single undo step.
    void importFrom(const std::filesystem::path& path);
    /// Sets the file of the recording in progress, and ends it: findings marked during the recording then get the
    /// file's hash.
    void beginRecording(const std::filesystem::path& path);
    void endRecording();
    /// Draws the findings of the scene and of the open recording.
    void show();

  Q_SIGNALS:
    void said(const QString& line);
    void failed(const QString& lines);
    /// A recording must be opened before playback.
    void recordingWanted(const std::filesystem::path& path);
    /// The number of findings changed; may be 0.
    void countChanged(std::size_t count);

  private:
    [[nodiscard]] const palpate::core::Finding& finding(int row) const;
    [[nodiscard]] palpate::core::Finding markedAt(std::int64_t tick) const;
    [[nodiscard]] std::optional<std::size_t> rowOf(const std::string& structure) const;
    [[nodiscard]] palpate::core::Vec3 restOf(const std::string& structure, const palpate::core::Vec3& p_W) const;
    [[nodiscard]] std::string hashOf(const std::filesystem::path& recording) const;

    Parts m_parts;
    palpate::ui::CameraFlight m_flight;
    QTimer m_show;                     ///< combines all changes of one event
    std::filesystem::path m_recording; ///< recording in progress; empty: none
    mutable std::map<std::filesystem::path, std::string> m_hashes;
};

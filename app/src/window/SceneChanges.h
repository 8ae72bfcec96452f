// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

#include <palpate/ui/SceneLoader.h>

#include <memory>
#include <vector>

namespace palpate::app {

class CoordinatesPart;
class DevicePart;
class DocumentPart;
class ExercisePart;
class LayerOffers;
class RecordingPart;
class SceneFiles;
class SceneSurfaces;
class StatusProgress;
class StructuresPart;
class TouchPart;

/// Puts loaded scenes into the window: replaces the open scene, adds to it, and closes it.
class SceneChanges : public QObject
{
    Q_OBJECT
  public:
    /// Parts of the window; all must outlive this object.
    struct Parts
    {
        DocumentPart& document;
        SceneFiles& files;
        CoordinatesPart& coordinates;
        StatusProgress& progress;
        StructuresPart& structures;
        TouchPart& touch;
        RecordingPart& recording;
        DevicePart& device;
        ExercisePart& exercise;
    };
    SceneChanges(const WindowCore& core, const Parts& parts);

  Q_SIGNALS:
    /// The view has a scene, or nothing to show any more.
    void viewChanged(bool hasScene);
    void stateChanged();
    /// The new or extended scene is open and drawn.
    void ready();

  private:
    void preview(const std::vector<ui::StructureRow>& rows);
    void dropPreview();
    void take(const std::shared_ptr<ui::OpenedScene>& scene);
    void replace(ui::OpenedScene& scene);
    void show(const ui::OpenedScene& scene);
    void arrange(const ui::OpenedScene& scene);
    void greet(const ui::OpenedScene& scene);
    void add(ui::OpenedScene& scene);
    void addRows(ui::OpenedScene& scene, int first);
    void close();
    void showProblems(const ui::OpenedScene& scene);
    [[nodiscard]] QStringList namable(const QStringList& texts) const;
    [[nodiscard]] int listNotes(const ui::OpenedScene& scene);

    WindowCore m_core;
    Parts m_parts;
    LayerOffers* m_layers = nullptr;
    SceneSurfaces* m_surfaces = nullptr;
    bool m_isPreview = false; ///< the view shows structures of a scene that is being opened
};

} // namespace palpate::app

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "shell/WindowPart.h"

#include <palpate/ui/SceneLoader.h>
#include <palpate/ui/StructureModel.h>

#include <QString>

#include <vector>

namespace palpate::app {

class LayerOffers;
class StatusProgress;

/// Surfaces of the open scene: draws the structures of the model, requests missing haptic copies, maps and surfaces
/// from the loader, and offers to repair inverted and stair-stepped surfaces.
class SceneSurfaces : public QObject
{
    Q_OBJECT
  public:
    /// The references must outlive this object.
    SceneSurfaces(const WindowCore& core, ui::SceneLoader& loader, StatusProgress& progress, LayerOffers& layers,
                  QObject* parent);

    /// Replaces the structures in the view.
    void draw(const std::vector<ui::StructureRow>& rows);
    /// Adds structures to the view.
    void drawAdded(const std::vector<ui::StructureRow>& rows);
    /// Offers repairs with a single click, and searches for gaps between structures.
    void offerRepairs();

  private:
    void connectLoader();
    void follow(int row, ui::StructureModel::Change change);
    void followSurface(int row);
    void requestMaps(int row);
    void offerSmoothing();
    void offerTurning();
    [[nodiscard]] QString nameOf(int row) const;

    WindowCore m_core;
    ui::SceneLoader& m_loader;
    StatusProgress& m_progress;
    LayerOffers& m_layers;
};

} // namespace palpate::app

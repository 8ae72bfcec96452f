// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

#include <cstddef>

class LumpLayout;

namespace palpate::study {
struct Layering;
}

namespace palpate::ui {
class MessageBar;
struct OpenedScene;
class StructureModel;
} // namespace palpate::ui

namespace palpate::app {

/// Layout of nested structures: palpated through the structure around them, or as layers below. Applied to mesh files,
/// offered for scenes without layers.
class LayerOffers : public QObject
{
    Q_OBJECT
  public:
    /// The references must outlive this object.
    LayerOffers(ui::StructureModel& model, ui::MessageBar& bar, QObject* parent);

    /// Lays out a newly opened scene. @param hasRecording  a recording waits to be played in the scene, so the layout
    /// is only offered
    void layOut(const ui::OpenedScene& scene, bool hasRecording);
    /// Lays out added structures by nesting if all others are laid out that way; otherwise offers to do so.
    /// @param isUnsaved  the scene has no scene file, which could contain another layout
    void layOutAdded(const ui::OpenedScene& scene, bool isUnsaved);
    /// Offers layers for a scene with a single layer. The message names the first structure whose contact would change.
    void offer(const study::Layering& layering);
    /// Lays out the structures as `layOut` does for meshes, after the holes of a surface were closed around some of
    /// them. No effect if structures have layers already.
    void layOutClosed(const study::Layering& layering);

  private:
    void offerBelowOpen(const LumpLayout& layout);
    void offerOther(const LumpLayout& layout, const QString& line);
    [[nodiscard]] bool isFlat() const;

    ui::StructureModel& m_model;
    ui::MessageBar& m_bar;
};

} // namespace palpate::app

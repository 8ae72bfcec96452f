// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <QObject>

class QLabel;

namespace palpate::ui {

class TouchPanel;
class VtkViewport;

/// Names the lump under the contact beside the cursor in the 3D view, live and in playback: "over lump 20 mm: +55 %,
/// plainly felt". Keeps clear of the cursor and the numbers beside it.
///
/// @par Thread GUI thread only.
class PALPATE_EXPORT LumpLabel : public QObject
{
    Q_OBJECT
  public:
    /// @param touch  source of the reading; must outlive this object, as must the view
    LumpLabel(VtkViewport& viewport, const TouchPanel& touch, QObject* parent);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override; ///< of the view: another size or font

  private:
    void show();

    VtkViewport& m_viewport;
    const TouchPanel& m_touch;
    QLabel* m_label = nullptr; ///< child of the view
    int m_place = -1;          ///< previous place, kept while free
};

} // namespace palpate::ui

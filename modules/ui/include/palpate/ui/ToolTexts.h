// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <QObject>

class QToolBar;
class QToolButton;

namespace palpate::ui {

/// Hides the button texts of a narrow tool bar, last button first. Otherwise Qt would move widgets at the end of the
/// bar, such as the chips, into the extension menu.
class PALPATE_EXPORT ToolTexts : public QObject
{
  public:
    /// @param bar  owner of this object; buttons that show text must have both icon and text
    explicit ToolTexts(QToolBar& bar);

    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void fit();

    QToolBar& m_bar;
};

} // namespace palpate::ui

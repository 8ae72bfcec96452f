// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QRect>

class QGridLayout;

namespace palpate::ui {
class MessageBar;
class VtkViewport;
} // namespace palpate::ui

namespace palpate::app {

/// Places the messages over the upper or the lower edge of the view, where they hide less tissue, and off the touched
/// place. The view keeps its place and size.
class MessagePlace : public QObject
{
    Q_OBJECT
  public:
    /// @param layout  contains messages and view in one cell
    MessagePlace(ui::MessageBar& messages, ui::VtkViewport& viewport, QGridLayout& layout);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    [[nodiscard]] QRect stripAt(bool isBelow) const;
    [[nodiscard]] bool hidesHand(bool isBelow) const;
    [[nodiscard]] bool isBetterBelow() const;
    void put(bool isBelow);
    void passCover();
    void follow();

    ui::MessageBar& m_messages;
    ui::VtkViewport& m_viewport;
    QGridLayout& m_layout;
    bool m_isBelow = false;
};

} // namespace palpate::app

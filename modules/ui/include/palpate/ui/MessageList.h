// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/Messages.h"

#include <QListView>

namespace palpate::ui {

/// Shows the messages; selected ones are copied with Ctrl+C, a line each.
class MessageList : public QListView
{
    Q_OBJECT
  public:
    /// @param messages  outlives the list
    explicit MessageList(Messages& messages, QWidget* parent = nullptr);
    void copySelection() const;

  protected:
    void keyPressEvent(QKeyEvent* event) override;
    void showEvent(QShowEvent* event) override;

  private:
    void scrollLater();

    bool m_isScrollPending = false;
};

} // namespace palpate::ui

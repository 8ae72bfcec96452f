// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/Messages.h"

#include <palpate/core/Export.h>

#include <QListView>

namespace palpate::ui {

/// List view of all messages. Ctrl+C copies the selection, one message per line.
class PALPATE_EXPORT MessageList : public QListView
{
    Q_OBJECT
  public:
    /// @param messages  must outlive the list
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

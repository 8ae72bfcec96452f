// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Export.h>

#include <QLabel>

namespace palpate::ui {

/// Text of the status line. Elided at the end when space is short; a click opens the message list.
class PALPATE_EXPORT HintLine : public QLabel
{
    Q_OBJECT
  public:
    explicit HintLine(QWidget* parent = nullptr);
    /// Shows a line and announces it to screen readers.
    void say(const QString& text);
    [[nodiscard]] const QString& said() const noexcept { return m_said; }

  Q_SIGNALS:
    void pressed();

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

  private:
    void fit();
    QString m_said;
};

} // namespace palpate::ui

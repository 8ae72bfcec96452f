// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QLabel>

namespace palpate::ui {

/// The status line's text: shortened at its end where there is no room, and pressed to see all messages.
class HintLine : public QLabel
{
    Q_OBJECT
  public:
    explicit HintLine(QWidget* parent = nullptr);
    /// Says a line, to screen readers too.
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

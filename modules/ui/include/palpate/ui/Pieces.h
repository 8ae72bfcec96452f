// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/MessageBar.h"
#include "palpate/ui/Theme.h"

#include <palpate/core/Export.h>

#include <QFrame>
#include <QLabel>
#include <QPointer>
#include <QWidget>

class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace palpate::ui {

class ActionList;

/// Short fact in a rounded frame: "mouse", "1.00 kHz". The short form is given, or omits the text after the first
/// comma.
class PALPATE_EXPORT Chip : public QLabel
{
    Q_OBJECT
  public:
    enum class Tone
    {
        Quiet,
        Good, ///< quiet with a green dot
        Warning,
        Recording
    };
    /// @param what  description of the fact for screen readers
    explicit Chip(const QString& what, QWidget* parent = nullptr);
    /// @param shortForm  text for a narrow window; empty: the text before the first comma
    void say(const QString& text, Tone tone = Tone::Quiet, const QString& shortForm = {});
    [[nodiscard]] const QString& said() const noexcept { return m_said; }
    [[nodiscard]] Tone tone() const noexcept { return m_tone; }
    /// Switches between full and short text. Chips with Tone::Good show only the dot.
    void setShort(bool isShort);
    /// Width of the chip with short or full text. [px]
    [[nodiscard]] int widthFor(bool isShort) const;

  Q_SIGNALS:
    void changed();
    void clicked();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

  private:
    void takeInk();
    [[nodiscard]] QString shortText() const;

    Tone m_tone = Tone::Quiet;
    QString m_said, m_shortForm;
    bool m_isShort = false;
};

/// Start page of an empty view: open a file, try the phantom, recent scenes.
class PALPATE_EXPORT WelcomePage : public QWidget
{
    Q_OBJECT
  public:
    explicit WelcomePage(QWidget* parent = nullptr);
    /// @param hasPhantom  false hides the phantom button
    void setChoices(bool hasPhantom, const QStringList& recent);

  Q_SIGNALS:
    void openWanted();
    void phantomWanted();
    void recentWanted(const QString& path);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    QPushButton* m_phantom = nullptr;
    QLabel* m_recentTitle = nullptr;
    QVBoxLayout* m_recent = nullptr;
    QWidget* m_card = nullptr;
};

/// Key card: all shortcuts on one card over the window. Arrow keys and wheel scroll a card that is too high; any other
/// key or a click closes the card.
class PALPATE_EXPORT KeysCard : public QFrame
{
    Q_OBJECT
  public:
    /// @param actions  content of the card; must outlive it
    KeysCard(const ActionList& actions, QWidget* parent);
    void toggle();

  protected:
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    void fill();

    const ActionList& m_actions;
    QScrollArea* m_scroll = nullptr; ///< the table is rebuilt each time the card opens
    QPointer<QWidget> m_before;      ///< previous focus widget, restored on closing
};

} // namespace palpate::ui

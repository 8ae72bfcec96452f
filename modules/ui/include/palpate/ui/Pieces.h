// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/MessageBar.h"
#include "palpate/ui/Theme.h"

#include <QFrame>
#include <QLabel>
#include <QPointer>
#include <QWidget>

class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace palpate::ui {

class ActionList;

/// A short fact in a rounded frame: "mouse", "1.00 kHz". What stands behind the first comma is left out where there is
/// no room for it.
class Chip : public QLabel
{
    Q_OBJECT
  public:
    enum class Tone
    {
        Quiet,
        Good, ///< quiet, with a green dot
        Warning,
        Recording
    };
    /// @param what  it is a fact of, for screen readers
    explicit Chip(const QString& what, QWidget* parent = nullptr);
    void say(const QString& text, Tone tone = Tone::Quiet);
    [[nodiscard]] const QString& said() const noexcept { return m_said; }
    [[nodiscard]] Tone tone() const noexcept { return m_tone; }
    /// Shows what was said in fewer words, or whole. Of what is good the dot alone stays.
    void setShort(bool isShort);
    /// Width of the chip in fewer words, or whole. [px]
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
    QString m_said;
    bool m_isShort = false;
};

/// What is shown instead of an empty view: open, try the phantom, recent scenes.
class WelcomePage : public QWidget
{
    Q_OBJECT
  public:
    explicit WelcomePage(QWidget* parent = nullptr);
    /// @param hasPhantom  false hides its button
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

/// All keys on one card over the window; where that is too low for it, arrows and wheel scroll the card. Any other key
/// or a click closes it.
class KeysCard : public QFrame
{
    Q_OBJECT
  public:
    /// @param actions  what the card shows; outlives it
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
    QScrollArea* m_scroll = nullptr; ///< its table is made anew each time the card is shown
    QPointer<QWidget> m_before;      ///< had the keys before, and gets them back
};

} // namespace palpate::ui

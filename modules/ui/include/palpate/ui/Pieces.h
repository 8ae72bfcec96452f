// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/Theme.h"

#include <QFrame>
#include <QLabel>
#include <QPointer>
#include <QWidget>

#include <functional>

class QPushButton;
class QVBoxLayout;

namespace palpate::ui {

class ActionList;

/// A short fact in a rounded frame: "mouse", "1.00 kHz".
class Chip : public QLabel
{
    Q_OBJECT
  public:
    enum class Tone
    {
        Quiet,
        Warning,
        Recording
    };
    explicit Chip(const QString& accessibleName, QWidget* parent = nullptr);
    void say(const QString& text, Tone tone = Tone::Quiet);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    Tone m_tone = Tone::Quiet;
};

/// A line over the view that stays until it is closed: an error with its full text, or a hint.
class MessageBar : public QFrame
{
    Q_OBJECT
  public:
    explicit MessageBar(QWidget* parent = nullptr);
    void showError(const QString& text);
    /// Shows a line with a button that does something about it and closes the bar.
    /// @param symbol  what kind of a line it is
    void offer(const QString& text, const QString& button, std::function<void()> act, Symbol symbol = Symbol::Warning);
    /// Shows a question with two answers, each of which closes the bar.
    void ask(const QString& text, const QString& button, std::function<void()> act, const QString& otherButton,
             std::function<void()> otherAct);
    [[nodiscard]] QString text() const { return m_text->text(); }

  private:
    QLabel* m_symbol = nullptr;
    QLabel* m_text = nullptr;
    QPushButton* m_button = nullptr;
    QPushButton* m_otherButton = nullptr;
    std::function<void()> m_act, m_otherAct;
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

  private:
    QPushButton* m_phantom = nullptr;
    QLabel* m_recentTitle = nullptr;
    QVBoxLayout* m_recent = nullptr;
    QWidget* m_card = nullptr;
};

/// All keys on one card over the window; any key or click closes it.
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
    QWidget* m_table = nullptr; ///< made anew each time the card is shown
    QPointer<QWidget> m_before; ///< had the keys before, and gets them back
};

} // namespace palpate::ui

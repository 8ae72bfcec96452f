// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/Messages.h"

#include <QFrame>

#include <functional>
#include <vector>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace palpate::ui {

/// One message over the view: an icon of its kind, its text, what can be done about it.
class MessageRow : public QFrame
{
    Q_OBJECT
  public:
    /// @param button  empty: the message has none
    MessageRow(Messages::Kind kind, const QString& text, const QString& button, QWidget* parent);
    [[nodiscard]] Messages::Kind kind() const noexcept { return m_kind; }
    [[nodiscard]] const QString& text() const noexcept { return m_text; }

  Q_SIGNALS:
    void answered();
    void closed();

  protected:
    void changeEvent(QEvent* event) override;

  private:
    void drawIcon();

    Messages::Kind m_kind;
    QString m_text;
    QLabel* m_symbol = nullptr;
};

/// Messages over the view that stay until they are answered or closed, the newest on top. Three are shown; older ones
/// wait behind them and are counted. Each goes into the list of messages too, and is told to screen readers.
/// @par Thread The GUI's.
class MessageBar : public QWidget
{
    Q_OBJECT
  public:
    /// How long an offer stands.
    enum class Keep
    {
        WithScene,    ///< it is about what is open
        UntilAnswered ///< whatever is opened meanwhile
    };
    static constexpr int kShown = 3;

    /// @param messages  outlives the bar
    explicit MessageBar(Messages& messages, QWidget* parent = nullptr);
    void showError(const QString& text);
    /// Shows a line with a button that does something about it and closes the line.
    void offer(const QString& text, const QString& button, std::function<void()> act, Keep keep = Keep::WithScene);
    /// Closes what was about the scene that was open.
    void forgetScene();
    /// The texts that stand, the newest first, a line each.
    [[nodiscard]] QString text() const;

  Q_SIGNALS:
    /// The line that counts what waits was pressed.
    void listWanted();

  private:
    struct Entry
    {
        MessageRow* row = nullptr;
        Keep keep = Keep::WithScene;
    };
    MessageRow* put(Messages::Kind kind, const QString& text, const QString& button, Keep keep);
    void remove(MessageRow* row);
    void arrange();

    Messages& m_messages;
    std::vector<Entry> m_entries; ///< the newest first
    QVBoxLayout* m_rows = nullptr;
    QPushButton* m_more = nullptr;
};

} // namespace palpate::ui

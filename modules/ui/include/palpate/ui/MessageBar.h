// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/Messages.h"

#include <palpate/core/Export.h>

#include <QFrame>

#include <functional>
#include <vector>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace palpate::ui {

/// Single message over the view with icon, text and buttons.
class PALPATE_EXPORT MessageRow : public QFrame
{
    Q_OBJECT
  public:
    /// @param buttons  actions, at most two
    MessageRow(Messages::Kind kind, const QString& text, const QStringList& buttons, QWidget* parent);
    [[nodiscard]] Messages::Kind kind() const noexcept { return m_kind; }
    [[nodiscard]] const QString& text() const noexcept { return m_text; }

  Q_SIGNALS:
    void answered(int button);
    void closed();

  protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void drawIcon();
    void fit();

    Messages::Kind m_kind;
    QString m_text;
    QLabel* m_symbol = nullptr;
    QLabel* m_line = nullptr;
};

/// Messages over the view that stay until answered or closed, newest on top. At most `kShown` are visible; older
/// messages are counted. Every message is also added to the message list and announced to screen readers.
///
/// @par Thread GUI thread only.
class PALPATE_EXPORT MessageBar : public QWidget
{
    Q_OBJECT
  public:
    /// Lifetime of an offer.
    enum class Keep
    {
        WithScene,    ///< until another scene is opened
        UntilAnswered ///< independent of the scene
    };
    static constexpr int kShown = 3;

    /// @param messages  must outlive the bar
    explicit MessageBar(Messages& messages, QWidget* parent = nullptr);
    void showError(const QString& text);
    /// Shows a message with a button. The button runs `act` and closes the message.
    void offer(const QString& text, const QString& button, std::function<void()> act, Keep keep = Keep::WithScene);
    /// Shows a question with two answers. Each answer closes the message.
    void ask(const QString& text, const QString& button, std::function<void()> act, const QString& otherButton,
             std::function<void()> otherAct);
    /// Closes the open message with this text, which is no longer of interest; nothing happens without one.
    void withdraw(const QString& text);
    /// Closes all open messages whose text matches. They stay in the message list.
    void withdrawIf(const std::function<bool(const QString& text)>& matches);
    /// Closes the messages about the previous scene.
    void forgetScene();
    /// Texts of the open messages, newest first, one per line.
    [[nodiscard]] QString text() const;

  Q_SIGNALS:
    /// Emitted when the line with the number of hidden messages is pressed.
    void listWanted();

  private:
    struct Entry
    {
        MessageRow* row = nullptr;
        Keep keep = Keep::WithScene;
    };
    MessageRow* put(Messages::Kind kind, const QString& text, const QStringList& buttons, Keep keep);
    void remove(MessageRow* row);
    void arrange();

    Messages& m_messages;
    std::vector<Entry> m_entries; ///< newest first
    QVBoxLayout* m_rows = nullptr;
    QPushButton* m_more = nullptr;
};

} // namespace palpate::ui

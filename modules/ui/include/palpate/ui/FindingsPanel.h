// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/FindingsModel.h"

#include <QPointer>
#include <QWidget>

class QLabel;
class QLineEdit;
class QTableView;

namespace palpate::ui {

/// The table of findings and notes, and a line to write a note in. Keys in the table: Enter flies there, Shift+Enter
/// plays where it was marked, F2 edits, Del deletes, Ctrl+C copies.
class FindingsPanel : public QWidget
{
    Q_OBJECT
  public:
    /// @param model  must outlive this
    explicit FindingsPanel(FindingsModel& model, QWidget* parent = nullptr);

    /// @return the row at hand, -1 without one
    [[nodiscard]] int current() const;
    /// Makes a row the one at hand; the focus stays where it is.
    void select(int row);
    /// Opens a row's note to be written; the focus comes back when it is closed.
    void editNote(int row);
    /// Puts the focus into the line for a note without a place; it comes back when the note is written or left.
    void startNote();
    /// The chosen rows as text, columns apart by tabs.
    [[nodiscard]] QString copiedText() const;

  Q_SIGNALS:
    /// @param row  -1: none
    void selected(int row);
    void flightWanted(int row);
    void playWanted(int row);
    void noteWritten(const QString& text);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool handleKey(int key, Qt::KeyboardModifiers modifiers);
    [[nodiscard]] std::vector<int> chosenRows() const;
    void rememberFocus();
    void giveFocusBack();
    void showEmpty();

    FindingsModel& m_model;
    QTableView* m_table = nullptr;
    QLineEdit* m_note = nullptr;
    QLabel* m_empty = nullptr;
    QPointer<QWidget> m_before; ///< had the focus before a note
};

} // namespace palpate::ui

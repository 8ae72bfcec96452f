// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/FindingsModel.h"

#include <palpate/core/Export.h>

#include <QPointer>
#include <QWidget>

class QLabel;
class QLineEdit;
class QTableView;

namespace palpate::ui {

/// Table of findings and notes with an input line for notes. A click on a cell of the selected row edits the cell, one
/// on the type opens the list of types, a double click moves the camera, the right button opens a menu. Keys: Enter
/// moves the camera to the finding, Shift+Enter plays the recording from the time of the mark, F2 edits, Del deletes,
/// Ctrl+C copies.
class PALPATE_EXPORT FindingsPanel : public QWidget
{
    Q_OBJECT
  public:
    /// @param model  must outlive this object
    explicit FindingsPanel(FindingsModel& model, QWidget* parent = nullptr);

    /// Current row, or -1.
    [[nodiscard]] int current() const;
    /// Makes a row current without moving the keyboard focus.
    void select(int row);
    /// Opens the editor of a row's note. The focus returns when the editor closes.
    void editNote(int row);
    /// Moves the focus to the input line for a note without a place. The focus returns when the note is entered or
    /// cancelled.
    void startNote();
    /// Selected rows as tab-separated text.
    [[nodiscard]] QString copiedText() const;

  Q_SIGNALS:
    /// @param row  -1 without a selection
    void selected(int row);
    void flightWanted(int row);
    void playWanted(int row);
    void noteWritten(const QString& text);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void openMenu(const QPoint& place);
    void editCell(int row, int column);
    bool handleKey(int key, Qt::KeyboardModifiers modifiers);
    [[nodiscard]] std::vector<int> chosenRows() const;
    void rememberFocus();
    void giveFocusBack();
    void showEmpty();

    FindingsModel& m_model;
    QTableView* m_table = nullptr;
    QLineEdit* m_note = nullptr;
    QLabel* m_empty = nullptr;
    QPointer<QWidget> m_before; ///< focus widget before the note editor opened
};

} // namespace palpate::ui

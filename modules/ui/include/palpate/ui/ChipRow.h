// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/Pieces.h"

#include <QWidget>

#include <vector>

class QToolButton;

namespace palpate::ui {

/// Chips in a row, as many as there is room for. Where there is less, the least important ones are said in fewer words
/// first, then fold into a button "»" that lists them: one that warns folds last, and the button then says "⚠ »"; one
/// that must stay never folds.
class ChipRow : public QWidget
{
    Q_OBJECT
  public:
    explicit ChipRow(QWidget* parent = nullptr);
    /// Adds a chip at the end of the row.
    /// @param id  its object name, for tests; not translated
    /// @param weight  of two chips the one with the smaller weight is shortened and folded first
    Chip* add(const char* id, const QString& name, int weight, bool mustStay = false);
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

  protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    struct Entry
    {
        Chip* chip = nullptr;
        int weight = 0;
        bool mustStay = false;
        bool isShort = false;
        bool isFolded = false;

        [[nodiscard]] bool warns() const { return chip->tone() == Chip::Tone::Warning; }
    };
    void fit();
    void shrink();
    [[nodiscard]] int needed() const;
    [[nodiscard]] int widthOf(const Entry& entry) const;
    void openRest();

    std::vector<Entry> m_entries;
    QToolButton* m_rest = nullptr;
};

} // namespace palpate::ui

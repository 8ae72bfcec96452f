// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/Pieces.h"

#include <palpate/core/Export.h>

#include <QWidget>

#include <vector>

class QToolButton;

namespace palpate::ui {

/// Row of chips that adapts to the available width. When space runs out, chips of low weight are first shortened and
/// then folded into a "»" button that lists them. Chips with a warning fold last; the button then shows "⚠ »". Chips
/// added with `mustStay` never fold.
class PALPATE_EXPORT ChipRow : public QWidget
{
    Q_OBJECT
  public:
    explicit ChipRow(QWidget* parent = nullptr);
    /// Adds a chip at the end of the row.
    /// @param id  untranslated object name, for tests
    /// @param weight  chips with a smaller weight are shortened and folded first
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

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QVBoxLayout>

namespace palpate::ui {

/// Combo box sized for the current entry, so that long unselected entries do not widen the panel. GUI thread only.
class ShownComboBox final : public QComboBox
{
  public:
    explicit ShownComboBox(QWidget* parent)
        : QComboBox(parent)
    {
        setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        connect(this, &QComboBox::currentTextChanged, this, [this] { updateGeometry(); });
    }
    [[nodiscard]] QSize minimumSizeHint() const override { return withText(QComboBox::minimumSizeHint()); }
    [[nodiscard]] QSize sizeHint() const override { return withText(QComboBox::sizeHint()); }

  private:
    [[nodiscard]] QSize withText(const QSize& least) const
    {
        constexpr int kMargin_px = 8; // margin that styles reserve in the edit rectangle
        const QString shown = currentIndex() < 0 ? placeholderText() : currentText();
        QStyleOptionComboBox option;
        initStyleOption(&option);
        const QSize text(fontMetrics().horizontalAdvance(shown) + kMargin_px, fontMetrics().height());
        return least.expandedTo(style()->sizeFromContents(QStyle::CT_ComboBox, &option, text, this));
    }
};

/// Form row with the label above the combo box, so that both use the full panel width.
class BoxRow final : public QWidget
{
  public:
    BoxRow(const QString& name, QComboBox* box, QWidget* parent)
        : QWidget(parent)
    {
        auto* label = new QLabel(name, this);
        label->setBuddy(box);
        auto* lines = new QVBoxLayout(this);
        lines->setContentsMargins(0, 0, 0, 0);
        lines->setSpacing(2);
        lines->addWidget(label);
        lines->addWidget(box);
    }
};

} // namespace palpate::ui

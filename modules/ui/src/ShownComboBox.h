// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QBoxLayout>
#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QLabel>
#include <QStyle>
#include <QStyleOptionComboBox>

#include <algorithm>

namespace palpate::ui {

/// A box that has room for the entry that it shows; see BoxRow for narrow panels. Long entries that are not chosen do
/// not widen the panel. On the GUI thread.
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
        constexpr int kMargin_px = 8; // styles keep a little of the box's edit rectangle free
        const QString shown = currentIndex() < 0 ? placeholderText() : currentText();
        QStyleOptionComboBox option;
        initStyleOption(&option);
        const QSize text(fontMetrics().horizontalAdvance(shown) + kMargin_px, fontMetrics().height());
        return least.expandedTo(style()->sizeFromContents(QStyle::CT_ComboBox, &option, text, this));
    }
};

/// A box with its name before it, or above it where the panel is too narrow for both; a row of a form. (A form that
/// wraps its long rows by itself does not give a row that becomes long later the height for that.)
class BoxRow final : public QWidget
{
  public:
    BoxRow(const QString& name, QComboBox* box, QWidget* parent)
        : QWidget(parent)
        , m_name(new QLabel(name, this))
        , m_box(box)
        , m_line(new QBoxLayout(QBoxLayout::LeftToRight, this))
    {
        m_name->setBuddy(box);
        m_line->setContentsMargins(0, 0, 0, 0);
        m_line->setSpacing(kGap_px);
        m_line->addWidget(m_name);
        m_line->addWidget(box, 1);
    }
    [[nodiscard]] QSize minimumSizeHint() const override
    {
        const int width = std::max(m_name->minimumSizeHint().width(), m_box->minimumSizeHint().width());
        return {width, m_line->totalMinimumSize().height()};
    }

  protected:
    bool event(QEvent* event) override
    {
        if (event->type() == QEvent::Resize) { // later: a form that is being laid out takes no other height
            QCoreApplication::postEvent(this, new QEvent(QEvent::LayoutRequest));
        } else if (event->type() == QEvent::LayoutRequest) {
            fit();
        }
        return QWidget::event(event);
    }

  private:
    static constexpr int kGap_px = 10, kGapBelow_px = 2;

    void fit()
    {
        const int wide = m_name->minimumSizeHint().width() + kGap_px + m_box->minimumSizeHint().width();
        const auto direction = wide > width() ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight;
        if (direction != m_line->direction()) {
            m_line->setDirection(direction);
            m_line->setSpacing(direction == QBoxLayout::TopToBottom ? kGapBelow_px : kGap_px);
            updateGeometry();
        }
    }

    QLabel* m_name;
    QComboBox* m_box;
    QBoxLayout* m_line;
};

} // namespace palpate::ui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QFormLayout>
#include <QSettings>
#include <QString>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>

namespace palpate::ui {

/// Group of form rows under a title that folds and unfolds them. The choice is stored.
class FoldGroup final : public QWidget
{
  public:
    /// @param key  name in the settings, "properties/feel"
    FoldGroup(const QString& title, const QString& key, bool isOpenAtFirst, QWidget* parent)
        : QWidget(parent)
        , m_head(new QToolButton(this))
        , m_content(new QWidget(this))
        , m_form(new QFormLayout(m_content))
    {
        m_head->setText(title);
        m_head->setAutoRaise(true);
        m_head->setCheckable(true);
        m_head->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        m_head->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        QFont bold = font();
        bold.setBold(true);
        m_head->setFont(bold);
        m_form->setContentsMargins(12, 2, 12, 8);
        m_form->setHorizontalSpacing(10);
        m_form->setVerticalSpacing(8);
        m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
        m_form->setRowWrapPolicy(QFormLayout::WrapLongRows);
        auto* column = new QVBoxLayout(this);
        column->setContentsMargins(0, 0, 0, 0);
        column->setSpacing(0);
        column->addWidget(m_head);
        column->addWidget(m_content);
        const auto show = [this](bool isOpen) {
            m_head->setArrowType(isOpen ? Qt::DownArrow : Qt::RightArrow);
            m_content->setVisible(isOpen);
        };
        m_head->setChecked(QSettings().value(key, isOpenAtFirst).toBool());
        show(m_head->isChecked());
        connect(m_head, &QToolButton::toggled, this, [show, key](bool isOpen) {
            show(isOpen);
            QSettings().setValue(key, isOpen);
        });
    }
    [[nodiscard]] QFormLayout& form() noexcept { return *m_form; }
    /// Parent of the rows' widgets.
    [[nodiscard]] QWidget* content() noexcept { return m_content; }

  private:
    QToolButton* m_head;
    QWidget* m_content;
    QFormLayout* m_form;
};

/// Shows or hides a row of the form that contains a widget.
inline void setRowVisible(QWidget& field, bool isVisible)
{
    static_cast<QFormLayout*>(field.parentWidget()->layout())->setRowVisible(&field, isVisible);
}

} // namespace palpate::ui

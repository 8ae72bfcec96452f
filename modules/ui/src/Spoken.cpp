// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/Spoken.h"

#include <QAccessibleWidget>
#include <QWidget>

namespace palpate::ui {

namespace {

/// Looks up the widget at each call, because a widget under destruction is no longer a Spoken.
class SpokenInterface final : public QAccessibleWidget, public QAccessibleValueInterface
{
  public:
    SpokenInterface(QWidget* widget, QAccessible::Role role)
        : QAccessibleWidget(widget, role)
    {
    }

    QString text(QAccessible::Text what) const override
    {
        if (what == QAccessible::Help) {
            return widget()->toolTip();
        }
        const Spoken* one = spoken();
        // Also as description: on Linux the text of a value is not passed on.
        return one != nullptr && (what == QAccessible::Value || what == QAccessible::Description)
                   ? one->spokenText()
                   : QAccessibleWidget::text(what);
    }
    void* interface_cast(QAccessible::InterfaceType type) override
    {
        return type == QAccessible::ValueInterface && scale() ? static_cast<QAccessibleValueInterface*>(this)
                                                              : QAccessibleWidget::interface_cast(type);
    }
    QVariant currentValue() const override { return scale().value_or(Spoken::Scale()).value; }
    void setCurrentValue(const QVariant& value) override
    {
        if (Spoken* one = spoken(); one != nullptr) {
            one->setSpoken(value.toDouble());
        }
    }
    QVariant maximumValue() const override { return scale().value_or(Spoken::Scale()).most; }
    QVariant minimumValue() const override { return scale().value_or(Spoken::Scale()).least; }
    QVariant minimumStepSize() const override { return scale().value_or(Spoken::Scale()).step; }

  private:
    Spoken* spoken() const { return dynamic_cast<Spoken*>(object()); }
    std::optional<Spoken::Scale> scale() const
    {
        const Spoken* one = spoken();
        return one != nullptr ? one->spokenScale() : std::nullopt;
    }
};

QAccessibleInterface* makeSpokenInterface(const QString& /*className*/, QObject* object)
{
    const auto* one = dynamic_cast<const Spoken*>(object);
    return one != nullptr ? new SpokenInterface(qobject_cast<QWidget*>(object), one->spokenRole()) : nullptr;
}

} // namespace

Spoken::Spoken(QWidget* self)
    : m_self(self)
    , m_pace([this] {
        if (const auto scale = spokenScale(); scale && QAccessible::isActive()) {
            QAccessibleValueChangeEvent event(m_self, scale->value);
            QAccessible::updateAccessibility(&event);
        }
    })
{
    static const bool isInstalled = (QAccessible::installFactory(makeSpokenInterface), true);
    static_cast<void>(isInstalled);
}

} // namespace palpate::ui

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/AccessibleReadout.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QWidget>

namespace palpate::ui {

namespace {

/// Looks up the widget at each call, because a widget under destruction is no longer a Spoken.
class AccessibleReadoutInterface final : public QAccessibleWidget, public QAccessibleValueInterface
{
  public:
    AccessibleReadoutInterface(QWidget* widget, QAccessible::Role role)
        : QAccessibleWidget(widget, role)
    {
    }

    QString text(QAccessible::Text what) const override
    {
        if (what == QAccessible::Help) {
            return widget()->toolTip();
        }
        const AccessibleReadout* one = spoken();
        // Also as description: on Linux the text of a value is not passed on.
        return one != nullptr && (what == QAccessible::Value || what == QAccessible::Description)
                   ? one->accessibleText()
                   : QAccessibleWidget::text(what);
    }
    void* interface_cast(QAccessible::InterfaceType type) override
    {
        return type == QAccessible::ValueInterface && scale() ? static_cast<QAccessibleValueInterface*>(this)
                                                              : QAccessibleWidget::interface_cast(type);
    }
    QVariant currentValue() const override { return scale().value_or(AccessibleReadout::Scale()).value; }
    void setCurrentValue(const QVariant& value) override
    {
        if (AccessibleReadout* one = spoken(); one != nullptr) {
            one->setAccessibleValue(value.toDouble());
        }
    }
    QVariant maximumValue() const override { return scale().value_or(AccessibleReadout::Scale()).most; }
    QVariant minimumValue() const override { return scale().value_or(AccessibleReadout::Scale()).least; }
    QVariant minimumStepSize() const override { return scale().value_or(AccessibleReadout::Scale()).step; }

  private:
    AccessibleReadout* spoken() const { return dynamic_cast<AccessibleReadout*>(object()); }
    std::optional<AccessibleReadout::Scale> scale() const
    {
        const AccessibleReadout* one = spoken();
        return one != nullptr ? one->accessibleScale() : std::nullopt;
    }
};

QAccessibleInterface* makeSpokenInterface(const QString& /*className*/, QObject* object)
{
    const auto* one = dynamic_cast<const AccessibleReadout*>(object);
    return one != nullptr ? new AccessibleReadoutInterface(qobject_cast<QWidget*>(object), one->accessibleRole())
                          : nullptr;
}

} // namespace

AccessibleReadout::AccessibleReadout(QWidget* self)
    : m_self(self)
    , m_pace([this] {
        if (const auto scale = accessibleScale(); scale && QAccessible::isActive()) {
            QAccessibleValueChangeEvent event(m_self, scale->value);
            QAccessible::updateAccessibility(&event);
        }
    })
{
    static const bool isInstalled = (QAccessible::installFactory(makeSpokenInterface), true);
    static_cast<void>(isInstalled);
}

} // namespace palpate::ui

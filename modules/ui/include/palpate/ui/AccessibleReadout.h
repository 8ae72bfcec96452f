// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/RateLimiter.h"

#include <palpate/core/Export.h>

#include <QAccessible>
#include <QString>

#include <optional>

class QWidget;

namespace palpate::ui {

/// Screen reader interface of widgets that draw numbers. Provides a description and, for a number on a scale, an
/// accessible value. To be inherited in addition to QWidget.
///
/// @par Thread GUI thread only.
class PALPATE_EXPORT AccessibleReadout
{
  public:
    /// Number on a scale, in the unit of `accessibleText`.
    struct Scale
    {
        double value = 0.0;
        double least = 0.0;
        double most = 1.0;
        double step = 0.0; ///< smallest step; 0: continuous
    };

    AccessibleReadout(const AccessibleReadout&) = delete;
    AccessibleReadout& operator=(const AccessibleReadout&) = delete;

    [[nodiscard]] virtual QAccessible::Role accessibleRole() const = 0;
    /// Displayed numbers with units: "8.9 of 20.0 s, 4.81 N".
    [[nodiscard]] virtual QString accessibleText() const = 0;
    /// Empty: no accessible value.
    [[nodiscard]] virtual std::optional<Scale> accessibleScale() const { return std::nullopt; }
    /// Sets the value on behalf of a screen reader. The default for read-only widgets does nothing.
    virtual void setAccessibleValue(double /*value*/) {}

  protected:
    explicit AccessibleReadout(QWidget* self);
    ~AccessibleReadout() = default;
    /// Announces a changed value, at most twice a second.
    void announceValue() { m_pace.want(); }

  private:
    QWidget* m_self = nullptr;
    RateLimiter m_pace;
};

} // namespace palpate::ui

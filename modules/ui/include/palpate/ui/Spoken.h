// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/Pace.h"

#include <QAccessible>
#include <QString>

#include <optional>

class QWidget;

namespace palpate::ui {

/// Screen reader interface of widgets that draw numbers. Provides a description and, for a number on a scale, an
/// accessible value. To be inherited in addition to QWidget.
///
/// @par Thread GUI thread only.
class Spoken
{
  public:
    /// Number on a scale, in the unit of `spokenText`.
    struct Scale
    {
        double value = 0.0;
        double least = 0.0;
        double most = 1.0;
        double step = 0.0; ///< smallest step; 0: continuous
    };

    Spoken(const Spoken&) = delete;
    Spoken& operator=(const Spoken&) = delete;

    [[nodiscard]] virtual QAccessible::Role spokenRole() const = 0;
    /// Displayed numbers with units: "8.9 of 20.0 s, 4.81 N".
    [[nodiscard]] virtual QString spokenText() const = 0;
    /// Empty: no accessible value.
    [[nodiscard]] virtual std::optional<Scale> spokenScale() const { return std::nullopt; }
    /// Sets the value on behalf of a screen reader. The default for read-only widgets does nothing.
    virtual void setSpoken(double /*value*/) {}

  protected:
    explicit Spoken(QWidget* self);
    ~Spoken() = default;
    /// Announces a changed value, at most twice a second.
    void tellValue() { m_pace.want(); }

  private:
    QWidget* m_self = nullptr;
    Pace m_pace;
};

} // namespace palpate::ui

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/ui/Pace.h"

#include <QAccessible>
#include <QString>

#include <optional>

class QWidget;

namespace palpate::ui {

/// What a widget that draws numbers says to a screen reader: they are its description and, where it is one on a scale,
/// its value. To be inherited beside QWidget.
/// @par Thread The GUI's.
class Spoken
{
  public:
    /// A number on a scale, in the unit that `spokenText` says.
    struct Scale
    {
        double value = 0.0;
        double least = 0.0;
        double most = 1.0;
        double step = 0.0; ///< smallest; 0: any
    };

    Spoken(const Spoken&) = delete;
    Spoken& operator=(const Spoken&) = delete;

    [[nodiscard]] virtual QAccessible::Role spokenRole() const = 0;
    /// The numbers as they are drawn, with their units: "8.9 of 20.0 s, 4.81 N".
    [[nodiscard]] virtual QString spokenText() const = 0;
    /// Nothing: it has no value of its own.
    [[nodiscard]] virtual std::optional<Scale> spokenScale() const { return std::nullopt; }
    /// A screen reader sets the value; one that is only shown does nothing.
    virtual void setSpoken(double /*value*/) {}

  protected:
    explicit Spoken(QWidget* self);
    ~Spoken() = default;
    /// The number is another one: told at most twice a second.
    void tellValue() { m_pace.want(); }

  private:
    QWidget* m_self = nullptr;
    Pace m_pace;
};

} // namespace palpate::ui

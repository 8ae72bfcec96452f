// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clocale>
#include <locale.h>

namespace palpate::meshio::internal {

/// Makes the calling thread read and write numbers with a decimal point during the lifetime of this object, whatever
/// the locale of the program: a Qt program uses the user's locale, and VTK reads with strtod. Other threads are
/// unaffected.
class NumericLocale
{
  public:
    NumericLocale()
        : m_point(newlocale(LC_ALL_MASK, "C", static_cast<locale_t>(nullptr)))
        , m_before(m_point != nullptr ? uselocale(m_point) : nullptr)
    {
    }
    ~NumericLocale()
    {
        if (m_point != nullptr) {
            uselocale(m_before);
            freelocale(m_point);
        }
    }
    NumericLocale(const NumericLocale&) = delete;
    NumericLocale& operator=(const NumericLocale&) = delete;

  private:
    locale_t m_point;
    locale_t m_before;
};

} // namespace palpate::meshio::internal

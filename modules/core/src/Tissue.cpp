// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/core/Tissue.h"

#include <cmath>

namespace palpate::core {

Status check(const Tissue& tissue)
{
    for (const TissueTerm& term : kTissueTerms) {
        const double value = tissue.*term.member;
        if (!(value >= 0.0 && value <= term.most)) {
            return {std::isfinite(value) ? StatusCode::OutOfRange : StatusCode::NonFinite,
                    PALPATE_TEXT("%1: found %2, expected 0 to %3 %4"),
                    term.key,
                    value,
                    term.most,
                    term.unit};
        }
    }
    if (tissue.friction_dynamic > tissue.friction_static) {
        return {StatusCode::OutOfRange,
                PALPATE_TEXT("friction_dynamic: found %1, expected at most %2 (friction_static)"),
                tissue.friction_dynamic, tissue.friction_static};
    }
    return check(tissue.law);
}

} // namespace palpate::core

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/ReadableName.h"

#include <QString>

namespace palpate::study {

std::string readableName(std::string_view name)
{
    QString text = QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size())).replace('_', ' ').simplified();
    // Reference libraries prefix every organ with the body: "VH F liver".
    for (const char* prefix : {"VH F ", "VH M "}) {
        if (text.startsWith(QLatin1String(prefix), Qt::CaseInsensitive)) {
            text.remove(0, 5);
        }
    }
    return text.toStdString();
}

} // namespace palpate::study

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/ElidedName.h"

#include <algorithm>

namespace palpate::ui {

namespace {

/// Number of equal characters at the start, or at the end, of two names.
qsizetype equalLetters(const QString& a, const QString& b, bool isAtEnd)
{
    const qsizetype most = std::min(a.size(), b.size());
    qsizetype count = 0;
    while (count < most && (isAtEnd ? a[a.size() - 1 - count] == b[b.size() - 1 - count] : a[count] == b[count])) {
        ++count;
    }
    return count;
}

/// Part of a name from `start` to `end` with dots where something is left out.
QString part(const QString& name, qsizetype start, qsizetype end)
{
    const QString dots(QChar(0x2026));
    return (start > 0 ? dots : QString()) + name.mid(start, end - start) + (end < name.size() ? dots : QString());
}

} // namespace

QString elidedName(const QString& name, const QFontMetrics& metrics, int width, const QStringList& others)
{
    const QString usual = metrics.elidedText(name, Qt::ElideMiddle, width);
    if (usual == name || name.isEmpty()) {
        return usual;
    }
    qsizetype start = name.size(), end = 0; // what differs from the names of the same short form
    for (const QString& other : others) {
        const bool isSimilar =
            !other.isEmpty() && other != name && other.front() == name.front() && other.back() == name.back();
        if (isSimilar && metrics.elidedText(other, Qt::ElideMiddle, width) == usual) {
            start = std::min(start, equalLetters(name, other, false));
            end = std::max(end, name.size() - equalLetters(name, other, true));
        }
    }
    if (end == 0) {
        return usual; // no other name looks like it
    }
    start = std::min(start, name.size() - 1);
    end = std::max(end, start + 1);
    const auto fits = [&](qsizetype from, qsizetype to) {
        return metrics.horizontalAdvance(part(name, from, to)) <= width;
    };
    for (bool hasGrown = true; hasGrown;) {
        hasGrown = false;
        if (start > 0 && fits(start - 1, end)) {
            --start;
            hasGrown = true;
        }
        if (end < name.size() && fits(start, end + 1)) {
            ++end;
            hasGrown = true;
        }
    }
    return metrics.elidedText(part(name, start, end), Qt::ElideRight, width);
}

} // namespace palpate::ui

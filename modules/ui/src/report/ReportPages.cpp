// SPDX-License-Identifier: BSD-3-Clause
#include "report/ReportPages.h"

#include <QFontMetricsF>
#include <QRegularExpression>
#include <QTextLayout>
#include <QTextOption>

#include <algorithm>
#include <numeric>
#include <utility>

namespace palpate::ui::internal {

namespace {

constexpr double kGap_pt = 9.0;         // between the columns of a table
constexpr double kMostNatural_pt = 220; // a column that wants more is broken into lines
constexpr double kPictureGap_pt = 12.0;
constexpr QColor kRule(0x66, 0x66, 0x66), kThinRule(0xd5, 0xd5, 0xd5), kQuiet(0x44, 0x44, 0x44),
    kAlert(0xb3, 0x4a, 0x00);

bool isFacts(const study::ReportTable& table)
{
    return table.columns.empty();
}

/// Keeps numbers and their units on one line.
QString withUnits(const QString& text)
{
    static const QRegularExpression number(
        QStringLiteral("(\\d) (?=(?:mm²|mm³|mm|cm²|m²|m³|ml|l|m|s|N|Hz|%)(?:\\W|$))"),
        QRegularExpression::UseUnicodePropertiesOption);
    return QString(text).replace(number, QStringLiteral("\\1\u00a0"));
}

/// Puts the unit of a heading on a line of its own.
QString headingText(const core::Message& heading)
{
    return withUnits(reportText(heading)).replace(QStringLiteral(" ["), QStringLiteral("\n["));
}

/// Returns the text of a cell; numbers are not broken into lines.
QString textOfCell(const study::ReportTable& table, std::size_t row, std::size_t column)
{
    QString text = reportText(table.rows[row][column]);
    return !isFacts(table) && table.columns[column].isNumber ? text.replace(QLatin1Char(' '), QChar(QChar::Nbsp))
                                                             : text;
}

std::size_t columnCount(const study::ReportTable& table)
{
    return isFacts(table) ? 2 : table.columns.size();
}

/// Narrows the widest columns until all fit, so that only the longest words are broken. A column keeps the words of its
/// heading whole, unless the headings alone are too wide.
void narrowTo(std::vector<double>& widths_px, const std::vector<double>& headings_px, double room_px)
{
    const auto fits = [&](double widest_px) {
        double sum = 0.0;
        for (std::size_t i = 0; i < widths_px.size(); ++i) {
            sum += std::min(widths_px[i], std::max(headings_px[i], widest_px));
        }
        return sum <= room_px;
    };
    double low = 0.0, high = room_px; // bisection to below a pixel
    for (int step = 0; step < 40; ++step) {
        const double middle = 0.5 * (low + high);
        (fits(middle) ? low : high) = middle;
    }
    for (std::size_t i = 0; i < widths_px.size(); ++i) {
        widths_px[i] = std::min(widths_px[i], std::max(headings_px[i], low));
    }
    const double sum = std::accumulate(widths_px.begin(), widths_px.end(), 0.0);
    for (double& width_px : widths_px) {
        width_px *= room_px / std::max(sum, room_px);
    }
}

} // namespace

ReportPages::ReportPages(QPaintDevice& device, const QRectF& body, double unit, const std::vector<QImage>& pictures)
    : m_device(device)
    , m_body(body)
    , m_unit(unit)
    , m_pictures(pictures)
    , m_plain(reportFont(9.5, unit))
    , m_small(reportFont(8.0, unit))
    , m_smallBold(reportFont(8.0, unit, true))
    , m_print(reportFont(6.5, unit))
    , m_printBold(reportFont(6.5, unit, true))
    , m_y(body.top())
{
}

qsizetype ReportPages::lineCount(const Row& row)
{
    qsizetype count = 1;
    for (const Cell& cell : row) {
        count = std::max(count, cell.lines.size());
    }
    return count;
}

double ReportPages::lineHeight(const QFont& font) const
{
    return 1.12 * QFontMetricsF(font, &m_device).height();
}

QStringList ReportPages::linesOf(const QString& text, const QFont& font, double width_px) const
{
    QStringList lines;
    for (const QString& part : withUnits(text).split(QLatin1Char('\n'))) {
        QTextLayout layout(part, font, &m_device);
        QTextOption option;
        option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
        layout.setTextOption(option);
        layout.beginLayout();
        for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
            line.setLineWidth(width_px);
            lines << part.mid(line.textStart(), line.textLength()).trimmed();
        }
        layout.endLayout();
    }
    return lines;
}

/// Begins a new page if the rest of the page is lower.
void ReportPages::ensureRoom(double height_px)
{
    if (m_y + height_px > m_body.bottom() && m_y > m_body.top()) {
        m_pages.emplace_back();
        m_y = m_body.top();
    }
}

void ReportPages::addItem(const QRectF& where, decltype(PageItem::what) what)
{
    m_pages.back().push_back({where, std::move(what)});
}

void ReportPages::addLines(const QStringList& lines, const QFont& font, double left_px, double width_px)
{
    const double height = lineHeight(font);
    for (const QString& line : lines) {
        ensureRoom(height);
        addItem(QRectF(left_px, m_y, width_px, height), PageText{line, font});
        m_y += height;
    }
}

void ReportPages::addRule(double thickness_pt, const QColor& colour)
{
    addItem(QRectF(m_body.left(), m_y, m_body.width(), thickness_pt * m_unit), PageFill{colour});
    m_y += thickness_pt * m_unit;
}

void ReportPages::addTitle(const QString& title, const QString& notice)
{
    addLines({title}, reportFont(18.0, m_unit, true), m_body.left(), m_body.width());
    m_y += 2.0 * m_unit;
    addItem(QRectF(m_body.left(), m_y, m_body.width(), lineHeight(m_plain)),
            PageText{notice, m_plain, Qt::AlignLeft, kQuiet});
    m_y += lineHeight(m_plain) + 8.0 * m_unit;
}

void ReportPages::addHeading(const core::Message& heading, bool beginsWithPicture)
{
    const QFont font = reportFont(12.0, m_unit, true);
    m_y += 12.0 * m_unit;
    constexpr double kText_pt = 80.0, kPicture_pt = 215.0; // beginning of the content
    ensureRoom(lineHeight(font) + (beginsWithPicture ? kPicture_pt : kText_pt) * m_unit);
    addLines(linesOf(reportText(heading), font, m_body.width()), font, m_body.left(), m_body.width());
    m_y += 1.0 * m_unit;
    addRule(0.7, kRule);
    m_y += 6.0 * m_unit;
}

void ReportPages::operator()(const study::ReportText& block)
{
    const QFont& font = block.isSmall ? m_print : m_plain;
    const double inset = block.isWarning ? 8.0 * m_unit : 0.0;
    const QStringList lines = linesOf(reportText(block.text), font, m_body.width() - inset);
    const double height = lineHeight(font);
    constexpr qsizetype kTogether = 5; // a short paragraph is not split
    ensureRoom(height * static_cast<double>(lines.size() <= kTogether ? lines.size() : 2));
    for (const QString& line : lines) {
        ensureRoom(height);
        if (block.isWarning) {
            addItem(QRectF(m_body.left(), m_y, 2.5 * m_unit, height), PageFill{kAlert});
        }
        addItem(QRectF(m_body.left() + inset, m_y, m_body.width() - inset, height), PageText{line, font});
        m_y += height;
    }
    m_y += 5.0 * m_unit;
}

/// Gives each column its natural width, or shares the width among the columns that want more than their part.
std::vector<double> ReportPages::columnWidths(const study::ReportTable& table) const
{
    const std::size_t columns = columnCount(table);
    constexpr std::size_t kMeasured = 300; // rows; the others are broken to fit
    static const QRegularExpression blank(QStringLiteral("[ \n]"));
    const Fonts fonts = fontsOf(table);
    const QFontMetricsF plain(fonts.plain, &m_device), bold(fonts.bold, &m_device);
    std::vector<double> natural(columns, 0.0), least(columns, 0.0), heading(columns, 0.0);
    for (std::size_t i = 0; i < columns; ++i) {
        const auto take = [&](const QString& text, const QFontMetricsF& metrics, bool isHeading) {
            for (const QString& word : withUnits(text).split(blank)) {
                least[i] = std::max(least[i], metrics.horizontalAdvance(word));
            }
            natural[i] = std::max(natural[i], isHeading ? least[i] : metrics.horizontalAdvance(text));
        };
        if (!isFacts(table)) {
            take(headingText(table.columns[i].heading), bold, true);
            heading[i] = least[i] + m_unit;
        }
        for (std::size_t row = 0; row < std::min(kMeasured, table.rows.size()); ++row) {
            take(textOfCell(table, row, i), isFacts(table) && i == 0 ? bold : plain, false);
        }
        natural[i] = std::min(natural[i] + m_unit, std::max(kMostNatural_pt * m_unit, least[i]));
        least[i] = std::min(least[i] + m_unit, natural[i]);
    }
    const double gaps = kGap_pt * m_unit * static_cast<double>(columns - 1);
    const double room = m_body.width() - gaps;
    const double wanted = std::accumulate(natural.begin(), natural.end(), 0.0);
    if (isFacts(table)) {
        natural[0] = std::min(natural[0], 0.4 * room);
        return {natural[0], room - natural[0]};
    }
    if (wanted <= room) {
        for (std::size_t i = 0; i < columns; ++i) {
            natural[i] += (room - wanted) / static_cast<double>(columns);
        }
        return natural;
    }
    const double needed = std::accumulate(least.begin(), least.end(), 0.0);
    if (needed >= room) {
        narrowTo(least, heading, room);
        return least;
    }
    for (std::size_t i = 0; i < columns; ++i) {
        least[i] += (room - needed) * (natural[i] - least[i]) / (wanted - needed);
    }
    return least;
}

ReportPages::Fonts ReportPages::fontsOf(const study::ReportTable& table) const
{
    return table.isSmall ? Fonts{m_print, m_printBold} : Fonts{m_small, m_smallBold};
}

ReportPages::Row ReportPages::brokenRow(const std::vector<QString>& texts, const study::ReportTable& table,
                                        const std::vector<double>& widths_px, const QFont& font) const
{
    Row row;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const bool isNumber = !isFacts(table) && table.columns[i].isNumber;
        const QFont own = isFacts(table) && i == 0 ? fontsOf(table).bold : font;
        row.push_back({linesOf(texts[i], own, widths_px[i]), isNumber ? Qt::AlignRight : Qt::AlignLeft, own});
    }
    return row;
}

/// Begins a new page for a row that is higher than the rest of the page. A row of more than half a page begins where it
/// is, and is continued on the next page.
void ReportPages::ensureRoomFor(const Row& row)
{
    ensureRoom(std::min(lineHeight(row.front().font) * static_cast<double>(lineCount(row)) + 4.0 * m_unit,
                        0.5 * m_body.height()));
}

void ReportPages::addRow(const Row& row, const std::vector<double>& widths_px)
{
    const qsizetype count = lineCount(row);
    const double height = lineHeight(row.front().font);
    m_y += 1.5 * m_unit;
    for (qsizetype line = 0; line < count; ++line) {
        ensureRoom(height);
        double left = m_body.left();
        for (std::size_t i = 0; i < row.size(); ++i) {
            if (line < row[i].lines.size()) {
                addItem(QRectF(left, m_y, widths_px[i], height),
                        PageText{row[i].lines[line], row[i].font, row[i].alignment});
            }
            left += widths_px[i] + kGap_pt * m_unit;
        }
        m_y += height;
    }
    m_y += 1.5 * m_unit;
}

void ReportPages::operator()(const study::ReportTable& table)
{
    const std::vector<double> widths_px = columnWidths(table);
    const Fonts fonts = fontsOf(table);
    std::vector<QString> headings;
    for (const study::ReportTable::Column& column : table.columns) {
        headings.push_back(headingText(column.heading));
    }
    const Row head = brokenRow(headings, table, widths_px, fonts.bold);
    const auto addHead = [&] {
        if (!isFacts(table)) {
            addRow(head, widths_px);
            addRule(0.6, kRule);
        }
    };
    ensureRoom(7.0 * lineHeight(fonts.plain));
    if (!table.caption.isEmpty()) {
        addLines(linesOf(reportText(table.caption), fonts.bold, m_body.width()), fonts.bold, m_body.left(),
                 m_body.width());
        m_y += 2.0 * m_unit;
    }
    addHead();
    for (std::size_t number = 0; number < table.rows.size(); ++number) {
        std::vector<QString> texts;
        for (std::size_t i = 0; i < widths_px.size(); ++i) {
            texts.push_back(textOfCell(table, number, i));
        }
        const Row row = brokenRow(texts, table, widths_px, fonts.plain);
        const std::size_t page = m_pages.size();
        ensureRoomFor(row);
        if (m_pages.size() != page) {
            addHead();
        }
        addRow(row, widths_px);
        addRule(0.35, kThinRule);
    }
    m_y += 9.0 * m_unit;
}

void ReportPages::operator()(const study::ReportPictures& block)
{
    const double width = 0.5 * (m_body.width() - kPictureGap_pt * m_unit);
    const double caption = lineHeight(m_small);
    for (std::size_t first = 0; first < block.pictures.size(); first += 2) {
        const std::size_t end = std::min(first + 2, block.pictures.size());
        double height = 0.0;
        std::vector<QStringList> captions;
        for (std::size_t i = first; i < end; ++i) {
            const std::size_t view = block.pictures[i].view;
            if (view < m_pictures.size() && !m_pictures[view].isNull()) {
                height = width * m_pictures[view].height() / m_pictures[view].width();
            }
            constexpr qsizetype kMostLines = 3;
            captions.push_back(linesOf(reportText(block.pictures[i].caption), m_small, width).mid(0, kMostLines));
        }
        qsizetype lines = 0;
        for (const QStringList& one : captions) {
            lines = std::max(lines, one.size());
        }
        const double all = height + 2.0 * m_unit + caption * static_cast<double>(lines);
        ensureRoom(all);
        for (std::size_t i = first; i < end; ++i) {
            const double left = m_body.left() + static_cast<double>(i - first) * (width + kPictureGap_pt * m_unit);
            const QRectF in(left, m_y, width, height);
            if (height > 0.0) {
                addItem(in, PageFill{kThinRule}); // a thin frame
                addItem(in.adjusted(0.4 * m_unit, 0.4 * m_unit, -0.4 * m_unit, -0.4 * m_unit),
                        m_pictures[block.pictures[i].view]);
            }
            for (qsizetype line = 0; line < captions[i - first].size(); ++line) {
                addItem(QRectF(left, m_y + height + 2.0 * m_unit + caption * static_cast<double>(line), width, caption),
                        PageText{captions[i - first][line], m_small});
            }
        }
        m_y += all + 8.0 * m_unit;
    }
}

void ReportPages::operator()(const study::ReportCurve& curve)
{
    const double height = 160.0 * m_unit;
    const QStringList caption = linesOf(reportText(curve.caption), m_small, m_body.width());
    ensureRoom(height + 2.0 * m_unit + lineHeight(m_small) * static_cast<double>(caption.size()));
    addItem(QRectF(m_body.left(), m_y, m_body.width(), height), &curve.force);
    m_y += height + 2.0 * m_unit;
    addLines(caption, m_small, m_body.left(), m_body.width());
    m_y += 6.0 * m_unit;
}

} // namespace palpate::ui::internal

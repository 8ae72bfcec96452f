// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report/ReportParts.h"

#include <QColor>
#include <QImage>
#include <QRectF>
#include <QString>
#include <QStringList>

#include <variant>
#include <vector>

class QPaintDevice;

namespace palpate::ui::internal {

/// One line of text. Lines are broken by `ReportPages::linesOf`.
struct PageText
{
    QString text;
    QFont font;
    Qt::Alignment alignment = Qt::AlignLeft;
    QColor colour{0x22, 0x22, 0x22};
};
struct PageFill
{
    QColor colour;
};

/// Drawing of a page: what, and where on the page [px].
struct PageItem
{
    QRectF where;
    std::variant<PageText, PageFill, QImage, const study::ForceCurve*> what;
};

/// Distributes the blocks of a report over pages. The complete layout is known before the first page is drawn, because
/// every page states the number of pages.
class ReportPages
{
  public:
    /// @param device  for the metrics of the fonts; @param body  area between header and footer [px]
    /// @param unit  length of a point [px]; @param pictures  by view
    ReportPages(QPaintDevice& device, const QRectF& body, double unit, const std::vector<QImage>& pictures);

    void addTitle(const QString& title, const QString& notice);
    /// @param beginsWithPicture  keeps the heading on the page of the picture or curve below
    void addHeading(const core::Message& heading, bool beginsWithPicture);
    void operator()(const study::ReportText& block);
    void operator()(const study::ReportTable& table);
    void operator()(const study::ReportPictures& block);
    void operator()(const study::ReportCurve& curve);

    [[nodiscard]] const std::vector<std::vector<PageItem>>& pages() const noexcept { return m_pages; }
    /// Breaks a text into lines of at most this width, between words where possible.
    [[nodiscard]] QStringList linesOf(const QString& text, const QFont& font, double width_px) const;

  private:
    struct Cell
    {
        QStringList lines;
        Qt::Alignment alignment;
        QFont font;
    };
    using Row = std::vector<Cell>;
    struct Fonts
    {
        QFont plain, bold;
    };

    [[nodiscard]] double lineHeight(const QFont& font) const;
    void ensureRoom(double height_px);
    void addItem(const QRectF& where, decltype(PageItem::what) what);
    void addLines(const QStringList& lines, const QFont& font, double left_px, double width_px);
    [[nodiscard]] static qsizetype lineCount(const Row& row);
    void ensureRoomFor(const Row& row);
    void addRow(const Row& row, const std::vector<double>& widths_px);
    void addRule(double thickness_pt, const QColor& colour);
    [[nodiscard]] Fonts fontsOf(const study::ReportTable& table) const;
    [[nodiscard]] std::vector<double> columnWidths(const study::ReportTable& table) const;
    [[nodiscard]] Row brokenRow(const std::vector<QString>& texts, const study::ReportTable& table,
                                const std::vector<double>& widths_px, const QFont& font) const;

    QPaintDevice& m_device;
    QRectF m_body;
    double m_unit;
    const std::vector<QImage>& m_pictures;
    QFont m_plain, m_small, m_smallBold;
    QFont m_print, m_printBold; ///< small print
    double m_y = 0.0;           ///< next free position on the last page
    std::vector<std::vector<PageItem>> m_pages{1};
};

} // namespace palpate::ui::internal

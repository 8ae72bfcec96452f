// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/ReportFile.h"

#include "palpate/ui/Translated.h"
#include "report/ReportPages.h"

#include <palpate/session/Recording.h>

#include <QBuffer>
#include <QFontMetricsF>
#include <QLocale>
#include <QMarginsF>
#include <QPageLayout>
#include <QPageSize>
#include <QPagedPaintDevice>
#include <QPainter>
#include <QPdfWriter>
#include <QTextOption>

#include <variant>

namespace palpate::ui {

namespace {

using internal::PageFill;
using internal::PageItem;
using internal::PageText;

constexpr int kResolution_dpi = 1200;
constexpr double kUnit = kResolution_dpi / 72.0; // a point [px]

void drawLine(QPainter& painter, const QRectF& where, const PageText& text)
{
    painter.setFont(text.font);
    painter.setPen(text.colour);
    QTextOption option(text.alignment | Qt::AlignAbsolute | Qt::AlignVCenter);
    option.setWrapMode(QTextOption::NoWrap);
    painter.drawText(where, text.text, option);
}

void drawItem(QPainter& painter, const PageItem& item)
{
    if (const auto* text = std::get_if<PageText>(&item.what)) {
        drawLine(painter, item.where, *text);
    } else if (const auto* fill = std::get_if<PageFill>(&item.what)) {
        painter.fillRect(item.where, fill->colour);
    } else if (const auto* image = std::get_if<QImage>(&item.what)) {
        painter.drawImage(item.where, *image);
    } else {
        internal::drawForceCurve(painter, item.where, *std::get<const study::ForceCurve*>(item.what), kUnit);
    }
}

/// Draws the notice and the number of the page below the body.
void drawFooter(QPainter& painter, const QRectF& in, const study::Report& report, std::size_t page, std::size_t pages)
{
    const QFont font = internal::reportFont(7.5, kUnit);
    const QColor colour(0x44, 0x44, 0x44);
    painter.fillRect(QRectF(in.left(), in.top(), in.width(), 0.5 * kUnit), QColor(0x99, 0x99, 0x99));
    const QRectF line = in.adjusted(0.0, 4.0 * kUnit, 0.0, 0.0);
    const QFontMetricsF metrics(font, painter.device());
    const QString notice = internal::reportText(report.notice);
    const QString number =
        internal::reportText(core::Message(PALPATE_TEXT("Page %1 of %2"), core::Count(page), core::Count(pages)));
    const double free = line.width() - metrics.horizontalAdvance(notice) - metrics.horizontalAdvance(number);
    const QString subject =
        metrics.elidedText(internal::reportText(report.subject).replace(QLatin1Char('\n'), QLatin1Char(' ')),
                           Qt::ElideMiddle, free - 30.0 * kUnit);
    drawLine(painter, line, {notice, font, Qt::AlignLeft, colour});
    drawLine(painter, line, {number, font, Qt::AlignRight, colour});
    drawLine(painter, line.adjusted(0.0, 0.0, -metrics.horizontalAdvance(number) - 12.0 * kUnit, 0.0),
             {subject, font, Qt::AlignRight, colour});
}

QPageSize paper()
{
    return QPageSize(QLocale::system().measurementSystem() == QLocale::ImperialUSSystem ? QPageSize::Letter
                                                                                        : QPageSize::A4);
}

} // namespace

QByteArray reportPdf(const study::Report& report, const std::vector<QImage>& pictures)
{
    QBuffer bytes;
    (void)bytes.open(QIODevice::WriteOnly);
    QPdfWriter writer(&bytes);
    writer.setPdfVersion(QPagedPaintDevice::PdfVersion_A1b);
    writer.setResolution(kResolution_dpi);
    writer.setPageSize(paper());
    writer.setPageMargins(QMarginsF(18.0, 16.0, 18.0, 14.0), QPageLayout::Millimeter);
    const QString title = internal::reportText(report.title);
    writer.setTitle(title + QStringLiteral(": ") + internal::reportText(report.subject));
    writer.setCreator(QStringLiteral("Palpate ") + QString::fromStdString(session::palpateVersion()));

    const QRectF page(0.0, 0.0, writer.width(), writer.height());
    const double footer = 18.0 * kUnit;
    internal::ReportPages layout(writer, page.adjusted(0.0, 0.0, 0.0, -footer - 8.0 * kUnit), kUnit, pictures);
    layout.addTitle(title, internal::reportText(report.notice));
    for (const study::ReportSection& section : report.sections) {
        if (!section.heading.isEmpty()) {
            const bool isText = std::holds_alternative<study::ReportText>(section.blocks.front()) ||
                                std::holds_alternative<study::ReportTable>(section.blocks.front());
            layout.addHeading(section.heading, !isText);
        }
        for (const study::ReportBlock& block : section.blocks) {
            std::visit(layout, block);
        }
    }

    QPainter painter(&writer);
    const std::size_t pages = layout.pages().size();
    for (std::size_t i = 0; i < pages; ++i) {
        if (i > 0) {
            writer.newPage();
        }
        for (const PageItem& item : layout.pages()[i]) {
            drawItem(painter, item);
        }
        drawFooter(painter, QRectF(page.left(), page.bottom() - footer, page.width(), footer), report, i + 1, pages);
    }
    painter.end();
    return bytes.data();
}

} // namespace palpate::ui

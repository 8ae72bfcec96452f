// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/ReportFile.h"

#include "report/ReportParts.h"

#include <QBuffer>
#include <QLocale>
#include <QPainter>

#include <variant>

namespace palpate::ui {

namespace {

using internal::reportText;

constexpr int kJpegQuality = 88;

/// Layout for screens and printers; nothing is loaded from elsewhere.
constexpr const char* kStyle = R"(
body { font-family: system-ui, "DejaVu Sans", sans-serif; color: #222; background: #fff; max-width: 60rem;
  margin: 2rem auto; padding: 0 1.5rem; line-height: 1.45; }
h1 { font-size: 1.7rem; margin: 0.6rem 0; }
h2 { font-size: 1.2rem; margin: 2rem 0 0.6rem; border-bottom: 1px solid #999; padding-bottom: 0.2rem; }
.notice { font-size: 0.85rem; color: #444; }
.warning { border-left: 4px solid #b34a00; background: #fdf3ea; padding: 0.4rem 0.8rem; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; margin: 0.8rem 0; font-size: 0.9rem; width: 100%; }
caption { text-align: left; font-weight: 600; padding: 0.2rem 0; }
th, td { text-align: left; vertical-align: top; padding: 0.25rem 0.7rem 0.25rem 0; border-bottom: 1px solid #ddd;
  overflow-wrap: break-word; }
thead th { vertical-align: bottom; border-bottom: 1px solid #666; }
tbody th { font-weight: 400; }
.facts { width: auto; }
.facts th { font-weight: 600; white-space: nowrap; padding-right: 2rem; }
.small { font-size: 0.75rem; }
.number { text-align: right; font-variant-numeric: tabular-nums; }
.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(20rem, 1fr)); gap: 1rem; margin: 0.8rem 0; }
figure { margin: 0; break-inside: avoid; }
figure img { width: 100%; height: auto; border: 1px solid #ccc; display: block; }
figcaption { font-size: 0.9rem; padding-top: 0.2rem; }
footer { margin-top: 2.5rem; border-top: 1px solid #999; padding-top: 0.4rem; }
@media print { body { margin: 0; max-width: none; } tr { break-inside: avoid; } h2 { break-after: avoid; } }
)";

QString escaped(const core::MessageArgument& text)
{
    return reportText(text).toHtmlEscaped().replace(QLatin1Char('\n'), QStringLiteral("<br/>"));
}

QString imageTag(const QImage& image, const core::Message& description, const char* format)
{
    QBuffer bytes;
    (void)image.save(&bytes, format, kJpegQuality);
    return QStringLiteral("<img src=\"data:image/%1;base64,%2\" width=\"%3\" height=\"%4\" alt=\"%5\"/>")
        .arg(QString::fromLatin1(format).toLower(), QString::fromLatin1(bytes.data().toBase64()))
        .arg(image.width())
        .arg(image.height())
        .arg(reportText(description).toHtmlEscaped());
}

/// Writes the blocks of the report.
class HtmlBlocks
{
  public:
    HtmlBlocks(QString& out, const std::vector<QImage>& pictures)
        : m_out(out)
        , m_pictures(pictures)
    {
    }

    void operator()(const study::ReportText& block)
    {
        const QString look = block.isWarning ? QStringLiteral(" class=\"warning\"")
                             : block.isSmall ? QStringLiteral(" class=\"small\"")
                                             : QString();
        m_out += QStringLiteral("<p%1>%2</p>\n").arg(look, escaped(block.text));
    }

    void operator()(const study::ReportTable& table)
    {
        const bool isFacts = table.columns.empty();
        QStringList looks;
        if (isFacts) {
            looks << QStringLiteral("facts");
        }
        if (table.isSmall) {
            looks << QStringLiteral("small");
        }
        m_out +=
            QStringLiteral("<div class=\"scroll\"><table%1>\n")
                .arg(looks.isEmpty() ? QString() : QStringLiteral(" class=\"%1\"").arg(looks.join(QLatin1Char(' '))));
        if (!table.caption.isEmpty()) {
            m_out += QStringLiteral("<caption>%1</caption>\n").arg(escaped(table.caption));
        }
        if (!isFacts) {
            m_out += QStringLiteral("<thead><tr>");
            for (const study::ReportTable::Column& column : table.columns) {
                m_out += QStringLiteral("<th scope=\"col\"%1>%2</th>").arg(classOf(column), escaped(column.heading));
            }
            m_out += QStringLiteral("</tr></thead>\n");
        }
        m_out += QStringLiteral("<tbody>\n");
        for (const std::vector<core::MessageArgument>& row : table.rows) {
            m_out += QStringLiteral("<tr>");
            for (std::size_t i = 0; i < row.size(); ++i) {
                const QString tag = i == 0 ? QStringLiteral("<th scope=\"row\"%1 dir=\"auto\">%2</th>")
                                           : QStringLiteral("<td%1 dir=\"auto\">%2</td>");
                m_out += tag.arg(isFacts ? QString() : classOf(table.columns[i]), escaped(row[i]));
            }
            m_out += QStringLiteral("</tr>\n");
        }
        m_out += QStringLiteral("</tbody></table></div>\n");
    }

    void operator()(const study::ReportPictures& block)
    {
        m_out += QStringLiteral("<div class=\"pictures\">\n");
        for (const study::ReportPicture& one : block.pictures) {
            const QImage image = one.view < m_pictures.size() ? m_pictures[one.view] : QImage();
            addFigure(image.isNull() ? QString() : imageTag(image, one.description, "JPEG"), one.caption);
        }
        m_out += QStringLiteral("</div>\n");
    }

    void operator()(const study::ReportCurve& curve)
    {
        constexpr double kUnit = 2.6; // pixels of a point: sharp on screens of high resolution
        QImage image(1660, 500, QImage::Format_RGB888);
        image.fill(Qt::white);
        QPainter painter(&image);
        internal::drawForceCurve(painter, QRectF(image.rect()).adjusted(10, 10, -10, -10), curve.force, kUnit);
        painter.end();
        addFigure(imageTag(image, curve.description, "PNG"), curve.caption);
    }

  private:
    static QString classOf(const study::ReportTable::Column& column)
    {
        return column.isNumber ? QStringLiteral(" class=\"number\"") : QString();
    }
    void addFigure(const QString& image, const core::Message& caption)
    {
        m_out += QStringLiteral("<figure>%1<figcaption dir=\"auto\">").arg(image) + escaped(caption) +
                 QStringLiteral("</figcaption></figure>\n");
    }

    QString& m_out;
    const std::vector<QImage>& m_pictures;
};

} // namespace

QByteArray reportHtml(const study::Report& report, const std::vector<QImage>& pictures)
{
    const QString notice = QStringLiteral("<p class=\"notice\">%1</p>\n").arg(escaped(report.notice));
    const QString title = escaped(report.title);
    QString out =
        QStringLiteral("<!DOCTYPE html>\n<html lang=\"%1\">\n<head>\n<meta charset=\"utf-8\"/>\n"
                       "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
                       "style-src 'unsafe-inline'\"/>\n"
                       "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>")
            .arg(QLocale().bcp47Name());
    out += title + QStringLiteral(": ") + escaped(report.subject) + QStringLiteral("</title>\n<style>") +
           QLatin1String(kStyle) + QStringLiteral("</style>\n</head>\n<body>\n<header>\n") + notice +
           QStringLiteral("<h1>") + title + QStringLiteral("</h1>\n</header>\n<main>\n");
    HtmlBlocks blocks(out, pictures);
    int number = 0;
    for (const study::ReportSection& section : report.sections) {
        if (section.heading.isEmpty()) {
            out += QStringLiteral("<section>\n");
        } else {
            out += QStringLiteral("<section aria-labelledby=\"s%1\">\n<h2 id=\"s%1\">").arg(++number) +
                   escaped(section.heading) + QStringLiteral("</h2>\n");
        }
        for (const study::ReportBlock& block : section.blocks) {
            std::visit(blocks, block);
        }
        out += QStringLiteral("</section>\n");
    }
    out += QStringLiteral("</main>\n<footer>\n") + notice + QStringLiteral("</footer>\n</body>\n</html>\n");
    return out.toUtf8();
}

} // namespace palpate::ui

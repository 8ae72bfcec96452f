// SPDX-License-Identifier: BSD-3-Clause
#include "report/ReportParts.h"

#include "palpate/ui/ReportFile.h"
#include "palpate/ui/Translated.h"

#include <palpate/core/AtomicFile.h>
#include <palpate/core/VisibleText.h>

#include <QColor>
#include <QFontDatabase>
#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <QPolygonF>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace palpate::ui {

namespace internal {

namespace {

/// Rounds a step of an axis up to 1, 2 or 5 times a power of ten.
double roundStep(double least)
{
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= least * (1.0 - 1e-12)) {
            return factor * power;
        }
    }
    return 10.0 * power;
}

constexpr QColor kInk(0x22, 0x22, 0x22), kGrid(0xdd, 0xdd, 0xdd), kCurve(0x1b, 0x5e, 0x8c), kMark(0xb3, 0x4a, 0x00);

/// Draws the parts of the force curve.
class CurvePicture
{
  public:
    CurvePicture(QPainter& painter, const QRectF& in, const study::ForceCurve& force, double unit)
        : m_painter(painter)
        , m_force(force)
        , m_unit(unit)
        , m_plot(in.adjusted(34.0 * unit, 26.0 * unit, -6.0 * unit, -26.0 * unit))
        , m_in(in)
    {
        for (const study::ForceCurve::Span& span : force.spans) {
            m_most_N = std::max(m_most_N, static_cast<double>(span.greatest_N));
        }
        m_step_N = roundStep(std::max(m_most_N, 0.1) / 4.0);
        m_most_N = m_step_N * std::ceil(std::max(m_most_N, 0.1) / m_step_N);
        m_duration_s = std::max(force.duration_s, 1e-3);
    }

    void draw()
    {
        m_painter.setRenderHint(QPainter::Antialiasing);
        m_painter.setFont(reportFont(7.5, m_unit));
        drawAxes();
        drawForce();
        drawMarks();
    }

  private:
    double x(double time_s) const { return m_plot.left() + m_plot.width() * time_s / m_duration_s; }
    double y(double force_N) const { return m_plot.bottom() - m_plot.height() * force_N / m_most_N; }

    void drawAxes()
    {
        const double line = 10.0 * m_unit;
        for (int i = 0; i * m_step_N <= m_most_N * (1.0 + 1e-9); ++i) {
            const double at = y(i * m_step_N);
            m_painter.setPen(QPen(kGrid, 0.5 * m_unit));
            m_painter.drawLine(QPointF(m_plot.left(), at), QPointF(m_plot.right(), at));
            m_painter.setPen(kInk);
            m_painter.drawText(QRectF(m_in.left(), at - line, m_plot.left() - m_in.left() - 4.0 * m_unit, 2.0 * line),
                               Qt::AlignRight | Qt::AlignVCenter, numberText(i * m_step_N, 4));
        }
        const double step_s = roundStep(m_duration_s / 10.0);
        for (int i = 0; i * step_s <= m_duration_s * (1.0 + 1e-9); ++i) {
            const double at = x(i * step_s);
            m_painter.setPen(QPen(kInk, 0.5 * m_unit));
            m_painter.drawLine(QPointF(at, m_plot.bottom()), QPointF(at, m_plot.bottom() + 3.0 * m_unit));
            m_painter.setPen(kInk);
            m_painter.drawText(QRectF(at - 30.0 * m_unit, m_plot.bottom() + 3.0 * m_unit, 60.0 * m_unit, 1.2 * line),
                               Qt::AlignHCenter | Qt::AlignTop, numberText(i * step_s, 7));
        }
        m_painter.setPen(QPen(kInk, 0.6 * m_unit));
        m_painter.drawLine(m_plot.bottomLeft(), m_plot.bottomRight());
        m_painter.drawText(QRectF(m_in.left(), m_in.top(), m_in.width(), 1.2 * line), Qt::AlignLeft | Qt::AlignTop,
                           translated(core::Message(PALPATE_TEXT("Force [N]"))));
        m_painter.drawText(QRectF(m_plot.left(), m_in.bottom() - 1.2 * line, m_plot.width(), 1.2 * line),
                           Qt::AlignRight | Qt::AlignBottom, translated(core::Message(PALPATE_TEXT("Time [s]"))));
    }

    /// Draws the range between the smallest and the greatest force, interrupted where nothing was recorded.
    void drawForce()
    {
        const double width_s = m_duration_s / static_cast<double>(m_force.spans.size());
        QPolygonF upper, lower;
        const auto flush = [&] {
            std::reverse(lower.begin(), lower.end());
            m_painter.setPen(QPen(kCurve, 0.7 * m_unit, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
            m_painter.setBrush(kCurve);
            m_painter.drawPolygon(upper + lower);
            upper.clear();
            lower.clear();
        };
        for (std::size_t i = 0; i < m_force.spans.size(); ++i) {
            const study::ForceCurve::Span& span = m_force.spans[i];
            if (!span.isRecorded) {
                flush();
                continue;
            }
            const double at = x((static_cast<double>(i) + 0.5) * width_s);
            upper << QPointF(at, y(span.greatest_N));
            lower << QPointF(at, y(span.least_N));
        }
        flush();
    }

    /// Draws a line for each finding, and its number where that has room.
    void drawMarks()
    {
        const QFontMetricsF metrics(m_painter.font());
        double free = m_in.left();
        for (const study::ForceCurve::Mark& mark : m_force.marks) {
            const double at = x(std::clamp(mark.time_s, 0.0, m_duration_s));
            m_painter.setPen(QPen(kMark, 0.7 * m_unit));
            m_painter.drawLine(QPointF(at, m_plot.top()), QPointF(at, m_plot.bottom()));
            const QString number = QLocale().toString(static_cast<qulonglong>(mark.number));
            const double half = 0.5 * metrics.horizontalAdvance(number) + 1.5 * m_unit;
            if (at - half >= free) {
                m_painter.drawText(QRectF(at - half, m_plot.top() - 12.0 * m_unit, 2.0 * half, 12.0 * m_unit),
                                   Qt::AlignHCenter | Qt::AlignBottom, number);
                free = at + half;
            }
        }
    }

    QPainter& m_painter;
    const study::ForceCurve& m_force;
    double m_unit;
    QRectF m_plot, m_in;
    double m_most_N = 0.0, m_step_N = 1.0, m_duration_s = 1.0;
};

} // namespace

QString reportText(const core::MessageArgument& text)
{
    QStringList lines;
    for (const QString& line : translated(text).split(QLatin1Char('\n'))) {
        lines << QString::fromStdString(core::visible(line.toStdString()));
    }
    return lines.join(QLatin1Char('\n'));
}

QFont reportFont(double size_pt, double unit, bool isBold)
{
    QFont font = QFontDatabase::systemFont(QFontDatabase::GeneralFont);
    font.setPixelSize(std::max(1, static_cast<int>(std::lround(size_pt * unit))));
    font.setBold(isBold);
    font.setLetterSpacing(QFont::AbsoluteSpacing, 0.02); // no ligatures, which searching in a PDF would not find
    return font;
}

void drawForceCurve(QPainter& painter, const QRectF& in, const study::ForceCurve& force, double unit)
{
    painter.save();
    CurvePicture(painter, in, force, unit).draw();
    painter.restore();
}

} // namespace internal

std::optional<ReportFormat> reportFormatOf(const std::filesystem::path& path)
{
    const QString extension = QString::fromStdString(path.extension().string()).toLower();
    if (extension == QLatin1String(".pdf")) {
        return ReportFormat::Pdf;
    }
    return extension == QLatin1String(".html") || extension == QLatin1String(".htm") ? std::optional(ReportFormat::Html)
                                                                                     : std::nullopt;
}

core::Status writeReport(const std::filesystem::path& path, const study::Report& report,
                         const std::vector<QImage>& pictures)
{
    const auto format = reportFormatOf(path);
    if (!format) {
        return {core::StatusCode::BadCommandLine,
                PALPATE_TEXT("%1: found another extension, expected a name that ends in .pdf or .html"), path};
    }
    const QByteArray bytes = format == ReportFormat::Pdf ? reportPdf(report, pictures) : reportHtml(report, pictures);
    return core::writeAtomically(path, {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

} // namespace palpate::ui

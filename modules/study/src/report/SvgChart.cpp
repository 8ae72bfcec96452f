// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/SvgChart.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace palpate::study {

namespace {

constexpr double kLeft = 74, kRight = 22, kTop = 18, kBottom = 54;

template<class... Args>
std::string svgText(const char* format, Args... args)
{
    char buffer[1024];
    std::snprintf(buffer, sizeof buffer, format, args...);
    return buffer;
}

} // namespace

SvgChart::SvgChart(int width, int height, ChartAxis x, ChartAxis y)
    : m_width(width)
    , m_height(height)
    , m_x(std::move(x))
    , m_y(std::move(y))
{
    const double right = m_width - kRight, bottom = m_height - kBottom;
    for (const double t : m_x.ticks()) {
        m_back += svgText("<line class='grid' x1='%.1f' y1='%.1f' x2='%.1f' y2='%.1f'/>", px(t), kTop, px(t), bottom);
        m_back += svgText("<text class='tick' x='%.1f' y='%.1f' text-anchor='middle'>", px(t), bottom + 20) +
                  shortNumber(t) + "</text>";
    }
    for (const double t : m_y.ticks()) {
        m_back += svgText("<line class='grid' x1='%.1f' y1='%.1f' x2='%.1f' y2='%.1f'/>", kLeft, py(t), right, py(t));
        m_back += svgText("<text class='tick' x='%.1f' y='%.1f' text-anchor='end'>", kLeft - 8, py(t) + 4) +
                  shortNumber(t) + "</text>";
    }
    m_back +=
        svgText("<text class='axis' x='%.1f' y='%.1f' text-anchor='middle'>", (kLeft + right) / 2, m_height - 10.0) +
        escaped(m_x.title) + "</text>";
    m_back += svgText("<text class='axis' transform='translate(16 %.1f) rotate(-90)' text-anchor='middle'>",
                      (kTop + bottom) / 2) +
              escaped(m_y.title) + "</text>";
}

double SvgChart::px(double x) const
{
    return kLeft + m_x.share(x) * (m_width - kLeft - kRight);
}

double SvgChart::py(double y) const
{
    return m_height - kBottom - m_y.share(y) * (m_height - kTop - kBottom);
}

void SvgChart::add(const Mark& mark)
{
    const double x = px(mark.x), y = py(mark.y), r = mark.isStrong ? 8.0 : 5.5;
    const std::string fill = mark.isHollow ? "#fff" : mark.colour;
    m_body += "<g><title>" + escaped(mark.tooltip) + "</title>";
    const double top = py(std::max(mark.y, mark.yEnd)), bottom = py(mark.yLow > 0.0 ? mark.yLow : mark.y);
    if (mark.yEnd > mark.y || (mark.yLow > 0.0 && mark.yLow < mark.y)) {
        m_body +=
            svgText("<path d='M%.1f %.1fV%.1fM%.1f %.1fh8M%.1f %.1fh8' stroke='%s' stroke-width='1.2' opacity='0.4' "
                    "fill='none'/>",
                    x, bottom, top, x - 4, top, x - 4, bottom, mark.colour.c_str());
        m_taken.push_back({x - 2, top, 4, bottom - top});
    }
    const double left = px(mark.xLow > 0.0 ? mark.xLow : mark.x), right = px(std::max(mark.x, mark.xEnd));
    if (mark.xEnd > mark.x || (mark.xLow > 0.0 && mark.xLow < mark.x)) {
        m_body +=
            svgText("<path d='M%.1f %.1fH%.1fM%.1f %.1fv8M%.1f %.1fv8' stroke='%s' stroke-width='1.2' opacity='0.4' "
                    "fill='none'/>",
                    left, y, right, left, y - 4, right, y - 4, mark.colour.c_str());
        m_taken.push_back({left, y - 2, right - left, 4});
    }
    const std::string style = svgText("fill='%s' stroke='%s' stroke-width='1.8'", fill.c_str(), mark.colour.c_str());
    switch (mark.shape) {
    case MarkShape::Circle:
        m_body += svgText("<circle cx='%.1f' cy='%.1f' r='%.1f' %s/>", x, y, r, style.c_str());
        break;
    case MarkShape::Square:
        m_body += svgText("<rect x='%.1f' y='%.1f' width='%.1f' height='%.1f' %s/>", x - 0.9 * r, y - 0.9 * r, 1.8 * r,
                          1.8 * r, style.c_str());
        break;
    case MarkShape::Diamond:
        m_body += svgText("<path d='M%.1f %.1fl%.1f %.1fl%.1f %.1fl%.1f %.1fz' %s/>", x, y - 1.2 * r, 1.2 * r, 1.2 * r,
                          -1.2 * r, 1.2 * r, -1.2 * r, -1.2 * r, style.c_str());
        break;
    case MarkShape::Triangle:
        m_body += svgText("<path d='M%.1f %.1fl%.1f %.1fh%.1fz' %s/>", x, y - 1.2 * r, 1.2 * r, 2.1 * r, -2.4 * r,
                          style.c_str());
        break;
    }
    m_body += "</g>";
    m_taken.push_back({x - r - 2, y - r - 2, 2 * r + 4, 2 * r + 4});
    if (!mark.label.empty()) {
        m_waiting.push_back({x, y, mark.label, mark.colour, mark.isStrong});
    }
}

void SvgChart::addLine(const std::vector<std::array<double, 2>>& points, std::string_view colour, double width_px,
                       bool isDashed, std::string_view label)
{
    if (points.empty()) {
        return;
    }
    m_back += "<polyline fill='none' stroke='" + std::string(colour) + svgText("' stroke-width='%.1f' ", width_px) +
              (isDashed ? "stroke-dasharray='5 4' " : "") + "stroke-linejoin='round' points='";
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double x = px(points[i][0]), y = py(points[i][1]);
        m_back += svgText("%.1f,%.1f ", x, y);
        if (const double before = i > 0 ? px(points[i - 1][0]) : x; x - before < 60.0) {
            m_taken.push_back({before, y - 2, x - before, 4});
        }
    }
    m_back += "'/>";
    if (!label.empty()) {
        m_waiting.push_back(
            {px(points.back()[0]), py(points.back()[1]), std::string(label), std::string(colour), false});
    }
}

void SvgChart::addRegion(const std::vector<std::array<double, 2>>& lower,
                         const std::vector<std::array<double, 2>>& upper, std::string_view colour)
{
    std::string corners;
    for (const auto& [x, y] : lower) {
        corners += svgText("%.1f,%.1f ", px(x), py(y));
    }
    for (auto point = upper.rbegin(); point != upper.rend(); ++point) {
        corners += svgText("%.1f,%.1f ", px((*point)[0]), py((*point)[1]));
    }
    m_back.insert(0, "<polygon fill='" + std::string(colour) + "' points='" + corners + "'/>");
}

void SvgChart::addBand(double yLow, double yHigh, std::string_view colour)
{
    m_back.insert(0, svgText("<rect x='%.1f' y='%.1f' width='%.1f' height='%.1f' fill='%s'/>", kLeft, py(yHigh),
                             m_width - kLeft - kRight, py(yLow) - py(yHigh), std::string(colour).c_str()));
}

void SvgChart::addVerticalRule(double x, std::string_view label)
{
    m_back +=
        svgText("<line class='rule' x1='%.1f' y1='%.1f' x2='%.1f' y2='%.1f'/>", px(x), kTop, px(x), m_height - kBottom);
    m_labels +=
        svgText("<text class='ruleText' x='%.1f' y='%.1f' text-anchor='end'>", px(x) - 6, m_height - kBottom - 8) +
        escaped(label) + "</text>";
    m_taken.push_back(
        {px(x) - 6 - 6.4 * double(label.size()), m_height - kBottom - 20, 6.4 * double(label.size()), 16});
    m_taken.push_back({px(x) - 1, kTop, 2, m_height - kTop - kBottom});
}

void SvgChart::addHorizontalRule(double y, std::string_view label)
{
    m_back +=
        svgText("<line class='rule' x1='%.1f' y1='%.1f' x2='%.1f' y2='%.1f'/>", kLeft, py(y), m_width - kRight, py(y));
    const double width = 6.4 * double(label.size()), right = m_width - kRight - 8;
    m_labels += svgText("<text class='ruleText' x='%.1f' y='%.1f' text-anchor='end'>", right, py(y) - 6) +
                escaped(label) + "</text>";
    m_taken.push_back({right - width, py(y) - 18, width, 16});
}

void SvgChart::addBar(double xLow, double xHigh, double y, std::string_view colour, std::string_view tooltip)
{
    const double top = py(y), bottom = m_height - kBottom;
    m_body +=
        svgText("<rect x='%.1f' y='%.1f' width='%.1f' height='%.1f' fill='%s'>", px(xLow) + 1, top,
                std::max(1.0, px(xHigh) - px(xLow) - 2), std::max(0.0, bottom - top), std::string(colour).c_str()) +
        "<title>" + escaped(tooltip) + "</title></rect>";
}

/// Places a label next to its mark at the first free position, trying positions at increasing distance.
void SvgChart::placeLabel(double x, double y, const std::string& label, std::string_view colour, bool isStrong)
{
    std::size_t letters = 0;
    for (const char c : label) {
        letters += (static_cast<unsigned char>(c) & 0xc0) != 0x80 ? 1 : 0;
    }
    const double w = (isStrong ? 7.8 : 6.7) * double(letters), h = isStrong ? 17 : 15;
    Rectangle best{x + 12, y - h / 2, w, h};
    double bestCost = std::numeric_limits<double>::infinity();
    for (const double d : {12.0, 20.0, 32.0, 46.0, 62.0}) {
        const std::array<Rectangle, 8> places{{{x + d, y - h / 2, w, h},
                                               {x - d - w, y - h / 2, w, h},
                                               {x - w / 2, y - d - h, w, h},
                                               {x - w / 2, y + d, w, h},
                                               {x + 0.7 * d, y - 0.7 * d - h, w, h},
                                               {x + 0.7 * d, y + 0.7 * d, w, h},
                                               {x - 0.7 * d - w, y - 0.7 * d - h, w, h},
                                               {x - 0.7 * d - w, y + 0.7 * d, w, h}}};
        for (const Rectangle& r : places) {
            double cost = 0.02 * d;
            if (r.x < kLeft + 2 || r.x + r.w > m_width - 4 || r.y < 2 || r.y + r.h > m_height - kBottom - 2) {
                cost += 1e6;
            }
            for (const Rectangle& t : m_taken) {
                const double ow = std::min(r.x + r.w, t.x + t.w) - std::max(r.x, t.x);
                const double oh = std::min(r.y + r.h, t.y + t.h) - std::max(r.y, t.y);
                cost += ow > 0 && oh > 0 ? ow * oh : 0.0;
            }
            if (cost < bestCost) {
                bestCost = cost;
                best = r;
            }
        }
    }
    m_taken.push_back(best);
    const double cx = std::clamp(x, best.x, best.x + best.w), cy = std::clamp(y, best.y, best.y + best.h);
    if (std::hypot(cx - x, cy - y) > 16.0) {
        m_labels +=
            svgText("<line x1='%.1f' y1='%.1f' x2='%.1f' y2='%.1f' stroke='%s' stroke-width='0.8' opacity='0.6'/>", x,
                    y, cx, cy, std::string(colour).c_str());
    }
    m_labels += svgText("<text class='%s' x='%.1f' y='%.1f' fill='%s'>", isStrong ? "label strong" : "label", best.x,
                        best.y + h - 4, std::string(colour).c_str()) +
                escaped(label) + "</text>";
}

std::string SvgChart::svg(std::string_view description) const
{
    SvgChart placed = *this;
    for (const Waiting& w : m_waiting) {
        placed.placeLabel(w.x, w.y, w.text, w.colour, w.isStrong);
    }
    return svgText("<svg viewBox='0 0 %d %d' role='img' xmlns='http://www.w3.org/2000/svg'><title>", m_width,
                   m_height) +
           escaped(description) + "</title>" + placed.m_back + placed.m_body + placed.m_labels + "</svg>";
}

} // namespace palpate::study

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/ColourLegend.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCoordinate.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace palpate::view {

namespace {

constexpr int kColourRows = 10; // rows of colours, interpolated linearly
constexpr double kBarLeft_px = 20.0, kBarWidth_px = 16.0, kBarHeight_px = 160.0;
constexpr double kLeastHeight_px = 50.0, kTitleLine = 1.5; // height of a line of the title, in letters
constexpr double kGreyHeight_px = 16.0, kBeside_px = 8.0;
constexpr double kLineSpacing = 1.35;                      // line spacing between marks, in letters
constexpr double kLead_px = 14.0, kBriefLead_px = 5.0;     // from the bar to the text of a mark
constexpr double kMostWidth = 0.36, kLeastLetter_px = 9.0; // fraction of the view; smallest font size
constexpr double kAboveCube_px = 28.0, kAboveGrey_px = 12.0;

/// Column of quads with a colour per row boundary.
vtkSmartPointer<vtkPolyData> columnShape(int rows, const vtkSmartPointer<vtkUnsignedCharArray>& colours)
{
    vtkNew<vtkPoints> points;
    points->SetNumberOfPoints(2 * rows);
    vtkNew<vtkCellArray> quads;
    for (vtkIdType row = 0; row + 1 < rows; ++row) {
        const vtkIdType quad[4] = {2 * row, 2 * row + 1, 2 * row + 3, 2 * row + 2};
        quads->InsertNextCell(4, quad);
    }
    auto shape = vtkSmartPointer<vtkPolyData>::New();
    shape->SetPoints(points);
    shape->SetPolys(quads);
    shape->GetPointData()->SetScalars(colours);
    return shape;
}

vtkSmartPointer<vtkActor2D> makeColumn(int rows, const vtkSmartPointer<vtkUnsignedCharArray>& colours)
{
    vtkNew<vtkCoordinate> pixels;
    pixels->SetCoordinateSystemToViewport();
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(columnShape(rows, colours));
    mapper->SetTransformCoordinate(pixels);
    auto actor = vtkSmartPointer<vtkActor2D>::New();
    actor->SetMapper(mapper);
    actor->VisibilityOff();
    return actor;
}

/// Places a column. @param box  left, right, bottom, top in device pixels
/// @param steps  number of colours with two rows each; 0: rows at equal distances
void placeColumn(vtkActor2D& column, int rows, const std::array<double, 4>& box, int steps = 0)
{
    auto* shape = vtkPolyDataMapper2D::SafeDownCast(column.GetMapper())->GetInput();
    for (vtkIdType row = 0; row < rows; ++row) {
        const double share = steps > 0 ? static_cast<double>((row + 1) / 2) / steps // the next step begins at the end
                                       : static_cast<double>(row) / (rows - 1);
        const double y = box[2] + (box[3] - box[2]) * share;
        shape->GetPoints()->SetPoint(2 * row, box[0], y, 0.0);
        shape->GetPoints()->SetPoint(2 * row + 1, box[1], y, 0.0);
    }
    shape->GetPoints()->Modified();
    shape->Modified();
}

template<class ColourAt>
vtkSmartPointer<vtkUnsignedCharArray> colourRows(int rows, ColourAt&& colourAt)
{
    auto colours = vtkSmartPointer<vtkUnsignedCharArray>::New();
    colours->SetNumberOfComponents(3);
    for (int row = 0; row < rows; ++row) {
        const Colour colour = colourAt(static_cast<double>(row) / (rows - 1));
        for (int side = 0; side < 2; ++side) {
            colours->InsertNextTuple3(std::round(255.0 * colour[0]), std::round(255.0 * colour[1]),
                                      std::round(255.0 * colour[2]));
        }
    }
    return colours;
}

vtkSmartPointer<vtkActor2D> makeLines()
{
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    vtkNew<vtkPolyData> shape;
    shape->SetPoints(points);
    shape->SetLines(lines);
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetNumberOfComponents(3);
    shape->GetCellData()->SetScalars(colours);
    vtkNew<vtkCoordinate> pixels;
    pixels->SetCoordinateSystemToViewport();
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(shape);
    mapper->SetTransformCoordinate(pixels);
    auto actor = vtkSmartPointer<vtkActor2D>::New();
    actor->SetMapper(mapper);
    actor->VisibilityOff();
    return actor;
}

/// Adds a line. @param from,to  device pixels
void addLine(vtkActor2D& actor, const std::array<double, 2>& from, const std::array<double, 2>& to,
             const Colour& colour)
{
    auto* shape = vtkPolyDataMapper2D::SafeDownCast(actor.GetMapper())->GetInput();
    shape->GetLines()->InsertNextCell(2);
    for (const auto& [x, y] : {from, to}) {
        shape->GetLines()->InsertCellPoint(shape->GetPoints()->InsertNextPoint(x, y, 0.0));
    }
    vtkUnsignedCharArray::SafeDownCast(shape->GetCellData()->GetScalars())
        ->InsertNextTuple3(std::round(255.0 * colour[0]), std::round(255.0 * colour[1]), std::round(255.0 * colour[2]));
}

std::string number(double value, const char* before, const std::string& decimalPoint)
{
    return before + shortText(value, 3, decimalPoint);
}

} // namespace

ColourLegend::ColourLegend()
    : m_back(makeColumn(2, colourRows(2, [](double) { return kTextGround; })))
    , m_bar(makeColumn(kColourRows, colourRows(kColourRows, [](double t) { return surfaceColour(t); })))
    , m_grey(makeColumn(2, colourRows(2, [](double) { return kUnknownColour; })))
    , m_lines(makeLines())
{
    for (auto& text : m_texts) {
        text = vtkSmartPointer<vtkTextActor>::New();
        text->GetTextProperty()->SetVerticalJustificationToCentered();
        text->GetTextProperty()->SetColor(kTextColour[0], kTextColour[1], kTextColour[2]);
        text->VisibilityOff();
    }
    m_texts[0]->GetTextProperty()->SetVerticalJustificationToBottom();
    m_texts[0]->GetTextProperty()->SetLineSpacing(kLineSpacing);
    for (auto& text : m_markTexts) {
        text = vtkSmartPointer<vtkTextActor>::New();
        text->GetTextProperty()->SetVerticalJustificationToCentered();
        text->GetTextProperty()->SetColor(kTextColour[0], kTextColour[1], kTextColour[2]);
        text->VisibilityOff();
    }
    m_lines->GetProperty()->SetLineWidth(1.5F);
    m_close = vtkSmartPointer<vtkTextActor>::New();
    m_close->SetInput(" \u00d7 ");
    m_close->GetTextProperty()->SetVerticalJustificationToTop();
    m_close->GetTextProperty()->SetJustificationToRight();
    m_close->GetTextProperty()->SetColor(kTextColour[0], kTextColour[1], kTextColour[2]);
    m_close->GetTextProperty()->SetBackgroundColor(kTextGround[0], kTextGround[1], kTextGround[2]);
    m_close->GetTextProperty()->SetBackgroundOpacity(1.0);
    m_close->VisibilityOff();
}

void ColourLegend::addTo(vtkRenderer& renderer)
{
    renderer.AddActor2D(m_back);
    renderer.AddActor2D(m_bar);
    renderer.AddActor2D(m_grey);
    renderer.AddActor2D(m_lines);
    for (const auto& text : m_texts) {
        renderer.AddActor2D(text);
    }
    for (const auto& text : m_markTexts) {
        renderer.AddActor2D(text);
    }
    renderer.AddActor2D(m_close);
}

void ColourLegend::show(const Content& content)
{
    const std::size_t marksBefore = m_hasContent ? m_marks.size() : kMaxMarks + 1;
    m_content = content;
    m_hasContent = true;
    m_hasUnknown = content.range.hasUnknown;
    m_range = content.range;
    m_marks = content.marks;
    m_marks.resize(std::min(m_marks.size(), kMaxMarks));
    m_revision += m_marks.size() != marksBefore ? 1 : 0;
    m_steps = static_cast<int>(content.steps.size());
    const int rows = m_steps > 0 ? 2 * m_steps : kColourRows;
    const auto colourAt = [&content](double t) {
        const std::size_t count = content.steps.size();
        return count == 0
                   ? surfaceColour(t)
                   : content.steps[std::min(count - 1, static_cast<std::size_t>(t * static_cast<double>(count)))];
    };
    vtkPolyDataMapper2D::SafeDownCast(m_bar->GetMapper())->SetInputData(columnShape(rows, colourRows(rows, colourAt)));
    write();
    setVisibilities();
}

/// Sets the texts of the full or the brief form.
void ColourLegend::write()
{
    const auto either = [this](const std::string& text, const std::string& brief) {
        return m_isBrief && !brief.empty() ? brief.c_str() : text.c_str();
    };
    const ColourRange& range = m_range;
    const std::string& point = m_content.decimalPoint;
    const bool isOne = !(range.high > range.low);
    m_texts[0]->SetInput(either(m_content.title, m_content.briefTitle));
    m_texts[1]->SetInput(isOne ? "" : number(range.high, range.isHighCut ? "\u2265 " : "", point).c_str());
    m_texts[2]->SetInput(number(0.5 * (range.low + range.high), "", point).c_str());
    m_texts[3]->SetInput(isOne ? "" : number(range.low, range.isLowCut ? "\u2264 " : "", point).c_str());
    m_texts[4]->SetInput(either(m_content.unknown, m_content.briefUnknown));
    for (std::size_t i = 0; i < m_markTexts.size(); ++i) {
        m_markTexts[i]->SetInput(i < m_marks.size() ? either(m_marks[i].text, m_marks[i].brief) : "");
    }
}

void ColourLegend::setVisibilities()
{
    const bool isShown = m_hasContent && !m_isClosed;
    m_back->SetVisibility(isShown);
    m_bar->SetVisibility(isShown);
    m_grey->SetVisibility(isShown && m_hasUnknown);
    m_lines->SetVisibility(isShown && !m_marks.empty());
    m_close->SetVisibility(isShown && m_isHovered);
    for (const auto& text : m_texts) {
        text->SetVisibility(isShown);
    }
    m_texts[4]->SetVisibility(isShown && m_hasUnknown);
    for (std::size_t i = 1; i < 4; ++i) {
        m_texts[i]->SetVisibility(isShown && m_marks.empty());
    }
    for (std::size_t i = 0; i < m_markTexts.size(); ++i) {
        m_markTexts[i]->SetVisibility(isShown && i < m_marks.size());
    }
}

void ColourLegend::hide()
{
    m_hasContent = false;
    setVisibilities();
}

void ColourLegend::setClosed(bool isClosed)
{
    m_isClosed = isClosed;
    setVisibilities();
}

void ColourLegend::setBrief(bool isBrief)
{
    if (isBrief != m_isBrief) {
        m_isBrief = isBrief;
        write();
    }
}

void ColourLegend::setHovered(bool isHovered)
{
    m_isHovered = isHovered;
    setVisibilities();
}

std::array<std::string, 5> ColourLegend::texts() const
{
    std::array<std::string, 5> texts;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        texts[i] = m_texts[i]->GetVisibility() != 0 && m_texts[i]->GetInput() != nullptr ? m_texts[i]->GetInput() : "";
    }
    return texts;
}

std::vector<std::string> ColourLegend::markTexts() const
{
    std::vector<std::string> texts;
    for (std::size_t i = 0; isShown() && i < m_marks.size(); ++i) {
        texts.push_back(m_marks[i].text);
    }
    return texts;
}

/// Height of a bar with room for the texts of the marks. [device px]
double ColourLegend::heightWithMarks(double letter) const
{
    return kLineSpacing * letter * (static_cast<double>(m_marks.size()) + 1.0);
}

/// Length of the lines from the bar to the texts of the marks. [logical px]
double ColourLegend::lead_px() const noexcept
{
    return m_isBrief ? kBriefLead_px : kLead_px;
}

/// Height of the title. [device px]
double ColourLegend::titleHeight(double letter) const
{
    const std::string_view title(m_texts[0]->GetInput());
    return kTitleLine * letter * static_cast<double>(1 + std::count(title.begin(), title.end(), '\n'));
}

/// Places the texts of the marks at their values, spread apart where the values are close together.
void ColourLegend::placeMarks(const Place& at)
{
    const double apart = kLineSpacing * at.letter, width = m_range.high - m_range.low;
    std::vector<double> tick, beside;
    for (const Mark& mark : m_marks) {
        const double share = width > 0.0 ? std::clamp((mark.value - m_range.low) / width, 0.0, 1.0) : 0.0;
        tick.push_back(at.low + share * (at.high - at.low));
        beside.push_back(beside.empty() ? tick.back() : std::max(tick.back(), beside.back() + apart));
    }
    for (std::size_t i = beside.size(); i-- > 0;) {
        beside[i] = std::min(beside[i], i + 1 < beside.size() ? beside[i + 1] - apart : at.high);
    }
    const double end = at.right + lead_px() * at.pixelRatio;
    for (std::size_t i = 0; i < m_marks.size(); ++i) {
        if (m_steps == 0) {
            addLine(*m_lines, {at.left, tick[i]}, {at.right, tick[i]}, kTextGround);
        }
        addLine(*m_lines, {at.right, tick[i]}, {end, beside[i]}, kTextColour);
        m_markTexts[i]->SetPosition(end + 0.5 * kBeside_px * at.pixelRatio, beside[i]);
    }
}

/// Draws the leader lines of the marks and the hatching.
void ColourLegend::placeLines(const Place& at)
{
    auto* shape = vtkPolyDataMapper2D::SafeDownCast(m_lines->GetMapper())->GetInput();
    shape->GetPoints()->Reset();
    shape->GetLines()->Reset();
    shape->GetCellData()->GetScalars()->Reset();
    placeMarks(at);
    for (int step = 1; step < m_steps; ++step) {
        const double y = at.low + (at.high - at.low) * step / m_steps;
        addLine(*m_lines, {at.left, y}, {at.right, y}, kTextGround);
    }
    const double wide = at.right - at.left, high = at.greyHigh - at.greyLow;
    for (const double share : {-0.5, 0.0, 0.5}) {
        const double from = std::max(0.0, -share), to = std::min(1.0, 1.0 - share);
        if (m_hasUnknown) {
            addLine(*m_lines, {at.left + from * wide, at.greyLow + (1.0 - from - share) * high},
                    {at.left + to * wide, at.greyLow + (1.0 - to - share) * high}, kTextGround);
        }
    }
    shape->GetPoints()->Modified();
    shape->GetLines()->Modified();
    shape->GetCellData()->GetScalars()->Modified();
    shape->Modified();
}

/// Extent of the widest text, from the left edge of the bar. [device px]
double ColourLegend::reach(vtkRenderer& renderer, const TextStyle& style, double pixelRatio)
{
    double reach = 0.0, size[2] = {0.0, 0.0};
    const auto take = [&](vtkTextActor& text, double from_px) {
        setFont(*text.GetTextProperty(), style, TextUse::Usual, pixelRatio);
        text.GetSize(&renderer, size);
        reach = std::max(reach, pixelRatio * from_px + size[0]);
    };
    take(*m_texts[0], 0.0);
    for (std::size_t i = m_marks.empty() ? 1 : 4; i < m_texts.size(); ++i) {
        take(*m_texts[i], kBarWidth_px + kBeside_px);
    }
    for (const auto& text : m_markTexts) {
        take(*text, kBarWidth_px + lead_px() + 0.5 * kBeside_px);
    }
    return reach;
}

/// Reduces the font size until the texts of the marks fit above `below_px` without overlaps and the legend leaves
/// most of the view's width to the tissue. @param height  of the part of the view that is not covered [device px]
TextStyle ColourLegend::fitting(vtkRenderer& renderer, const ViewFrame& frame, double below_px, double height)
{
    TextStyle style = frame.text;
    const double r = frame.pixelRatio;
    const double letter = letterSize_px(style, TextUse::Usual, r);
    const double apart = r * (2.0 * kAboveGrey_px + kBeside_px); // independent of the font size
    const double words = std::max(r * kGreyHeight_px, letter) + titleHeight(letter) + heightWithMarks(letter);
    const double room = height - r * below_px - apart;
    const double beside = r * (kBarWidth_px + lead_px() + kBeside_px); // independent of the font size
    const double wide = reach(renderer, style, r) - beside;
    const double across = kMostWidth * renderer.GetSize()[0] - r * kBarLeft_px - beside;
    const double least = std::min(1.0, kLeastLetter_px / style.size_px); // readability has priority over width
    style.size_px *= std::min(std::clamp(room / words, 0.3, 1.0), std::clamp(across / wide, least, 1.0));
    return style;
}

void ColourLegend::place(vtkRenderer& renderer, const ViewFrame& frame, const Below& below)
{
    if (!isShown()) {
        return;
    }
    const double r = frame.pixelRatio;
    const bool isRight = m_corner == Corner::LowerRight || m_corner == Corner::UpperRight;
    const bool isUpper = m_corner == Corner::UpperLeft || m_corner == Corner::UpperRight;
    const double covered_px = isRight ? below.coveredRight_px : below.coveredLeft_px;
    const double height = renderer.GetSize()[1] - r * covered_px;
    const double below_px = (isRight ? below.scale_px : below.cube_px) + kAboveCube_px;
    const TextStyle style = m_marks.empty() ? frame.text : fitting(renderer, frame, below_px, height);
    const double letter = letterSize_px(style, TextUse::Usual, r);
    const double margin = r * kBarLeft_px, room = r * kBeside_px;
    const double farRight = renderer.GetSize()[0] - margin - reach(renderer, style, r);
    const double greyHeight = std::max(r * kGreyHeight_px, letter);
    const double rest = greyHeight + 2.0 * r * kAboveGrey_px + titleHeight(letter) + 2.0 * room;
    const double most = m_marks.empty() ? std::max(r * kBarHeight_px, 6.0 * letter) : heightWithMarks(letter);
    double greyLow = r * below_px;
    // The bar is shorter in a low view.
    const double bar =
        std::clamp(height - greyLow - rest, std::min(most, std::max(r * kLeastHeight_px, 3.0 * letter)), most);
    const double highest = std::max(greyLow, height - rest - bar);
    greyLow = std::clamp((isUpper ? highest : greyLow) + r * m_offset_px.y(), std::min(room, greyLow), highest);
    const double left =
        std::clamp((isRight ? farRight : margin) + r * m_offset_px.x(), margin, std::max(margin, farRight));
    const double right = left + r * kBarWidth_px;
    const double greyHigh = greyLow + greyHeight, low = greyHigh + r * kAboveGrey_px, high = low + bar;
    placeColumn(*m_bar, m_steps > 0 ? 2 * m_steps : kColourRows, {left, right, low, high}, m_steps);
    placeColumn(*m_grey, 2, {left, right, greyLow, greyHigh});
    const double beside = right + room;
    m_texts[0]->SetPosition(left, high + kAboveGrey_px * r);
    m_texts[1]->SetPosition(beside, high);
    m_texts[2]->SetPosition(beside, 0.5 * (low + high));
    m_texts[3]->SetPosition(beside, low);
    m_texts[4]->SetPosition(beside, 0.5 * (greyLow + greyHigh));
    double end = right, top = high;
    for (const auto& text : m_texts) {
        setFont(*text->GetTextProperty(), style, TextUse::Usual, r);
        if (text->GetVisibility() != 0) {
            double size[2] = {0.0, 0.0};
            text->GetSize(&renderer, size);
            end = std::max(end, text->GetPosition()[0] + size[0]);
            top = std::max(top, text->GetPosition()[1] + (text == m_texts[0] ? size[1] : 0.0));
        }
    }
    if (!m_marks.empty()) {
        placeLines({left, right, low, high, greyLow, greyHigh, r, letter});
    }
    for (std::size_t i = 0; i < m_marks.size(); ++i) {
        double size[2] = {0.0, 0.0};
        setFont(*m_markTexts[i]->GetTextProperty(), style, TextUse::Usual, r);
        m_markTexts[i]->GetSize(&renderer, size);
        end = std::max(end, m_markTexts[i]->GetPosition()[0] + size[0]);
    }
    m_back->GetProperty()->SetOpacity(frame.text.groundOpacity);
    const double bottom = (m_hasUnknown ? greyLow : low) - room;
    placeColumn(*m_back, 2, {left - room, end + room, bottom, top + room});
    const Eigen::Vector2d middle(0.5 * renderer.GetSize()[0], 0.5 * renderer.GetSize()[1]);
    const auto boxOf = [&](const Eigen::Vector2d& lowerLeft, const Eigen::Vector2d& upperRight) {
        return Eigen::AlignedBox2d((lowerLeft - middle) / r, (upperRight - middle) / r);
    };
    const Eigen::Vector2d corner(end + room, top + room);
    m_box = boxOf({left - room, bottom}, corner);
    setFont(*m_close->GetTextProperty(), style, TextUse::Usual, r);
    m_close->SetPosition(corner.x(), corner.y());
    m_closeBox = boxOf(corner - Eigen::Vector2d::Constant(2.0 * letter), corner);
}

} // namespace palpate::view

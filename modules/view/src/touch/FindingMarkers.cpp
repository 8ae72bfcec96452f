// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/view/FindingMarkers.h"

#include "touch/MarkerShapes.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkRenderWindow.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkTexture.h>
#include <vtkTexturedActor2D.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace palpate::view {

namespace {

using Pixel = Eigen::Vector2d;

constexpr double kRim_px = 1.5;
constexpr double kHollow_px = 2.4; // line width of hollow shapes
constexpr double kLeader_px = 1.6;
constexpr int kAtlasHeight_px = 2048; // texture height that every OpenGL implementation supports

/// Colour of one pixel.
std::array<unsigned char, 4> rgba(const Colour& colour, double opacity)
{
    const auto byte = [](double share) { return static_cast<unsigned char>(std::lround(255.0 * share)); };
    return {byte(colour[0]), byte(colour[1]), byte(colour[2]), byte(opacity)};
}

/// Flat triangles in pixels from the centre of the view, drawn in insertion order.
class Flat
{
  public:
    Flat()
    {
        m_colours->SetNumberOfComponents(4);
        m_colours->SetName("colours");
        m_places->SetNumberOfComponents(2);
        m_data->SetPoints(m_points);
        m_data->SetPolys(m_faces);
        m_data->GetPointData()->SetScalars(m_colours);
        m_mapper->SetInputData(m_data);
        m_actor->SetMapper(m_mapper);
        m_actor->PickableOff();
    }
    [[nodiscard]] vtkTexturedActor2D& actor() { return *m_actor; }

    void clear()
    {
        m_points->Reset();
        m_faces->Reset();
        m_colours->Reset();
        m_places->Reset();
    }
    void add(const Pixel& a, const Pixel& b, const Pixel& c, const std::array<unsigned char, 4>& colour)
    {
        const vtkIdType corners[3] = {point(a, colour), point(b, colour), point(c, colour)};
        m_faces->InsertNextCell(3, corners);
    }
    void addQuad(const std::array<Pixel, 4>& p, const std::array<unsigned char, 4>& colour)
    {
        add(p[0], p[1], p[2], colour);
        add(p[0], p[2], p[3], colour);
    }
    /// Adds a textured rectangle. @param low,high  texture coordinates of the corners, 0 to 1
    void addTextured(const std::array<Pixel, 4>& p, const Pixel& low, const Pixel& high,
                     const std::array<unsigned char, 4>& colour)
    {
        vtkIdType corners[4];
        const Pixel t[4] = {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
        for (std::size_t i = 0; i < 4; ++i) {
            corners[i] = point(p[i], colour);
            m_places->InsertNextTuple2(t[i].x(), t[i].y());
        }
        const vtkIdType triangles[2][3] = {{corners[0], corners[1], corners[2]}, {corners[0], corners[2], corners[3]}};
        m_faces->InsertNextCell(3, triangles[0]);
        m_faces->InsertNextCell(3, triangles[1]);
    }
    void setTexture(vtkImageData* image)
    {
        m_data->GetPointData()->SetTCoords(m_places);
        m_texture->SetInputData(image);
        m_actor->SetTexture(m_texture);
    }
    void finish(bool isVisible)
    {
        m_points->Modified();
        m_faces->Modified();
        m_colours->Modified();
        m_places->Modified();
        m_data->Modified();
        m_actor->SetVisibility(isVisible && m_points->GetNumberOfPoints() > 0);
    }

  private:
    vtkIdType point(const Pixel& p, const std::array<unsigned char, 4>& colour)
    {
        m_colours->InsertNextTypedTuple(colour.data());
        return m_points->InsertNextPoint(p.x(), p.y(), 0.0);
    }

    vtkNew<vtkPoints> m_points;
    vtkNew<vtkCellArray> m_faces;
    vtkNew<vtkUnsignedCharArray> m_colours;
    vtkNew<vtkFloatArray> m_places;
    vtkNew<vtkPolyData> m_data;
    vtkNew<vtkPolyDataMapper2D> m_mapper;
    vtkNew<vtkTexture> m_texture;
    vtkNew<vtkTexturedActor2D> m_actor;
};

std::array<Pixel, 4> rectangle(const Pixel& middle, const Pixel& half)
{
    return {middle - half, middle + Pixel(half.x(), -half.y()), middle + half, middle + Pixel(-half.x(), half.y())};
}

/// Adds the band between two scaled copies of an outline.
void addBand(Flat& flat, const Pixel& middle, const std::vector<Pixel>& outline, double inner, double outer,
             double ratio, const std::array<unsigned char, 4>& colour)
{
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Pixel a = ratio * outline[i];
        const Pixel b = ratio * outline[(i + 1) % outline.size()];
        flat.addQuad({middle + inner * a, middle + outer * a, middle + outer * b, middle + inner * b}, colour);
    }
}

void addShape(Flat& flat, const Pixel& middle, core::FindingType type, bool isHidden, double ratio)
{
    const std::vector<Pixel>& outline = internal::markerOutline(type);
    const double radius_px = outline.front().norm();
    const double rim = 1.0 + kRim_px / radius_px;
    const Colour colour = core::kFindingColours[static_cast<std::size_t>(type)];
    if (isHidden) {
        const double inner = 1.0 - kHollow_px / radius_px;
        addBand(flat, middle, outline, inner, 1.0, ratio, rgba(colour, FindingMarkers::kHiddenOpacity));
        return;
    }
    const bool isRing = type == core::FindingType::Other;
    addBand(flat, middle, outline, isRing ? 0.28 : 0.0, rim, ratio, rgba(kDarkRim, 1.0));
    addBand(flat, middle, outline, isRing ? 0.5 : 0.0, 1.0, ratio, rgba(colour, 1.0));
}

bool areSame(const std::vector<Eigen::AlignedBox2d>& a, const std::vector<Eigen::AlignedBox2d>& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const auto& one, const auto& other) { return one.isApprox(other, 0.0); });
}

void addLine(Flat& flat, const Pixel& from, const Pixel& to, double width_px,
             const std::array<unsigned char, 4>& colour)
{
    const Pixel along = (to - from).normalized();
    const Pixel across = 0.5 * width_px * Pixel(-along.y(), along.x());
    flat.addQuad({from - across, to - across, to + across, from + across}, colour);
}

} // namespace

/// Geometry: shapes with leader lines and text backgrounds, then the texts from a single texture atlas.
class FindingMarkers::Picture
{
  public:
    /// Rectangle of a text in the atlas, in pixels.
    struct Piece
    {
        int x = 0, y = 0, width = 0, height = 0;
    };
    Flat shapes;
    Flat texts;
    std::vector<Piece> pieces; ///< per mark; zero width: no text
    Pixel atlasSize = Pixel::Ones();

    /// Renders texts into one image, stacked in columns.
    void write(const std::vector<std::string>& words, const TextStyle& text, double pixelRatio, int dpi)
    {
        vtkNew<vtkTextProperty> style;
        setFont(*style, text, TextUse::Usual, pixelRatio);
        style->SetColor(1.0, 1.0, 1.0);
        pieces.assign(words.size(), {});
        std::vector<vtkSmartPointer<vtkImageData>> images(words.size());
        int x = 0, y = 0, wide = 0, high = 1;
        for (std::size_t i = 0; i < words.size(); ++i) {
            if (words[i].empty()) {
                continue;
            }
            int size[2] = {0, 0};
            images[i] = vtkSmartPointer<vtkImageData>::New();
            if (!vtkTextRenderer::GetInstance()->RenderString(style, vtkStdString(words[i]), images[i], size, dpi)) {
                continue;
            }
            if (y + size[1] > kAtlasHeight_px && y > 0) {
                x += wide + 1;
                y = wide = 0;
            }
            pieces[i] = {x, y, size[0], size[1]};
            y += size[1] + 1;
            wide = std::max(wide, size[0]);
            high = std::max(high, y);
        }
        vtkNew<vtkImageData> atlas;
        atlas->SetDimensions(std::max(1, x + wide), high, 1);
        atlas->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
        auto* out = static_cast<unsigned char*>(atlas->GetScalarPointer());
        const int stride = 4 * std::max(1, x + wide);
        std::fill_n(out, static_cast<std::size_t>(stride) * static_cast<std::size_t>(high), 0);
        for (std::size_t i = 0; i < words.size(); ++i) {
            const Piece& piece = pieces[i];
            for (int row = 0; row < piece.height; ++row) {
                const int* extent = images[i]->GetExtent();
                const auto* in = static_cast<const unsigned char*>(
                    images[i]->GetScalarPointer(extent[0], extent[2] + row, extent[4]));
                std::copy_n(in, 4 * piece.width, out + stride * (piece.y + row) + 4 * piece.x);
            }
        }
        atlasSize = Pixel(std::max(1, x + wide), high);
        texts.setTexture(atlas);
    }
};

FindingMarkers::FindingMarkers()
    : m_picture(std::make_unique<Picture>())
{
}

FindingMarkers::~FindingMarkers() = default; // the renderer keeps the actors alive

void FindingMarkers::addTo(vtkRenderer& overlay)
{
    m_overlay = &overlay;
    overlay.AddActor2D(&m_picture->shapes.actor());
    overlay.AddActor2D(&m_picture->texts.actor());
    m_picture->shapes.finish(false);
    m_picture->texts.finish(false);
}

void FindingMarkers::set(std::vector<FindingMark> marks)
{
    std::erase_if(marks, [](const FindingMark& one) { return !one.p_W.allFinite(); });
    m_marks = std::move(marks);
    m_rest_W.clear();
    for (const FindingMark& one : m_marks) {
        m_rest_W.push_back(one.p_W);
    }
    m_isHidden.assign(m_marks.size(), false);
    m_labels.assign(m_marks.size(), {});
    ++m_revision;
    m_pixelRatio = 0.0;
    m_placed.reset();
}

void FindingMarkers::move(std::size_t i, const Vec3& p_W)
{
    if (m_marks[i].p_W != p_W) {
        m_marks[i].p_W = p_W;
        ++m_revision;
        m_placed.reset();
    }
}

std::optional<Vec3> FindingMarkers::selectedPlace() const
{
    const auto mark = std::find_if(m_marks.begin(), m_marks.end(), [this](const FindingMark& one) {
        return m_selected != 0 && one.number == m_selected && one.p_W.allFinite();
    });
    return mark == m_marks.end() ? std::nullopt : std::optional(mark->p_W);
}

void FindingMarkers::select(std::size_t number)
{
    if (number != m_selected) {
        m_selected = number;
        m_pixelRatio = 0.0;
        m_placed.reset();
    }
}

void FindingMarkers::setVisible(bool isVisible)
{
    m_isVisible = isVisible;
    m_placed.reset();
}

void FindingMarkers::updateHidden(const IsBehind& isBehind)
{
    for (std::size_t i = 0; i < m_marks.size() && m_marks.size() <= kMaxNumbered; ++i) {
        const bool isHidden = isBehind(m_marks[i].p_W);
        if (isHidden != m_isHidden[i]) {
            m_isHidden[i] = isHidden;
            m_placed.reset();
        }
    }
}

std::string FindingMarkers::textOf(std::size_t i) const
{
    const FindingMark& mark = m_marks[i];
    const bool isSelected = mark.number == m_selected;
    if (!isSelected && m_marks.size() > kMaxNumbered) {
        return {};
    }
    return std::to_string(mark.number) + (isSelected && !mark.name.empty() ? "  " + mark.name : "");
}

void FindingMarkers::writeTexts(const ViewFrame& frame)
{
    const double pixelRatio = frame.pixelRatio;
    vtkRenderWindow* window = m_overlay != nullptr ? m_overlay->GetRenderWindow() : nullptr;
    std::vector<std::string> words;
    for (std::size_t i = 0; i < m_marks.size(); ++i) {
        words.push_back(textOf(i));
    }
    m_picture->write(words, frame.text, pixelRatio, window != nullptr ? window->GetDPI() : 72);
    constexpr double kMargin_px = 3.0;
    for (std::size_t i = 0; i < m_marks.size(); ++i) {
        const Picture::Piece& piece = m_picture->pieces[i];
        m_labels[i].size_px =
            piece.width == 0
                ? Pixel::Zero()
                : Pixel(Pixel(piece.width, piece.height) / pixelRatio + Pixel(2.0 * kMargin_px, kMargin_px));
    }
    m_pixelRatio = pixelRatio;
    m_textStyle = frame.text;
}

/// Returns whether a number overlaps one of the boxes at the current layout.
bool FindingMarkers::overlapsAny(const std::vector<Eigen::AlignedBox2d>& taken) const
{
    return std::any_of(m_labels.begin(), m_labels.end(), [&](const DiscLabel& one) {
        const Pixel centre = one.disc_px + one.offset_px;
        const Eigen::AlignedBox2d box(centre - 0.5 * one.size_px, centre + 0.5 * one.size_px);
        return std::any_of(taken.begin(), taken.end(),
                           [&](const Eigen::AlignedBox2d& other) { return box.intersects(other); });
    });
}

void FindingMarkers::place(const ViewFrame& frame, const std::vector<Eigen::AlignedBox2d>& taken)
{
    const int* view_px = m_overlay != nullptr ? m_overlay->GetSize() : nullptr;
    for (Flat* flat : {&m_picture->shapes, &m_picture->texts}) {
        flat->actor().SetPosition(view_px != nullptr ? 0.5 * view_px[0] : 0.0,
                                  view_px != nullptr ? 0.5 * view_px[1] : 0.0);
    }
    if (frame.pixelRatio != m_pixelRatio || frame.text != m_textStyle) {
        writeTexts(frame);
    } else if (m_placed == frame && (m_avoided.empty() ? !overlapsAny(taken) : areSame(m_avoided, taken))) {
        return; // a hand far from all numbers does not trigger a rebuild
    }
    Flat& shapes = m_picture->shapes;
    Flat& texts = m_picture->texts;
    shapes.clear();
    texts.clear();
    for (std::size_t i = 0; i < m_marks.size(); ++i) {
        const Vec3 fromEye = m_marks[i].p_W - frame.eye_W;
        const double size = frame.mmPerPixel(m_marks[i].p_W);
        m_labels[i].disc_px = Pixel(fromEye.dot(frame.right_W), fromEye.dot(frame.up_W)) / size;
    }
    if (m_marks.size() <= kMaxNumbered) {
        placeLabels(m_labels, internal::kMarkerRadius_px);
        m_avoided.clear();
        if (overlapsAny(taken)) {
            m_avoided = taken;
            placeLabels(m_labels, internal::kMarkerRadius_px, taken);
        }
    }
    const double ratio = frame.pixelRatio;
    for (std::size_t i = 0; i < m_marks.size(); ++i) {
        const bool isBehindEye = !frame.isParallel && (frame.eye_W - m_marks[i].p_W).dot(frame.back_W) <= 0.0;
        if (isBehindEye) {
            continue;
        }
        const DiscLabel& label = m_labels[i];
        const Picture::Piece& piece = m_picture->pieces[i];
        const double opacity = m_isHidden[i] ? kHiddenOpacity : 1.0;
        const Pixel middle = ratio * label.disc_px;
        addShape(shapes, middle, m_marks[i].type, m_isHidden[i], ratio);
        if (piece.width == 0) {
            continue;
        }
        const Pixel at = middle + ratio * label.offset_px;
        if (label.isMoved) { // leader line from the marker's rim to the edge of the text
            const Pixel start = middle + ratio * internal::kMarkerRadius_px * label.offset_px.normalized();
            const double outside = (0.5 * label.size_px).cwiseQuotient(label.offset_px.cwiseAbs()).minCoeff();
            const Pixel end = middle + ratio * label.offset_px * std::max(0.0, 1.0 - outside);
            const Colour colour = core::kFindingColours[static_cast<std::size_t>(m_marks[i].type)];
            addLine(shapes, start, end, ratio * kLeader_px, rgba(colour, opacity));
        }
        shapes.addQuad(rectangle(at, 0.5 * ratio * label.size_px),
                       rgba(kTextGround, frame.text.groundOpacity * opacity));
        // Aligned to whole pixels: text would be blurred otherwise.
        const Pixel half = 0.5 * Pixel(piece.width, piece.height);
        const Pixel low(std::round(at.x() - half.x()), std::round(at.y() - half.y()));
        const Pixel from = Pixel(piece.x, piece.y).cwiseQuotient(m_picture->atlasSize);
        const Pixel to = Pixel(piece.x + piece.width, piece.y + piece.height).cwiseQuotient(m_picture->atlasSize);
        texts.addTextured(rectangle(low + half, half), from, to, rgba(kTextColour, m_isHidden[i] ? 0.6 : 1.0));
    }
    shapes.finish(m_isVisible);
    texts.finish(m_isVisible);
    m_placed = frame;
}

core::Box FindingMarkers::bounds() const
{
    core::Box box;
    if (m_isVisible) {
        for (const FindingMark& one : m_marks) {
            box.extend(one.p_W);
        }
    }
    return box;
}

} // namespace palpate::view

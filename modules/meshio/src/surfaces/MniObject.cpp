// SPDX-License-Identifier: BSD-3-Clause
// Polygons of the object format of the Montreal Neurological Institute (CIVET, BrainSuite, Display), as text. The files
// end in .obj too.
#include "formats/MeshFormat.h"

#include "surfaces/PolygonSoup.h"
#include "text/Fault.h"
#include "text/TextScan.h"

#include <optional>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;

constexpr int kSurfaceProperties = 5; ///< ambient, diffuse and specular light, exponent, opacity
/// Least size of an index, and of the coordinates and the normal of a point, with a blank after each number [bytes].
constexpr std::size_t kBytesOfIndex = 2, kBytesOfPoint = 12;

class MniReader
{
  public:
    MniReader(std::string_view text, const ScanContext& context)
        : m_context(context)
        , m_text(text)
        , m_rest(text)
        , m_soup(context)
    {
    }
    Result<TriangleSoup> run(PreScan& scan);

  private:
    Status wrong(const core::Message& found, const core::Message& expected) const
    {
        return fault(StatusCode::BadFormat, m_context.file, onByte(m_text.size() - m_rest.size()), found, expected);
    }
    Status takeNumber(double& value);
    Status takeCount(std::int64_t& value, std::size_t bytesOfOne);
    Status readPoints();
    Status skipColours(std::int64_t polygons);
    Status readPolygons();

    const ScanContext& m_context;
    std::string_view m_text, m_rest;
    PolygonSoup m_soup;
    std::int64_t m_points = 0;
};

Status MniReader::takeNumber(double& value)
{
    const std::string_view word = takeWord(m_rest);
    const std::optional<double> number = wordToNumber(word);
    value = number.value_or(0.0);
    return number         ? m_soup.progress(m_text.size() - m_rest.size(), m_text.size())
           : word.empty() ? wrong({PALPATE_TEXT("the file ends")}, {PALPATE_TEXT("the declared points and polygons")})
                          : wrong({PALPATE_TEXT("%1 is not a number"), inQuotes(word)}, {PALPATE_TEXT("a number")});
}

/// Takes a whole number from 0. @param bytesOfOne  least size of each thing that it counts [bytes]
Status MniReader::takeCount(std::int64_t& value, std::size_t bytesOfOne)
{
    const std::size_t most = m_text.size() / bytesOfOne;
    const std::string_view word = takeWord(m_rest);
    const std::optional<std::int64_t> number = wordToInteger(word);
    value = number.value_or(0);
    return number && value >= 0 && value <= static_cast<std::int64_t>(most)
               ? m_soup.progress(m_text.size() - m_rest.size(), m_text.size())
               : wrong({PALPATE_TEXT("the MNI object has %1 in place of a count"), inQuotes(word)},
                       {PALPATE_TEXT("a whole number up to %1, as many as its bytes can hold"), Count(most)});
}

/// Reads the points, and their normals, which are not used.
Status MniReader::readPoints()
{
    (void)takeWord(m_rest); // "P"
    double unused = 0.0;
    for (int i = 0; i < kSurfaceProperties; ++i) {
        if (Status status = takeNumber(unused); !status.isOk()) {
            return status;
        }
    }
    if (Status status = takeCount(m_points, kBytesOfPoint); !status.isOk()) {
        return status;
    }
    m_soup.points().resize(static_cast<std::size_t>(m_points));
    for (core::Vec3& p : m_soup.points()) {
        for (double& coordinate : p) {
            if (Status status = takeNumber(coordinate); !status.isOk()) {
                return status;
            }
        }
    }
    for (std::int64_t i = 0; i < 3 * m_points; ++i) {
        if (Status status = takeNumber(unused); !status.isOk()) {
            return status;
        }
    }
    return {};
}

/// Skips the colours: one for all (0), for each polygon (1) or for each point (2).
Status MniReader::skipColours(std::int64_t polygons)
{
    std::int64_t kind = 0;
    if (Status status = takeCount(kind, 1); !status.isOk()) {
        return status;
    }
    if (kind > 2) {
        return wrong({PALPATE_TEXT("the kind of colours %1"), kind}, {PALPATE_TEXT("%1 to %2"), 0, 2});
    }
    const std::int64_t colours = kind == 0 ? 1 : kind == 1 ? polygons : m_points;
    double unused = 0.0;
    for (std::int64_t i = 0; i < 4 * colours; ++i) {
        if (Status status = takeNumber(unused); !status.isOk()) {
            return status;
        }
    }
    return {};
}

Status MniReader::readPolygons()
{
    std::int64_t polygons = 0;
    if (Status status = takeCount(polygons, kBytesOfIndex); !status.isOk()) {
        return status;
    }
    if (Status status = skipColours(polygons); !status.isOk()) {
        return status;
    }
    std::vector<std::int64_t> ends(static_cast<std::size_t>(polygons));
    std::int64_t before = 0;
    for (std::int64_t& end : ends) {
        if (Status status = takeCount(end, kBytesOfIndex); !status.isOk()) {
            return status;
        }
        if (end < before) {
            return wrong({PALPATE_TEXT("an end of a polygon below the one before: %1"), end},
                         {PALPATE_TEXT("at least %1"), before});
        }
        before = end;
    }
    std::vector<std::int64_t> corners;
    before = 0;
    for (const std::int64_t end : ends) {
        corners.resize(static_cast<std::size_t>(end - before));
        for (std::int64_t& corner : corners) {
            if (Status status = takeCount(corner, 1); !status.isOk()) {
                return status;
            }
        }
        if (Status status = m_soup.add(corners); !status.isOk()) {
            return status;
        }
        before = end;
    }
    return {};
}

Result<TriangleSoup> MniReader::run(PreScan& scan)
{
    for (const auto step : {&MniReader::readPoints, &MniReader::readPolygons}) {
        if (Status status = (this->*step)(); !status.isOk()) {
            return status;
        }
    }
    if (const std::string_view more = takeWord(m_rest); !more.empty()) {
        return wrong({PALPATE_TEXT("%1 behind the last polygon"), inQuotes(more)},
                     {PALPATE_TEXT("one object of polygons")});
    }
    return m_soup.finish(scan);
}

bool looksLikeMni(std::string_view bytes)
{
    std::string_view text = startOfText(bytes);
    if (takeWord(text) != "P") {
        return false;
    }
    for (int i = 0; i < kSurfaceProperties; ++i) {
        if (!wordToNumber(takeWord(text))) {
            return false;
        }
    }
    return wordToInteger(takeWord(text)).has_value();
}

Result<TriangleSoup> readMni(const FileImage& image, const ScanContext& context, PreScan& scan)
{
    scan.format = "MNI OBJ";
    scan.frame = FileFrame::Ras; // as all coordinates of MINC
    return MniReader(withoutPadding(image.bytes()), context).run(scan);
}

} // namespace

const MeshFormat kMniObject{"MNI OBJ", {}, false, looksLikeMni, nullptr, nullptr, readMni};

} // namespace palpate::meshio::internal

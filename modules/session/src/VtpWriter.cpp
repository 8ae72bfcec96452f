// SPDX-License-Identifier: BSD-3-Clause
#include "VtpWriter.h"

#include "palpate/session/AtomicFile.h"

#include <bit>

namespace palpate::session::internal {

static_assert(std::endian::native == std::endian::little, "the file says little-endian");

namespace {

std::string element(const char* name, const std::string& content)
{
    return std::string("<") + name + ">\n" + content + "</" + name + ">\n";
}

} // namespace

/// Appends the values and says where they are.
template<class T>
std::string VtpWriter::array(const std::string& name, const char* type, int components, const std::vector<T>& values)
{
    const std::uint64_t bytes = values.size() * sizeof(T);
    std::string xml = std::string("<DataArray type=\"") + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
                      std::to_string(components) + "\" format=\"appended\" offset=\"" +
                      std::to_string(m_appended.size()) + "\"/>\n";
    m_appended.append(reinterpret_cast<const char*>(&bytes), sizeof bytes);
    m_appended.append(reinterpret_cast<const char*>(values.data()), bytes);
    return xml;
}

void VtpWriter::setPoints(const std::vector<core::Vec3>& points)
{
    m_pointCount = points.size();
    m_points = array("Points", "Float64", 3, points);
}

void VtpWriter::setLines(const std::vector<std::int64_t>& points, const std::vector<std::int64_t>& ends)
{
    m_lineCount = ends.size();
    m_lines = array("connectivity", "Int64", 1, points) + array("offsets", "Int64", 1, ends);
}

void VtpWriter::setPolys(const std::vector<std::int64_t>& points, const std::vector<std::int64_t>& ends)
{
    m_polyCount = ends.size();
    m_polys = array("connectivity", "Int64", 1, points) + array("offsets", "Int64", 1, ends);
}

void VtpWriter::addPointArray(const std::string& name, const std::vector<double>& values)
{
    m_pointArrays += array(name, "Float64", 1, values);
}

void VtpWriter::addPointArray(const std::string& name, const std::vector<core::Vec3>& values)
{
    m_pointArrays += array(name, "Float64", 3, values);
}

void VtpWriter::addPointArray(const std::string& name, const std::vector<std::int32_t>& values)
{
    m_pointArrays += array(name, "Int32", 1, values);
}

void VtpWriter::addCellArray(const std::string& name, const std::vector<std::int32_t>& values)
{
    m_cellArrays += array(name, "Int32", 1, values);
}

void VtpWriter::addFieldTexts(const std::string& name, const std::vector<std::string>& texts)
{
    // Texts are their bytes, each with a zero at its end.
    std::string bytes;
    for (const std::string& text : texts) {
        for (const char c : text) {
            bytes += std::to_string(static_cast<unsigned char>(c)) + ' ';
        }
        bytes += "0 ";
    }
    m_fields += "<Array type=\"String\" Name=\"" + name + "\" NumberOfTuples=\"" + std::to_string(texts.size()) +
                "\" format=\"ascii\">" + bytes + "</Array>\n";
}

core::Status VtpWriter::write(const std::filesystem::path& path) const
{
    auto file = AtomicFile::create(path);
    if (!file.isOk()) {
        return file.status();
    }
    VtpWriter space; // the tag goes last into the fields, whatever was added before
    space.addFieldTexts("SPACE", {"LPS"});
    const auto count = [](const char* name, std::size_t value) {
        return std::string(" ") + name + "=\"" + std::to_string(value) + "\"";
    };
    const std::string scalars = m_activeScalars.empty() ? "" : " Scalars=\"" + m_activeScalars + "\"";
    file.value().write("<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
                       "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n");
    file.value().write(element("FieldData", m_fields + space.m_fields));
    file.value().write("<Piece" + count("NumberOfPoints", m_pointCount) + count("NumberOfVerts", 0) +
                       count("NumberOfLines", m_lineCount) + count("NumberOfStrips", 0) +
                       count("NumberOfPolys", m_polyCount) + ">\n");
    file.value().write("<PointData" + scalars + ">\n" + m_pointArrays + "</PointData>\n");
    file.value().write(element("CellData", m_cellArrays) + element("Points", m_points));
    file.value().write(m_lines.empty() ? std::string() : element("Lines", m_lines));
    file.value().write(m_polys.empty() ? std::string() : element("Polys", m_polys));
    file.value().write("</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_");
    file.value().write(m_appended);
    file.value().write("\n</AppendedData>\n</VTKFile>\n");
    return file.value().finish();
}

} // namespace palpate::session::internal

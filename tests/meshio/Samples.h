// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/meshio/LoadScene.h>

#include <QTemporaryDir>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

namespace palpate::test {

/// A temporary folder with helpers for files.
class Folder
{
  public:
    [[nodiscard]] std::filesystem::path path(const std::string& name) const
    {
        return std::filesystem::path(m_folder.path().toStdString()) / name;
    }
    std::filesystem::path write(const std::string& name, std::string_view bytes) const
    {
        const std::filesystem::path file = path(name);
        std::filesystem::remove(file); // truncating a file makes some file systems wait for the disk
        std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        return file;
    }

  private:
    QTemporaryDir m_folder;
};

inline std::string fileBytes(const std::filesystem::path& path)
{
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

template<class T>
void appendRaw(std::string& out, T value)
{
    out.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

/// Returns a tetrahedron of 24 mm with a corner at the origin, normals outwards.
inline meshio::MeshStructure tetrahedron(const std::string& name, const core::Vec3& shift = core::Vec3::Zero())
{
    meshio::MeshStructure s;
    s.name = name;
    s.mesh.vertices = {{0, 0, 0}, {24, 0, 0}, {0, 24, 0}, {0, 0, 24}};
    for (core::Vec3& p : s.mesh.vertices) {
        p += shift;
    }
    s.mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    return s;
}

/// Returns a binary STL with a facet per triple of corners.
inline std::string binaryStl(std::uint32_t declared, const std::vector<std::array<float, 9>>& facets,
                             std::string header = "test")
{
    header.resize(80, ' ');
    appendRaw(header, declared);
    for (const auto& facet : facets) {
        appendRaw(header, std::array<float, 3>{});
        appendRaw(header, facet);
        appendRaw(header, std::uint16_t{0});
    }
    return header;
}

inline std::string asciiStl(const std::string& name = "liver", const std::string& lastVertex = "0 1.5 0")
{
    std::string text = "solid ";
    text.append(name).append("\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2.5 0 0\nvertex ");
    return text.append(lastVertex).append("\nendloop\nendfacet\nendsolid ").append(name).append("\n");
}

inline std::string asciiPly(const std::string& vertices = "0 0 0\n2.5 0 0\n0 1.5 0\n",
                            const std::string& faces = "3 0 1 2\n", int vertexCount = 3, int faceCount = 1)
{
    return "ply\nformat ascii 1.0\ncomment SPACE=LPS\nelement vertex " + std::to_string(vertexCount) +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " + std::to_string(faceCount) +
           "\nproperty list uchar int vertex_index\nend_header\n" + vertices + faces;
}

inline std::string asciiVtp(const std::string& points = "0 0 0 2.5 0 0 0 1.5 0", const std::string& corners = "0 1 2",
                            const std::string& counts = "NumberOfPoints=\"3\" NumberOfPolys=\"1\"",
                            const std::string& offsets = "3", const std::string& kind = "Polys",
                            const std::string& field = "")
{
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
           "header_type=\"UInt64\">\n<PolyData>" +
           field + "<Piece " + counts +
           ">\n<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">" + points +
           "</DataArray></Points>\n<" + kind + "><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">" +
           corners + "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">" + offsets +
           "</DataArray></" + kind + ">\n</Piece></PolyData></VTKFile>\n";
}

/// Returns a legacy VTK file as text, version 3: a title, three points, a triangle.
inline std::string asciiVtk(const std::string& points = "POINTS 3 float\n0 0 0 2.5 0 0 0 1.5 0\n",
                            const std::string& cells = "POLYGONS 1 4\n3 0 1 2\n", const std::string& title = "liver",
                            const std::string& version = "3.0")
{
    return "# vtk DataFile Version " + version + "\n" + title + "\nASCII\nDATASET POLYDATA\n" + points + cells;
}

/// Appends a number in big-endian order, as in a binary legacy file.
template<class T>
void appendBig(std::string& out, T value)
{
    std::string raw;
    appendRaw(raw, value);
    out.append(raw.rbegin(), raw.rend());
}

/// Returns the same surface in binary, version 5, with doubles, and with fields and attributes that the reader ignores.
inline std::string binaryVtk()
{
    std::string out = "# vtk DataFile Version 5.1\n3D Slicer output. SPACE=LPS\nBINARY\nDATASET POLYDATA\n"
                      "FIELD FieldData 2\ntime 1 1 double\n";
    appendBig(out, 0.25);
    out += "\nnote 1 2 string\n\xc2lp\xc1x\nPOINTS 3 double\n";
    for (const double x : {0.0, 0.0, 0.0, 2.5, 0.0, 0.0, 0.0, 1.5, 0.0}) {
        appendBig(out, x);
    }
    out += "\nMETADATA\nINFORMATION 0\n\nPOLYGONS 2 3\nOFFSETS vtktypeint64\n";
    for (const std::int64_t offset : {0, 3}) {
        appendBig(out, offset);
    }
    out += "\nCONNECTIVITY vtktypeint64\n";
    for (const std::int64_t corner : {0, 1, 2}) {
        appendBig(out, corner);
    }
    return out += "\nPOINT_DATA 3\nSCALARS distance float\nLOOKUP_TABLE default\n............";
}

/// Returns the same surface as an unstructured grid in the legacy format, with a line.
inline std::string asciiGrid(const std::string& types = "3\n5\n")
{
    return "# vtk DataFile Version 3.0\nliver\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 float\n0 0 0 2.5 0 0 0 1.5 "
           "0\n"
           "CELLS 2 7\n2 0 1\n3 0 1 2\nCELL_TYPES 2\n" +
           types;
}

/// Returns the same surface as an unstructured grid in XML.
inline std::string asciiVtu(const std::string& cellData = "")
{
    return "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\"><UnstructuredGrid>"
           "<Piece NumberOfPoints=\"3\" NumberOfCells=\"1\">" +
           cellData +
           "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 2.5 0 0 0 1.5 0"
           "</DataArray></Points><Cells><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2"
           "</DataArray><DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">3</DataArray>"
           "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">5</DataArray></Cells></Piece></UnstructuredGrid>"
           "</VTKFile>\n";
}

/// Returns a binary PLY of two strips of a triangle each.
inline std::string stripsPly()
{
    std::string out = "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                      "property float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n";
    appendRaw(out, std::array<float, 9>{0, 0, 0, 2.5F, 0, 0, 0, 1.5F, 0});
    appendRaw(out, std::array<std::int32_t, 8>{7, 0, 1, 2, -1, 0, 1, 2});
    return out;
}

inline const std::string kObj = "v 0 0 0\nv 2.5 0 0\nv 0 1.5 0\nf 1 2 3\n";

/// Returns the area of all triangles of a structure [mm²].
inline double area(const geometry::TriangleMesh& mesh)
{
    double sum = 0.0;
    for (const geometry::Triangle& t : mesh.triangles) {
        const core::Vec3 a = mesh.vertices[t[1]] - mesh.vertices[t[0]];
        sum += 0.5 * a.cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]).norm();
    }
    return sum;
}

inline std::size_t triangles(const meshio::MeshFile& file)
{
    std::size_t count = 0;
    for (const meshio::MeshStructure& s : file.structures) {
        count += s.mesh.triangles.size();
    }
    return count;
}

} // namespace palpate::test

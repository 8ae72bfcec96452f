// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/core/Status.h>
#include <palpate/core/Types.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace palpate::session::internal {

/// A VTK XML poly data file with raw appended arrays, little-endian, tagged SPACE=LPS.
/// @par Source VTK File Formats, "XML File Formats",
/// https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html
class VtpWriter
{
  public:
    void setPoints(const std::vector<core::Vec3>& points);
    /// Cells by their points; `ends` says where each one ends in `points`.
    void setLines(const std::vector<std::int64_t>& points, const std::vector<std::int64_t>& ends);
    void setPolys(const std::vector<std::int64_t>& points, const std::vector<std::int64_t>& ends);
    void addPointArray(const std::string& name, const std::vector<double>& values);
    void addPointArray(const std::string& name, const std::vector<core::Vec3>& values);
    void addPointArray(const std::string& name, const std::vector<std::int32_t>& values);
    void addCellArray(const std::string& name, const std::vector<std::int32_t>& values);
    void addFieldTexts(const std::string& name, const std::vector<std::string>& texts);
    /// Names the point array that a viewer colours by.
    void setActiveScalars(const std::string& name) { m_activeScalars = name; }
    [[nodiscard]] core::Status write(const std::filesystem::path& path) const;

  private:
    template<class T>
    std::string array(const std::string& name, const char* type, int components, const std::vector<T>& values);

    std::string m_points, m_lines, m_polys, m_pointArrays, m_cellArrays, m_fields; ///< XML
    std::string m_appended;
    std::size_t m_pointCount = 0, m_lineCount = 0, m_polyCount = 0;
    std::string m_activeScalars;
};

} // namespace palpate::session::internal

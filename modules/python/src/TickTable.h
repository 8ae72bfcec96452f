// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "LargePages.h"

#include <palpate/core/Types.h>
#include <palpate/servo/TickRecord.h>
#include <palpate/session/Recording.h>
#include <palpate/session/StructureNames.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace palpate::python {

namespace py = pybind11;

/// Collects ticks without the GIL and makes a structured array of them, with the columns and values of the CSV.
class TickTable
{
  public:
    enum class Columns
    {
        Replay, ///< session::TickCsv::Rows::Ticks
        Session ///< session::TickCsv::Rows::Session; NaN or empty in ticks without a hand
    };
    /// @param names  names of the structures by scene generation and number
    /// @param hasLayers  fills the column `layers`, which takes most of the memory
    TickTable(Columns columns, bool hasLayers)
        : m_columns(columns)
        , m_hasLayers(hasLayers)
    {
    }
    void reserve(std::size_t ticks) { m_rows.reserve(ticks); }
    /// @pre the GIL is not needed
    void add(const servo::TickRecord& tick, const session::StructureNames& names);
    /// @param events  by tick, ascending, for Columns::Session: each is put into the first tick at or after it, or the
    /// last tick
    /// @pre the GIL is held; it is released while the array is filled
    [[nodiscard]] py::array toArray(std::span<const session::RecordingEvent> events = {}) const;

  private:
    struct Row
    {
        std::int64_t tick;
        core::Vec3 p_WH, p_WG, f_W, n_W, fSent_W;
        double time_s, force_N, depth_mm, stiffness_N_per_mm;
        std::uint32_t solve_ns;
        std::uint32_t name;         ///< index in m_names
        std::size_t layers, length; ///< in m_layers [bytes]
        std::uint8_t constraints;
        char32_t slides; ///< 0: empty
    };
    class Layout;

    void putEvents(const py::array& array, std::span<const session::RecordingEvent> events) const;
    std::uint32_t numberOf(std::uint32_t scene, std::int32_t structure, const session::StructureNames& names);

    Columns m_columns;
    bool m_hasLayers;
    std::vector<Row, LargePages<Row>> m_rows;
    std::vector<std::u32string> m_names{U""};
    std::map<std::pair<std::uint32_t, std::int32_t>, std::uint32_t> m_numbers;  ///< by scene generation and structure
    std::basic_string<char, std::char_traits<char>, LargePages<char>> m_layers; ///< texts of all rows, UTF-8
    std::size_t m_longestLayers = 1;
};

} // namespace palpate::python

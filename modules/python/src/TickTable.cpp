// SPDX-License-Identifier: BSD-3-Clause
#include "TickTable.h"

#include "Errors.h"

#include <palpate/haptics/Contact.h>
#include <palpate/session/TickCsv.h>

#include <QString>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <limits>
#include <memory>
#include <string_view>

namespace palpate::python {

namespace {

bool isAscii(std::string_view text)
{
    unsigned char bits = 0;
    for (const char c : text) { // without a branch, so that the compiler takes several bytes at a time
        bits |= static_cast<unsigned char>(c);
    }
    return bits < 0x80;
}

std::u32string decoded(std::string_view text)
{
    const auto characters = QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())).toUcs4();
    return {characters.begin(), characters.end()};
}

/// Writes a text of UTF-8. @pre `out` has room for as many characters as the text has bytes
void writeText(std::byte* out, std::string_view text)
{
    if (!isAscii(text)) {
        const std::u32string characters = decoded(text);
        std::memcpy(out, characters.data(), characters.size() * sizeof(char32_t));
        return;
    }
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<char32_t>(text[i]);
        std::memcpy(out + i * sizeof c, &c, sizeof c);
    }
}

char32_t slidesText(haptics::Friction friction)
{
    return friction == haptics::Friction::Slides ? U'1' : friction == haptics::Friction::Holds ? U'0' : U'\0';
}

} // namespace

/// Fields of the array and their places in an item, each aligned for its type.
class TickTable::Layout
{
  public:
    /// @return offset of the field
    std::size_t add(const char* name, const std::string& format, std::size_t size, std::size_t alignment)
    {
        const std::size_t at = (m_size + alignment - 1) / alignment * alignment;
        m_names.append(name);
        m_formats.append(format);
        m_offsets.append(at);
        m_size = at + size;
        return at;
    }
    std::size_t addDouble(const char* name) { return add(name, "f8", sizeof(double), alignof(double)); }
    std::size_t addText(const char* name, std::size_t characters)
    {
        return add(name, "U" + std::to_string(characters), characters * sizeof(char32_t), alignof(char32_t));
    }
    std::size_t addVector(const char* x, const char* y, const char* z)
    {
        const std::size_t at = addDouble(x);
        addDouble(y);
        addDouble(z);
        return at;
    }
    /// References to Python objects, as few ticks have a text and texts can be long.
    void addObject(const char* name) { add(name, "O", sizeof(PyObject*), alignof(PyObject*)); }
    /// @return an array that is not filled yet; null pointers are objects
    [[nodiscard]] py::array empty(std::size_t items) const
    {
        const std::size_t size = (m_size + alignof(double) - 1) / alignof(double) * alignof(double);
        const py::dtype type(m_names, m_formats, m_offsets, static_cast<py::ssize_t>(size));
        auto array = py::module_::import("numpy").attr("empty")(items, type).cast<py::array>();
        adviseLargePages(array.mutable_data(), static_cast<std::size_t>(array.nbytes()));
        return array;
    }

  private:
    py::list m_names, m_formats, m_offsets;
    std::size_t m_size = 0;
};

std::uint32_t TickTable::numberOf(std::uint32_t scene, std::int32_t structure, const session::StructureNames& names)
{
    if (structure < 0) {
        return 0;
    }
    const auto [at, isNew] = m_numbers.try_emplace({scene, structure}, static_cast<std::uint32_t>(m_names.size()));
    if (isNew) {
        m_names.push_back(decoded(names(static_cast<std::uint32_t>(structure))));
    }
    return at->second;
}

void TickTable::add(const servo::TickRecord& tick, const session::StructureNames& names)
{
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    Row row{};
    row.tick = tick.tick;
    row.time_s = static_cast<double>(tick.time_ns) * 1e-9;
    if (m_columns == Columns::Session && (tick.flags & servo::kNoHand) != 0) {
        row.p_WH = row.p_WG = row.f_W = row.n_W = row.fSent_W = core::Vec3::Constant(kNone);
        row.force_N = row.depth_mm = row.stiffness_N_per_mm = kNone;
        m_rows.push_back(row);
        return;
    }
    const haptics::TickResult& felt = tick.felt;
    row.p_WH = tick.p_WH;
    row.p_WG = felt.p_WG;
    row.f_W = felt.f_W;
    row.n_W = felt.n_W;
    row.fSent_W = tick.fSent_W;
    row.force_N = felt.f_W.norm();
    row.depth_mm = felt.structure >= 0 ? (felt.p_WG - tick.p_WH).norm() : 0.0;
    row.stiffness_N_per_mm = row.depth_mm > 0.0 ? row.force_N / row.depth_mm : kNone;
    row.solve_ns = tick.solve_ns;
    row.name = numberOf(tick.scene, felt.structure, names);
    row.constraints = felt.constraints;
    row.slides = slidesText(felt.friction());
    row.layers = m_layers.size();
    if (m_hasLayers && felt.contactCount > 0) {
        const std::string text = session::layersText(felt, names);
        m_layers.append(text.data(), text.size());
        row.length = m_layers.size() - row.layers;
        m_longestLayers = std::max(m_longestLayers, row.length);
    }
    m_rows.push_back(row);
}

/// Fills the column `events`, with the texts of the CSV.
void TickTable::putEvents(const py::array& array, std::span<const session::RecordingEvent> events) const
{
    const py::object column = array["events"];
    column[py::ellipsis()] = py::str();
    if (m_rows.empty()) {
        return;
    }
    while (!events.empty()) {
        const auto last = std::prev(m_rows.end());
        const auto row = std::lower_bound(m_rows.begin(), last, events.front().tick,
                                          [](const Row& one, std::int64_t tick) { return one.tick < tick; });
        const auto end = row == last ? events.end()
                                     : std::find_if(events.begin(), events.end(),
                                                    [row](const auto& event) { return event.tick > row->tick; });
        const auto count = static_cast<std::size_t>(end - events.begin());
        column[py::int_(row - m_rows.begin())] = toPython(session::eventsText(events.first(count)));
        events = events.subspan(count);
    }
}

py::array TickTable::toArray(std::span<const session::RecordingEvent> events) const
{
    std::size_t longestName = 1;
    for (const std::u32string& name : m_names) {
        longestName = std::max(longestName, name.size());
    }
    Layout layout;
    const std::size_t tick = layout.add("tick", "i8", sizeof(std::int64_t), alignof(std::int64_t));
    const std::size_t hip = layout.addVector("hip_x", "hip_y", "hip_z");
    const std::size_t god = layout.addVector("god_x", "god_y", "god_z");
    const std::size_t force = layout.addVector("force_x", "force_y", "force_z");
    const std::size_t constraints = layout.add("constraints", "u1", 1, 1);
    const std::size_t structure = layout.addText("structure", longestName);
    const std::size_t solve = layout.add("solve_ns", "u4", sizeof(std::uint32_t), alignof(std::uint32_t));
    const std::size_t normal = layout.addVector("normal_x", "normal_y", "normal_z");
    const std::size_t slides = layout.addText("slides", 1);
    const std::size_t layers = layout.addText("layers", m_longestLayers);
    const bool isSession = m_columns == Columns::Session;
    const std::size_t time = isSession ? layout.addDouble("time_s") : 0;
    const std::size_t sent = isSession ? layout.addVector("sent_x_N", "sent_y_N", "sent_z_N") : 0;
    const std::size_t sizes = isSession ? layout.addVector("force_N", "depth_mm", "felt_N_per_mm") : 0;
    if (isSession) {
        layout.addObject("events");
    }

    py::array array = layout.empty(m_rows.size());
    auto* item = static_cast<std::byte*>(array.mutable_data());
    const auto step = static_cast<std::size_t>(array.itemsize());
    auto released = std::make_unique<py::gil_scoped_release>(); // nobody else has the array yet
    for (const Row& row : m_rows) {
        std::memset(item, 0, step);
        const auto put = [item](std::size_t at, const void* from, std::size_t bytes) {
            std::memcpy(item + at, from, bytes);
        };
        put(tick, &row.tick, sizeof row.tick);
        put(hip, row.p_WH.data(), sizeof(core::Vec3));
        put(god, row.p_WG.data(), sizeof(core::Vec3));
        put(force, row.f_W.data(), sizeof(core::Vec3));
        put(constraints, &row.constraints, 1);
        put(structure, m_names[row.name].data(), m_names[row.name].size() * sizeof(char32_t));
        put(solve, &row.solve_ns, sizeof row.solve_ns);
        put(normal, row.n_W.data(), sizeof(core::Vec3));
        put(slides, &row.slides, sizeof row.slides);
        writeText(item + layers, std::string_view(m_layers).substr(row.layers, row.length));
        if (isSession) {
            const core::Vec3 values(row.force_N, row.depth_mm, row.stiffness_N_per_mm);
            put(time, &row.time_s, sizeof row.time_s);
            put(sent, row.fSent_W.data(), sizeof(core::Vec3));
            put(sizes, values.data(), sizeof(core::Vec3));
        }
        item += step;
    }
    released.reset();
    if (isSession) {
        putEvents(array, events);
    }
    return array;
}

} // namespace palpate::python

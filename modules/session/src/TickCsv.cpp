// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/TickCsv.h"

#include <palpate/core/Numbers.h>

#include <utility>

namespace palpate::session {

namespace {

void appendText(std::string& line, std::string_view text)
{
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
        line.append(text);
        return;
    }
    line += '"';
    for (const char c : text) {
        line.append(c == '"' ? 2 : 1, c);
    }
    line += '"';
}

} // namespace

TickCsv::TickCsv(AtomicFile file)
    : m_file(std::move(file))
{
}

core::Result<TickCsv> TickCsv::create(const std::filesystem::path& path)
{
    auto file = AtomicFile::create(path);
    if (!file.isOk()) {
        return file.status();
    }
    TickCsv csv(std::move(file).value());
    csv.m_file.write(kHeader);
    csv.m_file.write("\n");
    return csv;
}

void TickCsv::write(const TickRow& row)
{
    m_line = std::to_string(row.tick);
    for (const core::Vec3* v : {&row.p_WH, &row.p_WG, &row.f_W}) {
        for (const double value : *v) {
            m_line += ',';
            core::appendNumber(m_line, value);
        }
    }
    m_line += ',';
    m_line += std::to_string(row.constraints);
    m_line += ',';
    appendText(m_line, row.structure);
    m_line += ',';
    m_line += std::to_string(row.solve_ns);
    m_line += '\n';
    m_file.write(m_line);
}

core::Status TickCsv::finish()
{
    return m_file.finish();
}

} // namespace palpate::session

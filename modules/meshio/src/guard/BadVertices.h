// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "guard/PreScan.h"

#include <map>

namespace palpate::meshio::internal {

/// Vertices with coordinates that are not finite or too far away. Modelling programs leave such vertices behind, and
/// they do no harm unless a face uses one: then the file is refused.
class BadVertices
{
  public:
    /// @param vertex  index from 0
    /// @param fault  the error, if a face uses the vertex
    void add(std::int64_t vertex, core::Status fault) { m_faults.emplace(vertex, std::move(fault)); }
    /// @return the error of a vertex that a face uses
    [[nodiscard]] core::Status check(std::int64_t vertex) const
    {
        const auto found = m_faults.empty() ? m_faults.end() : m_faults.find(vertex);
        return found == m_faults.end() ? core::Status() : found->second;
    }
    /// Adds a note with the number of vertices that are left out.
    void note(PreScan& scan) const { noteBadVertices(m_faults.size(), scan); }

  private:
    std::map<std::int64_t, core::Status> m_faults;
};

} // namespace palpate::meshio::internal

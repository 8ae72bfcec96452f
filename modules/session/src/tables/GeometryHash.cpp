// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/GeometryHash.h"

#include <QCryptographicHash>

#include <bit>
#include <cstdint>

namespace palpate::session {

static_assert(std::endian::native == std::endian::little, "the hash is defined over little-endian numbers");

std::string geometryHash(const geometry::TriangleMesh& mesh)
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    const auto add = [&hash](const void* data, std::size_t bytes) {
        hash.addData(QByteArrayView(static_cast<const char*>(data), static_cast<qsizetype>(bytes)));
    };
    const std::uint64_t counts[]{mesh.vertices.size(), mesh.triangles.size()};
    static_assert(sizeof(core::Vec3) == 3 * sizeof(double) && sizeof(geometry::Triangle) == 3 * sizeof(std::uint32_t));
    add(counts, sizeof counts);
    add(mesh.vertices.data(), mesh.vertices.size() * sizeof(core::Vec3));
    add(mesh.triangles.data(), mesh.triangles.size() * sizeof(geometry::Triangle));
    return hash.result().toHex().toStdString();
}

} // namespace palpate::session

// SPDX-License-Identifier: BSD-3-Clause
#include "share/ReceivedSurfaces.h"

#include "shared/Paths.h"

#include <palpate/meshio/MeshFile.h>
#include <palpate/ui/Translated.h>

#include <QFile>

#include <memory>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

namespace palpate::app {

namespace {

template<class T>
std::uint64_t checksumOf(const std::vector<T>& values, std::uint64_t before)
{
    return igtl::crc64({reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(T)}, before);
}

/// Name of the structure: one line of valid text, not empty.
QString structureName(const std::string& sent)
{
    const QString name = QString::fromStdString(sent).simplified();
    return name.isEmpty() ? ReceivedSurfaces::tr("Surface") : name;
}

/// Name of a file: letters, digits and a few signs, never a path.
QString fileName(const QString& name)
{
    QString kept;
    for (const QChar letter : name) {
        kept += letter.isLetterOrNumber() || letter == QLatin1Char('-') ? letter : QLatin1Char('_');
    }
    return kept;
}

/// Converts RAS to LPS.
meshio::MeshStructure structureOf(const igtl::ReceivedSurface& received)
{
    meshio::MeshStructure structure;
    structure.name = structureName(received.name).toStdString();
    structure.mesh.vertices.reserve(received.surface.points.size());
    for (const auto& [x, y, z] : received.surface.points) {
        structure.mesh.vertices.emplace_back(-static_cast<double>(x), -static_cast<double>(y), static_cast<double>(z));
    }
    structure.mesh.triangles = received.surface.triangles;
    return structure;
}

} // namespace

ReceivedSurfaces::ReceivedSurfaces(QObject* parent)
    : QObject(parent)
{
    m_writer.setMaxThreadCount(1);
}

ReceivedSurfaces::~ReceivedSurfaces()
{
    m_writer.clear();
    m_writer.waitForDone();
}

QString ReceivedSurfaces::folder()
{
    return QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + QStringLiteral("/Palpate/received");
}

void ReceivedSurfaces::take(igtl::ReceivedSurface surface)
{
    if (m_waiting.fetch_add(1) >= kMaxWaiting) {
        --m_waiting;
        if (!m_isDropping.exchange(true)) { // once, whatever a peer sends
            Q_EMIT failed(tr("A surface was not received: several others are still being stored. Send it again."));
        }
        return;
    }
    m_writer.start([this, kept = std::make_shared<igtl::ReceivedSurface>(std::move(surface))] {
        store(*kept);
        --m_waiting;
    });
}

void ReceivedSurfaces::store(const igtl::ReceivedSurface& surface)
{
    // 3D Slicer sends a model again whenever one of its properties changes.
    const std::uint64_t checksum = checksumOf(surface.surface.triangles, checksumOf(surface.surface.points, 0));
    if (const auto last = m_checksums.find(surface.name); last != m_checksums.end() && last->second == checksum) {
        return;
    }
    if (m_storedCount >= kMaxStored) {
        if (!std::exchange(m_isFull, true)) {
            Q_EMIT failed(tr("%1 surfaces were received. Further ones are ignored until Palpate is started again.")
                              .arg(kMaxStored));
        }
        return;
    }
    const QString directory = folder();
    if (QDir().mkpath(directory)) { // anatomy of a patient: for this user only
        QFile::setPermissions(directory, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    }
    const meshio::MeshStructure structure = structureOf(surface);
    const QString name = QString::fromStdString(structure.name);
    std::filesystem::path file;
    std::error_code error;
    do {
        ++m_storedCount;
        file = newFileIn(directory, QStringLiteral(" %1 %2.vtp").arg(fileName(name)).arg(m_storedCount));
    } while (std::filesystem::exists(file, error));
    if (const core::Status status = meshio::writeMesh(file, {&structure, 1}); !status.isOk()) {
        Q_EMIT failed(ui::translated(status));
        return;
    }
    m_checksums[surface.name] = checksum;
    m_isDropping = false;
    Q_EMIT stored(file, name);
}

} // namespace palpate::app

#include "moc_ReceivedSurfaces.cpp"

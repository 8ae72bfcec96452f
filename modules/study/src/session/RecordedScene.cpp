// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/RecordedScene.h"

#include "palpate/study/BuriedLumps.h"
#include "palpate/study/HapticCopy.h"
#include "palpate/study/RecordedLooks.h"
#include "palpate/study/StructureSources.h"

#include <palpate/meshio/DicomFolder.h>
#include <palpate/meshio/MeshFormats.h>
#include <palpate/session/Findings.h>
#include <palpate/session/GeometryHash.h>

#include <algorithm>
#include <array>
#include <utility>

namespace palpate::study {

using core::Result;
using core::Status;
using core::StatusCode;
using session::MeshesByHash;
using session::RecordingReader;
using session::StructureRecord;

namespace {

namespace fs = std::filesystem;

/// @return hashes of the surfaces of all palpable structures.
std::vector<std::string> palpableHashes(const RecordingReader& reader)
{
    std::vector<std::string> hashes;
    for (const session::SceneRecord& scene : reader.scenes()) {
        for (const StructureRecord& structure : scene.structures) {
            if (structure.palpable) {
                hashes.push_back(structure.source.sha256);
            }
        }
    }
    return hashes;
}

/// Returns the options used for a mesh file in a recording. Other files (a scene or a folder) use the options of the
/// first structure.
meshio::ReadOptions readAs(const RecordingReader& reader, const fs::path& file)
{
    meshio::ReadOptions options;
    options.readsScale = false; // the unit is known
    if (reader.scenes().empty() || reader.scenes().front().structures.empty()) {
        return options;
    }
    const std::vector<session::StructureRecord>& all = reader.scenes().front().structures;
    const auto named = std::find_if(all.begin(), all.end(), [&](const auto& one) {
        return fs::path(one.source.mesh).filename() == file.filename();
    });
    const session::StructureSource& source = (named == all.end() ? all.front() : *named).source;
    options.unit_mm = source.unit_mm;
    options.frame = source.frame;
    const std::vector<RecordedLook> looks = looksFrom(reader.info().looks);
    if (const auto number = static_cast<std::size_t>(named == all.end() ? 0 : named - all.begin());
        number < looks.size()) {
        options.turnsOutwards = looks[number].outwards;
        options.closeHoles_mm = looks[number].closeHoles_mm;
        options.isSmoothed = meshio::isSmoothed(looks[number].surface);
        options.isCurved = meshio::isCurved(looks[number].surface);
        if (meshio::hasLabelMapExtension(file)) {
            options.smoothing = options.isSmoothed ? looks[number].smoothing : 0.0;
        }
    }
    return options;
}

/// Finds a file at the recorded path, which is relative to the recording's folder, in older recordings absolute or as
/// typed, else by name in that folder.
std::optional<fs::path> locateFile(const RecordingReader& reader, const fs::path& file, const fs::path& beside = {})
{
    if (file.filename().empty()) {
        return std::nullopt;
    }
    const fs::path folder = reader.path().parent_path();
    fs::path stored = folder / file;
    if (*file.begin() == "..") { // relative to the parent of a link's target
        std::error_code error;
        const fs::path resolved = fs::weakly_canonical(fs::absolute(folder, error), error);
        stored = error ? stored : (resolved / file).lexically_normal();
    }
    for (const fs::path& place :
         {stored, beside.empty() ? fs::path() : folder / beside, file, folder / file.filename()}) {
        std::error_code error;
        if (!place.empty() && fs::exists(place, error)) {
            return place;
        }
    }
    return std::nullopt;
}

bool isSameMap(const haptics::TissueMap& a, const haptics::TissueMap& b)
{
    return a.isEmpty() == b.isEmpty() && (a.isEmpty() || (a.factor == b.factor && *a.corners == *b.corners));
}

/// Converts a recorded map to a map of a structure: one value per triangle if all corners of each triangle are equal,
/// else one value per vertex.
meshio::SurfaceMap surfaceMap(const haptics::TissueMap& map, core::MappedQuantity quantity,
                              const geometry::SurfaceIndex& index, const geometry::RepairedMesh& surface)
{
    using core::MappedQuantity;
    meshio::SurfaceMap out;
    out.mapping.quantity = quantity;
    // For a stiffness map in N/mm, the factor is the reciprocal of the tissue's own stiffness.
    out.mapping.unit = quantity == MappedQuantity::Stiffness && map.factor != 1.0 ? core::MapUnit::NPerMm
                                                                                  : core::traitsOf(quantity).unit;
    for (const core::KnownMap& known : core::kKnownMaps) {
        if (known.quantity == quantity && known.unit == out.mapping.unit) {
            out.mapping.array = known.array;
        }
    }
    out.isPerTriangle = std::all_of(map.corners->begin(), map.corners->end(),
                                    [](const auto& at) { return at[0] == at[1] && at[1] == at[2]; });
    out.values.assign(out.isPerTriangle ? surface.mesh.triangles.size() : surface.mesh.vertices.size(), 0.0F);
    for (std::uint32_t i = 0; i < index.triangleCount(); ++i) {
        const std::uint32_t triangle = index.sourceTriangle(i);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t at = out.isPerTriangle ? triangle : surface.mesh.triangles[triangle][corner];
            out.values[at] = (*map.corners)[i][corner];
        }
    }
    return out;
}

/// Rebuilds the scene of a recording.
class Reopening
{
  public:
    Reopening(const RecordingReader& reader, const meshio::ReadOptions& options)
        : m_reader(reader)
        , m_options(options)
        , m_records(reader.scenes().empty() ? std::vector<StructureRecord>() : reader.scenes().front().structures)
        , m_looks(looksFrom(reader.info().looks))
    {
        // Data that a recording does not store: camera and maps, and in older recordings the appearance.
        if (const auto file = recordedSceneFile(reader); file && meshio::isSceneFile(*file)) {
            if (auto read = meshio::readScene(*file); read.isOk()) {
                m_look = std::move(read).value();
            }
        }
    }

    Result<meshio::LoadedScene> run()
    {
        for (const core::Message& fault : m_reader.faults()) {
            m_out.losses.push_back({PALPATE_TEXT("%1: %2"), m_reader.path().filename(), fault});
        }
        m_found.resize(m_records.size());
        for (std::size_t i = 0; i < m_records.size(); ++i) {
            m_found[i] = embedded(m_records[i], i);
        }
        if (Status status = readMeshes(); !status.isOk()) {
            return status;
        }
        for (std::size_t i = 0; i < m_records.size(); ++i) {
            if (m_found[i]) {
                applyRecordedMaps(*m_found[i], m_records[i]);
                applyRecordedMotion(*m_found[i], m_records[i]);
                m_out.scene.structures.push_back(m_found[i]->description);
                m_out.structures.push_back(std::move(*m_found[i]));
            }
        }
        const std::string name = m_reader.path().filename().string();
        if (m_out.structures.empty()) {
            return Status(StatusCode::NotFound, PALPATE_TEXT("%1: found none of the surfaces that it was made on: %2"),
                          name,
                          m_out.losses.empty() ? core::Message(PALPATE_TEXT("it contains none and names no mesh"))
                                               : m_out.losses.front());
        }
        m_out.scene.camera = m_look.camera;
        for (auto& [tick, finding] : session::findingsOf(m_reader.events())) {
            m_out.scene.findings.push_back(std::move(finding));
        }
        return std::move(m_out);
    }

  private:
    /// Returns the recorded description with the recorded appearance; older recordings use the scene file.
    meshio::SceneStructure description(const StructureRecord& record, std::size_t number) const
    {
        meshio::SceneStructure out = withSceneAppearance(record, number);
        if (number < m_looks.size() && m_looks[number].name == record.name) {
            out.colour = m_looks[number].colour;
            out.opacity = m_looks[number].opacity;
            out.outwards = m_looks[number].outwards;
            out.closeHoles_mm = m_looks[number].closeHoles_mm;
            out.surface = m_looks[number].surface;
            out.smoothing = m_looks[number].smoothing;
            describeLump(out, m_looks[number]);
        }
        return out;
    }

    /// Applies what the recording states about a lump; older recordings state nothing.
    static void describeLump(meshio::SceneStructure& out, const RecordedLook& look)
    {
        if (out.layer == 0 && !look.inside.empty()) {
            out.inside = look.inside;
        }
        out.young_ratio = look.youngRatio ? look.youngRatio : out.young_ratio;
        out.young_kPa = look.young_kPa ? look.young_kPa : out.young_kPa;
        out.felt_contact_radius_mm = look.feltContactRadius_mm ? look.feltContactRadius_mm : out.felt_contact_radius_mm;
    }

    meshio::SceneStructure withSceneAppearance(const StructureRecord& record, std::size_t number) const
    {
        meshio::SceneStructure out = descriptionOf(record);
        const auto look = std::find_if(m_look.structures.begin(), m_look.structures.end(),
                                       [&](const meshio::SceneStructure& one) { return one.name == record.name; });
        if (look == m_look.structures.end()) {
            out.colour = meshio::defaultColour(record.name, number);
            return out;
        }
        out.colour = look->colour;
        out.opacity = look->opacity;
        out.maps = look->maps;
        out.inside = out.layer == 0 ? look->inside : std::string(); // lump properties, for the measures of lumps
        out.young_ratio = look->young_ratio;
        out.young_kPa = look->young_kPa;
        out.felt_contact_radius_mm = look->felt_contact_radius_mm;
        out.visible = look->visible || record.palpable;
        out.palpable = record.palpable || (look->palpable && !look->visible); // hidden structures are not palpable
        return out;
    }

    /// The motion is the recorded one. Its description is the scene file's, if that still has one.
    void applyRecordedMotion(meshio::LoadedStructure& one, const StructureRecord& record) const
    {
        one.motion = record.motion;
        const auto look = std::find_if(m_look.structures.begin(), m_look.structures.end(),
                                       [&](const meshio::SceneStructure& other) { return other.name == record.name; });
        if (record.motion != nullptr && look != m_look.structures.end()) {
            one.description.motion = look->motion;
            one.description.pulse = look->pulse;
        }
    }

    std::optional<meshio::LoadedStructure> embedded(const StructureRecord& record, std::size_t number)
    {
        auto surface = m_reader.embedded(record.source.sha256);
        if (!surface.isOk()) {
            if (surface.status().code() != StatusCode::NotFound) {
                m_out.losses.push_back(surface.status().at(record.name).text());
            }
            return std::nullopt;
        }
        meshio::LoadedStructure out;
        out.description = description(record, number);
        out.surface = std::make_shared<const geometry::RepairedMesh>(std::move(surface).value());
        return out;
    }

    /// Reads the remaining surfaces from mesh files. @return Cancelled
    Status readMeshes()
    {
        meshio::SceneFile wanted;
        std::vector<std::size_t> numbers;
        for (std::size_t i = 0; i < m_records.size(); ++i) {
            const fs::path said = m_records[i].source.mesh;
            const auto mesh = m_found[i] ? std::nullopt : locateFile(m_reader, said);
            if (mesh) {
                wanted.structures.push_back(description(m_records[i], i));
                wanted.structures.back().mesh = fs::absolute(*mesh).lexically_normal();
                numbers.push_back(i);
            } else if (!m_found[i]) {
                m_out.losses.push_back(
                    {PALPATE_TEXT("%1: %2: no such file, neither where it was nor beside the recording"),
                     m_records[i].name, said.filename()});
            }
        }
        if (wanted.structures.empty()) {
            return {};
        }
        const std::vector<meshio::SceneStructure> asked = wanted.structures;
        meshio::ReadOptions options = m_options;
        options.frame = core::FileFrame::Untagged; // as during recording
        auto read = meshio::loadScene(std::move(wanted), m_reader.path(), options);
        if (!read.isOk()) {
            if (read.status().code() != StatusCode::Cancelled) {
                m_out.losses.push_back(read.status().text());
                return {};
            }
            return read.status();
        }
        meshio::LoadedScene& loaded = read.value();
        m_out.warnings = std::move(loaded.warnings);
        m_out.losses.insert(m_out.losses.end(), loaded.losses.begin(), loaded.losses.end());
        // In the order of `asked`, without files that could not be opened.
        std::size_t next = 0;
        for (std::size_t i = 0; i < asked.size() && next < loaded.structures.size(); ++i) {
            meshio::LoadedStructure& one = loaded.structures[next];
            if (one.description.name != asked[i].name || one.description.mesh != asked[i].mesh) {
                continue;
            }
            const StructureRecord& record = m_records[numbers[i]];
            if (!record.source.sha256.empty() && session::geometryHash(one.surface->mesh) != record.source.sha256) {
                m_out.losses.push_back(
                    {PALPATE_TEXT("%1: %2: is another surface now than was recorded; opened as it is now"), record.name,
                     asked[i].mesh.filename()});
            }
            m_found[numbers[i]] = std::move(one);
            ++next;
        }
        return {};
    }

    /// Applies the recorded maps to a structure with different maps.
    void applyRecordedMaps(meshio::LoadedStructure& one, const StructureRecord& record)
    {
        if (record.tissueMaps.hasFelt()) {
            applyRecordedLumps(one, record);
        }
        if (one.maps.empty() && record.tissueMaps.isEmpty()) {
            return;
        }
        const auto index = indexed(*one.surface);
        const haptics::TissueMaps own = tissueMaps(one, *index);
        const auto& members = haptics::TissueMaps::kQuantities;
        const bool isSame = std::all_of(members.begin(), members.end(), [&](const auto member) {
            return isSameMap(own.*member, record.tissueMaps.*member);
        });
        if (isSame) {
            return;
        }
        one.maps.clear();
        for (std::size_t i = 0; i < members.size(); ++i) {
            const auto quantity = static_cast<core::MappedQuantity>(i);
            const haptics::TissueMap& map = record.tissueMaps.of(quantity);
            if (map.isEmpty()) {
                continue;
            }
            if (map.corners->size() != index->triangleCount()) {
                m_out.losses.push_back(
                    {PALPATE_TEXT("%1: its recorded map is of another surface; it is not felt"), record.name});
                continue;
            }
            one.maps.push_back(surfaceMap(map, quantity, *index, *one.surface));
        }
    }

    /// Applies the recorded effect of buried lumps to a structure without recomputing that effect.
    void applyRecordedLumps(meshio::LoadedStructure& one, const StructureRecord& record)
    {
        const auto index = indexed(*one.surface);
        for (const haptics::TissueMap& felt : record.tissueMaps.felt) {
            if (felt.isEmpty() || felt.corners->size() != index->triangleCount()) {
                m_out.losses.push_back(
                    {PALPATE_TEXT("%1: the recorded effect of its lumps is of another surface; it is not "
                                  "felt"),
                     record.name});
                one.feltBelow.clear();
                return;
            }
            std::vector<float>& values = one.feltBelow.emplace_back(one.surface->mesh.vertices.size(), 1.0F);
            for (std::uint32_t i = 0; i < index->triangleCount(); ++i) {
                const geometry::Triangle& corners = one.surface->mesh.triangles[index->sourceTriangle(i)];
                for (std::size_t corner = 0; corner < 3; ++corner) {
                    values[corners[corner]] = (*felt.corners)[i][corner];
                }
            }
        }
    }

    const RecordingReader& m_reader;
    const meshio::ReadOptions& m_options;
    std::vector<StructureRecord> m_records;
    std::vector<RecordedLook> m_looks; ///< by index in `m_records`
    meshio::SceneFile m_look;
    std::vector<std::optional<meshio::LoadedStructure>> m_found; ///< by index in `m_records`
    meshio::LoadedScene m_out;
};

} // namespace

Result<meshio::LoadedScene> openScene(const fs::path& path, const meshio::ReadOptions& options,
                                      std::vector<OrganPalpability>* felt)
{
    if (session::isRecordingByNameOrContent(path)) {
        return sceneOfRecording(path, options);
    }
    auto loaded = meshio::loadScene(path, options);
    if (!loaded.isOk() && loaded.status().code() == StatusCode::Empty) {
        if (Status dicom = meshio::dicomFolder(path); !dicom.isOk()) {
            return dicom;
        }
    }
    if (loaded.isOk()) {
        if (Status status = applyBuriedLumps(loaded.value(), options.progress, felt); !status.isOk()) {
            return status;
        }
    }
    return loaded;
}

void setSceneSource(session::RecordingInfo& info, const fs::path& scene)
{
    if (scene.empty()) {
        return;
    }
    std::error_code error; // fails without a working directory
    const fs::path whole = fs::absolute(scene, error).lexically_normal();
    info.scene = (error ? scene : whole).string();
    info.sceneSha256 = meshio::isSceneFile(info.scene) ? meshio::fileHash(info.scene) : std::string();
}

fs::path recordedMeshFile(const RecordingReader& reader, const StructureRecord& structure)
{
    return locateFile(reader, structure.source.mesh).value_or(structure.source.mesh);
}

std::optional<fs::path> recordedSceneFile(const RecordingReader& reader)
{
    return reader.info().scene.empty() ? std::nullopt
                                       : locateFile(reader, reader.info().scene, reader.info().sceneBeside);
}

Result<MeshesByHash> recordedSurfaces(const RecordingReader& reader, const fs::path& scene)
{
    MeshesByHash meshes;
    for (const std::string& hash : reader.embeddedHashes()) {
        auto surface = reader.embedded(hash);
        if (!surface.isOk()) {
            return surface.status();
        }
        meshes[hash] = std::make_shared<const geometry::RepairedMesh>(std::move(surface).value());
    }
    const std::vector<std::string> felt = palpableHashes(reader);
    const bool isWhole =
        std::all_of(felt.begin(), felt.end(), [&](const std::string& hash) { return meshes.contains(hash); });
    if (scene.empty() && isWhole && !meshes.empty()) {
        return meshes;
    }
    // One scene file, or individually opened mesh files.
    std::vector<fs::path> files;
    if (!scene.empty()) {
        files.push_back(scene);
    } else if (!reader.info().scene.empty()) {
        files.push_back(recordedSceneFile(reader).value_or(reader.info().scene));
    } else if (!reader.scenes().empty()) {
        for (const StructureRecord& structure : reader.scenes().front().structures) {
            const fs::path file = recordedMeshFile(reader, structure);
            if (!file.empty() && std::find(files.begin(), files.end(), file) == files.end()) {
                files.push_back(file);
            }
        }
    }
    if (files.empty()) {
        return Status(StatusCode::NotFound, PALPATE_TEXT("the recording does not say what scene it was made on"));
    }
    for (const fs::path& file : files) {
        const meshio::ReadOptions options = readAs(reader, file);
        std::error_code error;
        if (!fs::exists(file, error)) {
            return Status(StatusCode::NotFound, PALPATE_TEXT("%1: no such file"), file);
        }
        const auto loaded = openScene(file, options);
        if (!loaded.isOk()) {
            return loaded.status();
        }
        meshes.merge(meshesByHash(loaded.value()));
    }
    return meshes;
}

Result<meshio::LoadedScene> sceneOfRecording(const fs::path& recording, const meshio::ReadOptions& options)
{
    const auto opened = RecordingReader::open(recording);
    return opened.isOk() ? Reopening(*opened.value(), options).run() : opened.status();
}

Result<meshio::LoadedScene> openAsRecorded(const RecordingReader& reader, const fs::path& scene)
{
    return openScene(scene, readAs(reader, scene));
}

bool hasFingertip(const RecordingReader& reader)
{
    return !reader.scenes().empty() && reader.scenes().front().fingertip_mm > 0.0;
}

double defaultDistance_mm(const RecordingReader& reader, const session::MeshesByHash& surfaces)
{
    constexpr double kLeast_mm = 1.0; // smaller values are costly without adding information
    const double usual_mm = hasFingertip(reader) ? std::max(reader.scenes().front().fingertip_mm, kLeast_mm)
                                                 : session::MeasureOptions().distance_mm;
    return std::max(usual_mm, session::minDistance_mm(surfaces));
}

} // namespace palpate::study

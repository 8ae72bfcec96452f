// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/Replay.h"
#include "store/MapRows.h"
#include "tables/Contacts.h"
#include "tables/OldVelocity.h"
#include "tables/Packing.h"

#include <palpate/core/Numbers.h>
#include <palpate/haptics/ForceTable.h>
#include <palpate/servo/ServoCore.h>

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

namespace palpate::session {

using core::Status;
using core::StatusCode;

namespace {

std::string text(const Vec3& v)
{
    std::string out = "(";
    for (const double value : v) {
        core::appendNumber(out, value);
        out += out.size() > 1 ? " " : "";
    }
    out.back() = ')';
    return out;
}

/// Runs the recorded rows through a Palpator.
class Resimulator
{
  public:
    Resimulator(const RecordingReader& recording, const SurfacesByHash& surfaces, const TickSink& sink)
        : m_recording(recording)
        , m_surfaces(surfaces)
        , m_sink(sink)
        , m_oldVelocity(recording.info())
    {
    }

    core::Result<Resimulation> run()
    {
        if (Status status = useScene(m_recording.info().firstGeneration); !status.isOk()) {
            return status;
        }
        if (Status status = checkStart(m_recording.info().start); !status.isOk()) {
            return status;
        }
        m_palpator.restore(m_recording.info().start);
        m_nextTick = m_recording.info().firstTick;
        const Status read =
            m_recording.forEach(std::numeric_limits<std::int64_t>::min(), std::numeric_limits<std::int64_t>::max(),
                                [this](const servo::TickRecord& row) { return take(row); });
        if (!read.isOk()) {
            return read;
        }
        if (!m_status.isOk()) {
            return m_status;
        }
        return m_result;
    }

  private:
    Status useScene(std::uint32_t generation)
    {
        std::shared_ptr<const haptics::HapticScene>& scene = m_scenes[generation];
        if (scene == nullptr && generation != 0) {
            const SceneRecord* record = m_recording.scene(generation);
            if (record == nullptr) {
                return {StatusCode::BadFormat, PALPATE_TEXT("scene generation %1 is not described in the recording"),
                        generation};
            }
            auto built = rebuildScene(*record, m_surfaces);
            if (!built.isOk()) {
                return built.status();
            }
            scene = std::move(built).value();
        }
        m_palpator.borrowScene(scene.get(),
                               hasContinuity() ? haptics::Continuity::Contacts : haptics::Continuity::Places);
        boundRounding(scene.get());
        m_generation = generation;
        return {};
    }

    /// Validates structure and triangle indices of a state, because the solver uses them unchecked and the file is
    /// untrusted.
    Status checkStart(const haptics::PalpatorState& state) const
    {
        const auto found = m_scenes.find(m_generation);
        const haptics::HapticScene* const scene = found == m_scenes.end() ? nullptr : found->second.get();
        for (std::size_t i = 0; i < state.layers.size(); ++i) {
            const haptics::GodObjectState& god = state.layers[i];
            for (std::size_t k = 0; k < god.constraints; ++k) {
                const bool hasLayer = scene != nullptr && i < scene->layerCount();
                const auto& felt = hasLayer ? scene->layer(i).structures : std::vector<std::uint32_t>();
                const bool isFelt = std::find(felt.begin(), felt.end(), god.structure[k]) != felt.end();
                if (!isFelt || god.triangle[k] >= scene->structures()[god.structure[k]].surface->triangleCount()) {
                    return {StatusCode::BadFormat,
                            PALPATE_TEXT("the state before the first tick: found contact with triangle %1 of "
                                         "structure %2, expected one of the scene's layer %3"),
                            god.triangle[k], god.structure[k], i};
                }
            }
        }
        return {};
    }

    /// Version 4 added velocities and contacts that persist across scene changes.
    bool hasContinuity() const { return m_recording.info().tickVersion >= 4; }

    bool take(const servo::TickRecord& row)
    {
        const bool isGap = row.tick != std::exchange(m_nextTick, row.tick + 1);
        if ((isGap || (row.flags & servo::kDroppedBefore) != 0) && (row.flags & servo::kReset) == 0) {
            lose();
        }
        if (row.scene != m_generation) {
            if (m_mayHaveLeft) { // a contact of before may return
                m_isLost = true;
            }
            m_mayHaveLeft = m_mayHaveLeft || m_isLost;
            m_status = useScene(row.scene);
            if (!m_status.isOk()) {
                return false;
            }
        }
        std::uint16_t flags = row.flags;
        if (m_isLost) {
            const bool isFree = row.felt.structure < 0 && internal::sameBits(row.felt.p_WG, row.p_WH);
            if ((flags & servo::kReset) == 0 && (!isFree || (flags & servo::kNoHand) != 0)) {
                ++m_result.unverified;
                return true;
            }
            // In free space every god-object is at the HIP, so the state is known again, except for contacts with
            // removed structures.
            flags |= servo::kReset;
            m_isLost = false;
        }
        if ((row.flags & servo::kReset) != 0) {
            m_mayHaveLeft = false;
        }
        servo::TickRecord now = row;
        now.flags = flags;
        if (!hasContinuity()) {
            m_oldVelocity.fillIn(now);
        }
        servo::feelTick(m_palpator, m_recording.info().dt_s, now);
        now.flags = row.flags;
        ++m_result.compared;
        if ((flags & servo::kNoHand) == 0) {
            compare(row, now);
        }
        return !m_sink || m_sink(now);
    }

    /// Ticks are missing.
    void lose()
    {
        m_isLost = true;
        const auto left = m_palpator.state().left;
        m_mayHaveLeft = m_mayHaveLeft || std::any_of(left.begin(), left.end(),
                                                     [](const haptics::LostContact& one) { return one.isKept != 0; });
    }

    void compare(const servo::TickRecord& row, const servo::TickRecord& now)
    {
        const haptics::TickResult& was = row.felt;
        const haptics::TickResult& is = now.felt;
        const bool isSamePlace = internal::sameBits(was.p_WG, is.p_WG);
        const bool isSameForce = internal::sameBits(was.f_W, is.f_W);
        const bool isSameTouch =
            was.structure == is.structure && was.constraints == is.constraints && was.triangle == is.triangle;
        const bool knowsLayers = m_recording.info().version >= 3;
        if (isSamePlace && isSameForce && isSameTouch && (!knowsLayers || internal::sameContacts(was, is))) {
            return;
        }
        ++m_result.differing;
        const double apart_mm = std::max((was.p_WG - is.p_WG).norm(), knowsLayers ? layersApart(was, is) : 0.0);
        const double apart_N = (was.f_W - is.f_W).norm();
        m_result.farthest_mm = std::max(m_result.farthest_mm, apart_mm);
        m_result.farthest_N = std::max(m_result.farthest_N, apart_N);
        const auto places = [&] {
            return core::Message(PALPATE_TEXT("tick %1: god-object recorded at %2, now %3, %4 mm apart"), row.tick,
                                 text(was.p_WG), text(is.p_WG), core::shortNumber(apart_mm, 3));
        };
        const auto forces = [&] {
            return core::Message(PALPATE_TEXT("tick %1: force recorded as %2, now %3, %4 N apart"), row.tick,
                                 text(was.f_W), text(is.f_W), core::shortNumber(apart_N, 3));
        };
        const auto touches = [&] {
            return core::Message(PALPATE_TEXT("tick %1: structure, triangle and constraints recorded as %2, now %3"),
                                 row.tick, touch(was), touch(is));
        };
        const auto layers = [&] {
            return core::Message(PALPATE_TEXT("tick %1: layers (structure, triangle, friction) recorded as %2, now %3"),
                                 row.tick, touched(was), touched(is));
        };
        if (!m_result.firstDifference) {
            m_result.firstDifference = row.tick;
            m_result.difference = !isSamePlace   ? places()
                                  : !isSameForce ? forces()
                                  : !isSameTouch ? touches()
                                                 : layers();
        }
        // Written so that NaN fails the comparison.
        const bool isNear = apart_mm <= m_rounding_mm;
        const bool isAlike = apart_N <= m_rounding_N + kForceRounding * was.f_W.norm();
        // With nearly zero force, one build may touch a structure that the other just misses.
        const bool isSameStructure = was.structure == is.structure || was.structure < 0 || is.structure < 0;
        if (!(isNear && isAlike && isSameStructure) && !m_result.firstBeyond) {
            m_result.firstBeyond = row.tick;
            m_result.beyond = !isNear ? places() : !isAlike ? forces() : touches();
        }
    }

    /// Returns the largest distance between god-objects of the same layer. A contact in only one of the two results is
    /// detected by its force.
    static double layersApart(const haptics::TickResult& was, const haptics::TickResult& is)
    {
        double apart_mm = 0.0;
        for (std::size_t i = 0; i < was.contactCount; ++i) {
            for (std::size_t j = 0; j < is.contactCount; ++j) {
                if (was.contacts[i].layer == is.contacts[j].layer) {
                    apart_mm = std::max(apart_mm, (was.contacts[i].p_WG - is.contacts[j].p_WG).norm());
                }
            }
        }
        return apart_mm;
    }

    static core::MessageArgument touched(const haptics::TickResult& felt)
    {
        std::string out;
        for (std::size_t i = 0; i < felt.contactCount; ++i) {
            const haptics::Contact& contact = felt.contacts[i];
            out += (i > 0 ? " (" : "(") + std::to_string(contact.structure) + ' ' + std::to_string(contact.triangle) +
                   ' ' + std::to_string(static_cast<int>(contact.friction)) + ')';
        }
        return out.empty() ? core::MessageArgument(core::Message(PALPATE_TEXT("none"))) : out;
    }

    static std::string touch(const haptics::TickResult& felt)
    {
        std::string out(1, '(');
        out += std::to_string(felt.structure) + ' ' + std::to_string(felt.triangle) + ' ';
        return out + std::to_string(felt.constraints) + ')';
    }

    /// Computes the maximum effect of rounding for a scene.
    void boundRounding(const haptics::HapticScene* scene)
    {
        m_rounding_mm = 0.0;
        m_rounding_N = 0.0;
        for (std::size_t i = 0; scene != nullptr && i < scene->layerCount(); ++i) {
            const double layer_mm = kRoundingTolerance_skins * scene->layer(i).skin_mm;
            double stiffest = 0.0;
            for (const std::uint32_t number : scene->layer(i).structures) {
                const haptics::HapticStructure& structure = scene->structures()[number];
                stiffest = std::max(stiffest, structure.law == nullptr ? structure.tissue.stiffness_N_per_mm
                                                                       : structure.law->greatestSlope_N_per_mm());
            }
            m_rounding_mm = std::max(m_rounding_mm, layer_mm);
            m_rounding_N += stiffest * layer_mm;
        }
        m_result.rounding_mm = std::max(m_result.rounding_mm, m_rounding_mm);
    }

    /// Relative rounding error of a force: two products and a sum for each of up to four layers, each rounded to half
    /// an eps.
    static constexpr double kForceRounding =
        1.5 * static_cast<double>(haptics::HapticScene::kMaxLayers) * std::numeric_limits<double>::epsilon();

    const RecordingReader& m_recording;
    const SurfacesByHash& m_surfaces;
    const TickSink& m_sink;
    internal::OldVelocity m_oldVelocity; ///< for recordings without velocities
    haptics::Palpator m_palpator;
    std::map<std::uint32_t, std::shared_ptr<const haptics::HapticScene>> m_scenes;
    std::uint32_t m_generation = 0;
    std::int64_t m_nextTick = 0;
    double m_rounding_mm = 0.0; ///< for the current scene
    double m_rounding_N = 0.0;
    bool m_isLost = false;      ///< ticks are missing and the state is still unknown
    bool m_mayHaveLeft = false; ///< since ticks were missing: there may be contacts with removed structures
    Status m_status;
    Resimulation m_result;
};

} // namespace

namespace {

/// Returns why the maps of a structure do not fit a surface; empty if they do.
core::Message faultOfMaps(const StructureRecord& structure, const geometry::SurfaceIndex& surface)
{
    const haptics::TissueMaps& maps = structure.tissueMaps;
    if (internal::mapsText({maps, structure.motion}) != structure.maps) {
        return core::Message(PALPATE_TEXT("a map of its tissue or its motion is not in the recording, or damaged"));
    }
    for (const haptics::TissueMap* map : maps.all()) {
        if (!map->isEmpty() && map->corners->size() != surface.triangleCount()) {
            return {PALPATE_TEXT("a map of its tissue has %1 triangles, expected %2"), map->corners->size(),
                    surface.triangleCount()};
        }
    }
    return {};
}

} // namespace

core::Result<std::shared_ptr<const haptics::HapticScene>> rebuildScene(const SceneRecord& record,
                                                                       const SurfacesByHash& surfaces)
{
    std::vector<haptics::HapticStructure> structures;
    for (const StructureRecord& structure : record.structures) {
        haptics::HapticStructure& out = structures.emplace_back();
        out.name = structure.name;
        out.tissue = structure.tissue;
        out.layer = structure.layer;
        if (!structure.lawTable.empty()) {
            auto table = haptics::ForceTable::fromBytes(std::as_bytes(std::span(structure.lawTable)));
            if (!table.isOk()) {
                return Status(StatusCode::BadFormat, PALPATE_TEXT("structure \"%1\" of the recording: law_table: %2"),
                              structure.name, table.status().text());
            }
            out.law = std::move(table).value();
        }
        if (!structure.palpable) {
            continue;
        }
        const auto found = surfaces.find(structure.source.sha256);
        if (found == surfaces.end() || found->second == nullptr) {
            return Status(
                StatusCode::Mismatch,
                PALPATE_TEXT("structure \"%1\" of the recording: its geometry (SHA-256 %2...) is not in the scene"),
                structure.name, structure.source.sha256.substr(0, 12));
        }
        out.surface = found->second;
        out.maps = structure.tissueMaps;
        out.motion = structure.motion;
        if (const core::Message wrong = faultOfMaps(structure, *out.surface); !wrong.isEmpty()) {
            return Status(StatusCode::Mismatch, PALPATE_TEXT("structure \"%1\" of the recording: %2"), structure.name,
                          wrong);
        }
    }
    if (!(record.fingertip_mm >= 0.0 && record.fingertip_mm <= haptics::HapticScene::kMostFingertip_mm)) {
        return Status(StatusCode::BadFormat,
                      PALPATE_TEXT("found a fingertip radius of %1 mm in the recording, expected 0 to %2"),
                      record.fingertip_mm, haptics::HapticScene::kMostFingertip_mm);
    }
    return std::shared_ptr<const haptics::HapticScene>(
        std::make_shared<haptics::HapticScene>(std::move(structures), record.fingertip_mm));
}

core::Result<Resimulation> resimulate(const RecordingReader& recording, const SurfacesByHash& surfaces,
                                      const TickSink& sink)
{
    return Resimulator(recording, surfaces, sink).run();
}

} // namespace palpate::session

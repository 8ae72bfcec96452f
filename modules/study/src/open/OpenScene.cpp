// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/OpenScene.h"

#include "palpate/study/DeviceLimit.h"
#include "palpate/study/HapticCopy.h"
#include "palpate/study/StructureSources.h"

#include <palpate/meshio/SurfaceMaps.h>

#include <algorithm>
#include <utility>

namespace palpate::study {

namespace {

using Kind = SceneEvent::Kind;

/// Text as compared by `givesTargetAway`: ASCII letters in lower case, "_" as a space, single spaces.
std::string comparable(const std::string& text)
{
    std::string plain;
    for (char c : text) {
        c = c == '_' ? ' ' : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
        if (c != ' ' || (!plain.empty() && plain.back() != ' ')) {
            plain += c;
        }
    }
    return plain;
}

/// The part of a comparable name that the window displays: reference libraries prefix every organ with the body.
std::string displayed(std::string name)
{
    for (const char* prefix : {"vh f ", "vh m "}) {
        if (name.starts_with(prefix)) {
            name.erase(0, 5);
        }
    }
    while (!name.empty() && name.back() == ' ') {
        name.pop_back();
    }
    return name;
}

/// Prepares the maps for the servo tick. @par Cost O(triangles) per map
void refreshTouchMaps(OpenStructure& one)
{
    const bool varies = !one.loaded.maps.empty() || !one.loaded.feltBelow.empty();
    one.felt = one.touch != nullptr && varies ? tissueMaps(one.loaded, *one.touch) : haptics::TissueMaps();
}

} // namespace

bool needsOtherSurface(const meshio::SceneStructure& a, const meshio::SceneStructure& b) noexcept
{
    return a.outwards != b.outwards || a.closeHoles_mm != b.closeHoles_mm || a.surface != b.surface ||
           (a.smoothing != b.smoothing && meshio::isSmoothed(b.surface)) ||
           (a.crease_deg != b.crease_deg && meshio::isCurved(b.surface));
}

void OpenScene::reset(std::vector<OpenStructure> structures, meshio::BuriedTouch buried,
                      std::optional<meshio::Exercise> exercise)
{
    m_structures = std::move(structures);
    m_buried = buried;
    m_exercise = std::move(exercise);
    m_undisclosed.clear();
    for (std::size_t i = 0; i < m_structures.size(); ++i) {
        if (m_structures[i].loaded.description.isHiddenTarget) {
            hide(i);
        }
    }
    for (OpenStructure& one : m_structures) {
        if (buried == meshio::BuriedTouch::Layers) {
            one.recordedBelow = one.loaded.feltBelow;
        }
        refreshTouchMaps(one);
    }
}

SceneEvents OpenScene::apply(const SceneEdit& edit)
{
    SceneEvents events;
    m_buried = edit.buried.value_or(m_buried);
    std::vector<meshio::SceneStructure> before;
    for (const SceneEdit::Description& one : edit.descriptions) {
        meshio::SceneStructure& now = m_structures[one.structure].loaded.description;
        before.push_back(std::exchange(now, one.description));
        now.isHiddenTarget = before.back().isHiddenTarget;
        if (const auto hidden = m_undisclosed.find(one.structure); hidden != m_undisclosed.end()) {
            const std::string name = std::move(hidden->second.name);
            hidden->second = now;
            hidden->second.name = name;
            now.name = kUnnamed; // the edit may be older than the exercise
        } else if (now.name == kUnnamed) {
            now.name = before.back().name; // the edit was made while the structure was a hidden target
        }
        if (before.back().maps != now.maps) {
            resolveMaps(one.structure, events);
        } else if (before.back().tissue != now.tissue) {
            refreshTouchMaps(m_structures[one.structure]);
        }
    }
    for (const std::size_t i : edit.removed) {
        m_structures[i].isRemoved = true;
    }
    for (const std::size_t i : edit.restored) {
        m_structures[i].isRemoved = false;
    }
    std::vector<std::size_t> others;
    clearTransmittedMaps(others);
    const std::vector<bool> isThrough = edit.buried ? transmitted() : std::vector<bool>();
    for (std::size_t i = 0; i < isThrough.size(); ++i) {
        if (isThrough[i]) {
            others.push_back(i);
        }
    }
    for (std::size_t i = 0; i < edit.descriptions.size(); ++i) {
        const std::size_t number = edit.descriptions[i].structure;
        const meshio::SceneStructure& now = m_structures[number].loaded.description;
        if (needsOtherSurface(before[i], now) && m_structures[number].loaded.asRead != nullptr) {
            events.push_back({Kind::SurfaceWanted, number});
        }
        note(number, before[i], before[i].maps != now.maps, events);
    }
    for (const auto* changed : {&edit.removed, &edit.restored}) {
        for (const std::size_t i : *changed) {
            events.push_back({Kind::Look, i});
            events.push_back({Kind::Touch, i});
        }
    }
    for (const std::size_t i : others) {
        events.push_back({Kind::Touch, i});
    }
    return events;
}

SceneEdit OpenScene::inverse(const SceneEdit& edit) const
{
    SceneEdit back;
    for (const SceneEdit::Description& one : edit.descriptions) {
        back.descriptions.push_back({one.structure, m_structures[one.structure].loaded.description});
    }
    if (edit.buried) {
        back.buried = m_buried;
    }
    back.removed = edit.restored;
    back.restored = edit.removed;
    return back;
}

std::size_t OpenScene::append(OpenStructure structure)
{
    structure.isRemoved = true;
    structure.loaded.isTransmitted = false;
    structure.loaded.description.isHiddenTarget = false; // of the exercise of another scene
    structure.loaded.feltBelow.clear();
    refreshTouchMaps(structure);
    m_structures.push_back(std::move(structure));
    return m_structures.size() - 1;
}

SceneEvents OpenScene::setTargetsHidden(bool areHidden)
{
    SceneEvents events;
    for (std::size_t i = 0; m_exercise && i < m_structures.size(); ++i) {
        meshio::SceneStructure& one = m_structures[i].loaded.description;
        const auto& targets = m_exercise->targets;
        const bool isTarget =
            !m_structures[i].isRemoved && std::find(targets.begin(), targets.end(), described(i).name) != targets.end();
        if (!isTarget || one.isHiddenTarget == areHidden) {
            continue;
        }
        if (areHidden) {
            one.isHiddenTarget = true;
            hide(i);
        } else {
            one = m_undisclosed.at(i);
            one.isHiddenTarget = false;
            one.visible = true; // at the end all targets are shown
            m_undisclosed.erase(i);
        }
        events.push_back({Kind::Look, i});
    }
    return events;
}

/// Replaces the name of a hidden target.
void OpenScene::hide(std::size_t structure)
{
    meshio::SceneStructure& one = m_structures[structure].loaded.description;
    m_undisclosed[structure] = one;
    one.name = kUnnamed;
}

const meshio::SceneStructure& OpenScene::described(std::size_t structure) const
{
    const auto hidden = m_undisclosed.find(structure);
    return hidden != m_undisclosed.end() ? hidden->second : m_structures[structure].loaded.description;
}

bool OpenScene::givesTargetAway(const std::string& text) const
{
    const std::string where = comparable(text);
    return std::any_of(m_undisclosed.begin(), m_undisclosed.end(), [&where](const auto& hidden) {
        const std::string file = hidden.second.part.empty() ? hidden.second.mesh.stem().string() : std::string();
        for (const std::string& name : {hidden.second.name, hidden.second.part, file}) {
            const std::string sought = displayed(comparable(name));
            if (!sought.empty() && where.find(sought) != std::string::npos) {
                return true;
            }
        }
        return false;
    });
}

std::size_t OpenScene::hiddenTargets() const noexcept
{
    return static_cast<std::size_t>(std::count_if(m_structures.begin(), m_structures.end(), [](const OpenStructure& s) {
        return !s.isRemoved && s.loaded.description.isHiddenTarget;
    }));
}

/// Adds the events of a new description.
void OpenScene::note(std::size_t structure, const meshio::SceneStructure& before, bool hasOtherMaps,
                     SceneEvents& events)
{
    const meshio::SceneStructure& now = m_structures[structure].loaded.description;
    const bool isRenamed = before.name != now.name;
    if (isRenamed) {
        events.push_back({Kind::Renamed, structure, before.name});
        if (m_exercise) {
            std::replace(m_exercise->targets.begin(), m_exercise->targets.end(), before.name, now.name);
        }
    }
    if (before.colour != now.colour || before.opacity != now.opacity || isDrawn(before) != isDrawn(now)) {
        events.push_back({Kind::Look, structure});
    }
    const bool hasOtherLump = before.inside != now.inside || before.young_ratio != now.young_ratio ||
                              before.young_kPa != now.young_kPa ||
                              before.felt_contact_radius_mm != now.felt_contact_radius_mm;
    if (canBeFelt(before) != canBeFelt(now) || before.tissue != now.tissue || before.layer != now.layer ||
        hasOtherMaps || isRenamed || hasOtherLump) {
        events.push_back({Kind::Touch, structure});
    }
}

/// Reads the maps of a structure from arrays of its mesh, or asks for those of volumes.
void OpenScene::resolveMaps(std::size_t structure, SceneEvents& events)
{
    OpenStructure& one = m_structures[structure];
    const auto& mappings = one.loaded.description.maps;
    if (mappings && std::any_of(mappings->begin(), mappings->end(), [](const auto& m) { return m.array.empty(); })) {
        events.push_back({Kind::MapsWanted, structure}); // volumes are read on a worker thread
        return;
    }
    std::vector<core::Message> warnings, losses;
    meshio::resolveMaps(one.loaded, warnings, losses);
    one.mapProblems = std::move(losses);
    refreshTouchMaps(one);
}

/// Clears the maps of lumps that are no longer in transmitted mode. @param changed  receives structures with other
/// touch
void OpenScene::clearTransmittedMaps(std::vector<std::size_t>& changed)
{
    const std::vector<bool> isThrough = transmitted();
    const bool isAny = std::find(isThrough.begin(), isThrough.end(), true) != isThrough.end();
    for (std::size_t i = 0; i < m_structures.size(); ++i) {
        OpenStructure& one = m_structures[i];
        const bool isLost = one.loaded.isTransmitted && !isThrough[i];
        const bool isOther = !isAny && one.loaded.feltBelow != one.recordedBelow;
        one.loaded.isTransmitted = one.loaded.isTransmitted && !isLost;
        if (isOther) {
            one.loaded.feltBelow = one.recordedBelow;
            refreshTouchMaps(one);
        }
        if (isLost || isOther) {
            changed.push_back(i);
        }
    }
}

SceneEvents OpenScene::setTransmittedMaps(const std::vector<TransmittedMap>& maps)
{
    SceneEvents events;
    if (m_buried != meshio::BuriedTouch::Felt) {
        return events;
    }
    std::vector<bool> isThrough(m_structures.size());
    std::vector<const std::vector<std::vector<float>>*> below(m_structures.size());
    for (const TransmittedMap& one : maps) {
        below[one.organ] = &one.below;
        for (const std::size_t lump : one.lumps) {
            isThrough[lump] = true;
        }
    }
    for (std::size_t i = 0; i < m_structures.size(); ++i) {
        meshio::LoadedStructure& one = m_structures[i].loaded;
        const bool isOtherMap = below[i] == nullptr ? !one.feltBelow.empty() : one.feltBelow != *below[i];
        if (isOtherMap) {
            one.feltBelow = below[i] == nullptr ? std::vector<std::vector<float>>() : *below[i];
            refreshTouchMaps(m_structures[i]);
        }
        if (isOtherMap || one.isTransmitted != isThrough[i]) {
            one.isTransmitted = isThrough[i];
            events.push_back({Kind::Touch, i});
        }
    }
    return events;
}

void OpenScene::setNesting(const std::vector<std::optional<std::size_t>>& in)
{
    for (std::size_t i = 0; i < std::min(in.size(), m_structures.size()); ++i) {
        m_structures[i].in = in[i];
    }
}

void OpenScene::setTouch(std::size_t structure, std::shared_ptr<const geometry::SurfaceIndex> touch, std::string sha256)
{
    OpenStructure& one = m_structures[structure];
    one.touch = std::move(touch);
    one.sha256 = std::move(sha256);
    refreshTouchMaps(one);
}

void OpenScene::setMotion(std::size_t structure, std::shared_ptr<const geometry::SurfaceMotion> motion)
{
    m_structures[structure].loaded.motion = std::move(motion);
}

bool OpenScene::setMaps(std::size_t structure, const std::optional<std::vector<core::TissueMapping>>& of,
                        std::vector<meshio::SurfaceMap> maps, std::vector<core::Message> problems)
{
    OpenStructure& one = m_structures[structure];
    if (one.loaded.description.maps != of) {
        return false;
    }
    one.loaded.maps = std::move(maps);
    one.mapProblems = std::move(problems);
    refreshTouchMaps(one);
    return true;
}

std::optional<SceneEvents> OpenScene::setSurface(std::size_t structure, const OpenStructure& built)
{
    SceneEvents events;
    OpenStructure& one = m_structures[structure];
    const meshio::SceneStructure &now = one.loaded.description, &of = built.loaded.description;
    if (needsOtherSurface(now, of)) {
        return std::nullopt;
    }
    if (built.loaded.surface->mesh.vertices.size() != one.loaded.surface->mesh.vertices.size()) {
        one.loaded.feltBelow.clear(); // sized for the old vertices
        one.recordedBelow.clear();
    }
    one.loaded.surface = built.loaded.surface;
    one.loaded.staircase = built.loaded.staircase;
    one.loaded.closing = built.loaded.closing;
    one.loaded.smoothing = built.loaded.smoothing;
    one.loaded.curving = built.loaded.curving;
    one.touch = built.touch;
    one.sha256 = built.sha256;
    if (now.maps == of.maps) {
        one.loaded.maps = built.loaded.maps;
        one.mapProblems = built.mapProblems;
        refreshTouchMaps(one);
    } else {
        resolveMaps(structure, events);
    }
    return events;
}

LumpRule OpenScene::lumpRule() const
{
    std::vector<PlacedStructure> placed;
    for (std::size_t i = 0; i < m_structures.size(); ++i) {
        const OpenStructure& one = m_structures[i];
        placed.push_back({&described(i), one.isThere() ? one.loaded.surface.get() : nullptr, one.in});
    }
    return LumpRule(std::move(placed));
}

bool OpenScene::isTransmitted(std::size_t structure) const
{
    return m_buried == meshio::BuriedTouch::Felt && lumpRule().feltThrough(structure);
}

std::vector<bool> OpenScene::transmitted() const
{
    std::vector<bool> isThrough(m_structures.size());
    if (m_buried == meshio::BuriedTouch::Felt) {
        const LumpRule rule = lumpRule();
        for (std::size_t i = 0; i < m_structures.size(); ++i) {
            isThrough[i] = static_cast<bool>(rule.feltThrough(i));
        }
    }
    return isThrough;
}

std::vector<haptics::HapticStructure> OpenScene::hapticStructures(const haptics::Tissue& limit) const
{
    std::vector<haptics::HapticStructure> structures;
    structures.reserve(m_structures.size());
    const LumpRule rule = lumpRule();
    const std::vector<bool> isThrough = transmitted();
    for (std::size_t i = 0; i < m_structures.size(); ++i) {
        const OpenStructure& one = m_structures[i];
        const meshio::SceneStructure& from = described(i);
        const bool isTouched = canBeFelt(from) && !one.loaded.isTransmitted && !one.isRemoved;
        structures.push_back(hapticStructure(from, isTouched ? one.touch : nullptr));
        if (structures.back().surface != nullptr) {
            structures.back().maps = one.felt;
            structures.back().motion = one.loaded.motion;
            if (isThrough[i]) {
                structures.back().layer = rule.layerWithin(i); // map not computed yet, or the model does not apply
            }
        }
    }
    limitTissues(limit, structures);
    return structures;
}

std::shared_ptr<const haptics::HapticScene> OpenScene::hapticScene(const haptics::Tissue& limit,
                                                                   double fingertip_mm) const
{
    return std::make_shared<const haptics::HapticScene>(hapticStructures(limit), fingertip_mm);
}

std::vector<session::StructureSource> OpenScene::sources() const
{
    std::vector<session::StructureSource> sources;
    for (const OpenStructure& one : m_structures) {
        if (one.isRemoved) {
            sources.emplace_back(); // keeps the numbers of the structures
            continue;
        }
        sources.push_back(sourceOf(one.loaded.description, one.sha256));
        sources.back().embed = one.touch == nullptr ? nullptr : one.loaded.surface;
    }
    return sources;
}

meshio::LoadedScene OpenScene::loadedScene() const
{
    meshio::LoadedScene scene;
    scene.scene.buried = m_buried;
    for (std::size_t i = 0; i < m_structures.size(); ++i) {
        const OpenStructure& from = m_structures[i];
        meshio::LoadedStructure one;
        one.description = described(i);
        one.surface = from.isRemoved ? nullptr : from.loaded.surface;
        scene.structures.push_back(std::move(one));
    }
    return scene;
}

meshio::SceneFile OpenScene::sceneFile(meshio::SceneFile rest) const
{
    rest.buried = m_buried;
    for (std::size_t i = 0; i < m_structures.size(); ++i) {
        if (!m_structures[i].isRemoved) {
            rest.structures.push_back(described(i));
        }
    }
    rest.exercise = m_exercise;
    if (rest.exercise) {
        std::erase_if(rest.exercise->targets, [&rest](const std::string& name) { // removed from the scene
            return std::none_of(rest.structures.begin(), rest.structures.end(),
                                [&name](const meshio::SceneStructure& one) { return one.name == name; });
        });
        if (rest.exercise->targets.empty()) {
            rest.exercise.reset();
        }
    }
    return rest;
}

} // namespace palpate::study

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/CompareSessions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace palpate::session {

using core::Message;

namespace {

std::set<StructureKey> palpableSurfaces(const RecordingReader& reader)
{
    std::set<StructureKey> palpable;
    for (const SceneRecord& scene : reader.scenes()) {
        for (const StructureRecord& structure : scene.structures) {
            if (structure.palpable) {
                palpable.emplace(structure.name, structure.source.sha256);
            }
        }
    }
    return palpable;
}

bool hasName(const std::set<StructureKey>& surfaces, const std::string& name)
{
    return std::any_of(surfaces.begin(), surfaces.end(), [&](const StructureKey& one) { return one.first == name; });
}

/// Describes the first difference. @return empty: none
Message surfaceDifference(const std::set<StructureKey>& first, const std::set<StructureKey>& second)
{
    for (const StructureKey& one : first) {
        if (!second.contains(one)) {
            return hasName(second, one.first) ? Message(PALPATE_TEXT("the surface of %1 is another one"), one.first)
                                              : Message(PALPATE_TEXT("%1 was palpable only in the first"), one.first);
        }
    }
    for (const StructureKey& one : second) {
        if (!first.contains(one)) {
            return hasName(first, one.first) ? Message(PALPATE_TEXT("the surface of %1 is another one"), one.first)
                                             : Message(PALPATE_TEXT("%1 was palpable only in the second"), one.first);
        }
    }
    return {};
}

/// Collects the measures of one group.
class GroupRows
{
  public:
    explicit GroupRows(std::string structure, bool isSearch = false)
    {
        m_group.structure = std::move(structure);
        m_group.isSearch = isSearch;
    }

    void add(const char* key, core::MessageText<> name, std::optional<double> first, std::optional<double> second,
             int digits = 4)
    {
        m_group.measures.push_back({key, Message(name), digits, false, first, second});
    }
    void addForce(const char* key, core::MessageText<> name, std::optional<double> first, std::optional<double> second)
    {
        m_group.measures.push_back({key, Message(name), 4, true, first, second});
    }
    /// Adds the contact. A side without contact has no forces and depths. @param a,  b  null: never touched
    void addContact(const ContactMeasures* a, const ContactMeasures* b)
    {
        const auto of = [](const ContactMeasures* m, double ContactMeasures::*value) {
            return m != nullptr && m->ticks > 0 ? std::optional(m->*value) : std::nullopt;
        };
        const auto number = [](const ContactMeasures* m, auto ContactMeasures::*value) {
            return m != nullptr ? static_cast<double>(m->*value) : 0.0;
        };
        using C = ContactMeasures;
        add("contact_time_s", PALPATE_TEXT("Contact [s]"), number(a, &C::time_s), number(b, &C::time_s), 6);
        add("contacts", PALPATE_TEXT("Contacts"), number(a, &C::contacts), number(b, &C::contacts), 9);
        addForce("peak_force_N", PALPATE_TEXT("Peak force [N]"), of(a, &C::peakForce_N), of(b, &C::peakForce_N));
        addForce("mean_force_N", PALPATE_TEXT("Mean force [N]"), of(a, &C::meanForce_N), of(b, &C::meanForce_N));
        addForce("median_force_N", PALPATE_TEXT("Median force [N]"), of(a, &C::medianForce_N),
                 of(b, &C::medianForce_N));
        addForce("p95_force_N", PALPATE_TEXT("95th percentile of the force [N]"), of(a, &C::p95Force_N),
                 of(b, &C::p95Force_N));
        add("peak_depth_mm", PALPATE_TEXT("Peak depth [mm]"), of(a, &C::peakDepth_mm), of(b, &C::peakDepth_mm));
        add("mean_depth_mm", PALPATE_TEXT("Mean depth [mm]"), of(a, &C::meanDepth_mm), of(b, &C::meanDepth_mm));
    }
    /// Adds searching and pressing.
    void addPhases(const std::vector<Phase>& a, const std::vector<Phase>& b)
    {
        const PhaseSummary searchA = summary(a, Phase::Kind::Search), searchB = summary(b, Phase::Kind::Search);
        const PhaseSummary pressA = summary(a, Phase::Kind::Press), pressB = summary(b, Phase::Kind::Press);
        const auto mean = [](const PhaseSummary& sum) {
            return sum.phases > 0 ? std::optional(sum.meanForce_N) : std::nullopt;
        };
        add("search_time_s", PALPATE_TEXT("Searching [s]"), searchA.time_s, searchB.time_s, 6);
        addForce("search_mean_force_N", PALPATE_TEXT("Mean force when searching [N]"), mean(searchA), mean(searchB));
        add("press_time_s", PALPATE_TEXT("Pressing [s]"), pressA.time_s, pressB.time_s, 6);
        addForce("press_mean_force_N", PALPATE_TEXT("Mean force when pressing [N]"), mean(pressA), mean(pressB));
        add("presses", PALPATE_TEXT("Presses"), static_cast<double>(pressA.phases), static_cast<double>(pressB.phases),
            9);
    }
    ComparedGroup result() { return std::move(m_group); }

  private:
    ComparedGroup m_group;
};

ComparedGroup wholeSession(const SessionMeasures& a, const SessionMeasures& b)
{
    const auto places = [](const SessionMeasures& m) {
        return static_cast<double>(std::count_if(m.findings.begin(), m.findings.end(),
                                                 [](const FindingMeasures& one) { return one.finding.hasPlace; }));
    };
    GroupRows group{{}};
    group.add("duration_s", PALPATE_TEXT("Duration [s]"), a.sums.duration_s, b.sums.duration_s, 6);
    group.addContact(&a.sums.contact, &b.sums.contact);
    group.add("path_length_mm", PALPATE_TEXT("Path of the hand [mm]"), a.sums.pathLength_mm, b.sums.pathLength_mm);
    group.add("contact_path_mm", PALPATE_TEXT("Path on the surface [mm]"), a.sums.contactPath_mm,
              b.sums.contactPath_mm);
    group.addPhases(a.phases, b.phases);
    group.add("findings", PALPATE_TEXT("Marked findings"), places(a), places(b), 9);
    return group.result();
}

const SurfaceMeasures* surfaceOf(const SessionMeasures& measures, const std::string& name)
{
    const auto found = std::find_if(measures.surfaces.begin(), measures.surfaces.end(),
                                    [&](const SurfaceMeasures& one) { return one.structure == name; });
    return found == measures.surfaces.end() ? nullptr : &*found;
}

ComparedGroup structureGroup(const std::string& name, const SessionMeasures& a, const SessionMeasures& b)
{
    const auto contact = [&](const SessionMeasures& m) {
        const auto found = m.sums.structures.find(name);
        return found == m.sums.structures.end() ? nullptr : &found->second;
    };
    const auto phases = [&](const SessionMeasures& m) {
        const auto found = m.structurePhases.find(name);
        return found == m.structurePhases.end() ? std::vector<Phase>() : found->second;
    };
    GroupRows group(name);
    group.addContact(contact(a), contact(b));
    group.addPhases(phases(a), phases(b));
    const SurfaceMeasures *const first = surfaceOf(a, name), *const second = surfaceOf(b, name);
    if (first != nullptr && second != nullptr) {
        group.add("coverage_percent", PALPATE_TEXT("Covered [%]"), 100.0 * first->coverage(),
                  100.0 * second->coverage(), 3);
        group.add("longest_dwell_s", PALPATE_TEXT("Longest dwell [s]"), first->longestDwell_s, second->longestDwell_s,
                  6);
    }
    return group.result();
}

/// Compares the search for the lumps that both sessions evaluated.
std::vector<ComparedGroup> lumpGroups(const SessionMeasures& a, const SessionMeasures& b)
{
    std::vector<ComparedGroup> out;
    const auto percentOf = [](const LumpSearch& one) {
        const auto share = one.share();
        return share ? std::optional(100.0 * *share) : std::nullopt;
    };
    for (const LumpSearch& first : a.lumps) {
        const auto second = std::find_if(b.lumps.begin(), b.lumps.end(), [&](const LumpSearch& one) {
            return one.lump == first.lump && one.organ == first.organ;
        });
        if (second == b.lumps.end()) {
            continue;
        }
        GroupRows group(first.lump, true);
        group.add("pressed_hard_enough_percent", PALPATE_TEXT("Pressed hard enough [%]"), percentOf(first),
                  percentOf(*second), 3);
        group.add("greatest_change_percent", PALPATE_TEXT("Largest recorded change [%]"), first.recorded_percent,
                  second->recorded_percent, 3);
        out.push_back(group.result());
    }
    return out;
}

ComparedSurface compareSurface(const SurfaceMeasures& a, const SurfaceMeasures& b)
{
    ComparedSurface out{a.structure, a.area_mm2};
    const TouchedSurface* const any = a.surface != nullptr ? a.surface.get() : b.surface.get();
    for (std::size_t i = 0; any != nullptr && i < any->share_mm2().size(); ++i) {
        const auto isTouched = [i](const SurfaceMeasures& m) {
            return m.surface != nullptr && m.surface->dwell_s()[i] > 0.0;
        };
        const double share_mm2 = any->share_mm2()[i];
        switch (touchedBy(isTouched(a), isTouched(b))) {
        case TouchedBy::Both:
            out.both_mm2 += share_mm2;
            break;
        case TouchedBy::First:
            out.onlyFirst_mm2 += share_mm2;
            break;
        case TouchedBy::Second:
            out.onlySecond_mm2 += share_mm2;
            break;
        case TouchedBy::Neither:
            break;
        }
    }
    return out;
}

} // namespace

std::optional<double> ComparedMeasure::difference() const
{
    return first && second ? std::optional(*second - *first) : std::nullopt;
}

std::optional<double> ComparedMeasure::difference_percent() const
{
    return first && second && *first != 0.0 ? std::optional(100.0 * (*second - *first) / *first) : std::nullopt;
}

std::optional<bool> ComparedMeasure::isNoticeable() const
{
    const auto percent = difference_percent();
    return isForce && percent ? std::optional(std::abs(*percent) >= kForceThreshold_percent) : std::nullopt;
}

core::Status checkSameSurfaces(const RecordingReader& first, const RecordingReader& second)
{
    const Message difference = surfaceDifference(palpableSurfaces(first), palpableSurfaces(second));
    if (difference.isEmpty()) {
        return {};
    }
    return {core::StatusCode::BadCommandLine,
            PALPATE_TEXT("%1 and %2: found recordings of different surfaces (%3), expected two recordings of the same "
                         "scene"),
            first.path(), second.path(), difference};
}

SessionComparison compareSessions(const SessionMeasures& first, const SessionMeasures& second)
{
    SessionComparison out;
    out.distance_mm = first.distance_mm;
    out.groups.push_back(wholeSession(first, second));
    std::set<std::string> touched;
    for (const SessionMeasures* one : {&first, &second}) {
        for (const auto& [name, contact] : one->sums.structures) {
            touched.insert(name);
        }
    }
    for (const std::string& name : touched) {
        out.groups.push_back(structureGroup(name, first, second));
    }
    for (ComparedGroup& group : lumpGroups(first, second)) {
        out.groups.push_back(std::move(group));
    }
    for (const SurfaceMeasures& one : first.surfaces) {
        if (const SurfaceMeasures* other = surfaceOf(second, one.structure)) {
            out.surfaces.push_back(compareSurface(one, *other));
        }
    }
    return out;
}

} // namespace palpate::session

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/ReadableName.h"
#include "report/ReportSections.h"

#include <palpate/core/Quantity.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace palpate::study::internal {

namespace {

using core::Count;
using core::Message;
using core::MessageArgument;
using core::Rounded;
using geometry::Relation;

constexpr int kSizeDigits = 3; // of volumes and areas

/// Structures that are relevant to the session: touched structures, structures that hold or border a finding or hold an
/// end of a tape, and lumps with their organs. The other distances would fill pages.
class Relevance
{
  public:
    explicit Relevance(const ReportFacts& facts)
        : m_matters(facts.distances->sizes.size(), false)
    {
        for (const auto& [name, contact] : facts.measures.sums.structures) {
            add(name);
        }
        for (const session::FindingMeasures& one : facts.measures.findings) {
            addFinding(one.finding);
        }
        for (const core::Finding& one : facts.outside) {
            addFinding(one);
        }
        for (const core::Tape& tape : facts.tapes) {
            add(tape.fromOn);
            add(tape.toOn);
        }
        for (const OrganPalpability& one : facts.lumps) {
            add(facts.scene->structures[one.organ.organ].description.name);
        }
        for (std::size_t i = 0; i < m_matters.size(); ++i) {
            m_matters[i] = m_names.contains(readableName(facts.distances->sizes[i].name));
        }
        for (const LumpMargin& margin : facts.distances->margins) {
            m_matters[margin.lump] = true;
        }
        for (const std::size_t i : facts.besideFindings) {
            m_matters[i] = true;
        }
    }
    bool operator()(std::size_t structure) const { return m_matters[structure]; }
    bool operator()(const PairDistance& pair) const { return m_matters[pair.first] || m_matters[pair.second]; }

  private:
    void add(const std::string& name) { m_names.insert(readableName(name)); }
    void addFinding(const core::Finding& finding)
    {
        add(finding.structure);
        for (const core::FindingLayer& layer : finding.layers) {
            add(layer.structure);
        }
    }

    std::set<std::string> m_names;
    std::vector<bool> m_matters; ///< by structure
};

/// Returns the relevant elements; the whole list if it is short or has no relevant element.
template<class T, class Matters>
std::vector<const T*> relevant(const std::vector<T>& all, const Matters& matters)
{
    std::vector<const T*> chosen;
    for (const T& one : all) {
        if (all.size() <= kReportedPairs || matters(one)) {
            chosen.push_back(&one);
        }
    }
    if (chosen.empty()) {
        for (const T& one : all) {
            chosen.push_back(&one);
        }
    }
    return chosen;
}

/// Writes the distances of a scene.
class DistanceBlocks
{
  public:
    explicit DistanceBlocks(const ReportFacts& facts)
        : m_distances(*facts.distances)
        , m_matters(facts)
    {
    }

    std::vector<ReportBlock> run()
    {
        choosePairs();
        if (!m_apart.empty()) {
            m_blocks.emplace_back(pairTable());
        }
        addCrossings();
        addLeftOut();
        addMargins();
        return std::move(m_blocks);
    }

  private:
    std::string name(std::size_t structure) const { return readableName(m_distances.sizes[structure].name); }

    /// Sorts the relevant pairs by distance. Pairs that meet are listed in sentences, because their distance is 0.
    void choosePairs()
    {
        for (const PairDistance* pair : relevant(m_distances.pairs, m_matters)) {
            (pair->found.relation == Relation::Crossing ? m_crossing : m_apart).push_back(pair);
        }
        std::stable_sort(m_apart.begin(), m_apart.end(), [](const PairDistance* a, const PairDistance* b) {
            return a->found.surface_mm < b->found.surface_mm;
        });
        m_apart.resize(std::min(m_apart.size(), kReportedPairs));
    }

    Message relationText(const PairDistance& pair) const
    {
        const bool isApart = pair.found.relation == Relation::Apart;
        const std::size_t inner = pair.found.relation == Relation::Inside ? pair.first : pair.second;
        return isApart ? Message(PALPATE_TEXT("apart"))
                       : Message(PALPATE_TEXT("%1 lies inside, %2 mm from the surface"), name(inner),
                                 lengthText(pair.found.surface_mm));
    }

    ReportTable pairTable() const
    {
        ReportTable table;
        table.caption = {PALPATE_TEXT("Least distances, nearest first")};
        table.columns = {column(PALPATE_TEXT("From")), column(PALPATE_TEXT("To")),
                         column(PALPATE_TEXT("Distance [mm]"), true), column(PALPATE_TEXT("Position"))};
        for (const PairDistance* pair : m_apart) {
            const bool isTurned = m_matters(pair->second) && !m_matters(pair->first);
            table.rows.push_back({name(isTurned ? pair->second : pair->first),
                                  name(isTurned ? pair->first : pair->second), lengthText(pair->found.distance_mm),
                                  relationText(*pair)});
        }
        return table;
    }

    /// One sentence for each relevant structure with the structures that it meets.
    void addCrossings()
    {
        std::map<std::size_t, std::vector<std::string>> met;
        for (const PairDistance* pair : m_crossing) {
            const bool isFirst = m_matters(pair->first) || !m_matters(pair->second);
            met[isFirst ? pair->first : pair->second].push_back(name(isFirst ? pair->second : pair->first));
        }
        constexpr std::size_t kSentences = 8, kNames = 24;
        std::size_t number = 0;
        for (const auto& [structure, others] : met) {
            if (++number > kSentences) {
                m_blocks.emplace_back(
                    ReportText{{PALPATE_TEXT("Not listed: %1 more structures that cross or touch others."),
                                Count(met.size() - kSentences)}});
                break;
            }
            m_blocks.emplace_back(ReportText{
                {PALPATE_TEXT("%1 crosses or touches (0 mm): %2."), name(structure), namesText(others, kNames)}});
        }
    }

    void addLeftOut()
    {
        const std::size_t listed = m_apart.size() + m_crossing.size();
        if (listed < m_distances.pairs.size()) {
            m_blocks.emplace_back(ReportText{
                {PALPATE_TEXT("Of %1 pairs of structures, %2 are left out. Listed are the nearest pairs with a "
                              "structure that was touched, holds or borders a finding or the end of a tape, or is a "
                              "lump. All pairs: `palpate info --distances --json SCENE`, or View › Distances and sizes "
                              "in the window."),
                 Count(m_distances.pairs.size()), Count(m_distances.pairs.size() - listed)}});
        }
    }

    /// Margins, the largest share nearby first.
    void addMargins()
    {
        std::vector<const LumpMargin*> margins;
        for (const LumpMargin& margin : m_distances.margins) {
            margins.push_back(&margin);
        }
        if (margins.empty()) {
            return;
        }
        if (margins.size() > kReportedPairs) {
            std::stable_sort(margins.begin(), margins.end(), [](const LumpMargin* a, const LumpMargin* b) {
                return a->found.shares > b->found.shares;
            });
        }
        const std::size_t all = margins.size();
        margins.resize(std::min(all, kReportedPairs));
        m_blocks.emplace_back(marginTable(margins));
        if (margins.size() < all) {
            m_blocks.emplace_back(ReportText{
                {PALPATE_TEXT("Margins left out, with less of the lump's surface nearby: %1. All margins: `palpate "
                              "info --distances --json SCENE`."),
                 Count(all - margins.size())}});
        }
    }

    ReportTable marginTable(const std::vector<const LumpMargin*>& margins) const
    {
        ReportTable table;
        table.caption = {PALPATE_TEXT("Margins: share of the lump's surface by its distance to the structure [%]")};
        table.columns = {column(PALPATE_TEXT("Lump")), column(PALPATE_TEXT("Structure"))};
        for (const Message& band : bandNames(m_distances.limits_mm)) {
            table.columns.push_back({band, true});
        }
        table.columns.push_back(column(PALPATE_TEXT("Inside"), true));
        for (const LumpMargin* margin : margins) {
            std::vector<MessageArgument> row{name(margin->lump), name(margin->structure)};
            for (const double share : margin->found.shares) {
                row.emplace_back(Rounded{100.0 * share, 3});
            }
            row.emplace_back(Rounded{100.0 * margin->found.insideShare, 3});
            table.rows.push_back(std::move(row));
        }
        return table;
    }

    const DistanceTable& m_distances;
    Relevance m_matters;
    std::vector<const PairDistance*> m_apart, m_crossing; ///< relevant pairs
    std::vector<ReportBlock> m_blocks;
};

/// One sentence for each reason for a missing or incomplete volume.
void addGaps(ReportSection& section, const std::vector<StructureSize>& sizes)
{
    struct Kind
    {
        VolumeGap gap;
        core::MessageText<MessageArgument, MessageArgument> text;
    };
    constexpr Kind kKinds[] = {
        {VolumeGap::Open, PALPATE_TEXT("No volume, because the surface is open, for %1 structures: %2.")},
        {VolumeGap::InsideOut, PALPATE_TEXT("No volume, because the surface is inside out, for %1 structures: %2.")},
        {VolumeGap::Partial, PALPATE_TEXT("Volume of the closed parts alone, for %1 structures: %2.")}};
    for (const auto& [gap, text] : kKinds) {
        std::vector<std::string> names;
        const StructureSize* only = nullptr;
        for (const StructureSize& size : sizes) {
            if (size.gap == gap) {
                names.push_back(size.name);
                only = &size;
            }
        }
        if (names.size() == 1) {
            section.blocks.emplace_back(ReportText{{PALPATE_TEXT("%1: %2"), readableName(only->name), only->note}});
        } else if (!names.empty()) {
            section.blocks.emplace_back(ReportText{{text, MessageArgument(Count(names.size())), namesText(names)}});
        }
    }
}

} // namespace

ReportSection tapeSection(const ReportFacts& facts)
{
    ReportSection section{{PALPATE_TEXT("Measured distances")}, {}};
    if (facts.tapes.empty()) {
        return section;
    }
    ReportTable table;
    table.caption = {PALPATE_TEXT("Straight distances between two places, measured by the examiner with the tape")};
    table.columns = {column(PALPATE_TEXT("Name")), column(PALPATE_TEXT("Distance [mm]"), true),
                     column(PALPATE_TEXT("From")), column(PALPATE_TEXT("Place (x y z) [mm]"), true),
                     column(PALPATE_TEXT("To")),   column(PALPATE_TEXT("Place (x y z) [mm]"), true)};
    for (const core::Tape& tape : facts.tapes) {
        table.rows.push_back({nameOrDash(tape.name), lengthText(tape.length_mm()), structureOrDash(tape.fromOn),
                              placeText(tape.from_W), structureOrDash(tape.toOn), placeText(tape.to_W)});
    }
    section.blocks.emplace_back(std::move(table));
    return section;
}

ReportSection distanceSection(const ReportFacts& facts)
{
    ReportSection section{{PALPATE_TEXT("Distances and margins")}, {}};
    if (!facts.distances) {
        section.blocks.emplace_back(
            paragraph(PALPATE_TEXT("Distances were not measured, because the scene is missing.")));
    } else if (facts.distances->pairs.empty()) {
        section.blocks.emplace_back(paragraph(PALPATE_TEXT("There are no two structures to measure between.")));
    } else {
        section.blocks = DistanceBlocks(facts).run();
    }
    return section;
}

ReportSection sizeSection(const ReportFacts& facts)
{
    ReportSection section{{PALPATE_TEXT("Volumes and areas")}, {}};
    if (!facts.distances) {
        section.blocks.emplace_back(paragraph(PALPATE_TEXT("Sizes were not measured, because the scene is missing.")));
        return section;
    }
    const std::vector<StructureSize>& sizes = facts.distances->sizes;
    const Relevance matters(facts);
    std::vector<const StructureSize*> chosen = relevant(
        sizes, [&](const StructureSize& size) { return matters(static_cast<std::size_t>(&size - sizes.data())); });
    chosen.resize(std::min(chosen.size(), kReportedPairs));
    ReportTable table;
    table.caption = {PALPATE_TEXT("Sizes of the structures")};
    table.columns = {column(PALPATE_TEXT("Structure")), column(PALPATE_TEXT("Volume"), true),
                     column(PALPATE_TEXT("Ball of equal volume [mm]"), true), column(PALPATE_TEXT("Area"), true),
                     column(PALPATE_TEXT("Extent x × y × z [mm]"), true)};
    for (const StructureSize* size : chosen) {
        table.rows.push_back({readableName(size->name),
                              size->volume_mm3 ? core::volumeText(*size->volume_mm3, kSizeDigits) : dash(),
                              lengthText(size->ballDiameter_mm()), core::areaText(size->area_mm2, kSizeDigits),
                              Message(PALPATE_TEXT("%1 × %2 × %3"), lengthText(size->extent_mm.x()),
                                      lengthText(size->extent_mm.y()), lengthText(size->extent_mm.z()))});
    }
    section.blocks.emplace_back(std::move(table));
    addGaps(section, sizes);
    if (chosen.size() < sizes.size()) {
        section.blocks.emplace_back(
            ReportText{{PALPATE_TEXT("Structures left out of this table: %1. All sizes: `palpate info --distances "
                                     "--json SCENE`."),
                        Count(sizes.size() - chosen.size())}});
    }
    return section;
}

} // namespace palpate::study::internal

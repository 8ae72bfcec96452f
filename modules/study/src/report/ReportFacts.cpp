// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/study/ReportFacts.h"

#include "palpate/study/ReadableName.h"
#include "palpate/study/RecordedScene.h"
#include "palpate/study/SearchedLumps.h"
#include "palpate/study/StructureSources.h"

#include <palpate/geometry/SurfaceDistance.h>

#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>

namespace palpate::study {

namespace {

using core::Message;
using core::Result;
using core::Status;
using core::StatusCode;

constexpr std::int64_t kPolled = 20000; // ticks between two polls of the cancellation

/// Computes the facts step by step.
class Gathering
{
  public:
    Gathering(std::unique_ptr<session::RecordingReader> recording, const ReportOptions& options)
        : m_options(options)
    {
        m_facts.recording = std::move(recording);
        m_facts.caseText = options.caseText;
        m_facts.examiner = options.examiner;
    }

    Result<ReportFacts> run()
    {
        for (Status (Gathering::*step)() : {&Gathering::checkFile, &Gathering::readSurfaces, &Gathering::resimulate,
                                            &Gathering::computeLumps, &Gathering::measure, &Gathering::measureScene}) {
            if (Status status = (this->*step)(); !status.isOk()) {
                return status;
            }
            if (isCancelled()) {
                return Status(StatusCode::Cancelled, PALPATE_TEXT("the report was cancelled"));
            }
        }
        listMissing();
        return std::move(m_facts);
    }

  private:
    bool isCancelled() const { return m_options.isCancelled != nullptr && *m_options.isCancelled; }
    void show(double share, const Message& step) const
    {
        if (m_options.progress) {
            m_options.progress(share, step);
        }
    }
    const session::RecordingReader& reader() const { return *m_facts.recording; }
    /// Returns a progress callback for a step. @param from,  to  shares of the whole work
    std::function<bool(double)> shown(double from, double to, const Message& step) const
    {
        return [this, from, to, step](double share) {
            show(from + (to - from) * share, step);
            return !isCancelled();
        };
    }

    Status checkFile()
    {
        const Message step(PALPATE_TEXT("Checking the recording"));
        show(0.0, step);
        m_facts.sha256 = meshio::fileHash(reader().path());
        m_facts.verification.checksums = reader().verify(shown(0.05, 0.25, step));
        return {};
    }

    /// Finds the surfaces and the scene of the recording.
    Status readSurfaces()
    {
        show(0.25, {PALPATE_TEXT("Reading the surfaces")});
        auto surfaces = recordedSurfaces(reader(), m_options.scene);
        auto scene =
            m_options.scene.empty() ? sceneOfRecording(reader().path()) : openAsRecorded(reader(), m_options.scene);
        if (!m_options.scene.empty()) {
            for (const Status& status : {surfaces.status(), scene.status()}) {
                if (!status.isOk()) {
                    return status;
                }
            }
        }
        if (surfaces.isOk()) {
            m_surfaces = std::move(surfaces).value();
        } else if (m_options.opened != nullptr && hasAll(meshesByHash(*m_options.opened))) {
            m_surfaces = meshesByHash(*m_options.opened);
        } else {
            m_noSurfaces = surfaces.status().text();
        }
        if (scene.isOk()) {
            m_facts.scene = std::make_shared<const meshio::LoadedScene>(std::move(scene).value());
        } else if (m_noSurfaces.isEmpty() && m_options.opened != nullptr) {
            m_facts.scene = m_options.opened;
        } else {
            m_noScene = scene.status().text();
        }
        return {};
    }

    bool hasAll(const session::MeshesByHash& meshes) const
    {
        const auto& scenes = reader().scenes();
        return !scenes.empty() && std::all_of(scenes.begin(), scenes.end(), [&](const session::SceneRecord& scene) {
            return std::all_of(scene.structures.begin(), scene.structures.end(), [&](const auto& structure) {
                return !structure.palpable || meshes.contains(structure.source.sha256);
            });
        });
    }

    Status resimulate()
    {
        const Message step(PALPATE_TEXT("Computing the recording again"));
        show(0.3, step);
        Verification& verification = m_facts.verification;
        if (!m_noSurfaces.isEmpty()) {
            verification.notResimulated = m_noSurfaces;
            return {};
        }
        std::int64_t ticks = 0;
        auto result = session::resimulate(reader(), indexedByHash(m_surfaces), [&](const servo::TickRecord& tick) {
            if (++ticks % kPolled == 0) {
                show(0.3 + 0.3 * reader().shareBefore(tick.tick), step);
            }
            return !isCancelled();
        });
        if (result.isOk()) {
            verification.resimulated = std::move(result).value();
        } else {
            verification.notResimulated = result.status().text();
        }
        return {};
    }

    Status computeLumps()
    {
        if (m_facts.scene == nullptr) {
            return {};
        }
        auto organs = computePalpability(*m_facts.scene, {}, &m_facts.lumpNotes,
                                         shown(0.6, 0.65, {PALPATE_TEXT("Computing what can be felt of lumps")}));
        if (organs.isOk()) {
            m_facts.lumps = std::move(organs).value();
        }
        return organs.status();
    }

    /// Computes measures and force curve in one pass.
    Status measure()
    {
        startForce();
        session::MeasureOptions how;
        how.distance_mm = defaultDistance_mm(reader(), m_surfaces);
        how.progress = shown(0.65, 0.95, {PALPATE_TEXT("Measuring")});
        how.sink = [this](const servo::TickRecord& tick) { addForce(tick); };
        auto measures = m_facts.scene == nullptr
                            ? session::measureSession(reader(), m_surfaces, how)
                            : measureSearch(reader(), m_surfaces, *m_facts.scene, m_facts.lumps, std::move(how));
        if (!measures.isOk()) {
            return measures.status();
        }
        m_facts.measures = std::move(measures).value();
        std::size_t number = 0;
        for (const session::FindingMeasures& one : m_facts.measures.findings) {
            if (one.finding.hasPlace) {
                m_facts.force.marks.push_back({one.marked_s, ++number});
            }
        }
        takeOutside();
        return {};
    }

    /// Takes the findings of the scene that the recording does not contain.
    void takeOutside()
    {
        const auto isRecorded = [this](const core::Finding& one) {
            const auto& all = m_facts.measures.findings;
            return std::any_of(all.begin(), all.end(), [&one](const session::FindingMeasures& measured) {
                const core::Finding& other = measured.finding;
                return one.id.empty() || other.id.empty() ? one.p_W == other.p_W && one.name == other.name
                                                          : one.id == other.id;
            });
        };
        const std::vector<core::Finding> none;
        for (const core::Finding& one : m_options.findings         ? *m_options.findings
                                        : m_facts.scene != nullptr ? m_facts.scene->scene.findings
                                                                   : none) {
            if (one.hasPlace && !isRecorded(one)) {
                m_facts.outside.push_back(one);
            }
        }
    }

    Status measureScene()
    {
        if (m_facts.scene != nullptr) {
            show(0.95, {PALPATE_TEXT("Measuring distances")});
            const SharedIndices indices = completeIndices(*m_facts.scene, {});
            m_facts.distances = measureDistances(*m_facts.scene, indices);
            findNeighbours(indices);
        }
        if (m_options.tapes) {
            m_facts.tapes = *m_options.tapes;
        } else if (m_facts.scene != nullptr) {
            m_facts.tapes = m_facts.scene->scene.tapes;
        }
        return {};
    }

    /// Finds the structures beside a finding.
    void findNeighbours(const SharedIndices& indices)
    {
        std::vector<core::Vec3> places;
        for (const session::FindingMeasures& one : m_facts.measures.findings) {
            if (one.finding.hasPlace) {
                places.push_back(one.finding.p_W);
            }
        }
        for (const core::Finding& one : m_facts.outside) {
            places.push_back(one.p_W);
        }
        for (std::size_t i = 0; i < indices.size(); ++i) {
            if (indices[i] != nullptr && std::any_of(places.begin(), places.end(), [&](const core::Vec3& place) {
                    return geometry::nearestPoint(*indices[i], place, kBesideFinding_mm).has_value();
                })) {
                m_facts.besideFindings.push_back(i);
            }
        }
    }

    /// Number of ticks of the force curve, including missing ones.
    std::int64_t curveTicks() const { return reader().extent().lastTick - reader().extent().firstTick + 1; }

    /// Keeps the extremes of each span, so that memory is independent of the duration.
    void startForce()
    {
        const std::int64_t all = curveTicks();
        if (all > 0) {
            m_facts.force.duration_s = static_cast<double>(all) * reader().info().dt_s;
            m_facts.force.spans.resize(static_cast<std::size_t>(std::min<std::int64_t>(all, ForceCurve::kSpans)));
        }
    }

    void addForce(const servo::TickRecord& tick)
    {
        std::vector<ForceCurve::Span>& spans = m_facts.force.spans;
        const double at =
            static_cast<double>(tick.tick - reader().extent().firstTick) / static_cast<double>(curveTicks());
        const auto count = static_cast<double>(spans.size());
        ForceCurve::Span& span = spans[static_cast<std::size_t>(std::clamp(at * count, 0.0, count - 1.0))];
        const auto force_N = static_cast<float>(tick.felt.f_W.norm());
        span.least_N = span.isRecorded ? std::min(span.least_N, force_N) : force_N;
        span.greatest_N = std::max(span.greatest_N, force_N);
        span.isRecorded = true;
    }

    void lose(const Message& loss) { m_facts.missing.push_back(loss); }

    void listMissing()
    {
        const session::RecordingExtent& extent = reader().extent();
        const Verification& verification = m_facts.verification;
        if (extent.end != session::RecordingEnd::Closed) {
            lose({PALPATE_TEXT("The recording was interrupted: %1."), session::endingText(extent)});
        }
        if (extent.dropped > 0) {
            lose({PALPATE_TEXT("Ticks missing in the recording: %1."), core::Count(extent.dropped)});
        }
        if (!m_facts.measures.damaged.empty()) {
            lose({PALPATE_TEXT("The recording is damaged, or was changed after it was made. Damaged places: %1. Ticks "
                               "that do not match their checksum are left out of all numbers."),
                  core::Count(m_facts.measures.damaged.size())});
        } else if (!verification.checksums.isOk()) {
            lose({PALPATE_TEXT("The recording is damaged, or was changed after it was made: %1."),
                  verification.checksums.text()});
        }
        if (!verification.resimulated) {
            lose({PALPATE_TEXT("The recording was not computed again, so its forces are not verified: %1."),
                  verification.notResimulated});
        } else if (!verification.resimulated->isWithinRounding()) {
            lose({PALPATE_TEXT("Computing the recording again gives other forces, so they are not verified: %1."),
                  verification.resimulated->beyond});
        }
        if (!m_facts.measures.unmeasured.empty()) {
            std::string names;
            for (const std::string& name : m_facts.measures.unmeasured) {
                names.append(names.empty() ? "" : ", ").append(readableName(name));
            }
            lose({PALPATE_TEXT("Surfaces not available, so without coverage: %1."), names});
        }
        if (m_facts.scene == nullptr) {
            lose({PALPATE_TEXT("The scene is not available, so pictures, sizes, distances and lumps are missing: %1."),
                  m_noScene});
        } else {
            for (const Message& loss : m_facts.scene->losses) {
                lose(loss);
            }
        }
    }

    const ReportOptions& m_options;
    ReportFacts m_facts;
    session::MeshesByHash m_surfaces;
    Message m_noSurfaces; ///< why the surfaces are missing; empty: they are not
    Message m_noScene;    ///< as m_noSurfaces, for the scene
};

} // namespace

Result<ReportFacts> gatherReport(const std::filesystem::path& recording, const ReportOptions& options)
{
    auto opened = session::RecordingReader::open(recording);
    return opened.isOk() ? Gathering(std::move(opened).value(), options).run() : opened.status();
}

} // namespace palpate::study

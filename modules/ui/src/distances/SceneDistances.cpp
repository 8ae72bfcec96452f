// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/SceneDistances.h"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <utility>

namespace palpate::ui {

namespace {

constexpr int kDelay_ms = 300;     // after the latest change
constexpr int kUnnoticed_ms = 400; // shorter computations show no progress

} // namespace

/// State shared by the GUI thread and the worker.
struct SceneDistances::Job
{
    std::atomic<bool> isCancelled{false};
};

/// Results of the worker.
struct SceneDistances::Found
{
    study::DistanceTable table;
    study::SharedIndices indices;
    bool needsChoice = false;
};

SceneDistances::SceneDistances(StructureModel& model, QObject* parent)
    : QObject(parent)
    , m_model(model)
    , m_limits_mm(std::begin(study::kMarginLimits_mm), std::end(study::kMarginLimits_mm))
{
    m_thread.setMaxThreadCount(1); // a new job waits until the cancelled job has ended
    m_wait.setSingleShot(true);
    m_wait.setInterval(kDelay_ms);
    connect(&m_wait, &QTimer::timeout, this, &SceneDistances::begin);
    connect(&model, &StructureModel::edited, this, &SceneDistances::follow);
    connect(&model, &StructureModel::surfaceReplaced, this, &SceneDistances::follow);
    connect(&model, &QAbstractItemModel::rowsInserted, this, &SceneDistances::follow);
    const auto reset = [this] {
        m_from.reset();
        m_table = {};
        m_indices.clear();
        m_causes.clear();
        follow();
        Q_EMIT outdated(); // also without structures
    };
    connect(&model, &QAbstractItemModel::modelReset, this, reset);
    connect(&model, &StructureModel::targetsHidden, this, reset); // the table names targets
}

SceneDistances::~SceneDistances()
{
    stop();
    m_thread.waitForDone();
}

void SceneDistances::setWanted(bool isWanted)
{
    m_isWanted = isWanted;
    if (isWanted) {
        m_isGivenUp = false;
        follow();
        if (!m_isUpToDate && !isBusy()) {
            begin();
        }
    } else {
        m_wait.stop();
        stop();
    }
}

void SceneDistances::setFrom(std::optional<int> row)
{
    if (row != m_from) {
        m_from = row;
        restart();
    }
}

void SceneDistances::setLimits(std::vector<double> limits_mm)
{
    if (limits_mm != m_limits_mm) {
        m_limits_mm = std::move(limits_mm);
        restart();
    }
}

std::vector<SceneDistances::Cause> SceneDistances::causes() const
{
    std::vector<Cause> causes;
    for (const study::OpenStructure& row : m_model.rows()) {
        const meshio::SceneStructure& one = row.loaded.description;
        causes.push_back(
            {one.name, one.inside, one.young_ratio, one.palpable, row.isRemoved ? nullptr : row.loaded.surface.get()});
    }
    return causes;
}

void SceneDistances::follow()
{
    std::vector<Cause> now = causes();
    if (now != m_causes) {
        m_causes = std::move(now);
        if (m_from && m_causes[static_cast<std::size_t>(*m_from)].surface == nullptr) {
            m_from.reset(); // removed
        }
        restart();
    }
}

void SceneDistances::restart()
{
    stop();
    m_isUpToDate = m_isGivenUp = false;
    Q_EMIT outdated();
    if (m_isWanted) {
        m_wait.start();
    }
}

void SceneDistances::begin()
{
    if (m_model.presentCount() == 0 || m_model.scene().hiddenTargets() > 0) {
        return;
    }
    m_since.start();
    m_job = std::make_shared<Job>();
    const auto progress = [this, job = m_job](double share) {
        QMetaObject::invokeMethod(this, [this, job, share] {
            if (job == m_job && m_since.elapsed() > kUnnoticed_ms) {
                Q_EMIT progressed(tr("Measuring distances"), share);
            }
        });
        return !job->isCancelled;
    };
    study::SharedIndices indices;
    for (const study::OpenStructure& row : m_model.rows()) {
        indices.push_back(row.isRemoved ? nullptr : row.touch);
    }
    std::vector<std::size_t> from;
    if (m_from) {
        from.push_back(static_cast<std::size_t>(*m_from));
    }
    m_thread.start([this, job = m_job, progress, from = std::move(from), limits_mm = m_limits_mm,
                    indices = std::move(indices), scene = m_model.scene().loadedScene()] {
        auto found = std::make_shared<Found>();
        if (progress(0.0)) {
            found->indices = study::completeIndices(scene, indices);
            const auto count = std::count_if(found->indices.begin(), found->indices.end(),
                                             [](const auto& index) { return index != nullptr; });
            found->needsChoice =
                from.empty() && count > kMostWithoutLumps && study::lumpsOf(scene, found->indices).empty();
            if (!found->needsChoice) {
                found->table = study::measureDistances(scene, found->indices, limits_mm, from, progress);
            }
        }
        for (study::StructureSize& size : found->table.sizes) {
            size.name = readableName(size.name).toStdString();
        }
        QMetaObject::invokeMethod(this, [this, job, found] {
            if (job == m_job && !job->isCancelled) {
                take(*found);
            }
        });
    });
}

/// Cancels the job. The worker ends at its next progress call, and its results are discarded.
void SceneDistances::stop()
{
    if (m_job != nullptr) {
        m_job->isCancelled = true;
        m_job = nullptr;
        Q_EMIT ended();
    }
}

void SceneDistances::cancel()
{
    if (!isBusy()) {
        return;
    }
    m_wait.stop();
    stop();
    m_isGivenUp = true;
    Q_EMIT cancelled(tr("Measuring distances was cancelled."));
    Q_EMIT changed();
}

void SceneDistances::take(Found& found)
{
    m_job = nullptr;
    m_table = std::move(found.table);
    m_indices = std::move(found.indices);
    m_needsChoice = found.needsChoice;
    m_isUpToDate = true;
    Q_EMIT ended();
    Q_EMIT changed();
}

} // namespace palpate::ui

#include "palpate/ui/moc_SceneDistances.cpp"

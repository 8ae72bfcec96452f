// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/ui/SceneLoader.h"

#include <palpate/session/GeometryHash.h>
#include <palpate/study/HapticCopy.h>
#include <palpate/view/SurfaceMesh.h>

#include <QElapsedTimer>

#include <algorithm>

namespace palpate::ui {

/// What window and worker share; outlives both.
struct SceneLoader::Job
{
    std::atomic<bool> isCancelled{false};
};

namespace {

constexpr double kReading = 0.7; // of the progress; the rest is pictures and haptic copies

} // namespace

SceneLoader::SceneLoader(QObject* parent)
    : QObject(parent)
{
}

SceneLoader::~SceneLoader()
{
    finish();
    for (std::thread& builder : m_builders) {
        builder.join();
    }
}

void SceneLoader::cancel()
{
    if (m_job != nullptr) {
        m_job->isCancelled = true;
    }
}

void SceneLoader::finish()
{
    cancel();
    if (m_worker.joinable()) {
        m_worker.join();
    }
    m_isBusy = false;
}

void SceneLoader::open(std::vector<std::filesystem::path> files, double unit_mm)
{
    finish();
    m_job = std::make_shared<Job>();
    m_isBusy = true;
    m_worker = std::thread([this, job = m_job, read = m_reader, files = std::move(files), unit_mm] {
        QElapsedTimer timer;
        timer.start();
        // Signals of a job that was replaced meanwhile must not reach the window.
        const auto tell = [this, job](auto&& call) {
            QMetaObject::invokeMethod(
                this,
                [this, job, call = std::forward<decltype(call)>(call)] {
                    if (job == m_job) {
                        call();
                    }
                },
                Qt::QueuedConnection);
        };
        double lastTold = -1.0;
        const auto progress = [&](const QString& what, double share) {
            if (share - lastTold >= 0.01 || share < lastTold) {
                lastTold = share;
                tell([this, what, share] { Q_EMIT progressed(what, share); });
            }
            return !job->isCancelled;
        };
        auto opened = std::make_shared<OpenedScene>();
        opened->files = files;
        QStringList problems;
        for (std::size_t i = 0; i < files.size() && !job->isCancelled; ++i) {
            const QString what = tr("Reading %1").arg(QString::fromStdString(files[i].filename().string()));
            const double count = static_cast<double>(files.size());
            meshio::ReadOptions options;
            options.unit_mm = unit_mm;
            options.progress = [&](double share) {
                return progress(what, kReading * (static_cast<double>(i) + share) / count);
            };
            progress(what, kReading * static_cast<double>(i) / count);
            auto loaded = read(files[i], options);
            if (!loaded.isOk()) {
                if (loaded.status().code() != core::StatusCode::Cancelled) {
                    problems << QString::fromStdString(loaded.status().message());
                }
                continue;
            }
            meshio::LoadedScene& part = loaded.value();
            if (i == 0) {
                opened->scene = part.scene;
            } else {
                auto& all = opened->scene.structures;
                all.insert(all.end(), part.scene.structures.begin(), part.scene.structures.end());
            }
            for (meshio::LoadedStructure& one : part.structures) {
                opened->rows.push_back({std::move(one), nullptr, nullptr, {}});
            }
            opened->unopened.insert(opened->unopened.end(), part.unopened.begin(), part.unopened.end());
            for (const std::string& line : part.losses) {
                problems << QString::fromStdString(line);
            }
            for (const std::string& line : part.warnings) {
                opened->warnings << QString::fromStdString(line);
            }
        }
        double triangles = 0.0;
        for (const StructureRow& row : opened->rows) {
            triangles += static_cast<double>(row.loaded.surface->mesh.triangles.size());
        }
        double done = 0.0;
        for (StructureRow& row : opened->rows) {
            if (job->isCancelled) {
                break;
            }
            row.picture = view::makeSurface(*row.loaded.surface);
            if (row.loaded.description.palpable) {
                row.touch = study::indexed(*row.loaded.surface);
                row.sha256 = session::geometryHash(row.loaded.surface->mesh);
            }
            done += static_cast<double>(row.loaded.surface->mesh.triangles.size());
            progress(tr("Preparing for touch"), kReading + (1.0 - kReading) * done / std::max(1.0, triangles));
        }
        opened->seconds = static_cast<double>(timer.elapsed()) * 1e-3;
        const bool isCancelled = job->isCancelled;
        tell([this, opened, problems, isCancelled] {
            m_isBusy = false;
            if (isCancelled) {
                Q_EMIT cancelled();
            } else if (opened->rows.empty()) {
                Q_EMIT failed(problems.isEmpty() ? tr("Nothing to open.") : problems.join(QLatin1Char('\n')));
            } else {
                opened->problems = problems;
                Q_EMIT this->opened(opened);
            }
        });
    });
}

void SceneLoader::buildTouch(int row, std::shared_ptr<const geometry::RepairedMesh> surface)
{
    m_builders.emplace_back([this, row, surface = std::move(surface), job = m_job] {
        auto touch = study::indexed(*surface);
        const QString hash = QString::fromStdString(session::geometryHash(surface->mesh));
        QMetaObject::invokeMethod(
            this,
            [this, row, touch, hash, job] {
                if (job == m_job) { // the row is of the scene that is still open
                    Q_EMIT touchBuilt(row, touch, hash);
                }
            },
            Qt::QueuedConnection);
    });
}

} // namespace palpate::ui

// SPDX-License-Identifier: BSD-3-Clause
#include "Commands.h"
#include "Console.h"
#include "ProgressLine.h"
#include "SceneForTouch.h"

#include <palpate/evaluation/Report.h>
#include <palpate/evaluation/Shapes.h>
#include <palpate/session/MotionFile.h>
#include <palpate/session/RecordingReader.h>

#include <CLI/CLI.hpp>

#include <memory>
#include <optional>
#include <utility>

namespace palpate::app {

using core::Status;
using core::StatusCode;

namespace {

namespace fs = std::filesystem;
using Subjects = std::vector<std::shared_ptr<const evaluation::Subject>>;

struct EvaluateOptions
{
    std::vector<fs::path> scenes;
    fs::path motion, out = "evaluation";
    std::string unit = "mm", stiffness = "0.5";
    std::uint64_t seed = 1;
    bool isQuick = false;
    bool isStability = false;
};

/// @param losses  gets what of the scenes could not be opened
core::Result<Subjects> loadSubjects(const EvaluateOptions& options, double unit_mm, std::vector<std::string>& losses)
{
    Subjects subjects;
    for (const fs::path& path : options.scenes) {
        meshio::ReadOptions read;
        read.unit_mm = unit_mm;
        const auto loaded = loadSceneOrFolder(path, read);
        if (!loaded.isOk()) {
            return loaded.status();
        }
        const fs::path named = path.has_filename() ? path : path.parent_path();
        losses.insert(losses.end(), loaded.value().losses.begin(), loaded.value().losses.end());
        auto subject = evaluation::subjectOf(named.filename().string(), loaded.value());
        if (subject == nullptr) {
            return Status(StatusCode::Empty, path.string() + ": found nothing palpable, expected a surface to touch");
        }
        subjects.push_back(std::move(subject));
    }
    if (subjects.empty()) {
        // Hills and hollows of some 10 mm on a ball of 120 mm: as bumpy as an organ, and there without a file.
        subjects.push_back(
            evaluation::subjectOf("bumpy ball of 120 mm", evaluation::shapes::bumpySphere(32, 60.0, 0.02)));
    }
    return subjects;
}

core::Result<evaluation::HandMotion> loadMotion(const fs::path& path)
{
    core::Result<session::Motion> motion = [&]() -> core::Result<session::Motion> {
        if (!session::isRecordingFile(path)) {
            return session::readMotion(path);
        }
        auto recording = session::RecordingReader::open(path);
        if (!recording.isOk()) {
            return recording.status();
        }
        return recording.value()->motion();
    }();
    if (!motion.isOk()) {
        return motion.status();
    }
    return evaluation::resampled(path.filename().string(), motion.value().p_WH, motion.value().dt_s);
}

int runStability()
{
    std::vector<evaluation::HardCaseResult> results;
    {
        ProgressLine progress;
        results = evaluation::runHardCases(
            false, [&](double share, const std::string& what) { return progress.show(share, what); });
    }
    std::size_t passed = 0;
    for (const auto& result : results) {
        passed += result.passed() ? 1 : 0;
        const evaluation::HardCaseFigure* f = result.tightest();
        print("%s  %-52s %s %.3g, bound %.3g\n", result.passed() ? "pass" : "FAIL", result.name.c_str(),
              f != nullptr ? f->what.c_str() : "", f != nullptr ? f->measured : 0.0, f != nullptr ? f->bound : 0.0);
    }
    print("%zu of %zu hard cases pass\n", passed, results.size());
    return passed == results.size() ? kDone : kSomeLost;
}

int runEvaluate(const EvaluateOptions& options)
{
    if (options.isStability) {
        return runStability();
    }
    const auto unit = unitOption(options.unit);
    if (!unit.isOk()) {
        return report(unit.status());
    }
    const auto stiffness = numberOption("--stiffness", options.stiffness, 0.0, true);
    if (!stiffness.isOk()) {
        return report(stiffness.status());
    }
    std::optional<evaluation::HandMotion> motion;
    if (!options.motion.empty()) {
        auto loaded = loadMotion(options.motion);
        if (!loaded.isOk()) {
            return report(loaded.status());
        }
        motion = std::move(loaded).value();
    }
    // Before minutes of work, not after.
    std::error_code error;
    fs::create_directories(options.out, error);
    if (!fs::is_directory(options.out)) {
        return report(Status(StatusCode::BadCommandLine,
                             "--out: " + options.out.string() + " cannot be made: " + error.message()));
    }
    std::vector<std::string> losses;
    const auto subjects = loadSubjects(options, unit.value(), losses);
    if (!subjects.isOk()) {
        return report(subjects.status());
    }
    evaluation::Evaluation result;
    {
        ProgressLine progress;
        evaluation::EvaluateOptions how;
        how.isQuick = options.isQuick;
        how.stiffness_N_per_mm = stiffness.value();
        how.seed = options.seed;
        how.progress = [&](double share, const std::string& what) { return progress.show(share, what); };
        result = evaluation::evaluate(subjects.value(), motion ? &*motion : nullptr, how);
    }
    if (const Status status = evaluation::writeReport(options.out, result); !status.isOk()) {
        return report(status);
    }
    for (const evaluation::Advice& advice : result.advice) {
        print("%s: %s\n  %s\n", advice.subject.c_str(), advice.setting.c_str(), advice.why.c_str());
    }
    std::size_t passed = 0;
    for (const auto& hardCase : result.hardCases) {
        passed += hardCase.passed() ? 1 : 0;
    }
    print("%zu of %zu hard cases pass\n%s\n", passed, result.hardCases.size(),
          (options.out / "report.html").string().c_str());
    return reportLosses(losses);
}

} // namespace

void addEvaluateCommand(CLI::App& app, Chosen& chosen)
{
    auto options = std::make_shared<EvaluateOptions>();
    CLI::App* command =
        app.add_subcommand("evaluate", "Measure speed against error: every solver and setting, on your meshes");
    command->add_option("SCENE", options->scenes,
                        "Mesh files, scene files or folders of meshes; without any, a bumpy ball");
    command->add_option("--motion", options->motion,
                        "CSV with x,y,z in mm, or a recording; without it, motions are laid on the surfaces");
    command->add_option("--out", options->out, "Folder for report.html, results.csv and results.json")
        ->capture_default_str();
    command->add_option("--unit", options->unit, "Unit of a mesh file's numbers: m, cm or mm")->capture_default_str();
    command->add_option("--stiffness", options->stiffness, "Stiffness for forces [N/mm]")->capture_default_str();
    command->add_option("--seed", options->seed, "Seed of the motions")->capture_default_str();
    command->add_flag("--quick", options->isQuick, "End within half a minute");
    command->add_flag("--stability", options->isStability, "Run the hard cases alone; exit code 3 when one fails");
    command->callback([options, &chosen] { chosen = [options] { return runEvaluate(*options); }; });
}

} // namespace palpate::app

// SPDX-License-Identifier: BSD-3-Clause
#include "commands/Commands.h"
#include "commands/FeltComparisonRun.h"
#include "shared/Console.h"
#include "shared/LayersOption.h"
#include "shared/ProgramFolders.h"
#include "shared/ProgressLine.h"
#include "shared/SurfaceOptions.h"

#include <palpate/core/Tissue.h>
#include <palpate/evaluation/Report.h>
#include <palpate/session/MotionFile.h>
#include <palpate/session/RecordingReader.h>
#include <palpate/study/HapticCopy.h>
#include <palpate/study/RecordedScene.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <csignal>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include <sys/resource.h>

namespace palpate::app {

using core::Status;
using core::StatusCode;

namespace {

namespace fs = std::filesystem;
using Subjects = std::vector<std::shared_ptr<const evaluation::Subject>>;

struct EvaluateOptions
{
    std::vector<fs::path> scenes;
    fs::path motion, out = "out/evaluation";
    std::string unit = "mm", frame, stiffness, layers;
    SurfaceOptions surfaces;
    std::uint64_t seed = 1;
    int seeds = 0; ///< 0: default of the run type
    bool isQuick = false;
    bool isStability = false;
    bool isFelt = false;
    bool isLong = false;
    bool withGeneratedMotions = false; ///< in addition to the given motion
};

constexpr std::uint64_t kMostSeeds = 1000;
// On an idle machine, a quick run ends within 30 s including loading, the current step and writing, which cannot be
// cut short.
constexpr double kQuick_s = 22.0, kQuickLeast_s = 3.0;

/// CPU time of this process and of its file-reading child processes. [s]
double processorTime_s()
{
    double sum_s = 0.0;
    for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
        rusage usage{};
        (void)::getrusage(who, &usage);
        for (const timeval& time : {usage.ru_utime, usage.ru_stime}) {
            sum_s += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
        }
    }
    return sum_s;
}

/// Ignores Ctrl-C while a file is being written.
class Uninterrupted
{
  public:
    Uninterrupted()
    {
        for (std::size_t i = 0; i < kSignals.size(); ++i) {
            m_before[i] = std::signal(kSignals[i], SIG_IGN);
        }
    }
    ~Uninterrupted()
    {
        for (std::size_t i = 0; i < kSignals.size(); ++i) {
            (void)std::signal(kSignals[i], m_before[i]);
        }
    }

  private:
    static constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};
    std::array<void (*)(int), kSignals.size()> m_before{};
};

/// Loads the scenes. @param losses  gets a line for each item that could not be opened
core::Result<Subjects> loadSubjects(const EvaluateOptions& options, const meshio::ReadOptions& read,
                                    std::optional<double> stiffness, std::vector<core::Message>& losses)
{
    Subjects subjects;
    for (const fs::path& path : options.scenes) {
        auto loaded = study::openScene(path, read);
        if (!loaded.isOk()) {
            return loaded.status();
        }
        meshio::LoadedScene scene = std::move(loaded).value();
        losses.insert(losses.end(), scene.losses.begin(), scene.losses.end());
        if (!options.layers.empty()) {
            auto felt = study::hapticScene(scene);
            for (const core::Message& line : layOut(path, scene, felt)) {
                print("%s: layers: %s\n", path.filename().string().c_str(), line.english().c_str());
            }
        }
        for (meshio::LoadedStructure& structure : scene.structures) {
            double& own = structure.description.tissue.stiffness_N_per_mm;
            own = stiffness.value_or(own);
        }
        const fs::path named = path.has_filename() ? path : path.parent_path();
        std::string name = named.filename().string();
        if (std::any_of(subjects.begin(), subjects.end(), [&](const auto& s) { return s->name == name; })) {
            name = path.string(); // several folders may contain a liver.stl
        }
        auto subject = evaluation::subjectOf(std::move(name), scene);
        if (subject == nullptr) {
            return Status(StatusCode::Empty, PALPATE_TEXT("%1: found nothing palpable, expected a surface to touch"),
                          path);
        }
        subjects.push_back(std::move(subject));
    }
    return subjects;
}

core::Result<evaluation::HandMotion> loadMotion(const fs::path& path)
{
    core::Result<session::Motion> motion = [&]() -> core::Result<session::Motion> {
        if (!session::isRecordingByNameOrContent(path)) {
            return session::readMotion(path);
        }
        auto recording = session::RecordingReader::open(path);
        if (!recording.isOk()) {
            return recording.status();
        }
        auto recorded = recording.value()->motion();
        if (const auto faults = recording.value()->faults(); recorded.isOk() && !faults.empty()) {
            return Status(StatusCode::Mismatch,
                          PALPATE_TEXT("%1: %2; expected a recording as it was written, or what session recover makes "
                                       "of it"),
                          path, faults.front());
        }
        return recorded;
    }();
    if (!motion.isOk()) {
        return motion.status();
    }
    return evaluation::resampled(path.filename().string(), motion.value().p_WH, motion.value().dt_s);
}

int runHardCases(bool withLong)
{
    std::vector<evaluation::HardCaseResult> results;
    {
        ProgressLine progress;
        results =
            evaluation::runHardCases(withLong ? evaluation::HardCaseChoice::All : evaluation::HardCaseChoice::Ordinary,
                                     [&](double share, const std::string& what) { return progress.show(share, what); });
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

void printSummary(const evaluation::Evaluation& result)
{
    for (const evaluation::Advice& advice : result.advice) {
        print("%s: %s\n", advice.subject.c_str(), advice.setting.c_str());
        for (const std::string& line : advice.why) {
            print("  %s\n", line.c_str());
        }
        if (!advice.warning.empty()) {
            print("  %s\n", advice.warning.c_str());
        }
    }
    for (const evaluation::Ratio& ratio : result.ratios) {
        print("Sphere of %s triangles: a tick of %s takes %.3g times as long", grouped(ratio.triangles).c_str(),
              ratio.solver.c_str(), ratio.times);
        if (ratio.wanted > 0.0) {
            print(" (wanted: at least %g)", ratio.wanted);
        }
        print("\n");
    }
    std::size_t passed = 0;
    for (const auto& hardCase : result.hardCases) {
        passed += hardCase.passed() ? 1 : 0;
    }
    print("%zu of %zu hard cases that were run pass\n", passed, result.hardCases.size());
    for (const std::string& line : result.skippedItems) {
        print("Left out: %s\n", line.c_str());
    }
}

core::Result<std::optional<double>> stiffnessOption(const std::string& text)
{
    if (text.empty()) {
        return std::optional<double>();
    }
    const auto given = numberOption("--stiffness", text, {.most = core::kTissueTerms.front().most, .isAbove = true});
    return given.isOk() ? core::Result<std::optional<double>>(std::optional(given.value())) : given.status();
}

/// Without a scene argument, uses the bundled phantom and its recorded palpation.
core::Status chooseScene(EvaluateOptions& options)
{
    if (!options.scenes.empty()) {
        return {};
    }
    const auto folder = phantomFolder();
    if (!folder) {
        return {StatusCode::BadCommandLine,
                PALPATE_TEXT("evaluate: found no SCENE and no bundled phantom, expected a mesh or a scene file")};
    }
    options.scenes.push_back(*folder / "phantom.palpate.json");
    if (options.motion.empty()) {
        options.motion = *folder / "palpation.palpate";
        options.withGeneratedMotions = true;
    }
    return {};
}

Status makeFolder(const fs::path& folder)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (!fs::is_directory(folder)) {
        return {StatusCode::BadCommandLine, PALPATE_TEXT("--out: %1 cannot be made: %2"), folder,
                core::systemError(error.value())};
    }
    return {};
}

int runEvaluate(EvaluateOptions options)
{
    if (options.isStability) {
        return runHardCases(options.isLong);
    }
    if (options.isFelt) {
        if (!options.scenes.empty()) {
            return report(Status(StatusCode::BadCommandLine, PALPATE_TEXT("--felt: found %1, expected no SCENE"),
                                 options.scenes.front()));
        }
        const Status status = makeFolder(options.out);
        return status.isOk() ? runFeltComparison(options.out, options.isQuick) : report(status);
    }
    const auto unit = unitOption(options.unit);
    if (!unit.isOk()) {
        return report(unit.status());
    }
    const auto frame = frameOption(options.frame);
    if (!frame.isOk()) {
        return report(frame.status());
    }
    if (const Status status = checkLayers(options.layers); !status.isOk()) {
        return report(status);
    }
    const auto stiffness = stiffnessOption(options.stiffness);
    if (!stiffness.isOk()) {
        return report(stiffness.status());
    }
    if (const Status status = chooseScene(options); !status.isOk()) {
        return report(status);
    }
    std::vector<fs::path> inputs = options.scenes;
    inputs.push_back(options.motion);
    if (const Status status = checkOutputs(inputs, evaluation::reportFiles(options.out)); !status.isOk()) {
        return report(status);
    }
    std::vector<evaluation::HandMotion> motions;
    if (!options.motion.empty()) {
        auto loaded = loadMotion(options.motion);
        if (!loaded.isOk()) {
            return report(loaded.status());
        }
        motions.push_back(std::move(loaded).value());
    }
    if (const Status status = makeFolder(options.out); !status.isOk()) { // fail before minutes of work, not after
        return report(status);
    }
    std::vector<core::Message> losses;
    meshio::ReadOptions read;
    read.unit_mm = unit.value();
    read.frame = frame.value();
    options.surfaces.applyTo(read);
    const auto subjects = loadSubjects(options, read, stiffness.value(), losses);
    if (!subjects.isOk()) {
        return report(subjects.status());
    }
    evaluation::Evaluation result;
    {
        ProgressLine progress;
        evaluation::EvaluateOptions how;
        how.isQuick = options.isQuick;
        how.seed = options.seed;
        how.seeds = options.seeds;
        how.withGeneratedMotions = options.withGeneratedMotions;
        how.progress = [&](double share, const std::string& what) { return progress.show(share, what); };
        if (options.isQuick) {
            how.seconds = std::max(kQuickLeast_s, kQuick_s - processorTime_s());
        }
        result = evaluation::evaluate(subjects.value(), motions, how);
    }
    {
        const Uninterrupted whole;
        if (const Status status = evaluation::writeReport(options.out, result); !status.isOk()) {
            return report(status);
        }
    }
    printSummary(result);
    print("%s\n", (options.out / "report.html").string().c_str());
    return reportLosses(losses);
}

/// Validator for integers. CLI11 alone would accept -1 and out-of-range numbers with other values.
/// @return a check that returns an error message, or an empty string
std::function<std::string(const std::string&)> wholeNumber(std::uint64_t least, std::uint64_t most)
{
    return [least, most](const std::string& text) {
        std::uint64_t value = 0;
        const char* const end = text.data() + text.size();
        const auto read = std::from_chars(text.data(), end, value);
        const bool isGood = read.ec == std::errc{} && read.ptr == end && value >= least && value <= most;
        return isGood ? std::string()
                      : core::Message(PALPATE_TEXT("found \"%1\", expected a whole number from %2 to %3"), text, least,
                                      most)
                            .english();
    };
}

} // namespace

void addEvaluateCommand(CLI::App& app, Chosen& chosen)
{
    auto options = std::make_shared<EvaluateOptions>();
    CLI::App* command = app.add_subcommand(kEvaluate.name, kEvaluate.description);
    command->add_option("SCENE", options->scenes,
                        "Mesh files, scene files or folders of meshes; without any, the bundled phantom");
    command->add_option("--motion", options->motion,
                        "CSV with x,y,z in mm, or a recording; without it, motions are laid on the surfaces");
    command->add_option("--out", options->out, "Folder for report.html, chart.svg, results.json and the tables as CSV")
        ->capture_default_str();
    command->add_option("--unit", options->unit, "Unit of a mesh file's numbers: m, cm or mm")->capture_default_str();
    command->add_option("--frame", options->frame, kFrameHelp);
    options->surfaces.addTo(*command);
    command->add_option("--stiffness", options->stiffness,
                        "Stiffness of every tissue [N/mm]; without it, the scene's own");
    command->add_option("--layers", options->layers, kLayersHelp);
    command->add_option("--seed", options->seed, "Seed of the first path of the hand; the next have the next seeds")
        ->capture_default_str()
        ->check(wholeNumber(0, std::numeric_limits<std::uint64_t>::max()));
    command->add_option("--seeds", options->seeds, "Paths that are laid on each scene; without it 16, with --quick 3")
        ->check(wholeNumber(1, kMostSeeds));
    command->add_flag("--quick", options->isQuick, "End within half a minute on an idle machine");
    command->add_flag("--stability", options->isStability, "Run the hard cases alone; exit code 3 when one fails");
    command->add_flag("--long", options->isLong, "With --stability: the hard cases of millions of ticks as well");
    command->add_flag("--felt", options->isFelt,
                      "Hold what is said of buried lumps against exact solutions alone: felt.html; exit code 3 when a "
                      "bound does not hold");
    command->callback([options, &chosen] { chosen = [options] { return runEvaluate(*options); }; });
}

} // namespace palpate::app

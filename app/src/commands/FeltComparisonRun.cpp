// SPDX-License-Identifier: BSD-3-Clause
#include "commands/FeltComparisonRun.h"

#include "shared/Console.h"
#include "shared/ProgressLine.h"

#include <palpate/evaluation/FeltComparison.h>

namespace palpate::app {

int runFeltComparison(const std::filesystem::path& out, bool isQuick)
{
    evaluation::felt::Comparison comparison;
    {
        ProgressLine progress;
        comparison = evaluation::felt::compare(
            {isQuick, [&](double share, const std::string& what) { return progress.show(share, what); }});
    }
    if (const core::Status status = evaluation::felt::writeReport(out, comparison); !status.isOk()) {
        return report(status);
    }
    const evaluation::felt::Verdict verdict = evaluation::felt::verdictOf(comparison);
    const std::size_t spheres = comparison.spheres.size();
    print("Elements against the exact layer: %.2g %% off at most\n", 100.0 * verdict.layerError);
    print("Bounds hold in %zu of %zu spheres under the bell, in %zu under the punch with its own share\n",
          verdict.bellWithin, spheres, verdict.punchWithinOwn);
    print("  (in %zu under the punch with the bell's share: need not be all)\n", verdict.punchWithinBell);
    print("Estimate's error in the excess: bell %.3g %% at most, median %.2g %%; punch %.3g %%, median %.2g %%\n",
          100.0 * verdict.bell.largest, 100.0 * verdict.bell.median, 100.0 * verdict.punchOwn.largest,
          100.0 * verdict.punchOwn.median);
    print("%s\n", (out / "felt.html").string().c_str());
    return verdict.isProved(spheres) ? kDone : kSomeLost;
}

} // namespace palpate::app

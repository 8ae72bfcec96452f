// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkAlgorithm.h>
#include <vtkCommand.h>

#include <functional>

namespace palpate::meshio::internal {

/// Aborts a VTK algorithm on request of the caller. The caller is not asked again, because VTK 9.3 reports progress
/// once more after an abort.
class ProgressObserver : public vtkCommand
{
  public:
    static ProgressObserver* New() { return new ProgressObserver; }
    void Execute(vtkObject* caller, unsigned long, void*) override
    {
        auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
        if (algorithm != nullptr && report && !isCancelled && !report(algorithm->GetProgress())) {
            isCancelled = true;
            algorithm->SetAbortExecute(1);
        }
    }

    std::function<bool(double)> report;
    bool isCancelled = false;
};

} // namespace palpate::meshio::internal

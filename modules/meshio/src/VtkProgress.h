// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkAlgorithm.h>
#include <vtkCommand.h>

#include <functional>

namespace palpate::meshio::internal {

/// Stops a VTK algorithm when the caller asks for it, and does not ask again: VTK 9.3 tells of progress once more then.
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

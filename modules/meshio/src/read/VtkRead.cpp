// SPDX-License-Identifier: BSD-3-Clause
#include "read/VtkRead.h"

#include "guard/VtkMessages.h"
#include "guard/VtkProgress.h"
#include "text/Fault.h"
#include "text/NumericLocale.h"

#include <vtkAlgorithm.h>
#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkNew.h>

#include <exception>
#include <mutex>
#include <new>
#include <string_view>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;

} // namespace

Result<vtkSmartPointer<vtkPolyData>> readWithVtk(const MeshFormat& format, const FileImage& image, const PreScan& scan,
                                                 const ScanContext& context)
{
    // One reader per process at a time: VTK's PLY reader uses a single global heap (vtkPLY.cxx). With an import server
    // each file has a separate process, so nothing waits here.
    static std::mutex oneAtATime;
    const std::scoped_lock lock(oneAtATime);
    const NumericLocale locale;
    const VtkMessages messages;
    const auto unreadable = [&](std::string_view reason) {
        return fault(StatusCode::BadFormat, context.file, {}, {PALPATE_TEXT("VTK could not read it: %1"), reason},
                     {PALPATE_TEXT("a valid %1 file"), scan.format});
    };
    vtkNew<ProgressObserver> observer;
    observer->report = context.progress;
    vtkSmartPointer<vtkPolyData> mesh;
    try {
        const vtkSmartPointer<vtkAlgorithm> reader = format.reader(image.openPath(), scan);
        reader->AddObserver(vtkCommand::ProgressEvent, observer);
        reader->Update();
        mesh = vtkPolyData::SafeDownCast(reader->GetOutputDataObject(0));
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        return unreadable(error.what());
    }
    if (observer->isCancelled) {
        return Status(StatusCode::Cancelled, PALPATE_TEXT("%1: reading was cancelled"), context.file);
    }
    if (!messages.firstError().empty() || mesh == nullptr) {
        return unreadable(messages.firstError());
    }
    const auto points = static_cast<std::uint64_t>(mesh->GetNumberOfPoints());
    const auto cells = static_cast<std::uint64_t>(mesh->GetNumberOfPolys() + mesh->GetNumberOfStrips());
    if (points != scan.points || cells != scan.cells) {
        return fault(StatusCode::BadFormat, context.file, {},
                     {PALPATE_TEXT("number of points read by VTK: %1, of polygons: %2"), Count(points), Count(cells)},
                     {PALPATE_TEXT("%1 and %2"), Count(scan.points), Count(scan.cells)});
    }
    return mesh;
}

} // namespace palpate::meshio::internal

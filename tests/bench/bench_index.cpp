// SPDX-License-Identifier: BSD-3-Clause
// Times the preparation of a surface for contact, compared to VTK's tree in the same run.
//
// bench_index [--benchmark_filter=REGEX] [--benchmark_repetitions=5]
//
// repair/T: welding, duplicates, orientation of T triangles.
// index/T: the spatial index with neighbours and clear triangles on all cores. bytes: container memory per triangle;
// resident: the same from the growth of the process.
// obbtree/T: vtkOBBTree on the same triangles, if VTK is built in; compare the medians of one run.
#include "ResidentMemory.h"
#include "Shapes.h"

#include <benchmark/benchmark.h>

#ifdef PALPATE_BENCH_VTK
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkOBBTree.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#endif

namespace {

using namespace palpate;

void repair(benchmark::State& state)
{
    const geometry::TriangleMesh mesh = test::sphere(static_cast<int>(state.range(0)), 50.0);
    for (auto _ : state) {
        benchmark::DoNotOptimize(geometry::repair(mesh));
    }
    state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
}

void index(benchmark::State& state)
{
    const geometry::RepairedMesh mesh = geometry::repair(test::sphere(static_cast<int>(state.range(0)), 50.0));
    (void)geometry::SurfaceIndex::build(mesh); // memory kept after a first build does not belong to the index
    const double before = test::residentBytes();
    double grown = 0.0;
    {
        const geometry::SurfaceIndex kept = geometry::SurfaceIndex::build(mesh);
        grown = test::residentBytes() - before;
    }
    std::size_t bytes = 0;
    for (auto _ : state) {
        bytes = geometry::SurfaceIndex::build(mesh).byteSize();
        benchmark::DoNotOptimize(bytes);
    }
    state.counters["triangles"] = static_cast<double>(mesh.mesh.triangles.size());
    state.counters["bytes"] = static_cast<double>(bytes) / static_cast<double>(mesh.mesh.triangles.size());
    state.counters["resident"] = grown / static_cast<double>(mesh.mesh.triangles.size());
}

#ifdef PALPATE_BENCH_VTK
void obbtree(benchmark::State& state)
{
    const geometry::RepairedMesh mesh = geometry::repair(test::sphere(static_cast<int>(state.range(0)), 50.0));
    vtkNew<vtkPoints> points;
    for (const geometry::Vec3& v : mesh.mesh.vertices) {
        points->InsertNextPoint(v.data());
    }
    vtkNew<vtkCellArray> cells;
    for (const geometry::Triangle& t : mesh.mesh.triangles) {
        const vtkIdType ids[3] = {t[0], t[1], t[2]};
        cells->InsertNextCell(3, ids);
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(cells);
    for (auto _ : state) {
        vtkNew<vtkOBBTree> tree;
        tree->SetDataSet(data);
        tree->BuildLocator();
    }
    state.counters["triangles"] = static_cast<double>(mesh.mesh.triangles.size());
}
BENCHMARK(obbtree)->Arg(32)->Arg(256)->Unit(benchmark::kMillisecond)->UseRealTime();
#endif

BENCHMARK(repair)->Arg(32)->Arg(256)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(index)->Arg(32)->Arg(256)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace

BENCHMARK_MAIN();

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/RaySolver.h"

#include "peers/VtkMesh.h"

#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkStaticCellLocator.h>

namespace palpate::evaluation {

namespace {

class VtkCaster : public SegmentCaster
{
  public:
    explicit VtkCaster(const Surface& surface)
        : m_mesh(toPolyData(surface.repaired().mesh))
    {
        m_locator->SetDataSet(m_mesh);
        m_locator->BuildLocator();
    }

    std::string name() const override { return "VTK static cell locator"; }

    bool cast(const Vec3& from, const Vec3& to, Hit& hit) override
    {
        double t = 0.0, x[3], parameters[3];
        int subId = 0;
        vtkIdType cell = -1;
        if (m_locator->IntersectWithLine(from.data(), to.data(), 0.0, t, x, parameters, subId, cell, m_cell) == 0) {
            return false;
        }
        hit = {t, static_cast<std::uint32_t>(cell)};
        return true;
    }

  private:
    vtkSmartPointer<vtkPolyData> m_mesh;
    vtkNew<vtkStaticCellLocator> m_locator;
    vtkNew<vtkGenericCell> m_cell;
};

} // namespace

std::unique_ptr<SegmentCaster> makeVtkCaster(const Surface& surface)
{
    return std::make_unique<VtkCaster>(surface);
}

} // namespace palpate::evaluation

// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/evaluation/RaySolver.h"

#ifdef PALPATE_EMBREE
#if PALPATE_EMBREE >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <cstdint>
#endif

namespace palpate::evaluation {

#ifdef PALPATE_EMBREE

namespace {

class EmbreeCaster : public SegmentCaster
{
  public:
    explicit EmbreeCaster(const Surface& surface)
        : m_device(rtcNewDevice(nullptr))
        , m_scene(rtcNewScene(m_device))
        // Coordinates relative to the centre preserve single precision.
        , m_centre(surface.bounds().center())
    {
        const geometry::TriangleMesh& mesh = surface.repaired().mesh;
        RTCGeometry geometry = rtcNewGeometry(m_device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.vertices.size()));
        for (const Vec3& v : mesh.vertices) {
            const Eigen::Vector3f f = (v - m_centre).cast<float>();
            vertices = std::copy_n(f.data(), 3, vertices);
        }
        auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
            geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.triangles.size()));
        for (const geometry::Triangle& t : mesh.triangles) {
            indices = std::copy(t.begin(), t.end(), indices);
        }
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(m_scene, geometry);
        rtcReleaseGeometry(geometry);
        rtcSetSceneFlags(m_scene, RTC_SCENE_FLAG_ROBUST);
        rtcCommitScene(m_scene);
    }
    ~EmbreeCaster() override
    {
        rtcReleaseScene(m_scene);
        rtcReleaseDevice(m_device);
    }
    EmbreeCaster(const EmbreeCaster&) = delete;
    EmbreeCaster& operator=(const EmbreeCaster&) = delete;

    std::string name() const override { return "Embree"; }

    bool cast(const Vec3& from, const Vec3& to, Hit& hit) override
    {
        const Eigen::Vector3f origin = (from - m_centre).cast<float>(), way = (to - from).cast<float>();
        RTCRayHit query{};
        query.ray.org_x = origin.x();
        query.ray.org_y = origin.y();
        query.ray.org_z = origin.z();
        query.ray.dir_x = way.x();
        query.ray.dir_y = way.y();
        query.ray.dir_z = way.z();
        query.ray.tfar = 1.0f;
        query.ray.mask = ~0u;
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if PALPATE_EMBREE >= 4
        rtcIntersect1(m_scene, &query);
#else
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect1(m_scene, &context, &query);
#endif
        if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
            return false;
        }
        hit = {static_cast<double>(query.ray.tfar), query.hit.primID};
        return true;
    }

  private:
    RTCDevice m_device;
    RTCScene m_scene;
    Vec3 m_centre;
};

} // namespace

std::unique_ptr<SegmentCaster> makeEmbreeCaster(const Surface& surface)
{
    return std::make_unique<EmbreeCaster>(surface);
}

#else

std::unique_ptr<SegmentCaster> makeEmbreeCaster(const Surface&)
{
    return nullptr;
}

#endif

} // namespace palpate::evaluation

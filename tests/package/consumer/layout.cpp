// SPDX-License-Identifier: BSD-3-Clause
#include <palpate/device/HapticDevice.h>
#include <palpate/session/Recording.h>

#include <cstdio>
#include <cstring>

using namespace palpate;

namespace {

template<class T>
void print(const char* name)
{
    std::printf("%s %zu %zu\n", name, sizeof(T), alignof(T));
}

} // namespace

/// Prints size and alignment of public types, which must not depend on the flags of this program, and passes a scene to
/// the library.
int main()
{
    print<core::Transform>("Transform");
    print<core::Quaternion>("Quaternion");
    print<device::DeviceInfo>("DeviceInfo");
    print<device::DeviceState>("DeviceState");
    print<haptics::HapticStructure>("HapticStructure");
    print<haptics::TickResult>("TickResult");
    print<session::StructureSource>("StructureSource");
    print<session::RecordingInfo>("RecordingInfo");

    geometry::TriangleMesh mesh;
    mesh.vertices = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}};
    mesh.triangles = {{0, 1, 2}};
    haptics::HapticStructure structure;
    structure.name = "triangle";
    structure.surface =
        std::make_shared<const geometry::SurfaceIndex>(geometry::SurfaceIndex::build(geometry::repair(mesh)));
    const haptics::HapticScene scene({structure});
    std::vector<session::StructureSource> sources(1);
    sources[0].X_WM.translation() = core::Vec3(1, 2, 3);
    const session::SceneRecord record = session::describeScene(1, scene, sources);
    const core::Vec3 t = record.structures[0].source.X_WM.translation();
    std::printf("translation %g %g %g\n", t.x(), t.y(), t.z());
    return 0;
}

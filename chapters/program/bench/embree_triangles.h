#pragma once

#include "raylab/geometry/shapes.h"

#include <embree3/rtcore.h>

namespace raylab::bench {

/// Adds a mesh's triangles to a scene of Embree 3, which reads them where they lie: the mesh must outlive the scene.
inline void add_triangles(RTCDevice device, RTCScene scene, const Mesh& mesh) {
    const RTCGeometry triangles = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(triangles, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, mesh.vertices.data(), 0,
                               sizeof(Vec3f), mesh.vertices.size());
    rtcSetSharedGeometryBuffer(triangles, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.faces.data(), 0,
                               sizeof(Mesh::Face), mesh.faces.size());
    rtcCommitGeometry(triangles);
    rtcAttachGeometry(scene, triangles);
    rtcReleaseGeometry(triangles);
}

}  // namespace raylab::bench

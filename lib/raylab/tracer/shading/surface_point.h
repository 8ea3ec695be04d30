#pragma once

#include "raylab/geometry/surface/surface_position.h"
#include "raylab/scene/scene.h"
#include "raylab/tracer/shading/mesh_corners.h"

#include <array>

namespace raylab {

/// The point of a surface that a Hit stands for, computed on request: a Hit is kept small.
struct SurfacePoint {
    Vec3d position;        // on the surface, up to `error`
    double error;          // metres
    Vec3d normal;          // unit, of the surface, outward as the shape defines it (not turned to the viewer)
    Vec3d shading_normal;  // unit, what light is computed with: a smooth mesh's is between those of its vertices
    const Object* object;
    Primitive primitive;
    double u = 0, v = 0;  // as the Hit has them
};

/// The surface where a ray of this scene hit it.
SurfacePoint surface_point(const Scene& scene, const Ray& ray, const Hit& hit);

/// Whether an object is a mesh that is lit by the normals of its vertices.
inline bool is_smooth(const Object& object) {
    const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&object.shape);
    return mesh && !(*mesh)->normals.empty() && object.shading != Shading::flat;
}

/// The normal that a smooth object is lit by at a hit by a ray of this time; `normal` is the surface's own there.
Vec3d smooth_normal(const Object& object, const Hit& hit, const Vec3d& normal, float time);

/// The same where the surface position is known. Inlined and passed by value, so that the position stays in registers:
/// 1 % of the picture of tests/bench/mirror_and_glass.toml.
[[gnu::always_inline]] inline SurfacePoint surface_point(const Object& object, SurfacePosition at, const Hit& hit,
                                                         float time) {
    auto [position, error, normal] = at;
    return {
        .position = position,
        .error = error,
        .normal = normal,
        .shading_normal = is_smooth(object) ? smooth_normal(object, hit, {normal.x, normal.y, normal.z}, time) : normal,
        .object = &object,
        .primitive = hit.primitive,
        .u = hit.u,
        .v = hit.v};
}

/// The corners of the triangle that a point of a smooth object lies in, at time 0: only Whitted's rays ask.
std::array<Corner, 3> corners(const SurfacePoint& point);

/// The normal, turned if need be to the side that the ray comes from.
Vec3d facing(const Vec3d& normal, const Vec3d& direction);

/// The material of the side that a ray in this direction comes to.
const Material& material_of(const Scene& scene, const SurfacePoint& point, const Vec3d& direction);

/// The diffuse colour of the side that the ray comes from.
Color diffuse_color(const Scene& scene, const SurfacePoint& point, const Vec3d& direction);

}  // namespace raylab

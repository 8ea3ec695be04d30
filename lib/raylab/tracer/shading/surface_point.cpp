#include "raylab/tracer/shading/surface_point.h"

#include "raylab/geometry/placement_at.h"
#include "raylab/scene/moving.h"
#include "raylab/scene/pigment.h"

namespace raylab {

SurfacePoint surface_point(const Scene& scene, const Ray& ray, const Hit& hit) {
    const Object& object = scene.objects[hit.primitive.object];
    const Motion* motion = motion_of(scene, object);
    return surface_point(object, surface_position(ray, hit, object.shape, object.placement, motion), hit, ray.time);
}

Vec3d smooth_normal(const Object& object, const Hit& hit, const Vec3d& normal, float time) {
    const auto& mesh = *std::get<std::shared_ptr<const Mesh>>(object.shape);
    // Normals are only shaded with, so floats suffice; a translation leaves them as they are.
    const bool turns = object.motion && !only_translates(*object.motion);
    const Affine placement = turns ? rounded_placement(object.placement, *object.motion, time) : object.placement;
    return normal_between(mesh, hit.primitive.part, hit.u, hit.v, placement, normal);
}

std::array<Corner, 3> corners(const SurfacePoint& point) {
    const auto& mesh = *std::get<std::shared_ptr<const Mesh>>(point.object->shape);
    return mesh_corners(mesh, point.primitive.part, point.object->placement, point.normal);
}

Vec3d facing(const Vec3d& normal, const Vec3d& direction) { return dot(normal, direction) > 0 ? -normal : normal; }

const Material& material_of(const Scene& scene, const SurfacePoint& point, const Vec3d& direction) {
    return scene.materials[dot(point.normal, direction) > 0 ? point.object->back : point.object->front];
}

Color diffuse_color(const Scene& scene, const SurfacePoint& point, const Vec3d& direction) {
    return color_at(material_of(scene, point, direction).diffuse, point.position, point.normal);
}

}  // namespace raylab

#include "raylab/tracer/shading/surface_point.h"

#include "raylab/scene/pigment.h"

namespace raylab {

SurfacePoint surface_point(const Scene& scene, const Ray& ray, const Hit& hit) {
    const Object& object = scene.objects[hit.primitive.object];
    return surface_point(object, surface_position(ray, hit, object.shape, object.placement), hit);
}

Vec3d smooth_normal(const Object& object, const Hit& hit, const Vec3d& normal) {
    const auto& mesh = *std::get<std::shared_ptr<const Mesh>>(object.shape);
    return normal_between(mesh, hit.primitive.part, hit.u, hit.v, object.placement, normal);
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

#include "raylab/tracer/surface_point.h"

#include "raylab/geometry/intersect.h"
#include "raylab/scene/pigment.h"

namespace raylab {

SurfacePoint surface_point(const Scene& scene, const Ray& ray, const Hit& hit) {
    const Object& object = scene.objects[hit.primitive.object];
    const Candidate candidate{.t = hit.t, .t_error = 0, .u = hit.u, .v = hit.v};
    const auto normal_of = [&](const Shape& shape) { return normal_at(ray, candidate, shape, object.placement); };
    const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&object.shape);
    return {.position = convert<double>(ray.origin) + hit.t * convert<double>(ray.direction),
            .normal = mesh ? normal_of((*mesh)->triangle(hit.primitive.part)) : normal_of(object.shape),
            .object = &object};
}

Vec3d facing(const Vec3d& normal, const Vec3d& direction) { return dot(normal, direction) > 0 ? -normal : normal; }

Color diffuse_color(const Scene& scene, const SurfacePoint& point, const Vec3d& direction) {
    const std::size_t side = dot(point.normal, direction) > 0 ? point.object->back : point.object->front;
    return color_at(scene.materials[side].diffuse, point.position, point.normal);
}

}  // namespace raylab

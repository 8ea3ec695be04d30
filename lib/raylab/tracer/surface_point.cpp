#include "raylab/tracer/surface_point.h"

#include "raylab/geometry/intersect.h"
#include "raylab/geometry/surface_position.h"
#include "raylab/geometry/transformed_normal.h"
#include "raylab/scene/pigment.h"

namespace raylab {

namespace {

// Between the normals of a triangle's vertices, as the hit lies between the vertices; the triangle's own where they cancel.
Vec3d between_vertices(const Mesh& mesh, const Hit& hit, const Affine& placement, const Vec3d& normal) {
    const auto [a, b, c] = mesh.faces[hit.primitive.part];
    const Vec3d between = convert<double>(mesh.normals[a]) * (1 - hit.u - hit.v) +
                          convert<double>(mesh.normals[b]) * hit.u + convert<double>(mesh.normals[c]) * hit.v;
    if (!(dot(between, between) > 0)) return normal;
    if (placement.is_identity()) return glm::normalize(between);
    const auto& columns = placement.columns;
    return transformed_normal({convert<double>(columns[0]), convert<double>(columns[1]), convert<double>(columns[2])}, between);
}

}  // namespace

SurfacePoint surface_point(const Scene& scene, const Ray& ray, const Hit& hit) {
    const Object& object = scene.objects[hit.primitive.object];
    const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&object.shape);
    const auto [position, error] = surface_position(ray, hit, object.shape, object.placement);
    const Candidate candidate{.t = hit.t, .t_error = 0, .u = hit.u, .v = hit.v};
    const Vec3d normal = mesh ? normal_at(ray, candidate, (*mesh)->triangle(hit.primitive.part), object.placement)
                              : normal_at(ray, candidate, object.shape, object.placement);
    const bool smooth = mesh && !(*mesh)->normals.empty();
    return {.position = position,
            .error = error,
            .normal = normal,
            .shading_normal = smooth ? between_vertices(**mesh, hit, object.placement, normal) : normal,
            .object = &object,
            .primitive = hit.primitive};
}

Vec3d facing(const Vec3d& normal, const Vec3d& direction) { return dot(normal, direction) > 0 ? -normal : normal; }

const Material& material_of(const Scene& scene, const SurfacePoint& point, const Vec3d& direction) {
    return scene.materials[dot(point.normal, direction) > 0 ? point.object->back : point.object->front];
}

Color diffuse_color(const Scene& scene, const SurfacePoint& point, const Vec3d& direction) {
    return color_at(material_of(scene, point, direction).diffuse, point.position, point.normal);
}

}  // namespace raylab

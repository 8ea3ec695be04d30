#include "raylab/tracer/shading/mesh_corners.h"

#include "raylab/geometry/barycentric.h"
#include "raylab/geometry/scaled_to_largest_one.h"
#include "raylab/geometry/transformed_normal.h"

namespace raylab {

namespace {

std::array<Vec3d, 3> linear_part(const Affine& placement) {
    const auto& c = placement.columns;
    return {convert<double>(c[0]), convert<double>(c[1]), convert<double>(c[2])};
}

// Files give normals of any length; between them each counts by its direction only. Zero where the vertex has none.
Vec3d unit_normal(const Vec3f& normal) {
    if (normal == Vec3f{0, 0, 0}) return {0, 0, 0};
    return glm::normalize(scaled_to_largest_one(convert<double>(normal)));
}

Vec3d placed(const Vec3d& normal, const Affine& placement, const Vec3d& otherwise) {
    if (!(dot(normal, normal) > 0)) return otherwise;
    return placement.is_identity() ? glm::normalize(normal) : transformed_normal(linear_part(placement), normal);
}

}  // namespace

std::array<Corner, 3> mesh_corners(const Mesh& mesh, std::size_t face, const Affine& placement,
                                   const Vec3d& face_normal) {
    const auto corner = [&](std::uint32_t vertex) -> Corner {
        return {transform_point(placement, convert<double>(mesh.vertices[vertex])),
                placed(unit_normal(mesh.normals[vertex]), placement, face_normal)};
    };
    const auto [a, b, c] = mesh.faces[face];
    return {corner(a), corner(b), corner(c)};
}

Vec3d normal_between(const Mesh& mesh, std::size_t face, double u, double v, const Affine& placement,
                     const Vec3d& face_normal) {
    const auto [a, b, c] = mesh.faces[face];
    const Vec3d between =
        interpolate(unit_normal(mesh.normals[a]), unit_normal(mesh.normals[b]), unit_normal(mesh.normals[c]), u, v);
    return placed(between, placement, face_normal);
}

}  // namespace raylab

#include "raylab/scene/nff/patch.h"

#include <gmpxx.h>

#include <memory>

namespace raylab {

namespace {

using Exact = Triple<mpq_class>;

Exact exact(const Vec3f& v) { return {v.x, v.y, v.z}; }

Exact newell_normal(const std::vector<Vec3f>& vertices) {
    Exact sum{0, 0, 0};
    for (std::size_t i = 0; i < vertices.size(); ++i)
        sum = sum + cross(exact(vertices[i]), exact(vertices[(i + 1) % vertices.size()]));
    return sum;
}

// Whether every triangle of the fan faces the same way as the whole polygon.
bool can_be_fanned(const std::vector<Vec3f>& vertices) {
    if (vertices.size() == 3) return true;
    const auto normal = newell_normal(vertices);
    const auto first = exact(vertices[0]);
    for (std::size_t i = 2; i < vertices.size(); ++i) {
        const auto turn = cross(exact(vertices[i - 1]) - first, exact(vertices[i]) - first);
        if (sgn(dot(turn, normal)) < 0) return false;
    }
    return true;
}

}  // namespace

Shape make_patch(std::vector<Vec3f> vertices, std::vector<Vec3f> normals) {
    if (!can_be_fanned(vertices)) return Polygon{std::move(vertices)};
    Mesh mesh{.vertices = std::move(vertices), .faces = {}, .normals = std::move(normals)};
    for (std::uint32_t i = 2; i < mesh.vertices.size(); ++i) mesh.faces.push_back({0, i - 1, i});
    return std::make_shared<const Mesh>(std::move(mesh));
}

}  // namespace raylab

#include "raylab/experiment/generate/loose_triangles.h"

namespace raylab {

void add(Mesh& mesh, const Triangle& triangle) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {triangle.a, triangle.b, triangle.c});
    mesh.faces.push_back({first, first + 1, first + 2});
}

void add_parallelogram(Mesh& mesh, const Vec3f& corner, const Vec3f& u, const Vec3f& v) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {corner, corner + u, corner + u + v, corner + v});
    mesh.faces.push_back({first, first + 1, first + 2});
    mesh.faces.push_back({first, first + 2, first + 3});
}

std::shared_ptr<const Mesh> mesh_of(const std::vector<Triangle>& triangles) {
    auto mesh = std::make_shared<Mesh>();
    for (const Triangle& triangle : triangles) add(*mesh, triangle);
    return mesh;
}

}  // namespace raylab

#include "raylab/geometry/mesh/vertex_normals.h"

#include <cmath>

namespace raylab {

namespace {

// A sum of unit normals shorter than this share of its weights is what rounding left of normals that cancel.
constexpr double cancelled = 1e-6;

struct Sum {
    Vec3d normal{0, 0, 0};
    double angles = 0;

    void add(const Vec3d& unit_normal, double angle) {
        normal += angle * unit_normal;
        angles += angle;
    }
    Vec3f mean() const {
        const double length = glm::length(normal);
        return length > cancelled * angles ? convert<float>(normal / length) : Vec3f{0, 0, 0};
    }
};

// The angle is computed by its tangent: the cosine of a small angle has lost its digits.
double angle_between(const Vec3d& a, const Vec3d& b) { return std::atan2(glm::length(cross(a, b)), dot(a, b)); }

}  // namespace

std::vector<Vec3f> vertex_normals(const Mesh& mesh) {
    std::vector<Sum> sums(mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
        const auto [a, b, c] = in<double>(mesh.triangle(i));
        const Vec3d ab = b - a, bc = c - b, ca = a - c, upright = cross(ab, bc);
        const double length = glm::length(upright);
        if (!(length > 0)) continue;
        const Vec3d normal = upright / length;
        sums[mesh.faces[i].a].add(normal, angle_between(ab, -ca));
        sums[mesh.faces[i].b].add(normal, angle_between(bc, -ab));
        sums[mesh.faces[i].c].add(normal, angle_between(ca, -bc));
    }
    std::vector<Vec3f> normals;
    normals.reserve(sums.size());
    for (const Sum& sum : sums) normals.push_back(sum.mean());
    return normals;
}

Mesh with_vertex_normals(Mesh mesh) {
    mesh.normals = vertex_normals(mesh);
    return mesh;
}

}  // namespace raylab

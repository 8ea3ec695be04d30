#include "raylab/geometry/mesh/winding_number.h"

#include <cmath>
#include <numbers>

namespace raylab {

namespace {

// Seen from the origin, positive where the triangle's back is seen; the way to a vertex may have any length.
double solid_angle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    return 2 * std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

}  // namespace

double winding_number(const Vec3d& point, const Mesh& mesh, const Affine& placement) {
    const auto from_point = [&](std::uint32_t vertex) {
        return transform_point(placement, convert<double>(mesh.vertices[vertex])) - point;
    };
    double sum = 0;
    for (const auto& [a, b, c] : mesh.faces) sum += solid_angle(from_point(a), from_point(b), from_point(c));
    return sum / (4 * std::numbers::pi);
}

}  // namespace raylab

#include "raylab/sampling/mapping/spherical_triangle.h"

#include "raylab/sampling/mapping/solid_angle.h"

namespace raylab {

namespace {

// The unit tangent at a unit vector of the great circle to another. By their difference: the vectors may be close.
Vec3d tangent(const Vec3d& at, const Vec3d& to) {
    const Vec3d way = to - at;
    return glm::normalize(way - dot(way, at) * at);
}

}  // namespace

SphericalTriangle::SphericalTriangle(const Vec3d& a, const Vec3d& b, const Vec3d& c)
    : a_(glm::normalize(a)),
      b_(glm::normalize(b)),
      a_to_c_(tangent(a_, glm::normalize(c))),
      solid_angle_(triangle_solid_angle(a, b, c)) {
    const Vec3d a_to_b = tangent(a_, b_);
    angle_ = std::atan2(glm::length(cross(a_to_b, a_to_c_)), dot(a_to_b, a_to_c_));
    half_c_ = glm::length(b_ - a_) / glm::length(b_ + a_);
}

// A point on the side from a to c divides the triangle so that the part beside the side from a to b has the share u of
// the area. Half the tangents of the two sides and the angle at a between them give that area E:
//     tan(E / 2) = t sin(angle) / (1 + t cos(angle)),  t = tan(b / 2) tan(c / 2),
// which is solved for b without a difference of nearly equal numbers. (Arvo solves for the cosine of b, in which small
// triangles lose their digits.) Then 1 - cos of the way from b to that point is divided by v.
Vec3d SphericalTriangle::direction(double u, double v) const {
    const double half_area = 0.5 * u * solid_angle_;
    const double half_b = std::sin(half_area) / (std::sin(angle_ - half_area) * half_c_);  // its tangent
    const double turn = 2 / (1 + half_b * half_b);                                         // 1 + cos b
    const Vec3d opposite = (turn - 1) * a_ + half_b * turn * a_to_c_;
    const Vec3d way = opposite - b_;
    const double below = 0.5 * v * dot(way, way);
    return (1 - below) * b_ + std::sqrt(below * (2 - below)) * tangent(b_, opposite);
}

}  // namespace raylab

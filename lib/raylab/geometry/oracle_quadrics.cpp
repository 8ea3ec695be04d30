#include "raylab/geometry/oracle_numbers.h"

namespace raylab::oracle {

namespace {

/// The coordinates of the line's points, seen from a center, as functions of t.
std::array<InT, 3> coordinates(const Line& line, const Exact::Point_3& center) {
    const Exact::Vector_3 from = line.origin - center;
    const Exact::Vector_3& d = line.direction;
    return {InT{from.x(), d.x()}, InT{from.y(), d.y()}, InT{from.z(), d.z()}};
}

/// A whole closed surface: every zero is a hit.
Contacts meet_closed(const InT& equation) {
    const Zeros zero = zeros(equation);
    Contacts contacts{{}, zero.everywhere};
    for (const Root& t : zero.at) contacts.hits.push_back({zero.twice ? Meeting::tangent : Meeting::interior, t});
    return contacts;
}

}  // namespace

Contacts meet_sphere(const Line& line, const SphereOf<double>& sphere) {
    if (sphere.radius < 0) return {};
    const auto [x, y, z] = coordinates(line, exact_point(sphere.center));
    const Rational radius = exact(sphere.radius);
    return meet_closed(square(x) + square(y) + square(z) - InT{radius * radius, 0});
}

Answer meet(const RayOf<double>& ray, const SphereOf<double>& sphere) {
    return answer(meet_sphere(exact_line(ray), sphere), ray.range);
}

}  // namespace raylab::oracle

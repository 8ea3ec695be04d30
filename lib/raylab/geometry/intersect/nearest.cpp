#include "raylab/geometry/intersect/nearest.h"

#include "raylab/geometry/containment.h"
#include "raylab/geometry/flush_triangles.h"
#include "raylab/geometry/intersect/prepared_shape.h"
#include "raylab/geometry/predicate/intersection.h"
#include "raylab/geometry/shape_parts.h"
#include "raylab/number/dyadic.h"

#include <cassert>
#include <cmath>

namespace raylab {

namespace {

Root<Dyadic> exact_t(const Ray& ray, const Target& target) {
    const Mesh* mesh = as_mesh(*target.shape);
    const Shape& shape = mesh ? Shape(mesh->triangle(target.part)) : *target.shape;
    Signs<Dyadic> signs;
    const auto found = intersect(ray, shape, *target.placement, target.motion, target.sides, signs);
    assert(found);  // a candidate is a hit
    return found->t;
}

// The triangle, where it is neither transformed nor in motion.
std::optional<Triangle> triangle_at_rest(const Target& target) {
    if (target.motion || !target.placement->is_identity()) return std::nullopt;
    if (const Mesh* mesh = as_mesh(*target.shape)) return mesh->triangle(target.part);
    const auto* triangle = std::get_if<Triangle>(target.shape);
    return triangle ? std::optional(*triangle) : std::nullopt;
}

bool are_flush(const Target& a, const Target& b) {
    const auto one = triangle_at_rest(a), other = triangle_at_rest(b);
    return one && other && are_flush(*one, *other);
}

}  // namespace

std::optional<Candidate> intersect(const Ray& ray, const Target& target, DecisionCounts& decisions) {
    const Mesh* mesh = as_mesh(*target.shape);
    if (mesh && !target.motion)
        return intersect(ray, mesh->triangle(target.part), *target.placement, decisions, target.sides);
    return PreparedShape(*target.shape, *target.placement, target.motion)
        .intersect(ray, target.part, target.sides, decisions);
}

bool is_flat(const Shape& shape) { return as_mesh(shape) || is_planar(shape); }

Sign sure_order(const Candidate& a, const Candidate& b) {
    const double difference = a.t - b.t;
    // The sum and the difference are rounded once each.
    const double error = (a.t_error + b.t_error) * (1 + 4 * unit_roundoff<double>);
    return std::abs(difference) > error ? sign(difference) : Sign::zero;
}

Sign order(const Ray& ray, const Target& a, const Candidate& at_a, const Target& b, const Candidate& at_b,
           DecisionCounts& decisions) {
    if (const Sign sure = sure_order(at_a, at_b); sure != Sign::zero) return sure;
    ++decisions.exact;
    if (are_flush(a, b)) return Sign::zero;
    return compare(exact_t(ray, a), exact_t(ray, b));
}

}  // namespace raylab

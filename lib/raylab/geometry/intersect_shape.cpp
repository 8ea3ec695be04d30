#include "raylab/geometry/meet.h"
#include "raylab/number/dyadic.h"

#include <variant>

namespace raylab {

namespace {

template <Scalar T>
Candidate candidate(const Meeting<T>& found) {
    const Enclosure t = value(found.t);
    return {t.middle(), t.radius(), static_cast<double>(found.part)};
}

}  // namespace

std::optional<Candidate> intersect(const Ray& ray, const Shape& shape, const Affine& placement, Decisions& decisions,
                                   Sides sides) {
    if (const auto* triangle = std::get_if<Triangle>(&shape)) {
        return intersect(ray, *triangle, placement, decisions, sides);
    }
    if (const auto* sphere = std::get_if<Sphere>(&shape); sphere && placement.is_identity()) {
        return intersect(ray, *sphere, decisions, sides);
    }
    Signs<Enclosure> signs;
    if (const auto found = meet(ray, shape, placement, sides, signs); !signs.undecided()) {
        if (!found) return std::nullopt;
        const Candidate result = candidate(*found);
        if (is_accurate(result.t, result.t_error)) return result;
    }
    ++decisions.exact;
    Signs<Dyadic> exact_signs;
    const auto found = meet(ray, shape, placement, sides, exact_signs);
    return found ? std::optional(candidate(*found)) : std::nullopt;
}

}  // namespace raylab

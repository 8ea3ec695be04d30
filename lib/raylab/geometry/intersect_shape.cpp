#include "raylab/geometry/meet.h"
#include "raylab/geometry/prepared_flat.h"
#include "raylab/geometry/revolution_filter.h"
#include "raylab/geometry/verdict.h"

namespace raylab {

namespace {

template <Scalar T>
FilterVerdict decide_in(const Ray& ray, const Shape& shape, const Affine& placement, Sides sides) {
    Signs<T> signs;
    const auto found = meet(ray, shape, placement, sides, signs);
    if (signs.undecided()) return Undecided{};
    if (!found) return Miss{};
    const Enclosure t = value(found->t);
    return Candidate{t.middle(), t.radius(), static_cast<double>(found->part)};
}

// What plain doubles say: of a shape in a plane at rest by a filter of its own, of any other shape by estimates and, where
// these leave it open, by enclosures.
FilterVerdict decide_in_doubles(const Ray& ray, const Shape& shape, const Affine& placement, Sides sides) {
    if (placement.is_identity()) {
        if (const auto* plane = std::get_if<Plane>(&shape)) return PreparedFlat(*plane).meet(ray, sides);
        if (const auto* disk = std::get_if<Disk>(&shape)) return PreparedFlat(*disk).meet(ray, sides);
        if (const auto* polygon = std::get_if<Polygon>(&shape)) return PreparedFlat(*polygon).meet(ray, sides);
        FilterVerdict soon = Undecided{};
        if (const auto* cylinder = std::get_if<Cylinder>(&shape)) soon = revolution_filter::decide(ray, *cylinder, sides);
        if (const auto* cone = std::get_if<Cone>(&shape)) soon = revolution_filter::decide(ray, *cone, sides);
        if (!std::holds_alternative<Undecided>(soon)) return soon;
    }
    const FilterVerdict estimated = if_accurate(decide_in<Estimate>(ray, shape, placement, sides));
    if (!std::holds_alternative<Undecided>(estimated)) return estimated;
    return if_accurate(decide_in<Enclosure>(ray, shape, placement, sides));
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
    const auto ask = [&]<Scalar T>() { return decide_in<T>(ray, shape, placement, sides); };
    const FilterVerdict verdict = decide_in_doubles(ray, shape, placement, sides);
    if (!std::holds_alternative<Undecided>(verdict)) return candidate_of(verdict);
    return settle(ask, decisions);
}

}  // namespace raylab

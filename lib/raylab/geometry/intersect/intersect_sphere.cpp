#include "raylab/geometry/filter/sphere_filter.h"
#include "raylab/geometry/predicate/quadric_intersection.h"
#include "raylab/geometry/predicate/verdict.h"

namespace raylab {

namespace {

template <Scalar T>
FilterVerdict decide_in(const Ray& ray, const Sphere& sphere, Sides sides) {
    Signs<T> signs;
    const auto found = intersect(transformed_ray<T>(ray, {}), sphere, sides, signs);
    if (signs.undecided()) return Undecided{};
    if (!found) return Miss{};
    const Enclosure t = value(found->t);
    return Candidate{t.middle(), t.radius()};
}

}  // namespace

std::optional<Candidate> intersect(const Ray& ray, const Sphere& sphere, DecisionCounts& decisions, Sides sides) {
    using What = sphere_filter::SphereVerdict::What;
    const sphere_filter::SphereVerdict verdict = sphere_filter::decide(ray, sphere, sides);
    if (verdict.what == What::missed) return std::nullopt;
    if (verdict.what == What::hit) return Candidate{verdict.at.t, verdict.at.error};
    return decide_beyond_doubles([&]<Scalar T>() { return decide_in<T>(ray, sphere, sides); }, decisions);
}

}  // namespace raylab

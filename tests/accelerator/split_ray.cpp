#include "raylab/accelerator/split_tree/split_ray.h"

#include "catch.h"
#include "geometry/verdict.h"

#include <gmpxx.h>

using namespace raylab;
using namespace raylab::adversarial;

namespace {

// A plane that the ray crosses at t > 0, exactly; in floats such a t may be so small that it underflows.
template <Real T>
std::optional<std::string> judge(Draw& draw) {
    const int exponent = draw.one_in(2) ? draw.integer(-149, -110) : draw.integer(-100, 0);
    const float direction = std::ldexp(draw.uniform(1, 2), 39), place = std::ldexp(draw.uniform(1, 2), exponent + 39);
    const bool backward = draw.one_in(2), from_zero = draw.one_in(2);
    const float origin = from_zero ? 0 : std::ldexp(draw.uniform(-1, 1), exponent + 39);
    const float plane = backward ? origin - place : origin + place;
    Ray ray{{origin, 0, 0}, {backward ? -direction : direction, 1, 1}};
    if (plane == origin) return std::nullopt;
    const mpq_class t = (mpq_class(plane) - mpq_class(origin)) / mpq_class(ray.direction.x);
    const SplitRay<T> split(ray);
    const auto crossing = split.crossing(0, plane);
    const typename SplitRay<T>::Span whole{0, std::numeric_limits<T>::max()};
    if (mpq_class(double{split.before(crossing, whole).end}) < t)
        return "the half before the plane ends too soon: " + words(ray);
    if (mpq_class(double{split.beyond(crossing, whole).begin}) > t)
        return "the half beyond the plane begins too late: " + words(ray);
    return std::nullopt;
}

}  // namespace

TEST_CASE("a ray is in both halves of a cell where it crosses the plane between them, though that t be rounded or "
          "underflow") {
    CHECK(faults(20'000, judge<float>) == "");
    CHECK(faults(20'000, judge<double>) == "");
}

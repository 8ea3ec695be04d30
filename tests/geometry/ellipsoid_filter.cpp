#include "raylab/geometry/filter/ellipsoid_filter.h"
#include "catch.h"
#include "geometry/filter_fault.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"

#include <atomic>

using namespace raylab;
using namespace raylab::adversarial;

namespace {

struct Seen {
    std::atomic<int> asked = 0, decided = 0, hit = 0;  // by several threads
};

std::optional<std::string> judge(const Ray& ray, const Ellipsoid& ellipsoid, Sides sides, Seen& seen) {
    const FilterVerdict verdict = sphere_filter::as_filter_verdict(ellipsoid_filter::decide(ray, ellipsoid, sides));
    ++seen.asked;
    if (std::holds_alternative<Undecided>(verdict)) return std::nullopt;
    ++seen.decided;
    seen.hit += std::holds_alternative<Candidate>(verdict);
    return filter_fault(ray, ellipsoid, sides, candidate_of(verdict));
}

}  // namespace

TEST_CASE("what doubles say of a ray and an ellipsoid is true, and most rays are decided") {
    Seen seen;
    const auto any = [&](Draw& draw) {
        const Ellipsoid ellipsoid{any_point(draw), {any_radius(draw), any_radius(draw), any_radius(draw)}};
        Ray ray = draw.one_in(2) ? through(any_point(draw), convert<double>(ellipsoid.center + draw.in_cube(1)))
                                 : Ray{ellipsoid.center + draw.in_cube(1), draw.lattice_direction(2)};
        if (draw.one_in(3)) ray.range = {draw.uniform(0, 1), draw.uniform(1, 3)};
        return judge(ray, ellipsoid, any_sides(draw), seen);
    };
    CHECK(faults(20'000, any) == "");
    CHECK(seen.decided > seen.asked * 3 / 4);
    CHECK(seen.hit > seen.asked / 10);
}

TEST_CASE("of a ray that touches an ellipsoid nothing wrong is said, however rounding falls") {
    Seen seen;
    // An affine image of a sphere of radius 5 that is touched at (3, 4, 0): by whole numbers that are no powers of two,
    // so that their products are rounded.
    const auto touched = [&](Draw& draw) {
        const auto odd = [&] { return cast<float>(2 * draw.integer(1, 1 << 20) + 1); };
        const Vec3f by{odd(), odd(), odd()};
        const auto stretched = [&](float x, float y, float z) { return Vec3f{x * by.x, y * by.y, z * by.z}; };
        const float rise = cast<float>(draw.integer(-3, 3));
        const Vec3f way = stretched(4, -3, rise);
        return judge({stretched(3, 4, 0) - way, way}, {{0, 0, 0}, 5.0f * by}, any_sides(draw), seen);
    };
    CHECK(faults(20'000, touched) == "");
    CHECK(seen.asked > 0);
    CHECK(seen.decided == 0);  // no rounded number tells a tangent
}

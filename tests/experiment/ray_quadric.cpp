#include "catch.h"

#include "raylab/experiment/ray_quadric/ray_quadric.h"
#include "raylab/geometry/surface/gradient.h"

#include <limits>

using namespace raylab;

namespace {

template <class T>
std::optional<QuadricHit<T>> shoot(const Quadric& quadric, Vec3<T> origin, Vec3<T> direction) {
    return nearest_quadric_hit<T>({origin, direction, {0, std::numeric_limits<T>::infinity()}}, quadric);
}

template <class T>
void check_hit(const std::optional<QuadricHit<T>>& hit, T t, Part part = Part::side) {
    REQUIRE(hit.has_value());
    CHECK(hit->t == t);
    CHECK(hit->part == part);
}

// One of each, about the y axis from -1 to 1, radius 2 where it is widest.
const Cylinder cylinder{{0, -1, 0}, {0, 1, 0}, 2, Ends::capped};
const Cone cone{{0, -1, 0}, {0, 1, 0}, 2, 0, Ends::capped};
const Paraboloid paraboloid{{0, -1, 0}, {0, 1, 0}, 2, Ends::capped};
const Hyperboloid hyperboloid{{0, -1, 0}, {0, 1, 0}, 1, 2, Ends::capped};
const Ellipsoid ellipsoid{{0, 0, 0}, {2, 1, 4}};

template <class Shape>
Shape opened(Shape shape) {
    shape.ends = Ends::open;
    return shape;
}

}  // namespace

TEMPLATE_TEST_CASE("a ray across the axis hits each quadric at its radius", "", float, double, long double) {
    using T = TestType;
    check_hit(shoot<T>(cylinder, {10, 0, 0}, {-1, 0, 0}), T(8));
    check_hit(shoot<T>(cone, {10, 0, 0}, {-1, 0, 0}), T(9));  // half-way up its radius is 1
    check_hit(shoot<T>(hyperboloid, {10, 0, 0}, {-1, 0, 0}), T(9));
    check_hit(shoot<T>(ellipsoid, {10, 0, 0}, {-1, 0, 0}), T(8));
    check_hit(shoot<T>(ellipsoid, {0, 0, 10}, {0, 0, -2}), T(3));
    // radius^2 = 4 s is 1 at s = 1/4, y = -1/2
    check_hit(shoot<T>(paraboloid, {10, T(-0.5), 0}, {-1, 0, 0}), T(9));
}

TEMPLATE_TEST_CASE("a ray along the axis hits the caps, or goes through what is open", "", float, double, long double) {
    using T = TestType;
    check_hit(shoot<T>(cylinder, {1, 5, 0}, {0, -1, 0}), T(4), Part::top_cap);
    check_hit(shoot<T>(cylinder, {1, -5, 0}, {0, 1, 0}), T(4), Part::base_cap);
    check_hit(shoot<T>(hyperboloid, {0, 5, 0}, {0, -1, 0}), T(4), Part::top_cap);
    check_hit(shoot<T>(paraboloid, {1, 5, 0}, {0, -1, 0}), T(4), Part::top_cap);
    check_hit(shoot<T>(opened(paraboloid), {1, 5, 0}, {0, -1, 0}), T(5.5));
    CHECK_FALSE(shoot<T>(opened(cylinder), {1, 5, 0}, {0, -1, 0}).has_value());
    CHECK_FALSE(shoot<T>(opened(hyperboloid), {0, 5, 0}, {0, -1, 0}).has_value());
}

TEMPLATE_TEST_CASE("beyond its ends a quadric is not there", "", float, double, long double) {
    using T = TestType;
    CHECK_FALSE(shoot<T>(cylinder, {10, 2, 0}, {-1, 0, 0}).has_value());
    CHECK_FALSE(shoot<T>(cone, {10, 3, 0}, {-1, 0, 0}).has_value());  // the cone's other half
    CHECK_FALSE(shoot<T>(hyperboloid, {10, 2, 0}, {-1, 0, 0}).has_value());
    CHECK_FALSE(shoot<T>(paraboloid, {10, 2, 0}, {-1, 0, 0}).has_value());
}

TEMPLATE_TEST_CASE("through an open end a ray hits the inside of the far wall", "", float, double, long double) {
    using T = TestType;
    // Enters above the rim at x = -3, y = 2 and goes down at 45 degrees: the near wall is passed at y = 1.
    check_hit(shoot<T>(opened(cylinder), {T(-3.5), 3, 0}, {1, T(-0.5), 0}), T(5.5));
    check_hit(shoot<T>(cylinder, {T(-3.5), 3, 0}, {1, T(-0.5), 0}), T(4), Part::top_cap);
}

TEMPLATE_TEST_CASE("a ray along a generator misses, parallel to one it hits the other side", "", float, double,
                   long double) {
    using T = TestType;
    CHECK_FALSE(shoot<T>(opened(cylinder), {2, 5, 0}, {0, -1, 0}).has_value());
    CHECK_FALSE(shoot<T>(opened(cone), {3, -2, 0}, {-1, 1, 0}).has_value());
    // A line parallel to the cone's side has no t^2: one crossing only.
    check_hit(shoot<T>(opened(cone), {-3, 2, 0}, {1, -1, 0}), T(2));
}

TEMPLATE_TEST_CASE("a cap of radius zero is no cap: a ray along a generator passes the apex and hits the base's rim",
                   "", float, double, long double) {
    using T = TestType;
    const Cone tip_up{{0, 0, 0}, {0, 0, 4}, 4, 0, Ends::capped}, tip_down{{0, 0, 4}, {0, 0, 0}, 0, 4, Ends::capped};
    check_hit(shoot<T>(tip_up, {-4, 0, 8}, {1, 0, -1}), T(8), Part::base_cap);
    check_hit(shoot<T>(tip_down, {-4, 0, 8}, {1, 0, -1}), T(8), Part::top_cap);
    check_hit(shoot<T>(cone, {0, 5, 0}, {0, -1, 0}), T(4), Part::side);
    CHECK_FALSE(shoot<T>(Cylinder{{0, -1, 0}, {0, 1, 0}, 0, Ends::capped}, {0, 5, 0}, {0, -1, 0}).has_value());
}

TEMPLATE_TEST_CASE("a gradient points outward and has no particular length", "", float, double, long double) {
    using T = TestType;
    const auto check = [](const Quadric& quadric, Vec3<T> point, Vec3<T> expected, Part part = Part::side) {
        CHECK(gradient<T>(quadric, point, part) == expected);
        CHECK_THAT(cast<double>(glm::length(gradient_normal<T>(quadric, point, part))), WithinAbs(1, 1e-6));
    };
    check(Sphere{{1, 0, 0}, 3}, {1, 3, 0}, {0, 6, 0});
    check(ellipsoid, {2, 0, 0}, {1, 0, 0});
    check(ellipsoid, {0, 1, 0}, {0, 2, 0});
    check(ellipsoid, {0, 0, -4}, {0, 0, T(-0.5)});
    check(cylinder, {0, 0, 2}, {0, 0, 4});
    check(cone, {1, 0, 0}, {2, 2, 0});
    check(paraboloid, {1, T(-0.5), 0}, {2, -2, 0});
    check(hyperboloid, {-1, 0, 0}, {-2, 0, 0});
    check(cylinder, {1, 1, 0}, {0, 2, 0}, Part::top_cap);
    check(cylinder, {1, -1, 0}, {0, -2, 0}, Part::base_cap);
}

TEST_CASE("a quadric stands anywhere and leans any way") {
    // The cylinder of radius 5 about a 3-4-0 axis, hit square-on through its axis' middle.
    const Cylinder leaning{{100, 200, 300}, {130, 240, 300}, 5, Ends::open};
    check_hit(shoot<double>(leaning, {115, 220, 400}, {0, 0, -1}), 95.0);
}

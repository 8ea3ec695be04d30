#include "catch.h"

#include "raylab/experiment/ray_sphere/ray_sphere.h"
#include "raylab/geometry/nearest_sphere_hit.h"
#include "raylab/sampling/sequence.h"

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

using namespace raylab;

namespace {

// Each method of the question in one number type, so that a claim is tested for all of them.
template <class T>
struct Named {
    std::string name;
    std::function<std::optional<T>(const RayOf<T>&, const SphereOf<T>&)> hit;
};

template <class T>
std::vector<Named<T>> methods() {
    std::vector<Named<T>> all = {{"textbook", textbook_sphere_hit<T>},
                                 {"stable", stable_sphere_hit<T>},
                                 {"reformulated", reformulated_sphere_hit<T>},
                                 {"factored", factored_sphere_hit<T>}};
    if constexpr (std::same_as<T, double>) all.push_back({"nearest_sphere_hit", nearest_sphere_hit});
    return all;
}

template <class T>
struct Question {
    Vec3<T> origin, direction;
    Interval<T> range = {0, std::numeric_limits<T>::infinity()};
    SphereOf<T> sphere = {{0, 0, 0}, 1};
};

// All methods give the same answer: the numbers in these questions are small integers, and only the factored form
// rounds on its way (it takes square roots).
template <class T>
void check_all(const Question<T>& question, std::optional<T> expected) {
    for (const auto& method : methods<T>()) {
        INFO(method.name);
        const auto t = method.hit({question.origin, question.direction, question.range}, question.sphere);
        REQUIRE(t.has_value() == expected.has_value());
        if (!t) continue;
        const T allowed = method.name == "factored" ? 4 * std::numeric_limits<T>::epsilon() * *expected : 0;
        CHECK(std::abs(*t - *expected) <= allowed);
    }
}

}  // namespace

TEMPLATE_TEST_CASE("a ray through the center of a sphere hits its near side", "", float, double, long double) {
    check_all<TestType>({.origin = {0, 0, 5}, .direction = {0, 0, -1}}, 4);
    check_all<TestType>({.origin = {3, 7, -2}, .direction = {0, 1, 0}, .sphere = {{3, 11, -2}, 2}}, 2);
}

TEMPLATE_TEST_CASE("a sphere is hit at the first of two crossings off its center", "", float, double, long double) {
    // 3-4-5: the line x = 3 crosses the sphere of radius 5 at z = +-4.
    check_all<TestType>({.origin = {3, 0, 10}, .direction = {0, 0, -1}, .sphere = {{0, 0, 0}, 5}}, 6);
}

TEMPLATE_TEST_CASE("t counts directions, whatever their length", "", float, double, long double) {
    check_all<TestType>({.origin = {0, 0, 5}, .direction = {0, 0, -2}}, 2);
    check_all<TestType>({.origin = {0, 0, 5}, .direction = {0, 0, TestType(-0.125)}}, 32);
}

TEMPLATE_TEST_CASE("a ray that starts inside a sphere hits on its way out", "", float, double, long double) {
    check_all<TestType>({.origin = {0, 0, 0}, .direction = {0, 0, -1}}, 1);
    check_all<TestType>({.origin = {3, 0, 3}, .direction = {0, 0, 1}, .sphere = {{0, 0, 0}, 5}}, 1);
}

TEMPLATE_TEST_CASE("a sphere behind the ray is a miss", "", float, double, long double) {
    check_all<TestType>({.origin = {0, 0, 5}, .direction = {0, 0, 1}}, std::nullopt);
}

TEMPLATE_TEST_CASE("a sphere beside the ray is a miss", "", float, double, long double) {
    check_all<TestType>({.origin = {2, 0, 5}, .direction = {0, 0, -1}}, std::nullopt);
}

TEMPLATE_TEST_CASE("the range of a ray is closed at both ends", "", float, double, long double) {
    check_all<TestType>({.origin = {0, 0, 5}, .direction = {0, 0, -1}, .range = {0, 4}}, 4);
    check_all<TestType>({.origin = {0, 0, 5}, .direction = {0, 0, -1}, .range = {4, 9}}, 4);
    check_all<TestType>({.origin = {0, 0, 5}, .direction = {0, 0, -1}, .range = {0, 3}}, std::nullopt);
    check_all<TestType>({.origin = {0, 0, 5}, .direction = {0, 0, -1}, .range = {7, 9}}, std::nullopt);
}

TEMPLATE_TEST_CASE("where the near crossing is out of range, the far one counts", "", float, double, long double) {
    check_all<TestType>({.origin = {0, 0, 5}, .direction = {0, 0, -1}, .range = {5, 9}}, 6);
}

TEMPLATE_TEST_CASE("a tangent ray along an axis hits", "", float, double, long double) {
    check_all<TestType>({.origin = {1, 0, 5}, .direction = {0, 0, -1}}, 5);
}

TEMPLATE_TEST_CASE("a ray that starts on a sphere and leaves it hits at zero", "", float, double, long double) {
    check_all<TestType>({.origin = {0, 0, 1}, .direction = {0, 0, 1}}, 0);
}

TEMPLATE_TEST_CASE("scaling a scene by a power of two scales t and changes no other bit", "", float, double,
                   long double) {
    for (int i = 0; i < 200; ++i) {
        RandomSequence random(2, static_cast<std::uint64_t>(i));
        const auto vector = [&] { return convert<TestType>(random.in_cube()); };
        const RayOf<TestType> ray{vector() * TestType(4), vector(), {0, std::numeric_limits<TestType>::infinity()}};
        const SphereOf<TestType> sphere{vector(), cast<TestType>(random.between(1, 2))};
        const TestType scale = std::ldexp(TestType(1), i % 24 - 12);
        for (const auto& method : methods<TestType>()) {
            INFO(method.name << ", case " << i);
            const auto plain = method.hit(ray, sphere);
            const auto scaled = method.hit({ray.origin * scale, ray.direction, ray.range},
                                           {sphere.center * scale, sphere.radius * scale});
            REQUIRE(plain.has_value() == scaled.has_value());
            if (plain) CHECK(*scaled == *plain * scale);
        }
    }
}

TEST_CASE("numbers past float's range make a miss, never a hit at NaN") {
    for (const auto& method : methods<float>()) {
        INFO(method.name);
        const auto hit = method.hit({{0, 0, 5e25f}, {0, 0, -1e25f}, {0, 1e30f}}, {{0, 0, 0}, 1e25f});
        CHECK((!hit || std::isfinite(*hit)));
    }
}

TEST_CASE("from far away only the reformulated discriminant still sees a small sphere in float") {
    // The line x = 2 passes a unit sphere by. From 2^14 away b^2 and a c agree in all 24 bits.
    const RayOf<float> ray{{2, 0, 16384}, {0, 0, -1}, {0, 1e6f}};
    CHECK(textbook_sphere_hit<float>(ray, {{0, 0, 0}, 1}).has_value());
    CHECK(stable_sphere_hit<float>(ray, {{0, 0, 0}, 1}).has_value());
    CHECK_FALSE(reformulated_sphere_hit<float>(ray, {{0, 0, 0}, 1}).has_value());
}

TEST_CASE("the stable roots keep the small root that the school formula cancels away") {
    // t^2 - 2 t + 1e-8: in float the school formula answers 0.
    const Quadratic<float> quadratic{1, -1, 1e-8f};
    CHECK(textbook_roots(quadratic, quadratic.discriminant())->low == 0);
    CHECK_THAT(stable_roots(quadratic, quadratic.discriminant())->low, WithinRel(5e-9, 1e-6));
}

TEST_CASE("stable roots of a quadratic without a square, and without anything") {
    const Quadratic<double> linear{0, -2, 12};
    CHECK(stable_roots(linear, linear.discriminant())->low == 3);
    CHECK_FALSE(stable_roots(Quadratic<double>{0, 0, 1}, 0.0).has_value());
    CHECK_FALSE(stable_roots(Quadratic<double>{0, 0, 0}, 0.0).has_value());
    CHECK(stable_roots(Quadratic<double>{3, 0, 0}, 0.0)->low == 0);
}

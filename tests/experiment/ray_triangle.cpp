#include "catch.h"

#include "raylab/experiment/ray_triangle/published_methods.h"
#include "raylab/sampling/sequence.h"

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

// Every method on cases a hand can work out, in every number type.

using namespace raylab;

namespace {

template <Real T>
constexpr T infinity = std::numeric_limits<T>::infinity();

/// a at the origin, b along x, c along y: (x, y) of a point in it are its u and v.
template <Real T>
const TriangleOf<T> unit_triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

/// A ray straight down that starts 2 above (x, y, 0).
template <Real T>
RayOf<T> down_at(T x, T y, Interval<T> range = {0, infinity<T>}) {
    return {{x, y, 2}, {0, 0, -1}, range};
}

/// A point of the cube [-1, 1]^3 whose coordinates are floats.
template <Real T>
Vec3<T> float_vector(RandomSequence& random) {
    return convert<T>(convert<float>(random.in_cube()));
}

/// Runs a claim about every method in T.
template <Real T, class Claim>
void each(Claim claim) {
    each_published_method<T>([&](const auto& method) {
        CAPTURE(method.name);
        claim([&](const RayOf<T>& ray, const TriangleOf<T>& triangle) {
            return method.hit(ray, method.prepare(triangle));
        });
    });
}

}  // namespace

TEMPLATE_TEST_CASE("a ray through the inside hits, and t, u, v say where", "", float, double, long double) {
    using T = TestType;
    each<T>([](auto hit) {
        const auto found = hit(down_at<T>(T(0.25), T(0.5)), unit_triangle<T>);
        REQUIRE(found);
        CHECK(*found == TriangleHitOf<T>{2, T(0.25), T(0.5)});
    });
}

TEMPLATE_TEST_CASE("a ray beyond each of the three edges misses", "", float, double, long double) {
    using T = TestType;
    each<T>([](auto hit) {
        CHECK_FALSE(hit(down_at<T>(T(0.5), T(-0.125)), unit_triangle<T>));
        CHECK_FALSE(hit(down_at<T>(T(-0.125), T(0.5)), unit_triangle<T>));
        CHECK_FALSE(hit(down_at<T>(T(0.625), T(0.5)), unit_triangle<T>));
    });
}

TEMPLATE_TEST_CASE("edges and vertices belong to the triangle", "", float, double, long double) {
    using T = TestType;
    const std::vector<std::pair<T, T>> border = {{T(0.5), 0}, {0, T(0.5)}, {T(0.5), T(0.5)}, {0, 0}, {1, 0}, {0, 1}};
    each<T>([&](auto hit) {
        for (const auto& [x, y] : border) {
            CAPTURE(x, y);
            CHECK(hit(down_at<T>(x, y), unit_triangle<T>));
        }
    });
}

TEMPLATE_TEST_CASE("both sides are seen", "", float, double, long double) {
    using T = TestType;
    const RayOf<T> up{{T(0.25), T(0.25), -2}, {0, 0, 1}, {0, infinity<T>}};
    each<T>([&](auto hit) { CHECK(hit(up, unit_triangle<T>)); });
}

TEMPLATE_TEST_CASE("the range is closed at both ends, and excludes what lies behind", "", float, double, long double) {
    using T = TestType;
    each<T>([](auto hit) {
        const auto hits_within = [&](T min, T max) {
            return hit(down_at<T>(T(0.25), T(0.25), {min, max}), unit_triangle<T>).has_value();
        };
        CHECK(hits_within(2, infinity<T>));
        CHECK(hits_within(0, 2));
        CHECK_FALSE(hits_within(0, T(1.75)));
        CHECK_FALSE(hits_within(T(2.25), infinity<T>));
        CHECK(hits_within(-infinity<T>, infinity<T>));
        const RayOf<T> away{{T(0.25), T(0.25), 2}, {0, 0, 1}, {0, infinity<T>}};
        CHECK_FALSE(hit(away, unit_triangle<T>));
    });
}

TEMPLATE_TEST_CASE("the direction need not be unit: t is measured in it", "", float, double, long double) {
    using T = TestType;
    const RayOf<T> fast{{T(0.25), T(0.5), 2}, {0, 0, -8}, {0, infinity<T>}};
    each<T>([&](auto hit) {
        const auto found = hit(fast, unit_triangle<T>);
        REQUIRE(found);
        CHECK(*found == TriangleHitOf<T>{T(0.25), T(0.25), T(0.5)});
    });
}

TEMPLATE_TEST_CASE("a parallel ray misses, beside the plane and in it", "", float, double, long double) {
    using T = TestType;
    const RayOf<T> beside{{-1, T(0.25), 1}, {1, 0, 0}, {0, infinity<T>}};
    const RayOf<T> within{{-1, T(0.25), 0}, {1, 0, 0}, {0, infinity<T>}};
    each<T>([&](auto hit) {
        CHECK_FALSE(hit(beside, unit_triangle<T>));
        CHECK_FALSE(hit(within, unit_triangle<T>));
    });
}

TEMPLATE_TEST_CASE("a triangle without area is never hit", "", float, double, long double) {
    using T = TestType;
    const std::vector<TriangleOf<T>> degenerate = {
        {{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}, {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}}, {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}};
    each<T>([&](auto hit) {
        for (const auto& triangle : degenerate) {
            CHECK_FALSE(hit(down_at<T>(0, 0), triangle));
            CHECK_FALSE(hit(down_at<T>(1, 0), triangle));
            CHECK_FALSE(hit(down_at<T>(1, 1), triangle));
        }
    });
}

TEMPLATE_TEST_CASE("whatever overflows, a hit has finite t, u and v", "", float, double, long double) {
    using T = TestType;
    using Limits = std::numeric_limits<T>;
    for (int exponent = Limits::min_exponent / 2; exponent < Limits::max_exponent / 2;
         exponent += Limits::max_exponent / 32)
        for (int i = 0; i < 100; ++i) {
            RandomSequence random(1, static_cast<std::uint64_t>(exponent), static_cast<std::uint64_t>(i));
            const auto vector = [&] { return convert<T>(random.in_cube()) * std::ldexp(T(1), exponent); };
            const TriangleOf<T> triangle{vector(), vector(), vector()};
            const Vec3<T> origin = vector();
            const RayOf<T> ray{origin, (triangle.a + triangle.b + triangle.c) / T(3) - origin, {0, infinity<T>}};
            each<T>([&](auto hit) {
                const auto found = hit(ray, triangle);
                if (found) CHECK((std::isfinite(found->t) && std::isfinite(found->u) && std::isfinite(found->v)));
            });
        }
}

TEMPLATE_TEST_CASE("a power of two changes no decision and no u, v", "", float, double, long double) {
    using T = TestType;
    for (std::uint64_t i = 0; i < 2000; ++i) {
        RandomSequence random(2, i);
        const auto vector = [&] { return float_vector<T>(random); };
        const TriangleOf<T> triangle{vector(), vector(), vector()};
        const Vec3<T> target = (triangle.a + triangle.b) / T(2);  // an edge: where decisions are hardest
        const Vec3<T> origin = T(3) * vector();
        const RayOf<T> ray{origin, target - origin, {0, infinity<T>}};
        for (const T scale : {std::ldexp(T(1), -20), std::ldexp(T(1), 20)}) {
            const TriangleOf<T> scaled{scale * triangle.a, scale * triangle.b, scale * triangle.c};
            const RayOf<T> scaled_ray{scale * ray.origin, scale * ray.direction, ray.range};
            each<T>([&](auto hit) { CHECK(hit(ray, triangle) == hit(scaled_ray, scaled)); });
        }
    }
}

TEMPLATE_TEST_CASE("Pluecker and watertight decide the same for every order of the vertices", "", float, double) {
    using T = TestType;
    for (std::uint64_t i = 0; i < 2000; ++i) {
        RandomSequence random(3, i);
        const auto vector = [&] { return float_vector<T>(random); };
        const Vec3<T> a = vector(), b = vector(), c = vector(), origin = T(3) * vector();
        const RayOf<T> ray{origin, (a + b) / T(2) - origin, {0, infinity<T>}};
        for (const auto& turned : {TriangleOf<T>{b, c, a}, {c, a, b}, {a, c, b}, {c, b, a}, {b, a, c}}) {
            CHECK(pluecker(ray, {a, b, c}).has_value() == pluecker(ray, turned).has_value());
            CHECK(watertight(ray, {a, b, c}).has_value() == watertight(ray, turned).has_value());
        }
    }
}

TEST_CASE("an absolute epsilon loses a small triangle that is hit in the middle") {
    const float scale = 1e-5f;
    const TriangleOf<float> small{{0, 0, 0}, {scale, 0, 0}, {0, scale, 0}};
    const auto ray = down_at<float>(scale / 4, scale / 4);
    CHECK(moeller_trumbore(ray, small));
    CHECK_FALSE(moeller_trumbore(ray, small, 1e-8f));
}

TEST_CASE("watertight in float asks a zero edge value again in double") {
    // p x q is -e^2: no float product shows it, and without the second look both triangles over pq would be hit.
    const float e = 0x1p-23f;
    const Vec3f p{1 + e, 1, 1}, q{-(1 + 2 * e), -(1 + e), 1};
    const RayOf<float> ray{{0, 0, 0}, {0, 0, 1}, {0, infinity<float>}};
    CHECK(watertight<float>(ray, {p, q, {-1, 1, 1}}));
    CHECK_FALSE(watertight<float>(ray, {p, q, {1, -1, 1}}));
}

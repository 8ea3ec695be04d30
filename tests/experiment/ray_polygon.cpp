#include "catch.h"

#include "raylab/experiment/ray_polygon/even_odd.h"
#include "raylab/experiment/ray_polygon/fan.h"
#include "raylab/experiment/ray_polygon/half_planes.h"
#include "raylab/experiment/ray_polygon/methods.h"

#include <limits>
#include <utility>

using namespace raylab;

namespace {

/// A square of side 4 with a notch down to (2, 1), in the plane z = x / 2 (so that z is the dominant axis).
const Polygon notched{{{0, 0, 0}, {4, 0, 2}, {4, 4, 2}, {2, 1, 1}, {0, 4, 0}}};
const Polygon square{{{0, 0, 0}, {4, 0, 2}, {4, 4, 2}, {0, 4, 0}}};

template <Real T>
RayOf<T> down_at(T x, T y) {
    return {{x, y, 10}, {0, 0, -1}, {0, std::numeric_limits<T>::infinity()}};
}

}  // namespace

TEMPLATE_TEST_CASE("even-odd finds the inside of a concave polygon and leaves out its notch", "", float, double) {
    using T = TestType;
    const PolygonIn<T> polygon(notched);
    for (const auto& [x, y] : {std::pair<T, T>{2, T(0.5)}, {1, 2}, {3, 2}, {T(0.5), 3}, {T(3.5), 3}}) {
        CAPTURE(x, y);
        const auto t = even_odd(down_at<T>(x, y), polygon);
        REQUIRE(t);
        CHECK(*t == 10 - x / 2);
    }
    for (const auto& [x, y] : {std::pair<T, T>{2, 3}, {-1, 2}, {5, 2}, {2, -1}, {2, 5}, {5, 4}, {-1, 0}}) {
        CAPTURE(x, y);
        CHECK_FALSE(even_odd(down_at<T>(x, y), polygon));
    }
}

TEMPLATE_TEST_CASE("edges and vertices belong to a polygon", "", float, double) {
    using T = TestType;
    const PolygonIn<T> polygon(notched);
    for (const auto& [x, y] :
         {std::pair<T, T>{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}, {2, 0}, {4, 2}, {3, T(2.5)}, {1, T(2.5)}, {0, 2}}) {
        CAPTURE(x, y);
        CHECK(even_odd(down_at<T>(x, y), polygon));
    }
}

TEMPLATE_TEST_CASE("three methods agree on a convex polygon, from both sides and for both windings", "", float,
                   double) {
    using T = TestType;
    const Polygon turned{{square.vertices.rbegin(), square.vertices.rend()}};
    for (const auto& shape : {square, turned}) {
        const PolygonIn<T> polygon(shape);
        for (const auto& [x, y] : {std::pair<T, T>{1, 1}, {3, 2}, {2, T(3.5)}, {-1, 1}, {5, 2}, {2, 5}, {1, -2}}) {
            CAPTURE(x, y);
            const bool inside = x > 0 && x < 4 && y > 0 && y < 4;
            const RayOf<T> up{{x, y, -10}, {0, 0, 1}, {0, std::numeric_limits<T>::infinity()}};
            for (const auto& ray : {down_at<T>(x, y), up}) {
                CHECK(half_planes(ray, polygon).has_value() == inside);
                CHECK(even_odd(ray, polygon).has_value() == inside);
                CHECK(fan(ray, polygon).has_value() == inside);
            }
        }
    }
}

TEMPLATE_TEST_CASE("convex methods fail on a concave polygon: half-planes lose its ears, the fan fills its notch", "",
                   float, double) {
    using T = TestType;
    const PolygonIn<T> polygon(notched);
    CHECK_FALSE(half_planes(down_at<T>(T(0.5), 3), polygon));
    CHECK(even_odd(down_at<T>(T(0.5), 3), polygon));
    CHECK(fan(down_at<T>(2, T(1.5)), polygon).has_value());
    CHECK_FALSE(even_odd(down_at<T>(2, T(1.5)), polygon));
}

TEMPLATE_TEST_CASE("a ray parallel to a polygon misses, and so does one whose range ends before it", "", float,
                   double) {
    using T = TestType;
    const PolygonIn<T> polygon(square);
    const RayOf<T> parallel{{-1, 1, 1}, {2, 0, 1}, {0, std::numeric_limits<T>::infinity()}};
    CHECK_FALSE(even_odd(parallel, polygon));
    CHECK_FALSE(half_planes(parallel, polygon));
    RayOf<T> ending = down_at<T>(2, 2);
    ending.range.max = 9;
    CHECK(even_odd(ending, polygon));
    CHECK(half_planes(ending, polygon));
    ending.range.max = T(8.75);
    CHECK_FALSE(even_odd(ending, polygon));
    CHECK_FALSE(half_planes(ending, polygon));
}

TEST_CASE("every polygon method answers each query about its own polygon") {
    const std::vector<Polygon> polygons = {square, {{{8, 0, 1}, {9, 0, 1}, {9, 1, 1}, {8, 1, 1}}}};
    const std::vector<PolygonQuery> queries = {{{{8.25f, 0.5f, 2}, {0, 0, -1}}, 1},
                                               {{{8.25f, 0.5f, 2}, {0, 0, -1}}, 0}};
    for (const auto& method : ray_polygon_methods()) {
        CAPTURE(method.title());
        std::vector<std::optional<double>> results(queries.size());
        method.answer(method.prepare(polygons), polygons, queries, results);
        CHECK(results[0] == 1.0);
        CHECK_FALSE(results[1]);
    }
}

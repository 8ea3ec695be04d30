#include "catch.h"
#include "geometry/verdict.h"
#include "raylab/accelerator/bvh/ray_slabs.h"
#include "raylab/accelerator/bvh/ray_sphere_bound.h"
#include "raylab/experiment/adversarial/adversarial.h"
#include "raylab/geometry/bounds/bounding_sphere.h"
#include "raylab/number/dyadic.h"

#include <gmpxx.h>

using namespace raylab;
using namespace raylab::adversarial;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Some points, now and then all on a line, in a plane, all the same, or with any exponents.
Hull points(Draw& draw) {
    const int kind = draw.integer(0, 4), count = draw.integer(1, 12);
    const Vec3f at = draw.in_cube(1e3), along = draw.in_cube(1), beside = draw.in_cube(1);
    Hull hull;
    for (int i = 0; i < count; ++i) {
        const float x = draw.uniform(-1, 1), y = draw.uniform(-1, 1);
        const Vec3f p = kind == 0   ? at + along * x
                        : kind == 1 ? at + along * x + beside * y
                        : kind == 2 ? at
                        : kind == 3 ? draw.anywhere()
                                    : draw.in_cube(1);
        hull.push_back({convert<double>(p), 0});
    }
    return hull;
}

Dyadic square(const Vec3<Dyadic>& v) { return dot(v, v); }

bool holds(const Sphere& sphere, const Vec3d& point) {
    if (std::isinf(sphere.radius)) return sphere.radius > 0;
    const Dyadic radius(sphere.radius);
    return sign(square(convert<Dyadic>(point) - convert<Dyadic>(sphere.center)) - radius * radius) != Sign::positive;
}

bool holds(const Slabs& slabs, const Vec3d& point) {
    const auto from = convert<Dyadic>(point) - convert<Dyadic>(slabs.center);
    for (std::size_t i = 0; i < 3; ++i) {
        const float half = slabs.half[static_cast<int>(i)];
        if (std::isinf(half)) continue;
        const Dyadic along = dot(convert<Dyadic>(slabs.axes[i]), from);
        if (sign(along - Dyadic(half)) == Sign::positive || sign(-along - Dyadic(half)) == Sign::positive) return false;
    }
    return true;
}

Ray any_ray(Draw& draw, const Vec3d& toward) {
    Ray ray = draw.one_in(4) ? Ray{draw.anywhere(), draw.any_direction()}
                             : through(draw.in_cube(draw.one_in(2) ? 3 : 1e4), toward);
    if (draw.one_in(4)) ray.direction[draw.integer(0, 2)] = draw.one_in(2) ? 0.0f : -0.0f;
    if (draw.one_in(3)) ray.range = {-std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity()};
    if (draw.one_in(3)) ray.range = {draw.uniform(-2, 1), draw.uniform(1, 2)};
    return ray.direction == Vec3f(0) ? Ray{ray.origin, {0, 0, 1}, ray.range} : ray;
}

// The smallest t in range at which the ray is exactly between all three pairs of planes.
std::optional<mpq_class> first_inside(const Ray& ray, const Slabs& slabs) {
    const double far = 1e300;  // stands for infinity: floats are far below it
    const auto rational = [=](double x) { return mpq_class(std::clamp(x, -far, far)); };
    mpq_class near = rational(ray.range.min), last = rational(ray.range.max);
    const auto from = convert<Dyadic>(ray.origin) - convert<Dyadic>(slabs.center);
    for (std::size_t i = 0; i < 3; ++i) {
        const mpq_class f = dot(convert<Dyadic>(slabs.axes[i]), from).rational();
        const mpq_class g = dot(convert<Dyadic>(slabs.axes[i]), convert<Dyadic>(ray.direction)).rational();
        const mpq_class half = rational(slabs.half[static_cast<int>(i)]);
        if (g == 0) {
            if (abs(f) > half) return std::nullopt;
            continue;
        }
        const mpq_class one = (-half - f) / g, other = (half - f) / g;
        near = std::max<mpq_class>(near, std::min(one, other));
        last = std::min<mpq_class>(last, std::max(one, other));
    }
    return near <= last ? std::optional(near) : std::nullopt;
}

Slabs any_slabs(Draw& draw) {
    Slabs slabs = bounding_slabs(points(draw));
    // The axes need not be perpendicular.
    if (draw.one_in(4)) slabs.axes = {draw.in_cube(1), draw.in_cube(1), draw.in_cube(1)};
    if (draw.one_in(4)) slabs.center = draw.anywhere();
    if (draw.one_in(4)) slabs.half[draw.integer(0, 2)] = std::abs(draw.anything());
    return slabs;
}

}  // namespace

TEST_CASE("a bounding sphere and bounding slabs hold every point exactly, whatever its coordinates") {
    const auto judge = [](Draw& draw) -> std::optional<std::string> {
        const Hull hull = points(draw);
        const Sphere sphere = bounding_sphere(hull);
        const Slabs slabs = bounding_slabs(hull);
        for (const Ball& ball : hull) {
            if (!holds(sphere, ball.center)) return "outside of the sphere";
            if (!holds(slabs, ball.center)) return "outside of the slabs";
        }
        return std::nullopt;
    };
    CHECK(faults(20'000, judge) == "");
}

TEST_CASE("bounds are nearly the smallest: the sphere about a cube, a box about a turned box, balls about a ball") {
    Hull cube, turned;
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
            for (const double z : {-1.0, 1.0}) {
                cube.push_back({{x, y, z}, 0});
                turned.push_back({Vec3d(0.6, 0.8, 0) * (3 * x) + Vec3d(-0.8, 0.6, 0) * y + Vec3d(0, 0, 2 * z), 0});
            }
    CHECK(bounding_sphere(cube).radius < 1.02 * std::sqrt(3.0));
    const Vec3f half = bounding_slabs(turned).half;
    CHECK(half.x * half.y * half.z < 6.0001f);
    CHECK(bounding_sphere(Hull{{{1, 2, 3}, 4}}).radius < 4.00001f);
    CHECK(bounding_sphere(Hull{{{-3, 0, 0}, 1}, {{3, 0, 0}, 2}}).radius < 1.02 * 4.5);
}

TEST_CASE("a ray is never said to miss a sphere that it exactly hits, nor to enter it later than it does") {
    const auto judge = [](Draw& draw) -> std::optional<std::string> {
        Sphere sphere = bounding_sphere(points(draw));
        if (draw.one_in(3)) sphere = {draw.in_cube(1), draw.uniform(0, 1)};
        if (!std::isfinite(sphere.radius)) return std::nullopt;
        // Aims at a point of the sphere's surface, from anywhere.
        const Vec3d edge = convert<double>(draw.in_cube(1));
        const Ray ray =
            any_ray(draw, convert<double>(sphere.center) + edge * (sphere.radius / std::max(1e-9, glm::length(edge))));
        const auto truth = oracle::intersect(in<double>(ray), sphere);
        if (!truth.hit()) return std::nullopt;
        const double entry = SphereBoundRay(ray).entry(sphere);
        if (truth.t->compare(entry) >= 0) return std::nullopt;
        return fmt::format("enters at {} instead of {}: {}", entry, truth.t->to_string(), adversarial::words(ray));
    };
    CHECK(faults(20'000, judge) == "");
}

TEST_CASE("a ray is never said to miss slabs that it exactly hits, nor to enter them later than it does") {
    const auto judge = [](Draw& draw) -> std::optional<std::string> {
        const Slabs slabs = any_slabs(draw);
        Vec3d corner = convert<double>(slabs.center);
        for (std::size_t i = 0; i < 3; ++i) {
            const double to = draw.integer(-1, 1) * double{slabs.half[static_cast<int>(i)]};
            if (std::isfinite(to)) corner += convert<double>(slabs.axes[i]) * to;
        }
        const Ray ray = any_ray(draw, corner);
        const auto truth = first_inside(ray, slabs);
        if (!truth) return std::nullopt;
        const double entry = SlabsRay(ray).entry(slabs);
        if (entry == -infinity || (entry < infinity && *truth >= entry)) return std::nullopt;
        return fmt::format("enters at {} instead of {}: {}", entry, truth->get_d(), adversarial::words(ray));
    };
    CHECK(faults(20'000, judge) == "");
}

TEST_CASE("a ray beside slabs and along them misses them") {
    const Slabs slabs{.center = Vec3f(0), .half = Vec3f(1)};
    for (int axis = 0; axis < 3; ++axis) {
        Vec3f origin(0), direction(0);
        origin[axis] = 1.5f, direction[(axis + 1) % 3] = 1;
        CHECK(SlabsRay({origin, direction}).entry(slabs) == infinity);
        origin[axis] = 1;
        CHECK(SlabsRay({origin, direction}).entry(slabs) == 0);
    }
}

TEST_CASE("what is around nothing is missed, what reaches to infinity is hit") {
    const Ray ray{{1, 2, 3}, {0.5f, 1, -1}};
    CHECK(SphereBoundRay(ray).entry(bounding_sphere({})) == infinity);
    CHECK(SlabsRay(ray).entry(bounding_slabs({})) == infinity);
    const Hull endless{{{infinity, 0, 0}, 0}};
    CHECK(SphereBoundRay(ray).entry(bounding_sphere(endless)) == 0);
    CHECK(SlabsRay(ray).entry(bounding_slabs(endless)) == 0);
}

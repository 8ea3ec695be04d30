#include "raylab/experiment/ray_triangle/ray_triangle_workloads.h"

#include "raylab/sampling/sequence.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace raylab {

namespace {

struct Pair {
    Triangle triangle;
    Ray ray;
};

constexpr double scene_size = 1;    // triangles in [-1, 1]^3
constexpr double view_size = 3;     // origins in [-3, 3]^3
constexpr double closeness = 1e-5;  // of a sliver's apex to its edge, and of a grazing ray's origin to the plane

/// A triangle in double, before its vertices are rounded: {a, b, c}.
using Corners = std::array<Vec3d, 3>;

Corners random_corners(RandomSequence& random) {
    return {scene_size * random.in_cube(), scene_size * random.in_cube(), scene_size * random.in_cube()};
}

Triangle rounded(const Corners& at) { return {convert<float>(at[0]), convert<float>(at[1]), convert<float>(at[2])}; }

Corners corners_of(const Triangle& triangle) {
    return {convert<double>(triangle.a), convert<double>(triangle.b), convert<double>(triangle.c)};
}

/// The ray to a target; its direction is the rounded difference, as in any program that aims at a point.
Ray aimed(const Vec3f& origin, const Vec3d& target) {
    return {origin, convert<float>(target - convert<double>(origin))};
}

Vec3d at(const Corners& triangle, double u, double v) {
    const auto& [a, b, c] = triangle;
    return a + u * (b - a) + v * (c - a);
}

/// A point of the triangle.
Vec3d inside(RandomSequence& random, const Triangle& triangle) {
    const double u = random.next(), v = random.next();
    return u + v <= 1 ? at(corners_of(triangle), u, v) : at(corners_of(triangle), 1 - u, 1 - v);
}

/// A point of the parallelogram over the triangle: half of them are outside.
Vec3d around(RandomSequence& random, const Triangle& triangle) {
    const double u = random.next();
    return at(corners_of(triangle), u, random.next());
}

Vec3d unit_normal(const Corners& at) { return glm::normalize(cross(at[1] - at[0], at[2] - at[0])); }

/// Moves the whole pair by `offset` and scales it by `scale`, before anything is rounded.
Pair placed(RandomSequence& random, double scale, const Vec3d& offset, auto aim) {
    Corners corners = random_corners(random);
    for (auto& corner : corners) corner = scale * corner + offset;
    const Triangle triangle = rounded(corners);
    const Vec3f origin = convert<float>(scale * view_size * random.in_cube() + offset);
    return {triangle, aimed(origin, aim(random, triangle))};
}

Pair generic(RandomSequence& random) { return placed(random, 1, Vec3d(0), around); }

Pair edge(RandomSequence& random) {
    return placed(random, 1, Vec3d(0), [](RandomSequence& draw, const Triangle& triangle) {
        const Corners corners = corners_of(triangle);
        const auto first = static_cast<std::size_t>(draw.whole(0, 2));
        return corners[first] + draw.next() * (corners[(first + 1) % 3] - corners[first]);
    });
}

Pair vertex(RandomSequence& random) {
    return placed(random, 1, Vec3d(0), [](RandomSequence& draw, const Triangle& triangle) {
        return corners_of(triangle)[static_cast<std::size_t>(draw.whole(0, 2))];
    });
}

Pair sliver(RandomSequence& random) {
    auto [a, b, c] = random_corners(random);
    const Vec3d away = unit_normal({a, b, c});  // any direction across the edge will do
    c = a + random.next() * (b - a) + closeness * away;
    const Triangle triangle = rounded({a, b, c});
    const Vec3f origin = convert<float>(view_size * random.in_cube());
    return {triangle, aimed(origin, inside(random, triangle))};
}

Pair grazing(RandomSequence& random) {
    const Triangle triangle = rounded(random_corners(random));
    const Corners exact = corners_of(triangle);
    const double u = random.between(-view_size, view_size), v = random.between(-view_size, view_size);
    const double height = closeness * random.between(-1, 1);
    const Vec3f origin = convert<float>(at(exact, u, v) + height * unit_normal(exact));
    return {triangle, aimed(origin, inside(random, triangle))};
}

Pair far_scene(RandomSequence& random) { return placed(random, 1, Vec3d(1e4), around); }

Pair far_origin(RandomSequence& random) {
    const Triangle triangle = rounded(random_corners(random));
    const Vec3f origin = convert<float>(1e6 * random.unit_vector());
    return {triangle, aimed(origin, around(random, triangle))};
}

Pair tiny(RandomSequence& random) { return placed(random, 1e-15, Vec3d(0), inside); }

Pair huge(RandomSequence& random) { return placed(random, 1e13, Vec3d(0), inside); }

Pair lattice(RandomSequence& random) {
    const auto point = [&](int low, int high) {
        const int x = random.whole(low, high), y = random.whole(low, high);
        return Vec3f(static_cast<float>(x), static_cast<float>(y), static_cast<float>(random.whole(low, high)));
    };
    Pair pair;
    do pair.triangle = {point(0, 4), point(0, 4), point(0, 4)};
    // This is exact here.
    while (cross(pair.triangle.b - pair.triangle.a, pair.triangle.c - pair.triangle.a) == Vec3f(0));
    pair.ray.origin = point(0, 4);
    do pair.ray.direction = point(-2, 2);
    while (pair.ray.direction == Vec3f(0));
    return pair;
}

struct Recipe {
    std::string name, about;
    Pair (*make)(RandomSequence&);
};

const std::vector<Recipe>& recipes() {
    static const std::vector<Recipe> all = {
        {"generic", "random triangles, aimed at random around them: nothing is hard", generic},
        {"edge", "aimed at an edge: the side is decided by the last bits", edge},
        {"vertex", "aimed at a vertex: two sides at once, one hit in twenty exactly on the vertex", vertex},
        {"sliver", "triangles 1e-5 wide", sliver},
        {"grazing", "origins at most 1e-5 off the triangle's plane", grazing},
        {"off1e4", "the scene moved by 10 000: coordinates keep a thousandth", far_scene},
        {"far1e6", "seen from a million away", far_origin},
        {"tiny1e-15", "the scene scaled by 1e-15: products underflow in float", tiny},
        {"huge1e13", "the scene scaled by 1e13: products overflow in float", huge},
        {"lattice", "small whole numbers: exact hits on edges and vertices, rays in the plane", lattice},
    };
    return all;
}

}  // namespace

std::vector<std::string> ray_triangle_workload_names() {
    std::vector<std::string> names;
    for (const auto& recipe : recipes()) names.push_back(recipe.name);
    return names;
}

TriangleWorkload ray_triangle_workload(const std::string& name, std::size_t count, std::uint64_t seed) {
    const auto recipe = std::ranges::find(recipes(), name, &Recipe::name);
    assert(recipe != recipes().end());
    TriangleWorkload workload{.name = name, .about = recipe->about, .data = {}, .queries = {}};
    for (std::size_t i = 0; i < count; ++i) {
        RandomSequence random(seed, i);
        const auto [triangle, ray] = recipe->make(random);
        workload.data.push_back(triangle);
        workload.queries.push_back({ray, static_cast<std::uint32_t>(i)});
    }
    return workload;
}

}  // namespace raylab

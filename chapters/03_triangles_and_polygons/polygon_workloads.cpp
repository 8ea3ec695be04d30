#include "polygon_workloads.h"

#include "raylab/sampling/sequence.h"

#include <cmath>
#include <numbers>

namespace raylab {

namespace {

constexpr std::size_t rays_per_polygon = 50;  // enough that preparing a polygon pays

enum class Kind { convex, concave };
enum class PolygonAim { around, edge };

/// Two orthonormal axes of a plane.
struct Plane2 {
    Vec3d center, x, y;
    Vec3d at(double u, double v) const { return center + u * x + v * y; }
};

Plane2 random_plane(RandomSequence& random) {
    const Vec3d normal = random.unit_vector();
    const Vec3d x = glm::normalize(cross(normal, random.unit_vector()));
    return {random.in_cube(), x, cross(normal, x)};
}

/// Vertices at random angles, in order, around the plane's center: on a circle they make a convex polygon, at random
/// distances a star-shaped one with notches. Rounded to floats they are no longer exactly in one plane.
Polygon random_polygon(const Plane2& plane, Kind kind, RandomSequence& random) {
    const int count = random.whole(4, 12);
    Polygon polygon;
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * (i + random.between(0.1, 0.9)) / count;
        const double radius = kind == Kind::convex ? 1 : random.between(0.2, 1);
        polygon.vertices.push_back(convert<float>(plane.at(radius * std::cos(angle), radius * std::sin(angle))));
    }
    return polygon;
}

Vec3d target(const Plane2& plane, const Polygon& polygon, PolygonAim aim, RandomSequence& random) {
    if (aim == PolygonAim::around) {
        const double u = random.between(-1, 1);
        return plane.at(u, random.between(-1, 1));
    }
    const auto count = polygon.vertices.size();
    const auto i = static_cast<std::size_t>(random.whole(0, static_cast<int>(count) - 1));
    const Vec3d from = convert<double>(polygon.vertices[i]), to = convert<double>(polygon.vertices[(i + 1) % count]);
    return from + random.next() * (to - from);
}

PolygonWorkload workload(Kind kind, PolygonAim aim, std::size_t count, std::uint64_t seed) {
    const std::string shape = kind == Kind::convex ? "convex" : "concave";
    PolygonWorkload made{
        .name = shape + (aim == PolygonAim::around ? "" : ", edges"),
        .about = shape + " polygons, aimed " + (aim == PolygonAim::around ? "at random around them" : "at their edges"),
        .data = {},
        .queries = {}};
    for (std::size_t i = 0; made.queries.size() < count; ++i) {
        RandomSequence random(seed, i);
        const Plane2 plane = random_plane(random);
        made.data.push_back(random_polygon(plane, kind, random));
        for (std::size_t j = 0; j < rays_per_polygon && made.queries.size() < count; ++j) {
            const Vec3f origin = convert<float>(3.0 * random.in_cube());
            const Vec3d point = target(plane, made.data.back(), aim, random);
            const Ray ray{origin, convert<float>(point - convert<double>(origin))};
            made.queries.push_back({ray, static_cast<std::uint32_t>(i)});
        }
    }
    return made;
}

}  // namespace

std::vector<PolygonWorkload> polygon_workloads(std::size_t count, std::uint64_t seed) {
    std::vector<PolygonWorkload> all;
    for (const Kind kind : {Kind::convex, Kind::concave})
        for (const PolygonAim aim : {PolygonAim::around, PolygonAim::edge})
            all.push_back(workload(kind, aim, count, seed));
    return all;
}

}  // namespace raylab

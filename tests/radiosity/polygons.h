#pragma once

#include "raylab/radiosity/form_factor/convex_polygon.h"
#include "raylab/sampling/sequence.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

// Polygons whose form factors are known, and random ones.

namespace raylab {

using Vertices = std::vector<Vec3d>;

struct PolygonPair {
    Vertices from, to;
};

/// Seen from the side to which cross(u, v) points.
inline Vertices rectangle(const Vec3d& corner, const Vec3d& u, const Vec3d& v) {
    return {corner, corner + u, corner + u + v, corner + v};
}

/// [0, a] x [0, b] at z = 0, facing up, and the same shifted by dx and dy at z = c, facing down.
inline PolygonPair parallel_pair(double a, double b, double c, double dx = 0, double dy = 0) {
    return {rectangle({0, 0, 0}, {a, 0, 0}, {0, b, 0}), rectangle({dx, dy, c}, {0, b, 0}, {a, 0, 0})};
}

/// Two rectangles of length 1 that share the edge x = z = 0, one of width w on the floor, one of height h that rises at
/// this angle, in radians, from the floor.
inline PolygonPair hinged_pair(double h, double w, double angle = std::numbers::pi / 2) {
    const Vec3d rise{std::cos(angle), 0, std::sin(angle)};
    return {rectangle({0, 0, 0}, {w, 0, 0}, {0, 1, 0}), rectangle({0, 0, 0}, {0, 1, 0}, h * rise)};
}

/// A random rotation, scale and shift.
class Placement {
public:
    Placement(RandomSequence& random, double scale, double reach)
        : x_(random.unit_vector()),
          y_(random.unit_vector_across(x_)),
          scale_(scale),
          shift_(reach * random.in_cube()) {}

    Vertices operator()(const Vertices& polygon) const {
        Vertices placed;
        for (const Vec3d& v : polygon) placed.push_back(shift_ + scale_ * (v.x * x_ + v.y * y_ + v.z * cross(x_, y_)));
        return placed;
    }

private:
    Vec3d x_, y_;
    double scale_;
    Vec3d shift_;
};

/// A polygon of 3 to 6 vertices on a circle of this radius around a centre, counter-clockwise around the normal.
inline Vertices random_polygon(RandomSequence& random, const Vec3d& center, const Vec3d& normal, double radius) {
    const Vec3d x = random.unit_vector_across(normal), y = cross(normal, x);
    std::vector<double> angles;
    const int vertices = random.whole(3, 6);
    for (int i = 0; i < vertices; ++i) angles.push_back(2 * std::numbers::pi * (i + random.between(0, 0.6)) / vertices);
    Vertices polygon;
    for (const double angle : angles) polygon.push_back(center + radius * (std::cos(angle) * x + std::sin(angle) * y));
    return polygon;
}

/// Two polygons of radius 1 that face each other, with centres this far apart: each is in front of the other's plane if
/// they are at least 3 apart.
inline PolygonPair facing_pair(RandomSequence& random, double apart) {
    const Vec3d way = random.unit_vector();
    const auto towards = [&](const Vec3d& direction) {
        return glm::normalize(direction + 0.6 * random.in_cube() / std::numbers::sqrt3);
    };
    return {random_polygon(random, {0, 0, 0}, towards(way), 1), random_polygon(random, apart * way, towards(-way), 1)};
}

inline Vertices turned(Vertices polygon) {
    std::ranges::reverse(polygon);
    return polygon;
}

/// The faces of the box from the origin to `size`, seen from inside, each as cells x cells rectangles.
inline std::vector<Vertices> room(const Vec3d& size, int cells) {
    std::vector<Vertices> walls;
    const auto wall = [&](const Vec3d& corner, const Vec3d& u, const Vec3d& v) {
        for (int i = 0; i < cells; ++i)
            for (int j = 0; j < cells; ++j)
                walls.push_back(rectangle(corner + (1.0 * i / cells) * u + (1.0 * j / cells) * v, (1.0 / cells) * u,
                                          (1.0 / cells) * v));
    };
    const Vec3d x{size.x, 0, 0}, y{0, size.y, 0}, z{0, 0, size.z}, origin{0, 0, 0};
    wall(origin, x, y);
    wall(origin, y, z);
    wall(origin, z, x);
    wall(z, y, x);
    wall(x, z, y);
    wall(y, x, z);
    return walls;
}

}  // namespace raylab

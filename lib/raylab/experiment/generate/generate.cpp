#include "raylab/experiment/generate/generate.h"

#include "raylab/experiment/generate/circle.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace raylab {

namespace {

Vec3d unit(const Vec3d& v) { return (1 / std::sqrt(dot(v, v))) * v; }

/// The triangles of a surface that closes in both directions: `along` rings of `around` points each.
std::vector<Mesh::Face> closed_grid(std::size_t along, std::size_t around) {
    const auto vertex = [&](std::size_t ring, std::size_t point) {
        return static_cast<std::uint32_t>((ring % along) * around + point % around);
    };
    std::vector<Mesh::Face> faces;
    for (std::size_t i = 0; i < along; ++i)
        for (std::size_t j = 0; j < around; ++j) {
            faces.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
            faces.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
        }
    return faces;
}

/// Points of the unit sphere and the triangles between them.
struct UnitSphere {
    std::vector<Vec3d> points;
    std::vector<Mesh::Face> faces;
};

UnitSphere icosahedron() {
    const double g = (1 + std::sqrt(5.0)) / 2;  // the golden ratio
    UnitSphere sphere{{{-1, g, 0},
                       {1, g, 0},
                       {-1, -g, 0},
                       {1, -g, 0},
                       {0, -1, g},
                       {0, 1, g},
                       {0, -1, -g},
                       {0, 1, -g},
                       {g, 0, -1},
                       {g, 0, 1},
                       {-g, 0, -1},
                       {-g, 0, 1}},
                      {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                       {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
    for (auto& point : sphere.points) point = unit(point);
    return sphere;
}

// Each triangle becomes four; neighbours share the new vertex of their edge.
UnitSphere split(const UnitSphere& coarse) {
    UnitSphere fine{coarse.points, {}};
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto [known, is_new] =
            middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(fine.points.size()));
        if (is_new) fine.points.push_back(unit(coarse.points[a] + coarse.points[b]));
        return known->second;
    };
    for (const auto& [a, b, c] : coarse.faces) {
        const auto ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        for (const Mesh::Face& face : {Mesh::Face{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}})
            fine.faces.push_back(face);
    }
    return fine;
}

UnitSphere sphere_of(int levels) {
    assert(levels >= 0 && levels <= 12);  // 12: 335 million triangles
    auto sphere = icosahedron();
    for (int level = 0; level < levels; ++level) sphere = split(sphere);
    return sphere;
}

Mesh mesh_of(const std::vector<Vec3d>& points, std::vector<Mesh::Face> faces) {
    Mesh mesh;
    for (const auto& point : points) mesh.vertices.push_back(convert<float>(point));
    mesh.faces = std::move(faces);
    return mesh;
}

// cos(n arccos x), by T(n+1) = 2 x T(n) - T(n-1).
double chebyshev(int n, double x) {
    double previous = 1, current = x;
    if (n == 0) return previous;
    for (int i = 1; i < n; ++i) previous = std::exchange(current, 2 * x * current - previous);
    return current;
}

}  // namespace

Mesh icosphere(int levels) {
    const auto sphere = sphere_of(levels);
    return mesh_of(sphere.points, sphere.faces);
}

Mesh bumpy_sphere(int levels, double height, int bumps) {
    assert(std::abs(height) < 1 && bumps >= 0);
    auto sphere = sphere_of(levels);
    for (auto& p : sphere.points)
        p = (1 + height * chebyshev(bumps, p.x) * chebyshev(bumps, p.y) * chebyshev(bumps, p.z)) * p;
    return mesh_of(sphere.points, sphere.faces);
}

Mesh torus(double tube, int levels) {
    assert(tube > 0 && tube < 1 && levels >= 2 && levels <= 14);
    const auto angles = circle(levels);
    std::vector<Vec3d> points;
    for (const auto& [c, s] : angles)
        for (const auto& [tube_c, tube_s] : angles)
            points.push_back({(1 + tube * tube_c) * c, (1 + tube * tube_c) * s, tube * tube_s});
    return mesh_of(points, closed_grid(angles.size(), angles.size()));
}

Mesh trefoil_knot(double tube, int levels) {
    assert(tube > 0 && tube <= 0.5 && levels >= 4 && levels <= 14);
    const auto along = circle(levels + 2), around = circle(levels - 2);
    std::vector<Vec3d> points;
    for (const auto& [c, s] : along) {
        const double c2 = c * c - s * s, s2 = 2 * s * c, c3 = c * (4 * c * c - 3), s3 = s * (3 - 4 * s * s);
        const Vec3d center{s + 2 * s2, c - 2 * c2, -s3};
        const Vec3d tangent = unit({c + 4 * c2, 4 * s2 - s, -3 * c3});  // never upright: its x^2 + y^2 is 17 + 8 cos 3t
        const Vec3d side = unit(cross(tangent, Vec3d{0, 0, 1})), up = cross(side, tangent);
        for (const auto& [tube_c, tube_s] : around) points.push_back(center + tube * (tube_c * side + tube_s * up));
    }
    return mesh_of(points, closed_grid(along.size(), around.size()));
}

}  // namespace raylab

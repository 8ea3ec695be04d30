#pragma once

#include "raylab/experiment/ray_triangle/methods.h"
#include "raylab/experiment/ray_triangle/ray_triangle_workloads.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

// From inside a closed mesh every ray hits exactly one of its triangles or, through an edge or a vertex, those that
// share it. A method for which a ray hits none lets light leak.

namespace raylab {

/// The points at which rays are aimed.
enum class Target { face, edge, vertex };

/// The triangles with which each ray is tested: those that touch its target, or all of them.
enum class Asked { around, all };

struct ShotOptions {
    Target target = Target::edge;
    Asked asked = Asked::around;
    std::size_t count = 10'000;
    std::uint64_t seed = 1;
};

/// Rays from inside a mesh, each with the triangles that it is tested against. Directions are of length 1, rounded to
/// float.
struct Shots {
    TriangleWorkload workload;
    std::vector<std::size_t> first;  // shot i has the queries first[i] .. first[i + 1]
};

/// The origins lie within half a unit of `center`, which the mesh must contain.
Shots shots_inside(const Mesh& mesh, const Vec3d& center, const ShotOptions& options);

/// Shares of rays in parts per million.
struct Leaks {
    double none = 0;  // hit no triangle
    double many = 0;  // hit two or more
};

Leaks count_leaks(const Shots& shots, std::span<const std::optional<TriangleHit>> answers);

/// The first ray that hits none of the triangles (`none`), or several of them (`many`), by its number.
enum class Leak { none, many };
std::optional<std::size_t> first_leak(const Shots& shots, std::span<const std::optional<TriangleHit>> answers,
                                      Leak kind);

/// The mesh with each vertex translated, and rounded again.
Mesh moved(Mesh mesh, const Vec3d& by);

}  // namespace raylab

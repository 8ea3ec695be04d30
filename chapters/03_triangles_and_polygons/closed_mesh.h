#pragma once

#include "raylab/geometry/ray_triangle/methods.h"
#include "raylab/sampling/ray_triangle_workloads.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

// From inside a closed mesh there is no way out: every ray hits exactly one of its triangles, or, through an edge or a
// vertex, those that share it. A method that says none lets light leak.

namespace raylab {

/// What rays are aimed at.
enum class Target { face, edge, vertex };

/// Which triangles each ray is asked about: those that touch its target, or all of them.
enum class Asked { around, all };

struct ShotOptions {
    Target target = Target::edge;
    Asked asked = Asked::around;
    std::size_t count = 10'000;
    std::uint64_t seed = 1;
};

/// Rays from inside a mesh, each with the triangles it is asked about. Directions are unit, rounded to float.
struct Shots {
    TriangleWorkload workload;
    std::vector<std::size_t> first;  // shot i asks the queries first[i] .. first[i + 1]
};

/// The origins lie within half a unit of `center`, which the mesh must contain.
Shots shots_inside(const Mesh& mesh, const Vec3d& center, const ShotOptions& options);

/// Rays in parts per million.
struct Leaks {
    double none = 0;  // hit no triangle
    double many = 0;  // hit two or more
};

Leaks count_leaks(const Shots& shots, std::span<const std::optional<TriangleHit>> answers);

/// The mesh with each vertex moved, and rounded again.
Mesh moved(Mesh mesh, const Vec3d& by);

}  // namespace raylab

#pragma once

#include "raylab/experiment/ray_sphere/ray_sphere_methods.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace raylab {

/// Pairs of a ray and a sphere; each set is hard in one way. All numbers are floats, so every question has an exact
/// answer.
using SphereWorkload = Workload<std::monostate, SphereQuery>;

/// The number of queries, and their seed. The same seed gives the same queries, and a longer set begins with the
/// shorter one.
struct WorkloadSize {
    std::size_t count;
    std::uint64_t seed;
};

/// Rays that pass a unit sphere within 1.2 radii, from 4 radii away; all lengths are multiplied by 2^exponent.
SphereWorkload generic_spheres(WorkloadSize draw);
SphereWorkload scaled_spheres(const std::string& name, int exponent, WorkloadSize draw);

/// Rays that pass a unit sphere within 1.2 radii, from `distance` radii away.
SphereWorkload spheres_at(double distance, WorkloadSize draw);

/// Rays that pass a unit sphere, 100 radii away, at 1 +- 1e-4 radii from its center.
SphereWorkload silhouettes(WorkloadSize draw);

/// Rays that touch a sphere exactly: origin, direction, center and radius are integers. `small`: so small that the
/// quadratic formula has no rounding error in float; `large`: so small that it has none that matters in double only.
enum class Wholes { small, large };
SphereWorkload tangents(Wholes wholes, WorkloadSize draw);

/// The small tangents with the sphere's radius one float smaller: all rays miss.
SphereWorkload near_tangents(WorkloadSize draw);

/// Rays that start inside a sphere and must leave it.
SphereWorkload inside_starts(WorkloadSize draw);

/// Rays that start on a sphere's surface: rounding decided whether they start slightly inside or outside.
SphereWorkload surface_starts(WorkloadSize draw);

/// The position of an eye above a large sphere, looking down and around: a floor, or the Earth.
enum class Up { along_y, tilted };
struct Floor {
    double radius;
    Up up = Up::tilted;
    double eye_height = 1;
};
SphereWorkload sphere_floor(const Floor& floor, WorkloadSize draw);

/// All of these, in the order of chapter 02.
std::vector<SphereWorkload> ray_sphere_workloads(WorkloadSize draw);

}  // namespace raylab

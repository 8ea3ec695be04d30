#pragma once

#include "raylab/experiment/ray_sphere/ray_sphere_workloads.h"

#include "raylab/experiment/ray_quadric/ray_quadric_methods.h"

namespace raylab {

using QuadricWorkload = Workload<Quadric, QuadricQuery>;

/// The kinds of quadrics; they have random positions and random axes, and every other one is capped.
enum class QuadricKind { ellipsoid, cylinder, cone, paraboloid, hyperboloid, any };

/// Rays that pass quadrics of one kind closely, from `distance` away.
QuadricWorkload quadrics_at(double distance, QuadricKind kind, WorkloadSize draw);

/// Rays aimed at the circle where a cylinder's side and cap join.
QuadricWorkload rims(WorkloadSize draw);

/// Rays aimed at the apex of a cone.
QuadricWorkload apexes(WorkloadSize draw);

/// Rays parallel to the tangent plane at a point of the surface, 1e-5 above or below it.
QuadricWorkload grazing_quadrics(WorkloadSize draw);

}  // namespace raylab

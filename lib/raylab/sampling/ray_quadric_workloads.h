#pragma once

#include "raylab/sampling/ray_sphere_workloads.h"

#include "raylab/geometry/ray_quadric_methods.h"

namespace raylab {

using QuadricWorkload = Workload<Quadric, QuadricQuery>;

/// The kinds of quadrics; they have random positions and random axes, and every other one is capped.
enum class QuadricKind { ellipsoid, cylinder, cone, paraboloid, hyperboloid, any };

/// Rays that pass quadrics of one kind closely, from `distance` away.
QuadricWorkload quadrics_at(double distance, QuadricKind kind, Draw draw);

/// Rays aimed at the circle where a cylinder's side and cap join.
QuadricWorkload rims(Draw draw);

/// Rays aimed at the apex of a cone.
QuadricWorkload apexes(Draw draw);

/// Rays parallel to the tangent plane at a point of the surface, 1e-5 above or below it.
QuadricWorkload grazing_quadrics(Draw draw);

}  // namespace raylab

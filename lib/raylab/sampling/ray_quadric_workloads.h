#pragma once

#include "raylab/sampling/ray_sphere_workloads.h"

#include "raylab/geometry/ray_quadric_methods.h"

namespace raylab {

using QuadricWorkload = Workload<Quadric, QuadricQuery>;

/// Kinds of quadrics, drawn at random places, leaning at random, every other one capped.
enum class QuadricKind { ellipsoid, cylinder, cone, paraboloid, hyperboloid, any };

/// Rays that pass quadrics of one kind closely, from `distance` away.
QuadricWorkload quadrics_at(double distance, QuadricKind kind, Draw draw);

/// Rays aimed at the circle in which a cylinder's side and cap meet.
QuadricWorkload rims(Draw draw);

/// Rays aimed at the apex of a cone.
QuadricWorkload apexes(Draw draw);

/// Rays in the tangent plane of a point of the surface, 1e-5 off it to either side.
QuadricWorkload grazing_quadrics(Draw draw);

}  // namespace raylab

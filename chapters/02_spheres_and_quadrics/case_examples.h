#pragma once

#include "raylab/geometry/quadric.h"
#include "raylab/geometry/ray.h"
#include "raylab/report/stability.h"

// A ray that shows how a stability case of this chapter fails, drawn from its own numbers.

namespace raylab {

/// The solid's section with a plane through the ray and the solid's middle.
CaseExample example_of(const Ray& ray, const Quadric& quadric, TrueAnswer truth);

/// A sphere as a floor, from the side: where the ray hits it, and where the method's `given` t leads.
CaseExample example_of_floor(const Ray& ray, const Sphere& sphere, double t, double given);

}  // namespace raylab

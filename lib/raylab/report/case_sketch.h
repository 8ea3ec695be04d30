#pragma once

#include "raylab/report/plane/plane_sketch.h"
#include "raylab/report/stability.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

// Sketches of stability cases: what a case does, drawn by hand with a single ray or surface.

namespace raylab {

/// A sketch of the part of the plane from `low` to `high`, as small as a page shows it.
CaseSketch case_sketch(const std::string& caption, const PlaneSketch& marks, PlanePoint low, PlanePoint high);

using CaseSketches = std::map<std::string, std::function<CaseSketch()>>;  // by the case's name

/// The cases, each with the sketch of its name.
std::vector<StabilityCase> with_sketches(std::vector<StabilityCase> cases, const CaseSketches& sketches);

/// A floor, and the point in its middle over which much of a lesson about light stands: the origin.
PlaneSketch floor_with_point();

}  // namespace raylab

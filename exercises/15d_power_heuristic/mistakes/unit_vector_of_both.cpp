// hint: infinity_over_infinity
// Makes a unit vector of both densities, and divides by the larger one first, which may be infinite.
#include "raylab/transport/power_heuristic.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

double raylab::power_heuristic(double pdf, double other) {
    const glm::dvec2 densities{pdf, other};
    const glm::dvec2 unit = glm::normalize(densities / std::max(pdf, other));
    return unit.x * unit.x;
}

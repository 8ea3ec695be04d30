// hint: whole_steps
// Takes the distance from a table of 1024 rings of one area: between two rings there is nothing.
#include "raylab/sampling/mapping/lens_point.h"

#include <array>
#include <cmath>
#include <numbers>

raylab::DiskPoint raylab::lens_point(double radius, double u, double v) {
    std::array<double, 1024> ring{};
    for (std::size_t i = 0; i < ring.size(); ++i) ring[i] = std::sqrt((static_cast<double>(i) + 0.5) / ring.size());
    const double r = radius * ring[static_cast<std::size_t>(u * ring.size())], turn = 2 * std::numbers::pi * v;
    return {r * std::cos(turn), r * std::sin(turn)};
}

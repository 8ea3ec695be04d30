#pragma once

#include "arguments.h"

#include <array>
#include <limits>

// The truth, by counting the six faces of each box: the average projected area of a convex body is a quarter of its
// surface (Cauchy). It is computed in long double.

namespace raylab::grading::cuts {

using Sides = std::array<long double, 3>;

inline long double surface(const Sides& sides) {
    long double sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (int face = 0; face < 2; ++face) sum += sides[(axis + 1) % 3] * sides[(axis + 2) % 3];
    return sum;
}

struct Truth {
    long double hits_below, hits_above, cost;  // the probabilities for a ray that hits the cell, and the cost
};

inline Truth truth(const SahCut& cut) {
    const Sides whole{cut.size.x, cut.size.y, cut.size.z};
    Sides below = whole, above = whole;
    const auto axis = static_cast<std::size_t>(cut.axis);
    below[axis] = cut.place;
    above[axis] = whole[axis] - static_cast<long double>(cut.place);
    if (surface(whole) == 0) return {0, 0, std::numeric_limits<long double>::infinity()};
    Truth found{surface(below) / surface(whole), surface(above) / surface(whole), 0};
    long double tests = found.hits_below * cut.below + found.hits_above * cut.above;
    if (cut.below == 0 || cut.above == 0) tests *= 1 - static_cast<long double>(cut.empty_bonus);
    found.cost = cut.visit_cost + cut.test_cost * tests;
    return found;
}

}  // namespace raylab::grading::cuts

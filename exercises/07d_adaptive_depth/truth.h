#pragma once

#include "arguments.h"

#include <cmath>

// The truth: the levels are added up one by one, in long double.

namespace raylab::grading::branches {

/// 1 + rho + rho^2 + ..., so many terms.
inline double series(double rho, int terms) {
    long double sum = 0, term = 1;
    for (int i = 0; i < terms; ++i) {
        sum += term;
        term *= rho;
    }
    return static_cast<double>(sum);
}

/// The most that a branch with this share may add to the pixel.
inline double most(const Arguments& given, double share) {
    return static_cast<double>(static_cast<long double>(given.weight) * share * given.brightest) *
           series(given.largest_share, given.levels);
}

inline double weight_of(const Arguments& given, double share) {
    return most(given, share) > given.least ? given.weight * share : 0;
}

inline FollowedBranches truth(const Arguments& given) {
    return {weight_of(given, given.reflected), weight_of(given, given.transmitted)};
}

}  // namespace raylab::grading::branches

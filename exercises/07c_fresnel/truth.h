#pragma once

#include "arguments.h"

#include <cmath>

// The truth by the two angles, in long double: Fresnel's own form, with sines and tangents.

namespace raylab::grading::fresnel_share {

inline long double sine_behind(const Arguments& given) {
    const long double c = given.cosine;
    return given.ior_before / static_cast<long double>(given.ior_behind) * std::sqrt((1 - c) * (1 + c));
}

inline double truth(const Arguments& given) {
    const long double sine = sine_behind(given);
    if (sine >= 1 || given.cosine == 0) return 1;
    const long double before = given.ior_before, behind = given.ior_behind;
    if (given.cosine == 1) return static_cast<double>(std::pow((before - behind) / (before + behind), 2));
    const long double a = std::acos(static_cast<long double>(given.cosine)), b = std::asin(sine);
    const long double s = std::sin(a - b) / std::sin(a + b), p = std::tan(a - b) / std::tan(a + b);
    return static_cast<double>((s * s + p * p) / 2);
}

}  // namespace raylab::grading::fresnel_share

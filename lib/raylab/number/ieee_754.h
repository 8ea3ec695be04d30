#pragma once

#include <cfloat>
#include <limits>

// Filters and their error bounds hold where each operation on floats and doubles is rounded once, to nearest, as IEEE
// 754 requires. Compiler flags that violate this and define a macro are refused here; others are detected by
// arithmetic_probe.h.

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    defined(__NO_SIGNED_ZEROS__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "raylab decides exactly by IEEE 754: compile what includes it without -ffast-math, -Ofast and their parts"
#endif

static_assert(std::numeric_limits<float>::is_iec559 && std::numeric_limits<double>::is_iec559,
              "float and double are the formats of IEEE 754");
static_assert(FLT_EVAL_METHOD == 0, "floats are computed in float and doubles in double, with no excess precision");

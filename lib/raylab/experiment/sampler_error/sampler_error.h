#pragma once

#include "raylab/sampling/sampler.h"

#include <functional>
#include <string>

// How much the mean of a sampler's samples errs, and how fast that falls with their number.

namespace raylab {

/// A function over the unit square, and its integral.
struct SquareIntegrand {
    std::string name;
    std::function<double(double, double)> value;
    double truth;
};

SquareIntegrand smooth_integrand();  // exp(x + y)
SquareIntegrand disc_integrand();    // 1 inside of a quarter of a circle: an edge at all angles
SquareIntegrand step_integrand();    // 1 where x < 0.37: an edge along an axis

/// Root of the mean squared error of the mean of `count` samples, over this many seeds (from 1). With 200 it is known
/// to 5 %.
double sampler_rmse(SamplerKind kind, int count, const SquareIntegrand& integrand, int seeds = 200);

/// The slope of the line through log RMSE over log N, for N = 16, 64, ..., 4096; of 200 seeds it is known to 0.01.
/// Expected: random -1/2; jittered -3/4 at an edge (Mitchell, SIGGRAPH 1996) and -1 where smooth; scrambled nets -3/2
/// where smooth (Owen, 1997).
double sampler_slope(SamplerKind kind, const SquareIntegrand& integrand, int seeds = 200);

}  // namespace raylab

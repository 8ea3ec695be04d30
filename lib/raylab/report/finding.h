#pragma once

#include "raylab/experiment/measure/measure.h"

#include <functional>
#include <string>

namespace raylab {

/// What the experiment's rows answer, in one sentence: Experiment::answer where the chapter has words of its own, and
/// otherwise the method that errs least, and its time beside the fastest method's on each workload, however wrong that
/// is.
///
///     filtered exact: no wrong decisions in 2 000 000 queries, as fast as any on generic,
///     11 × the fastest's time on vertex (the fastest: 38 % wrong)
std::string answer_of(const Experiment& experiment);

/// Of methods that were measured with several settings of a knob: the cheapest setting whose error stays below a bound
/// on each workload, and its time beside the fastest method's. It is made to be an Experiment::answer.
///
///     An error below 0.05 takes 16 rays to 64 rays by jittered, 64 rays by random (2.5 × the time); centre does not
///     reach it
std::function<std::string(const Experiment&)> answer_within(double bound);

}  // namespace raylab

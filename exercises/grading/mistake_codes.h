#pragma once

#include "exercise.h"

#include <vector>

namespace raylab::grading {

/// A recorded mistake, in each code in which it is recorded.
using Codes = std::vector<KnownAnswer>;

/// All recorded mistakes of an exercise. Two codes are of one mistake if their hint is the same, and three of four
/// wrong answers of the one are the other's. (Codes that answer all rightly, and work too much, have the same mistake
/// if they have the same hint.)
std::vector<Codes> mistakes_of(const Exercise& exercise);

}  // namespace raylab::grading
